// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/condition_list.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace percolith::simulation {
namespace {

using mesh::Index;
using seepage::NodeCondition;

/// What helps where a condition asks for a pressure below the cavitation pressure.
constexpr const char* ways_to_press_enough =
    "pressures not below fluid.cavitation_pressure, a seepage_face, or "
    "fluid.cavitation_pressure = \"-inf\"";
constexpr const char* ways_to_end_at_the_head =
    "a head not below the top of the boundary: split it in the mesh into a wet part, which keeps "
    "the head, and the part above, without a condition or with seepage_face = 0 where water may "
    "come out; or fluid.cavitation_pressure = \"-inf\"";

/// Whether crack and facing pores at a vertex have one pressure by infinite exchange.
bool shares_pressure(const seepage::Model& model, Index vertex) {
  const auto joints = model.mesh.vertex_joints.row(vertex);
  return std::any_of(joints.begin(), joints.end(), [&](Index j) {
    return model.cracks.is_broken(j) && std::isinf(model.crack.exchange[at(j)]);
  });
}

/// What helps where two conditions prescribe different pressures at a vertex.
std::string ways_to_agree(const seepage::Model& model, Index vertex) {
  const auto joints = model.mesh.vertex_joints.row(vertex);
  const bool has_crack =
      std::any_of(joints.begin(), joints.end(), [&](Index j) { return model.cracks.is_broken(j); });
  if (has_crack && !shares_pressure(model, vertex)) {
    return "one pressure per place; end one of the groups an edge earlier, give both the same "
           "value there, or limit a boundary table with on = \"matrix\" or \"crack\"";
  }
  return "one pressure per place; end one of the groups an edge earlier, or give both the same "
         "value there";
}

/// The times at which two schedules must agree to agree always; a step function jumps, so just
/// before a break counts too.
std::set<double> decisive_times(const Schedule& a, const Schedule& b) {
  std::set<double> times{0.0};
  for (const Schedule* s : {&a, &b}) {
    for (const double t : s->time) {
      times.insert(t);
      times.insert(std::nextafter(t, -1.0));
    }
  }
  return times;
}

}  // namespace

void ConditionList::begin(const std::string& name, const std::string& option,
                          const Schedule& schedule) {
  conditions_.name.push_back(name);
  conditions_.schedule.push_back(schedule);
  conditions_.option.push_back(option);
}

std::string ConditionList::key() const {
  return fmt::format("{}.{}", conditions_.name.back(), conditions_.option.back());
}

NodeCondition ConditionList::present(Index place, double factor, double offset) const {
  const auto number = static_cast<Index>(conditions_.name.size()) - 1;
  return {place, number, number, factor, offset};
}

void ConditionList::check_cavitation(Index vertex, const NodeCondition& condition) const {
  if (!model_->can_empty()) {
    return;
  }
  const double limit = model_->reference_pressure();
  const Schedule& schedule = conditions_.schedule.back();
  const auto lowest = std::min_element(schedule.value.begin(), schedule.value.end());
  const double pressure = condition.factor * *lowest + condition.offset;
  // Heads and pressures of equal meaning differ by round-off.
  const double tolerance = 1e-9 * (std::abs(condition.offset) + std::abs(limit));
  if (pressure < limit - tolerance) {
    const Point p = model_->mesh.vertex[at(vertex)];
    throw InputError(
        {{},
         key(),
         "",
         fmt::format("prescribes {:.6g} Pa at ({:g}, {:g}), below the cavitation "
                     "pressure of {:.6g} Pa",
                     pressure, p.x, p.y, limit),
         conditions_.option.back() == "head" ? ways_to_end_at_the_head : ways_to_press_enough});
  }
}

bool ConditionList::claim_vertex(Owners& owners, const Owners& others, Index vertex,
                                 const NodeCondition& condition) {
  check_cavitation(vertex, condition);
  const auto [found, is_new] = owners.emplace(vertex, condition);
  if (!is_new) {
    require_agreement(vertex, condition, found->second);
  }
  const auto other = others.find(vertex);
  if (other != others.end() && shares_pressure(*model_, vertex)) {
    require_agreement(vertex, condition, other->second);
  }
  return is_new;
}

void ConditionList::require_agreement(Index vertex, const NodeCondition& condition,
                                      const NodeCondition& other) const {
  const Schedule& mine = conditions_.schedule.back();
  const Schedule& theirs = conditions_.schedule[at(other.schedule)];
  for (const double t : decisive_times(mine, theirs)) {
    const double a = conditions_.value(condition, t);
    const double b = conditions_.value(other, t);
    const double scale = std::max({std::abs(a), std::abs(b), std::abs(condition.offset)});
    if (std::abs(a - b) > 1e-9 * scale) {
      const Point p = model_->mesh.vertex[at(vertex)];
      throw InputError({{},
                        key(),
                        "",
                        fmt::format("prescribes {:.6g} Pa at ({:g}, {:g}), where {}.{} prescribes "
                                    "{:.6g} Pa (at time {:g} s)",
                                    a, p.x, p.y, conditions_.name[at(other.condition)],
                                    conditions_.option[at(other.condition)], b, std::max(t, 0.0)),
                        ways_to_agree(*model_, vertex)});
    }
  }
}

seepage::Conditions ConditionList::take() {
  std::erase_if(conditions_.pore.seepage_face, [&](const NodeCondition& c) {
    return pore_owner_.contains(model_->mesh.vertex_of(c.place));
  });
  std::erase_if(conditions_.crack.seepage_face,
                [&](const NodeCondition& c) { return crack_owner_.contains(c.place); });
  return std::move(conditions_);
}

void ConditionList::prescribe_pores(Index vertex, double factor, double offset) {
  if (claim_vertex(pore_owner_, crack_owner_, vertex, present(vertex, factor, offset))) {
    for (const Index corner : model_->mesh.vertex_corners.row(vertex)) {
      conditions_.pore.pressure.push_back(present(corner, factor, offset));
    }
  }
}

void ConditionList::prescribe_crack(Index vertex, double factor, double offset) {
  if (claim_vertex(crack_owner_, pore_owner_, vertex, present(vertex, factor, offset))) {
    conditions_.crack.pressure.push_back(present(vertex, factor, offset));
  }
}

void ConditionList::seepage_face_pores(Index vertex) {
  if (claim_vertex(pore_face_, crack_face_, vertex, present(vertex, 1.0, 0.0))) {
    for (const Index corner : model_->mesh.vertex_corners.row(vertex)) {
      conditions_.pore.seepage_face.push_back(present(corner, 1.0, 0.0));
    }
  }
}

void ConditionList::seepage_face_crack(Index vertex) {
  if (claim_vertex(crack_face_, pore_face_, vertex, present(vertex, 1.0, 0.0))) {
    conditions_.crack.seepage_face.push_back(present(vertex, 1.0, 0.0));
  }
}

void ConditionList::rate_into_corner(Index corner, double factor) {
  conditions_.pore.rate.push_back(present(corner, factor, 0.0));
}

void ConditionList::rate_into_crack(Index vertex, double factor) {
  conditions_.crack.rate.push_back(present(vertex, factor, 0.0));
}

void ConditionList::claim_edge(Index edge, const std::string& key) {
  const auto number = static_cast<Index>(conditions_.name.size()) - 1;
  const auto [found, is_new] = edge_owner_.emplace(edge, number);
  if (!is_new) {
    const Point p = model_->mesh.middle_of(model_->mesh.boundary[at(edge)].vertex);
    throw InputError({{},
                      key,
                      "",
                      fmt::format("its edge at ({:g}, {:g}) already has the condition {}", p.x, p.y,
                                  conditions_.name[at(found->second)]),
                      "each boundary edge in one boundary table"});
  }
}

}  // namespace percolith::simulation
