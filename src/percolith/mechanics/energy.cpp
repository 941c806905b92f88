// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/energy.hpp"

#include "percolith/mechanics/closed_joints.hpp"
#include "percolith/mechanics/joint_points.hpp"
#include "percolith/mechanics/pressed_faces.hpp"

namespace percolith::mechanics {

double elastic_energy_of(const Model& model, Index t) {
  const auto u = load_corners<ScalarLane>(model.motion.ux.data(), model.motion.uy.data(),
                                          mesh::corner_of(t, 0));
  return SolidForces(model).strain_energy<ScalarLane>(t, u);
}

double elastic_energy(const Model& model, const Displacements& u, Execution& execution) {
  return execution.sum_each<1>("energies", model.mesh.triangles(), StrainEnergy(model, u)).sum[0];
}

JointEnergy energy_in_joints(const Model& model, const JointTable& table, const Displacements& u,
                             Execution& execution) {
  const auto held =
      execution.sum_each<bond_terms>("energies", model.mesh.joints(), BondEnergy(model, table, u));
  return {held.sum[static_cast<std::size_t>(BondTerm::stored)],
          held.sum[static_cast<std::size_t>(BondTerm::fluid)]};
}

double stored_in_joints(const Model& model, const JointTable& table, Execution& execution) {
  const Displacements now = displacements_before(model, 0.0);
  return energy_in_joints(model, table, now, execution).stored + stored_in_closed_joints(model);
}

/// What bonds that soften and their friction lost in the last half step, J/m.
static material::JointLoss<double> lost_in_bonds(const Model& model, const JointTable& table,
                                                 double back) {
  CompensatedSum bond;
  CompensatedSum friction;
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    bond += model.joints.past.spent[at(j)];
    friction += model.joints.past.rubbed[at(j)];
    const material::JointLoss<double> lost = bond_loss_since(model, table, j, back);
    bond += lost.bond;
    friction += lost.friction;
  }
  return {bond.total(), friction.total()};
}

EnergyBalance energy_balance(const Model& model, const JointTable& table, const EnergyStart& start,
                             const ContactEnergy& contact, const Displacements& u,
                             Execution& execution) {
  const Energies& e = model.energy;
  EnergyBalance b;
  b.kinetic = e.kinetic;
  const double half = 0.5 * model.motion.last_step;
  const JointEnergy joints = energy_in_joints(model, table, u, execution);
  const material::JointLoss<double> lost = lost_in_bonds(model, table, half);
  b.elastic = elastic_energy(model, u, execution);
  b.joint = joints.stored + stored_in_closed_joints(model, half);
  b.absorbed = e.absorbed.total() + e.taken_out.total() + e.joints_taken_out.total();
  b.damping = e.damping.total() + e.viscous.total();
  b.gravity = e.gravity_work.total();
  b.fluid = e.fluid_work.total() + joints.fluid + work_on_faces_since(model, half);
  b.external = e.load_work.total() + e.absorbed.total() + e.support_work.total();
  b.fracture = lost.bond;
  b.friction = contact.friction + e.closed_friction.total() + closed_friction_since(model, half) +
               lost.friction;
  b.contact = contact.stored;
  b.residual =
      b.gravity + b.external + b.fluid -
      ((b.kinetic - start.kinetic) + (b.elastic - start.elastic) + (b.joint - start.joint) +
       b.fracture + b.contact + b.friction + b.damping + b.absorbed);
  return b;
}

}  // namespace percolith::mechanics
