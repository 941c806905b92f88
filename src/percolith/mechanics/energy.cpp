// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/energy.hpp"

#include "percolith/mechanics/closed_joints.hpp"
#include "percolith/mechanics/joint_points.hpp"
#include "percolith/mechanics/pressed_faces.hpp"
#include "percolith/mechanics/strain.hpp"
#include "percolith/mechanics/wet_joints.hpp"

#include <vector>

namespace percolith::mechanics {

double elastic_energy_of(const Model& model, Index t, double back) {
  const Tensor e = triangle_strain(model, t, back).strain;
  const Triangles& tri = model.triangles;
  const Tensor s = material::stress_of(model.material[at(tri.material[at(t)])].stiffness, e);
  double density = 0.5 * (s.xx * e.xx + s.yy * e.yy + 2.0 * s.xy * e.xy);
  if (!tri.initial_xx.empty()) {
    density += tri.initial_xx[at(t)] * e.xx + tri.initial_yy[at(t)] * e.yy +
               2.0 * tri.initial_xy[at(t)] * e.xy;
  }
  return density * model.mesh.area(t);
}

double elastic_energy(const Model& model, const Execution& execution, double back) {
  return execution.sum(model.mesh.triangles(), [&](Index t) {
    const bool is_there = model.triangles.inverse_mass[at(t)] > 0.0;
    return is_there ? elastic_energy_of(model, t, back) : 0.0;
  });
}

double stored_in_joints(const Model& model, const JointTable& table, const Execution& execution,
                        double back) {
  const double bonded = execution.sum(model.mesh.joints(), [&](Index j) {
    if (model.joints.state[at(j)] != JointState::bonded) {
      return 0.0;
    }
    const JointPoints points = joint_points(model, table, j, back);
    const material::JointConstants<double> c = joint_constants(model, table, j);
    double stored = 0.0;
    for (std::size_t g = 0; g < 2; ++g) {
      stored += material::stored_energy(c, points.moment[g]);
    }
    return 0.5 * model.mesh.joint_length(j) * stored;
  });
  return bonded + stored_in_closed_joints(model, back);
}

EnergyBalance energy_balance(const Model& model, const JointTable& table, const EnergyStart& start,
                             const ContactEnergy& contact, const Execution& execution) {
  const Energies& e = model.energy;
  EnergyBalance b;
  b.kinetic = e.kinetic;
  const double half = 0.5 * model.motion.last_step;
  b.elastic = elastic_energy(model, execution, half);
  b.joint = stored_in_joints(model, table, execution, half);
  b.absorbed = e.absorbed.total() + e.taken_out.total() + e.joints_taken_out.total();
  b.damping = e.damping.total() + e.viscous.total();
  b.gravity = e.gravity_work.total();
  b.fluid = e.fluid_work.total() + work_in_joints_since(model, execution, half) +
            work_on_faces_since(model, half);
  b.external = e.load_work.total() + e.absorbed.total() + e.support_work.total();
  std::vector<material::JointLoss<double>> lost(at(model.mesh.joints()));
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    lost[at(j)] = bond_loss_since(model, table, j, half);
  }
  const auto over_joints = [&](const auto& value) {
    return execution.sum(model.mesh.joints(), value);
  };
  b.fracture =
      over_joints([&](Index j) { return model.joints.past.spent[at(j)] + lost[at(j)].bond; });
  b.friction =
      contact.friction + e.closed_friction.total() + closed_friction_since(model, half) +
      over_joints([&](Index j) { return model.joints.past.rubbed[at(j)] + lost[at(j)].friction; });
  b.contact = contact.stored;
  b.residual =
      b.gravity + b.external + b.fluid -
      ((b.kinetic - start.kinetic) + (b.elastic - start.elastic) + (b.joint - start.joint) +
       b.fracture + b.contact + b.friction + b.damping + b.absorbed);
  return b;
}

}  // namespace percolith::mechanics
