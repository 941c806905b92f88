// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/state.hpp"

#include "percolith/seepage/implicit_flow.hpp"

namespace percolith::seepage {

static void describe_state(StateArchive& archive, State& state) {
  archive("time", state.time);
  archive("pressure", state.pressure);
  archive("saturation", state.saturation);
  archive("content", state.content);
  archive("content_carry", state.content_carry);
  archive("storage", state.storage);
  archive("void_volume", state.void_volume);
  archive("growth", state.growth);
  archive("crack_pressure", state.crack_pressure);
  archive("crack_saturation", state.crack_saturation);
  archive("crack_content", state.crack_content);
  archive("crack_content_carry", state.crack_content_carry);
}

static void describe_state(StateArchive& archive, CrackProperties& crack) {
  archive("group", crack.group);
  archive("opening", crack.opening);
  archive("compression", crack.compression);
  archive("aperture", crack.aperture);
  archive("conductance", crack.conductance);
  archive("exchange", crack.exchange);
  archive("void_volume", crack.void_volume);
}

/// The network and the pore nodes follow from the joints that have broken.
static void rebuild_topology(Model& model) {
  std::vector<Index> broken;
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (model.crack.group[at(j)] != mesh::none) {
      broken.push_back(j);
    }
  }
  model.cracks = mesh::CrackNetwork(model.mesh);
  model.cracks.break_joints(model.mesh, broken);
  model.pore_nodes = mesh::NodeMap(model.mesh, model.tied);
}

void describe_state(StateArchive& archive, Model& model) {
  archive("tied", model.tied);
  archive("crack", model.crack);
  if (archive.reads()) {
    rebuild_topology(model);
  }
  archive("state", model.state);
  archive("schedules", model.conditions.schedule);
  archive("let_in", model.let_in);
  archive("rate", model.rate);
  archive("passed_in", model.passed_in);
  archive("passed_out", model.passed_out);
  archive("rate_in", model.rate_in);
  archive("rate_out", model.rate_out);
}

void ActiveSet::describe_state(StateArchive& archive) {
  archive("held", held_);
  archive("empty", empty_);
  archive("face_open", face_open_);
  archive("empties", empties_);
}

void ImplicitFlow::describe_state(StateArchive& archive) {
  archive("active", active_);
  archive("previous_rate", previous_rate_);
  archive("previous_dt", previous_dt_);
  if (archive.reads()) {
    // The same matrix gives the same factors: they are made again at the next step.
    factorised_dt_ = 0.0;
  }
}

}  // namespace percolith::seepage
