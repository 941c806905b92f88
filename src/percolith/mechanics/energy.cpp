// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/energy.hpp"

#include "percolith/mechanics/closed_joints.hpp"
#include "percolith/mechanics/joint_points.hpp"
#include "percolith/mechanics/strain.hpp"

namespace percolith::mechanics {

double elastic_energy(const Model& model, const Execution& execution, double back) {
  return execution.sum(model.mesh.triangles(), [&](Index t) {
    if (model.triangles.inverse_mass[at(t)] == 0.0) {
      return 0.0;
    }
    const TriangleStrain strained = triangle_strain(model, t, back);
    const auto& stiffness = model.material[at(model.triangles.material[at(t)])].stiffness;
    const Tensor& e = strained.strain;
    const Tensor s = material::stress_of(stiffness, e);
    double density = 0.5 * (s.xx * e.xx + s.yy * e.yy + 2.0 * s.xy * e.xy);
    if (!model.triangles.initial_xx.empty()) {
      density += model.triangles.initial_xx[at(t)] * e.xx +
                 model.triangles.initial_yy[at(t)] * e.yy +
                 2.0 * model.triangles.initial_xy[at(t)] * e.xy;
    }
    return density * model.mesh.area(t);
  });
}

double stored_in_joints(const Model& model, const JointTable& table, const Execution& execution,
                        double back) {
  const double bonded = execution.sum(model.mesh.joints(), [&](Index j) {
    if (model.joints.state[at(j)] != JointState::bonded) {
      return 0.0;
    }
    const JointPoints points = joint_points(model, table, j, back);
    double stored = 0.0;
    for (std::size_t g = 0; g < 2; ++g) {
      stored += material::stored_energy(points.traction[g], points.opening[g], points.slip[g]);
    }
    return 0.5 * model.mesh.joint_length(j) * stored;
  });
  return bonded + stored_in_closed_joints(model, back);
}

EnergyBalance energy_balance(const Model& model, const JointTable& table, const EnergyStart& start,
                             double contact_friction, const Execution& execution) {
  const Energies& e = model.energy;
  const double back = model.motion.last_step;
  const auto& [joint, contact, load, gravity, support] = e.ahead;
  EnergyBalance b;
  b.kinetic = e.kinetic;
  b.elastic = elastic_energy(model, execution, back);
  b.joint = stored_in_joints(model, table, execution, back);
  const double absorbed = e.absorbed.total() - e.absorbed_ahead;
  b.absorbed = absorbed + e.taken_out.total() + e.joints_taken_out.total();
  b.damping = (e.damping.total() - e.damping_ahead) + (e.viscous.total() - e.viscous_ahead);
  b.gravity = e.gravity_work.total() - gravity;
  b.external = (e.load_work.total() - load) + absorbed + (e.support_work.total() - support);
  b.friction = contact_friction + e.closed_friction.total();
  const double handed = e.handed_over.total();
  b.contact = handed - (e.contact_work.total() - contact) - contact_friction;
  b.fracture = -(e.joint_work.total() - joint) - (b.joint - start.joint) -
               e.closed_friction.total() - handed - e.joints_taken_out.total();
  b.residual =
      b.gravity + b.external -
      ((b.kinetic - start.kinetic) + (b.elastic - start.elastic) + (b.joint - start.joint) +
       b.fracture + b.contact + b.friction + b.damping + b.absorbed);
  return b;
}

}  // namespace percolith::mechanics
