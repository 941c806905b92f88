// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/stored_energy.hpp"

namespace percolith::mechanics {

Displacements displacements_before(const Model& model, double back) {
  const Motion& m = model.motion;
  Displacements u{m.ux, m.uy};
  for (std::size_t c = 0; back != 0.0 && c < u.ux.size(); ++c) {
    u.ux[c] -= back * m.vx[c];
    u.uy[c] -= back * m.vy[c];
  }
  return u;
}

BondEnergy::BondEnergy(const Model& model, const JointTable& table, const Displacements& u)
    : reader_(model, table, u.ux.data(), u.uy.data()), condition_(model.joints.condition.data()) {
  if (!model.pores.joint_share.empty()) {
    push_ = {model.pores.push[0].data(), model.pores.push[1].data()};
    opening_ = {model.pores.opening[0].data(), model.pores.opening[1].data()};
  }
}

}  // namespace percolith::mechanics
