// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/seepage/explicit_step.hpp"

#include "percolith/seepage/joint_flow.hpp"
#include "percolith/seepage/pore_contents.hpp"
#include "percolith/seepage/pore_flow.hpp"

#include <algorithm>
#include <numeric>

namespace percolith::seepage {
namespace {

double donor_weight(double flow_into_first, double s_first, double s_second) {
  return saturation_weight(flow_into_first > 0.0 ? s_second : s_first);
}

/// Flows of the broken joints: along the crack, (29), and from the crack into its faces, (33),
/// (36). Entry k of the results belongs to the k-th broken joint.
struct CrackFlow {
  const Model* model;
  double* exchange_flow;  // into the four corners of the joint
  double* crack_flow;     // from end 0 to end 1

  void operator()(ScalarLane lane) const {
    const auto k = at(lane.first);
    const auto j = at(model->cracks.broken_joints()[k]);
    const mesh::Joint& joint = model->mesh.joint[j];
    const State& s = model->state;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t end = 0; end < 2; ++end) {
        const auto face = at(joint.corner[side][end]);
        const auto node = at(joint.vertex[end]);
        double flow = model->crack.exchange[j] * (s.crack_pressure[node] - s.pressure[face]);
        flow *= donor_weight(flow, s.saturation[face], s.crack_saturation[node]);
        exchange_flow[4 * k + 2 * side + end] = flow;
      }
    }
    const auto a = at(joint.vertex[0]);
    const auto b = at(joint.vertex[1]);
    double flow = model->crack.conductance[j] * ((s.crack_pressure[a] - s.crack_pressure[b]) +
                                                 (model->crack.lift[a] - model->crack.lift[b]));
    flow *= donor_weight(flow, s.crack_saturation[b], s.crack_saturation[a]);
    crack_flow[k] = flow;
  }
};

/// Adds what a corner at a crack face receives from the one or two cracks it lies at.
struct FaceInflow {
  const CrackFace* face;
  const double* exchange_flow;
  double* inflow;

  void operator()(ScalarLane lane) const {
    const CrackFace& f = face[lane.first];
    double sum = exchange_flow[f.flow[0]];
    if (f.flow[1] != mesh::none) {
      sum += exchange_flow[f.flow[1]];
    }
    inflow[f.corner] += sum;
  }
};

/// Advances the contents of the open crack nodes by what flows along the cracks and into the faces,
/// in ascending order of joints, (30)-(32), (34).
struct CrackContents {
  Model* model;
  const mesh::IndexTable* ends;
  const double* exchange_flow;
  const double* crack_flow;
  double dt;

  void operator()(ScalarLane lane) const {
    const Index vertex = model->cracks.open_nodes()[at(lane.first)];
    double sum = 0.0;
    for (const Index entry : ends->row(lane.first)) {
      const Index k = entry / 2;
      const Index end = entry % 2;
      sum += end == 0 ? -crack_flow[k] : crack_flow[k];
      sum -= exchange_flow[4 * k + end];
      sum -= exchange_flow[4 * k + 2 + end];
    }
    CompensatedSum content{model->state.crack_content[at(vertex)],
                           model->state.crack_content_carry[at(vertex)]};
    content += sum * dt;
    set_crack_content(*model, vertex, content);
  }
};

/// Joins the entries of corners that lie at two cracks; both orders ascend.
void merge_faces(std::vector<CrackFace>& faces) {
  std::stable_sort(faces.begin(), faces.end(),
                   [](const CrackFace& a, const CrackFace& b) { return a.corner < b.corner; });
  std::size_t count = 0;
  for (const CrackFace& face : faces) {
    if (count > 0 && faces[count - 1].corner == face.corner) {
      faces[count - 1].flow[1] = face.flow[0];
    } else {
      faces[count++] = face;
    }
  }
  faces.resize(count);
}

/// Places in the list of open nodes by vertex.
std::vector<Index> open_node_numbers(const Model& model) {
  std::vector<Index> number(model.mesh.vertex.size(), mesh::none);
  Index count = 0;
  for (const Index v : model.cracks.open_nodes()) {
    number[at(v)] = count++;
  }
  return number;
}

}  // namespace

ExplicitStep::ExplicitStep(const Model& model, Fields fields)
    : fields_(fields), inflow_(at(model.mesh.corners()), 0.0) {
  if (!model.pore.joint.empty()) {
    across_ = joints_across(model);
  }
  network_changed(model);
}

void ExplicitStep::network_changed(const Model& model) {
  const auto& broken = model.cracks.broken_joints();
  if (across_.conductance.empty()) {
    blocks_ = node_blocks(model);
  } else {
    for (const Index j : broken) {
      close_joint(model, j, across_);
    }
  }
  if (fields_ == Fields::pores) {
    return;
  }
  exchange_flow_.resize(4 * broken.size());
  crack_flow_.resize(broken.size());
  faces_.clear();
  crack_ends_.start.assign(model.cracks.open_nodes().size() + 1, 0);
  const std::vector<Index> node = open_node_numbers(model);
  for (const Index j : broken) {
    for (const Index v : model.mesh.joint[at(j)].vertex) {
      ++crack_ends_.start[at(node[at(v)]) + 1];
    }
  }
  std::partial_sum(crack_ends_.start.begin(), crack_ends_.start.end(), crack_ends_.start.begin());
  crack_ends_.entry.resize(2 * broken.size());
  std::vector<Index> next(crack_ends_.start.begin(), crack_ends_.start.end() - 1);
  for (std::size_t k = 0; k < broken.size(); ++k) {
    const mesh::Joint& joint = model.mesh.joint[at(broken[k])];
    for (std::size_t end = 0; end < 2; ++end) {
      const auto slot = static_cast<Index>(4 * k + end);
      crack_ends_.entry[at(next[at(node[at(joint.vertex[end])])]++)] =
          static_cast<Index>(2 * k + end);
      faces_.push_back({joint.corner[0][end], {slot, mesh::none}});
      faces_.push_back({joint.corner[1][end], {slot + 2, mesh::none}});
    }
  }
  merge_faces(faces_);
}

void ExplicitStep::advance(Model& model, double dt, Execution& execution) {
  bookings_.clear();
  step(model, model.state.time, dt, execution, bookings_);
  book_step(model, bookings_, dt);
  model.state.time += dt;
}

void ExplicitStep::step(Model& model, double t, double dt, Execution& execution,
                        std::vector<Booking>& bookings) {
  const bool weighted = model.can_empty();
  const auto cracks = static_cast<Index>(crack_flow_.size());
  State& s = model.state;
  execution.for_each("pore flow", model.mesh.triangles(),
                     PoreFlow{s.pressure.data(), s.saturation.data(), model.pore.conductance.data(),
                              model.gravity != 0.0 ? model.pore.lift.data() : nullptr,
                              inflow_.data(), model.weight, weighted});
  if (!across_.conductance.empty()) {
    execution.for_each("joint flow", model.mesh.triangles(),
                       JointFlow{s.pressure.data(), s.saturation.data(), across_.conductance.data(),
                                 across_.start.data(), across_.end.data(), inflow_.data(),
                                 model.mesh.corners(), weighted});
  }
  execution.for_each("crack flow", cracks,
                     CrackFlow{&model, exchange_flow_.data(), crack_flow_.data()});
  execution.for_each("crack flow", static_cast<Index>(faces_.size()),
                     FaceInflow{faces_.data(), exchange_flow_.data(), inflow_.data()});
  apply_rates(model, t, dt, bookings);
  advance_pores(model, dt, execution);
  const bool with_cracks = fields_ == Fields::pores_and_cracks;
  if (with_cracks) {
    execution.for_each(
        "crack contents", static_cast<Index>(model.cracks.open_nodes().size()),
        CrackContents{&model, &crack_ends_, exchange_flow_.data(), crack_flow_.data(), dt});
  }
  apply_pressures(model, last_moment(t + dt), bookings);
  if (with_cracks) {
    apply_crack_pressures(model, last_moment(t + dt), bookings);
  }
}

void ExplicitStep::advance_pores(Model& model, double dt, Execution& execution) {
  State& s = model.state;
  const ContentViews views{s.content.data(),
                           s.content_carry.data(),
                           s.storage.data(),
                           s.void_volume.data(),
                           s.pressure.data(),
                           s.saturation.data(),
                           inflow_.data(),
                           s.growth.data(),
                           model.swelling.empty() ? nullptr : model.swelling.data(),
                           model.reference_pressure(),
                           model.can_empty(),
                           dt};
  if (across_.conductance.empty()) {
    execution.for_each("pore contents", blocks_.nodes(), BlockContents(views, blocks_));
    execution.for_each("pore contents", static_cast<Index>(blocks_.single.size()),
                       NodeContents{views, &model.mesh, &model.pore_nodes, blocks_.single.data()});
  } else {
    execution.for_each("pore contents", model.mesh.triangles(), CornerContents{views});
  }
}

void ExplicitStep::apply_rates(Model& model, double t, double dt,
                               std::vector<Booking>& bookings) const {
  const double middle = t + 0.5 * dt;
  State& s = model.state;
  for (const NodeCondition& c : model.conditions.pore.rate) {
    const double volume = model.conditions.value(c, middle) * dt;
    const auto node = at(model.pore_nodes.leader(c.place));
    add_compensated(s.content[node], s.content_carry[node], volume);
    bookings.push_back({c.condition, model.mesh.vertex_of(c.place), volume});
  }
  if (fields_ == Fields::pores) {
    return;
  }
  for (const NodeCondition& c : model.conditions.crack.rate) {
    const double volume = model.conditions.value(c, middle) * dt;
    add_compensated(s.crack_content[at(c.place)], s.crack_content_carry[at(c.place)], volume);
    bookings.push_back({c.condition, c.place, volume});
  }
}

void ExplicitStep::apply_pressures(Model& model, double t, std::vector<Booking>& bookings) const {
  const State& s = model.state;
  const double reference = model.reference_pressure();
  const auto pore = [&](const NodeCondition& c, double pressure) {
    const Index node = model.pore_nodes.leader(c.place);
    const double target = s.storage[at(node)] * (pressure - reference) + s.growth[at(node)];
    const double volume = (target - s.content[at(node)]) - s.content_carry[at(node)];
    set_pore_content(model, node, {target, 0.0});
    bookings.push_back({c.condition, model.mesh.vertex_of(c.place), volume});
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
}

void ExplicitStep::apply_crack_pressures(Model& model, double t,
                                         std::vector<Booking>& bookings) const {
  const State& s = model.state;
  const double reference = model.reference_pressure();
  const auto crack = [&](const NodeCondition& c, double pressure) {
    const double target = model.crack_storage(c.place) * (pressure - reference);
    const double volume =
        (target - s.crack_content[at(c.place)]) - s.crack_content_carry[at(c.place)];
    set_crack_content(model, c.place, {target, 0.0});
    bookings.push_back({c.condition, c.place, volume});
  };
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
