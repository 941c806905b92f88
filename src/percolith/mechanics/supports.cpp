// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/supports.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace percolith::mechanics {
namespace {

/// Directions closer than this (sine of the angle) are one.
constexpr double parallel = 1e-6;

bool is_rest(const PrescribedMotion& motion) {
  // A displacement that never changes is rest too.
  return motion.value.is_constant() &&
         (motion.kind == PrescribedMotion::Kind::displacement || motion.value.value[0] == 0.0);
}

bool agree(const PrescribedMotion& a, const PrescribedMotion& b) {
  return (is_rest(a) && is_rest(b)) || (a.kind == b.kind && a.value == b.value);
}

[[noreturn]] void refuse(const Model& model, Index corner, const PrescribedMotion& a,
                         const PrescribedMotion& b) {
  const Point p = model.mesh.place_of(corner);
  throw InputError({{},
                    b.name,
                    "",
                    fmt::format("the point at ({:g}, {:g}) is over-constrained: {} prescribes "
                                "another motion there",
                                p.x, p.y, a.name),
                    "at each point two independent directions at the most, each prescribed once"});
}

/// What holds one corner of a node holds all of them.
std::vector<Held> spread_over_nodes(const Model& model, const std::vector<Held>& held) {
  std::vector<Held> spread;
  for (const Held& h : held) {
    model.nodes.for_each_corner(model.mesh, model.nodes.leader(h.corner), [&](Index corner) {
      spread.push_back({corner, h.direction, h.motion});
    });
  }
  return spread;
}

Index record_of(Model& model, Index block) {
  Constraints& c = model.constraints;
  Index& record = c.record[at(block)];
  if (record == mesh::none) {
    const auto size = c.pxx.size() + mesh::corners_per_block;
    record = static_cast<Index>(c.pxx.size() / mesh::corners_per_block);
    c.pxx.resize(size, 1.0);
    c.pyy.resize(size, 1.0);
    for (auto* values : {&c.pxy, &c.wx, &c.wy, &c.rx, &c.ry}) {
      values->resize(size, 0.0);
    }
  }
  return record;
}

}  // namespace

SupportSet::SupportSet(Model& model, std::vector<PrescribedMotion> motions, std::vector<Held> held)
    : motions_(std::move(motions)) {
  for (const PrescribedMotion& motion : motions_) {
    at_rest_ = at_rest_ && is_rest(motion);
    if (std::find(tables_.begin(), tables_.end(), motion.name) == tables_.end()) {
      tables_.push_back(motion.name);
    }
  }
  held = spread_over_nodes(model, held);
  std::stable_sort(held.begin(), held.end(),
                   [](const Held& a, const Held& b) { return a.corner < b.corner; });
  for (std::size_t i = 0; i < held.size();) {
    std::size_t end = i;
    while (end < held.size() && held[end].corner == held[i].corner) {
      ++end;
    }
    add_corner(model, std::span<const Held>(held).subspan(i, end - i));
    i = end;
  }
}

void SupportSet::add_corner(Model& model, std::span<const Held> held) {
  std::vector<Held> kept;
  for (const Held& h : held) {
    bool is_new = true;
    for (const Held& other : kept) {
      if (std::abs(cross(h.direction, other.direction)) < parallel) {
        if (!agree(motions_[at(h.motion)], motions_[at(other.motion)])) {
          refuse(model, h.corner, motions_[at(other.motion)], motions_[at(h.motion)]);
        }
        is_new = false;
      }
    }
    // What is at rest along two directions is at rest along a third.
    const auto rests = [&](const Held& k) { return is_rest(motions_[at(k.motion)]); };
    if (is_new && kept.size() == 2) {
      if (!rests(h) || !rests(kept[0]) || !rests(kept[1])) {
        refuse(model, h.corner, motions_[at(kept[0].motion)], motions_[at(h.motion)]);
      }
      is_new = false;
    }
    if (is_new) {
      kept.push_back(h);
    }
  }
  Entry entry;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto table = std::find(tables_.begin(), tables_.end(), motions_[at(kept[i].motion)].name);
    entry.table[i] = static_cast<Index>(table - tables_.begin());
    entry.direction[i] = kept[i].direction;
  }
  const Point d0 = kept[0].direction;
  Tensor free{1.0 - d0.x * d0.x, 1.0 - d0.y * d0.y, -d0.x * d0.y};
  entry.motion[0] = kept[0].motion;
  entry.along[0] = d0;
  if (kept.size() == 2) {
    const Point d1 = kept[1].direction;
    const double scale = 1.0 / cross(d0, d1);
    free = {0.0, 0.0, 0.0};
    entry.motion[1] = kept[1].motion;
    entry.along[0] = scale * Point{d1.y, -d1.x};
    entry.along[1] = scale * Point{-d0.y, d0.x};
  }
  entry.corner = kept[0].corner;
  const Index record = record_of(model, mesh::triangle_of(entry.corner) / block_width);
  entry.place = record * mesh::corners_per_block + entry.corner % mesh::corners_per_block;
  model.constraints.pxx[at(entry.place)] = free.xx;
  model.constraints.pyy[at(entry.place)] = free.yy;
  model.constraints.pxy[at(entry.place)] = free.xy;
  entries_.push_back(entry);
}

void SupportSet::apply(Model& model, double dt) const {
  if (at_rest_) {
    return;
  }
  const double t = model.motion.time;
  std::vector<double> speed(motions_.size());
  for (std::size_t i = 0; i < motions_.size(); ++i) {
    const PrescribedMotion& m = motions_[i];
    // The velocity in the middle of the step carries the corner over all of it.
    speed[i] = m.kind == PrescribedMotion::Kind::velocity
                   ? m.value.at(t + 0.5 * dt)
                   : (m.value.at(t + dt) - m.value.at(t)) / dt;
  }
  for (const Entry& entry : entries_) {
    Point w = speed[at(entry.motion[0])] * entry.along[0];
    if (entry.motion[1] != mesh::none) {
      w = w + speed[at(entry.motion[1])] * entry.along[1];
    }
    model.constraints.wx[at(entry.place)] = w.x;
    model.constraints.wy[at(entry.place)] = w.y;
  }
}

double SupportSet::next_break(double t) const {
  double next = std::numeric_limits<double>::infinity();
  for (const PrescribedMotion& motion : motions_) {
    next = std::min(next, motion.value.next_break(t));
  }
  return next;
}

bool SupportSet::moves(double t) const {
  return std::any_of(motions_.begin(), motions_.end(), [&](const PrescribedMotion& m) {
    return m.kind == PrescribedMotion::Kind::velocity && m.value.at(t) != 0.0;
  });
}

std::vector<Point> SupportSet::reactions(const Model& model) const {
  std::vector<Point> sum(tables_.size());
  for (const Entry& entry : entries_) {
    const Point force{model.constraints.rx[at(entry.place)], model.constraints.ry[at(entry.place)]};
    if (entry.table[1] == mesh::none || entry.table[1] == entry.table[0]) {
      sum[at(entry.table[0])] = sum[at(entry.table[0])] + force;
      continue;
    }
    const auto& [first, second] = entry.direction;
    const double scale = 1.0 / cross(first, second);
    Point& one = sum[at(entry.table[0])];
    Point& two = sum[at(entry.table[1])];
    one = one + scale * cross(force, second) * first;
    two = two + scale * cross(first, force) * second;
  }
  return sum;
}

std::vector<Point> SupportSet::displacements(const Model& model) const {
  std::vector<Point> sum(tables_.size());
  std::vector<double> count(tables_.size(), 0.0);
  for (const Entry& entry : entries_) {
    if (model.triangles.inverse_mass[at(mesh::triangle_of(entry.corner))] == 0.0) {
      continue;
    }
    const Point u{model.motion.ux[at(entry.corner)], model.motion.uy[at(entry.corner)]};
    for (std::size_t i = 0; i < 2; ++i) {
      if (entry.table[i] != mesh::none && (i == 0 || entry.table[1] != entry.table[0])) {
        sum[at(entry.table[i])] = sum[at(entry.table[i])] + u;
        count[at(entry.table[i])] += 1.0;
      }
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] = count[i] > 0.0 ? (1.0 / count[i]) * sum[i] : Point{};
  }
  return sum;
}

}  // namespace percolith::mechanics
