// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/motion.hpp"

namespace percolith::mechanics {

MotionLaw motion_law(const Model& model, double dt) {
  return {model.damping.nodal_viscosity, model.damping.local, dt,
          0.5 * (model.motion.last_step + dt)};
}

MotionLaw creeping_law(double dt, bool moves) {
  return {0.0, 0.0, moves ? dt : 0.0, dt, true};
}

Move::Move(Model& model, const ContactForces& contact, const MotionLaw& motion)
    : solid(model), law(motion), ux(model.motion.ux.data()), uy(model.motion.uy.data()),
      vx(model.motion.vx.data()), vy(model.motion.vy.data()), growth(model.pores.growth.data()),
      inverse_mass(model.triangles.inverse_mass.data()),
      weight(model.triangles.weight.empty() ? nullptr : model.triangles.weight.data()),
      contact_x(contact.x.data()), contact_y(contact.y.data()),
      contact_acts(contact.acts.empty() ? nullptr : contact.acts.data()),
      load_x(model.loads.fx.data()), load_y(model.loads.fy.data()),
      load_acts(model.loads.acts.data()), constrained(model.constraints.record.data()),
      pxx(model.constraints.pxx.data()), pxy(model.constraints.pxy.data()),
      pyy(model.constraints.pyy.data()), wx(model.constraints.wx.data()),
      wy(model.constraints.wy.data()), rx(model.constraints.rx.data()),
      ry(model.constraints.ry.data()) {}

}  // namespace percolith::mechanics
