// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/state.hpp"

#include "percolith/mechanics/dynamics.hpp"

namespace percolith::mechanics {

static void describe_state(StateArchive& archive, JointPast& past) {
  archive("opening", past.opening);
  archive("slip", past.slip);
  archive("normal", past.normal);
  archive("shear", past.shear);
  archive("slope", past.slope);
  archive("friction", past.friction);
  archive("spent", past.spent);
  archive("rubbed", past.rubbed);
}

static void describe_state(StateArchive& archive, Joints& joints) {
  archive("stiffness", joints.stiffness);
  archive("opening_peak", joints.opening_peak);
  archive("slip_peak", joints.slip_peak);
  archive("damage", joints.damage);
  archive("past", joints.past);
  archive("condition", joints.condition);
  archive("state", joints.state);
  archive("force", joints.force);
}

/// Excavation takes mass and weight.
static void describe_state(StateArchive& archive, Triangles& triangles) {
  archive("inverse_mass", triangles.inverse_mass);
  archive("weight", triangles.weight);
}

static void describe_state(StateArchive& archive, ClosedJoint& closed) {
  archive("joint", closed.joint);
  archive("stiffness", closed.stiffness);
  archive("friction", closed.friction);
  archive("shear", closed.shear);
  archive("slip", closed.slip);
  archive("slip_at_start", closed.slip_at_start);
  archive("turn", closed.turn);
  archive("loss", closed.loss);
  archive("ended", closed.ended);
}

static void describe_state(StateArchive& archive, Motion& motion) {
  archive("time", motion.time);
  archive("last_step", motion.last_step);
  archive("ux", motion.ux);
  archive("uy", motion.uy);
  archive("vx", motion.vx);
  archive("vy", motion.vy);
}

static void describe_state(StateArchive& archive, Constraints& constraints) {
  archive("wx", constraints.wx);
  archive("wy", constraints.wy);
  archive("rx", constraints.rx);
  archive("ry", constraints.ry);
}

static void describe_state(StateArchive& archive, Loads& loads) {
  archive("fx", loads.fx);
  archive("fy", loads.fy);
  archive("acts", loads.acts);
}

static void describe_state(StateArchive& archive, Energies& energy) {
  archive("kinetic", energy.kinetic);
  archive("load_work", energy.load_work);
  archive("gravity_work", energy.gravity_work);
  archive("support_work", energy.support_work);
  archive("fluid_work", energy.fluid_work);
  archive("damping", energy.damping);
  archive("viscous", energy.viscous);
  archive("absorbed", energy.absorbed);
  archive("closed_friction", energy.closed_friction);
  archive("taken_out", energy.taken_out);
  archive("joints_taken_out", energy.joints_taken_out);
  archive("unbalanced", energy.unbalanced);
  archive("internal", energy.internal);
}

static void describe_state(StateArchive& archive, PoreFluid& pores) {
  archive("growth", pores.growth);
  archive("joint_share", pores.joint_share);
  archive("push", pores.push);
  archive("opening", pores.opening);
}

static void describe_state(StateArchive& archive, PressedFaces& faces) {
  archive("joint", faces.joint);
  archive("pressure", faces.pressure);
  archive("opening", faces.opening);
  archive("compression", faces.compression);
  archive("across", faces.across);
  archive("last_pressure", faces.last_pressure);
  archive("last_opening", faces.last_opening);
}

void describe_state(StateArchive& archive, Model& model) {
  archive("triangles", model.triangles);
  archive("joints", model.joints);
  archive.of_any_size("closed", model.closed);
  archive("tied", model.tied);
  archive("bonded", model.bonded);
  archive("constraints", model.constraints);
  archive("loads", model.loads);
  archive("pores", model.pores);
  archive.of_any_size("pressed", model.pressed);
  archive("motion", model.motion);
  archive("energy", model.energy);
  if (archive.reads()) {
    model.nodes = mesh::NodeMap(model.mesh, model.tied);
    model.fans = mesh::NodeMap(model.mesh, model.bonded);
  }
}

static void describe_state(StateArchive& archive, CornerForce& force) {
  archive("corner", force.corner);
  archive("force", force.force);
}

static void describe_state(StateArchive& archive, FadingSupport& support) {
  archive("start", support.start);
  archive("duration", support.duration);
  archive.of_any_size("force", support.force);
  archive("pressure", support.pressure);
  archive.of_any_size("wall", support.wall);
}

void LoadSet::describe_state(StateArchive& archive, const mesh::Mesh& mesh) {
  archive.of_any_size("fading", list_.fading);
  if (archive.reads()) {
    find_corners(mesh);
  }
  archive("drag", drag_);
}

static void describe_state(StateArchive& archive, EnergyStart& start) {
  archive("kinetic", start.kinetic);
  archive("elastic", start.elastic);
  archive("joint", start.joint);
}

void Dynamics::describe_state(StateArchive& archive) {
  archive("model", model_);
  loads_.describe_state(archive, model_.mesh);
  contact_.describe_state(archive);
  archive("candidate", candidate_);
  archive("faces_touch", faces_touch_);
  archive("start", start_);
  archive("travelled", travelled_);
}

}  // namespace percolith::mechanics
