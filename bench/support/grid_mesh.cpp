// SPDX-License-Identifier: BSD-3-Clause
#include "bench/support/grid_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace percolith::bench {
namespace {

using Edge = std::array<std::int32_t, 2>;

constexpr std::int32_t lines = 9;      // fractures in each direction
constexpr double largest_shift = 0.2;  // of a cell

/// Random numbers whose sequence the C++ standard fixes, unlike its distributions.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  /// In [0, 1).
  double share() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  std::vector<std::int32_t> permutation(std::size_t n) {
    std::vector<std::int32_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = n; i > 1; --i) {
      std::swap(order[i - 1], order[static_cast<std::size_t>(share() * static_cast<double>(i))]);
    }
    return order;
  }

private:
  std::mt19937_64 engine_;
};

class Grid {
public:
  Grid(std::int32_t n, std::uint64_t seed)
      : n_(n), dice_(seed),
        number_(dice_.permutation(static_cast<std::size_t>((n + 1) * (n + 1)))) {}

  std::vector<Point> points() {
    std::vector<Point> result(number_.size());
    const double cell = 1.0 / n_;
    for (std::int32_t j = 0; j <= n_; ++j) {
      for (std::int32_t i = 0; i <= n_; ++i) {
        const bool inner = i > 0 && i < n_ && j > 0 && j < n_;
        const double scale = inner ? 2.0 * largest_shift : 0.0;
        const double x = i + scale * (dice_.share() - 0.5);
        const double y = j + scale * (dice_.share() - 0.5);
        result[static_cast<std::size_t>(point(i, j))] = {x * cell, y * cell};
      }
    }
    return result;
  }

  std::vector<std::array<std::int32_t, 3>> triangles() {
    std::vector<std::array<std::int32_t, 3>> ordered;
    ordered.reserve(static_cast<std::size_t>(2 * n_ * n_));
    for (std::int32_t j = 0; j < n_; ++j) {
      for (std::int32_t i = 0; i < n_; ++i) {
        // Diagonals alternate, so that vertices of few and of many triangles both occur.
        if ((i + j) % 2 == 0) {
          ordered.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
          ordered.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
        } else {
          ordered.push_back({point(i, j), point(i + 1, j), point(i, j + 1)});
          ordered.push_back({point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)});
        }
      }
    }
    std::vector<std::array<std::int32_t, 3>> result;
    result.reserve(ordered.size());
    for (const std::int32_t t : dice_.permutation(ordered.size())) {
      result.push_back(ordered[static_cast<std::size_t>(t)]);
    }
    return result;
  }

  std::vector<Edge> side(std::int32_t i) const {
    std::vector<Edge> edges;
    for (std::int32_t j = 0; j < n_; ++j) {
      edges.push_back({point(i, j), point(i, j + 1)});
    }
    return edges;
  }

  /// Lines from a tenth to nine tenths of the side.
  std::vector<Edge> fractures() const {
    std::vector<Edge> edges;
    for (std::int32_t line = 1; line <= lines; ++line) {
      const std::int32_t at = line * n_ / (lines + 1);
      for (std::int32_t i = n_ / (lines + 1); i < lines * n_ / (lines + 1); ++i) {
        edges.push_back({point(i, at), point(i + 1, at)});
        edges.push_back({point(at, i), point(at, i + 1)});
      }
    }
    return edges;
  }

private:
  [[nodiscard]] std::int32_t point(std::int32_t i, std::int32_t j) const {
    return number_[static_cast<std::size_t>(j * (n_ + 1) + i)];
  }
  std::int32_t n_;
  Dice dice_;
  std::vector<std::int32_t> number_;
};

}  // namespace

mesh::GmshMesh grid_mesh(std::int32_t n, std::uint64_t seed) {
  Grid grid(n, seed);
  mesh::GmshMesh mesh;
  mesh.file = "grid";
  mesh.points = grid.points();
  mesh.triangles = grid.triangles();
  mesh.triangle_region.assign(mesh.triangles.size(), 0);
  mesh.regions = {"rock"};
  mesh.curves["left"] = grid.side(0);
  mesh.curves["right"] = grid.side(n);
  mesh.curves["fractures"] = grid.fractures();
  return mesh;
}

std::int32_t cells_for(std::int32_t triangles) {
  return static_cast<std::int32_t>(std::lround(std::sqrt(0.5 * triangles)));
}

}  // namespace percolith::bench
