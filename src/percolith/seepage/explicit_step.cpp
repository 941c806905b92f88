// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/explicit_step.hpp"

#include "percolith/seepage/pore_flow.hpp"

#include <algorithm>

namespace percolith::seepage {
namespace {

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

double donor_weight(double flow_into_first, double s_first, double s_second) {
  return saturation_weight(flow_into_first > 0.0 ? s_second : s_first);
}

/// Flows through a joint: between the pore nodes of its two sides while it is unbroken, (20)-(22);
/// along the crack, (29), and from the crack into its faces, (33), (36), once it is broken.
struct JointFlow {
  const Model* model;
  const Index* active;
  double* joint_flow;
  double* crack_flow;

  void operator()(ScalarLane lane) const {
    const Index j = active[lane.first];
    if (model->cracks.is_broken(j)) {
      broken(j);
    } else {
      finite(j);
    }
  }

private:
  void finite(Index j) const {
    const auto& corner = model->mesh.joint[at(j)].corner;
    const State& s = model->state;
    for (std::size_t end = 0; end < 2; ++end) {
      const auto a = at(corner[0][end]);
      const auto b = at(corner[1][end]);
      double flow = model->pore.joint[at(j)] * (s.pressure[b] - s.pressure[a]);
      flow *= donor_weight(flow, s.saturation[a], s.saturation[b]);
      joint_flow[4 * at(j) + end] = flow;
      joint_flow[4 * at(j) + 2 + end] = -flow;
    }
  }

  void broken(Index j) const {
    const mesh::Joint& joint = model->mesh.joint[at(j)];
    const State& s = model->state;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t end = 0; end < 2; ++end) {
        const auto face = at(joint.corner[side][end]);
        const auto node = at(joint.vertex[end]);
        double flow = model->crack.exchange[at(j)] * (s.crack_pressure[node] - s.pressure[face]);
        flow *= donor_weight(flow, s.saturation[face], s.crack_saturation[node]);
        joint_flow[4 * at(j) + 2 * side + end] = flow;
      }
    }
    const auto a = at(joint.vertex[0]);
    const auto b = at(joint.vertex[1]);
    double flow = model->crack.conductance[at(j)] * ((s.crack_pressure[a] - s.crack_pressure[b]) +
                                                     (model->crack.lift[a] - model->crack.lift[b]));
    flow *= donor_weight(flow, s.crack_saturation[b], s.crack_saturation[a]);
    crack_flow[j] = flow;
  }
};

/// Gathers the inflow of the pore nodes at a vertex in ascending order of corners, then joints,
/// and advances their contents, (23), (24).
struct PoreContents {
  Model* model;
  const double* inflow;
  const double* joint_flow;
  const std::uint8_t* active;
  const std::uint8_t* whole;
  double reference_pressure;
  bool can_empty;
  double dt;

  void operator()(ScalarLane lane) const {
    const auto corners = model->mesh.vertex_corners.row(lane.first);
    if (corners.empty()) {
      return;
    }
    const bool joints = active[lane.first] != 0;
    if (whole[lane.first] != 0 && !joints) {
      double sum = 0.0;
      for (const Index c : corners) {
        sum += inflow[c];
      }
      const auto fluid = advance(corners.front(), sum);
      for (const Index c : corners) {
        model->state.pressure[at(c)] = fluid.pressure;
        model->state.saturation[at(c)] = fluid.saturation;
      }
      return;
    }
    for (const Index node : corners) {
      if (model->pore_nodes.leader(node) == node) {
        const auto fluid = advance(node, node_inflow(lane.first, node));
        for (const Index c : corners) {
          if (model->pore_nodes.leader(c) == node) {
            model->state.pressure[at(c)] = fluid.pressure;
            model->state.saturation[at(c)] = fluid.saturation;
          }
        }
      }
    }
  }

private:
  [[nodiscard]] double node_inflow(Index vertex, Index node) const {
    double sum = 0.0;
    model->pore_nodes.for_each_corner(model->mesh, node, [&](Index c) { sum += inflow[c]; });
    if (active[vertex] == 0) {
      return sum;
    }
    for (const Index j : model->mesh.vertex_joints.row(vertex)) {
      if (model->pore.joint.empty() && !model->cracks.is_broken(j)) {
        continue;
      }
      const auto end = at(model->mesh.joint_end(j, vertex));
      for (std::size_t side = 0; side < 2; ++side) {
        if (model->pore_nodes.leader(model->mesh.joint[at(j)].corner[side][end]) == node) {
          sum += joint_flow[4 * at(j) + 2 * side + end];
        }
      }
    }
    return sum;
  }

  [[nodiscard]] FluidState<double> advance(Index node, double sum) const {
    State& s = model->state;
    const auto i = at(node);
    add_compensated(s.content[i], s.content_carry[i], sum * dt);
    return fluid_state(s.content[i] + s.content_carry[i], 0.0, s.storage[i], s.void_volume[i],
                       reference_pressure, can_empty);
  }
};

/// Gathers the inflow of an open crack node and advances its content, (30)-(32), (34).
struct CrackContents {
  Model* model;
  const double* joint_flow;
  const double* crack_flow;
  double dt;

  void operator()(ScalarLane lane) const {
    const Index vertex = model->cracks.open_nodes()[at(lane.first)];
    double sum = 0.0;
    for (const Index j : model->mesh.vertex_joints.row(vertex)) {
      if (!model->cracks.is_broken(j)) {
        continue;
      }
      const auto end = at(model->mesh.joint_end(j, vertex));
      sum += end == 0 ? -crack_flow[j] : crack_flow[j];
      sum -= joint_flow[4 * at(j) + end];
      sum -= joint_flow[4 * at(j) + 2 + end];
    }
    CompensatedSum content{model->state.crack_content[at(vertex)],
                           model->state.crack_content_carry[at(vertex)]};
    content += sum * dt;
    set_crack_content(*model, vertex, content);
  }
};

/// True when no node has voids left to fill.
bool all_full(const Model& model) {
  const auto full = [](double s) { return s >= 1.0; };
  return std::all_of(model.state.saturation.begin(), model.state.saturation.end(), full) &&
         std::all_of(model.state.crack_saturation.begin(), model.state.crack_saturation.end(),
                     full);
}

}  // namespace

ExplicitStep::ExplicitStep(const Model& model) : inflow_(at(model.mesh.corners()), 0.0) {
  network_changed(model);
}

void ExplicitStep::network_changed(const Model& model) {
  active_joints_.clear();
  active_.assign(model.mesh.vertex.size(), 0);
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (!model.pore.joint.empty() || model.cracks.is_broken(j)) {
      active_joints_.push_back(j);
      active_[at(model.mesh.joint[at(j)].vertex[0])] = 1;
      active_[at(model.mesh.joint[at(j)].vertex[1])] = 1;
    }
  }
  if (!active_joints_.empty()) {
    joint_flow_.resize(4 * model.mesh.joint.size(), 0.0);
    crack_flow_.resize(model.mesh.joint.size(), 0.0);
  }
}

void ExplicitStep::advance(Model& model, double dt, Execution& execution) {
  const double t = model.state.time + dt;
  saturated_ = !model.can_empty() || all_full(model);
  std::fill(model.rate.begin(), model.rate.end(), 0.0);
  execution.for_each("pore flow", model.mesh.triangles(),
                     PoreFlow{model.state.pressure.data(), model.state.saturation.data(),
                              model.pore.conductance.data(), model.pore.lift.data(), inflow_.data(),
                              model.weight, saturated_});
  execution.for_each(
      "joint flow", static_cast<Index>(active_joints_.size()),
      JointFlow{&model, active_joints_.data(), joint_flow_.data(), crack_flow_.data()});
  apply_rates(model, dt);
  execution.for_each("pore contents", model.mesh.vertices(),
                     PoreContents{&model, inflow_.data(), joint_flow_.data(), active_.data(),
                                  model.pore_nodes.whole().data(), model.reference_pressure(),
                                  model.can_empty(), dt});
  execution.for_each("crack contents", static_cast<Index>(model.cracks.open_nodes().size()),
                     CrackContents{&model, joint_flow_.data(), crack_flow_.data(), dt});
  apply_pressures(model, dt, t);
  model.state.time = t;
}

void ExplicitStep::book(Model& model, Index condition, double volume, double dt) {
  model.let_in[at(condition)] += volume;
  model.rate[at(condition)] += volume / dt;
}

void ExplicitStep::apply_rates(Model& model, double dt) {
  const double middle = model.state.time + 0.5 * dt;
  State& s = model.state;
  for (const NodeCondition& c : model.conditions.pore.rate) {
    const double volume = model.conditions.value(c, middle) * dt;
    const auto node = at(model.pore_nodes.leader(c.place));
    add_compensated(s.content[node], s.content_carry[node], volume);
    book(model, c.condition, volume, dt);
  }
  for (const NodeCondition& c : model.conditions.crack.rate) {
    const double volume = model.conditions.value(c, middle) * dt;
    add_compensated(s.crack_content[at(c.place)], s.crack_content_carry[at(c.place)], volume);
    book(model, c.condition, volume, dt);
  }
}

void ExplicitStep::apply_pressures(Model& model, double dt, double t) {
  const State& s = model.state;
  const double reference = model.reference_pressure();
  const auto pore = [&](const NodeCondition& c, double pressure) {
    const Index node = model.pore_nodes.leader(c.place);
    const double target = s.storage[at(node)] * (pressure - reference);
    const double volume = (target - s.content[at(node)]) - s.content_carry[at(node)];
    set_pore_content(model, node, {target, 0.0});
    book(model, c.condition, volume, dt);
  };
  const auto crack = [&](const NodeCondition& c, double pressure) {
    const double target = model.crack_storage(c.place) * (pressure - reference);
    const double volume =
        (target - s.crack_content[at(c.place)]) - s.crack_content_carry[at(c.place)];
    set_crack_content(model, c.place, {target, 0.0});
    book(model, c.condition, volume, dt);
  };
  for (const NodeCondition& c : model.conditions.pore.pressure) {
    pore(c, model.conditions.value(c, t));
  }
  for (const NodeCondition& c : model.conditions.pore.seepage_face) {
    const double outside = model.conditions.value(c, t);
    if (s.pressure[at(c.place)] > outside) {
      pore(c, outside);
    }
  }
  for (const NodeCondition& c : model.conditions.crack.pressure) {
    if (model.cracks.is_open(c.place)) {
      crack(c, model.conditions.value(c, t));
    }
  }
  for (const NodeCondition& c : model.conditions.crack.seepage_face) {
    const double outside = model.conditions.value(c, t);
    if (model.cracks.is_open(c.place) && s.crack_pressure[at(c.place)] > outside) {
      crack(c, outside);
    }
  }
}

}  // namespace percolith::seepage
