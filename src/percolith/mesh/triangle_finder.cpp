// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/triangle_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace percolith::mesh {
namespace {

/// Weights below zero by less than this are round-off.
constexpr double tolerance = 1e-10;

std::array<double, 3> weights_in(const std::array<Point, 3>& t, const Point& p) {
  const double area = cross(t[1] - t[0], t[2] - t[0]);
  return {cross(t[1] - p, t[2] - p) / area, cross(t[2] - p, t[0] - p) / area,
          cross(t[0] - p, t[1] - p) / area};
}

}  // namespace

TriangleFinder::TriangleFinder(const Mesh& mesh) : mesh_(&mesh), low_(mesh.vertex.front()) {
  Point high = low_;
  for (const Point& p : mesh.vertex) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double area = std::max((high.x - low_.x) * (high.y - low_.y), 1e-300);
  size_ = std::sqrt(area / mesh.triangles());
  columns_ = static_cast<Index>(std::min((high.x - low_.x) / size_, 1e6)) + 1;
  rows_ = static_cast<Index>(std::min((high.y - low_.y) / size_, 1e6)) + 1;
  cells_.start.assign(at(columns_ * rows_) + 1, 0);
  const auto visit = [&](const auto& add) {
    for (Index t = 0; t < mesh.triangles(); ++t) {
      const auto p = mesh.triangle_points(t);
      const auto [x_low, x_high] = std::minmax({p[0].x, p[1].x, p[2].x});
      const auto [y_low, y_high] = std::minmax({p[0].y, p[1].y, p[2].y});
      const auto first = cell_of({x_low, y_low});
      const auto last = cell_of({x_high, y_high});
      for (Index row = first[1]; row <= last[1]; ++row) {
        for (Index column = first[0]; column <= last[0]; ++column) {
          add(row * columns_ + column, t);
        }
      }
    }
  };
  visit([&](Index cell, Index) { ++cells_.start[at(cell) + 1]; });
  std::partial_sum(cells_.start.begin(), cells_.start.end(), cells_.start.begin());
  cells_.entry.resize(at(cells_.start.back()));
  std::vector<Index> next(cells_.start.begin(), cells_.start.end() - 1);
  visit([&](Index cell, Index t) { cells_.entry[at(next[at(cell)]++)] = t; });
}

std::array<Index, 2> TriangleFinder::cell_of(const Point& p) const {
  const auto clamped = [](double offset, Index cells) {
    return static_cast<Index>(std::clamp(offset, 0.0, static_cast<double>(cells - 1)));
  };
  return {clamped((p.x - low_.x) / size_, columns_), clamped((p.y - low_.y) / size_, rows_)};
}

std::optional<PlaceInTriangle> TriangleFinder::find(const Point& p) const {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
    return std::nullopt;
  }
  const auto cell = cell_of(p);
  for (const Index t : cells_.row(cell[1] * columns_ + cell[0])) {
    auto weight = weights_in(mesh_->triangle_points(t), p);
    // Asked this way round, the weights of a point so far away that they overflow fail too.
    if (!std::all_of(weight.begin(), weight.end(), [](double w) { return w >= -tolerance; })) {
      continue;
    }
    double sum = 0.0;
    for (double& w : weight) {
      w = std::max(w, 0.0);
      sum += w;
    }
    for (double& w : weight) {
      w /= sum;
    }
    return PlaceInTriangle{t, weight};
  }
  return std::nullopt;
}

}  // namespace percolith::mesh
