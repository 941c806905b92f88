// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_checks.hpp"
#include "percolith/mesh/gmsh_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace percolith::mesh {
namespace {

struct Box {
  Point low, high;
};

Box bounding_box(const GmshMesh& mesh) {
  Box box{mesh.points.front(), mesh.points.front()};
  for (const Point& point : mesh.points) {
    box.low = {std::min(box.low.x, point.x), std::min(box.low.y, point.y)};
    box.high = {std::max(box.high.x, point.x), std::max(box.high.y, point.y)};
  }
  return box;
}

/// Points filed by the square cell they lie in, in a hash table with open addressing. A cell is
/// twice as wide as the tolerance, so points closer than it share a cell or lie in neighbours.
class PointTable {
public:
  PointTable(const std::vector<Point>& points, const Point& origin, double tolerance)
      : points_(points), origin_(origin), tolerance_(tolerance),
        slots_(std::bit_ceil(2 * points.size()), unoccupied) {}

  /// Index of a filed point closer to point `i` than the tolerance in x and in y, else -1.
  [[nodiscard]] std::int32_t find_close(std::int32_t i) const {
    const Point scaled = cells(i);
    const double x = std::floor(scaled.x);
    const double y = std::floor(scaled.y);
    const double beside_x = scaled.x - x < 0.5 ? x - 1.0 : x + 1.0;
    const double beside_y = scaled.y - y < 0.5 ? y - 1.0 : y + 1.0;
    for (const Point& cell :
         {Point{x, y}, Point{beside_x, y}, Point{x, beside_y}, Point{beside_x, beside_y}}) {
      const std::int32_t found = find_in_cell(cell, i);
      if (found != unoccupied) {
        return found;
      }
    }
    return unoccupied;
  }

  void insert(std::int32_t i) {
    const Point scaled = cells(i);
    std::size_t slot = first_slot({std::floor(scaled.x), std::floor(scaled.y)});
    while (slots_[slot] != unoccupied) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = i;
  }

private:
  static constexpr std::int32_t unoccupied = -1;

  [[nodiscard]] const Point& point(std::int32_t i) const {
    return points_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] Point cells(std::int32_t i) const {
    return (0.5 / tolerance_) * (point(i) - origin_);
  }
  [[nodiscard]] std::size_t first_slot(const Point& cell) const {
    const auto x = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.x));
    const auto y = static_cast<std::uint64_t>(static_cast<std::int64_t>(cell.y));
    std::uint64_t hash = x * 0x9e3779b97f4a7c15U + y * 0xc2b2ae3d27d4eb4fU;
    hash ^= hash >> 29U;
    hash *= 0xbf58476d1ce4e5b9U;
    hash ^= hash >> 32U;
    return hash & (slots_.size() - 1);
  }
  [[nodiscard]] std::int32_t find_in_cell(const Point& cell, std::int32_t i) const {
    std::size_t slot = first_slot(cell);
    for (; slots_[slot] != unoccupied; slot = (slot + 1) & (slots_.size() - 1)) {
      const Point distance = point(slots_[slot]) - point(i);
      if (std::abs(distance.x) < tolerance_ && std::abs(distance.y) < tolerance_) {
        return slots_[slot];
      }
    }
    return unoccupied;
  }

  const std::vector<Point>& points_;
  Point origin_;
  double tolerance_;
  std::vector<std::int32_t> slots_;
};

}  // namespace

void check_gmsh_duplicate_points(const GmshMesh& mesh) {
  const Box box = bounding_box(mesh);
  const Point size = box.high - box.low;
  const double tolerance = 1e-8 * std::max(size.x, size.y);
  PointTable table(mesh.points, box.low, tolerance);
  const auto count = static_cast<std::int32_t>(mesh.points.size());
  for (std::int32_t i = 0; i < count; ++i) {
    if (table.find_close(i) >= 0) {
      fail_mesh({mesh.file},
                fmt::format("two points of the mesh lie at {}, so the triangles there are not "
                            "connected; write 'Coherence;' at the end of the geometry, or join "
                            "them with 'Coherence Mesh;' (RemoveDuplicateNodes), and mesh again",
                            place_text(mesh.points[static_cast<std::size_t>(i)])));
    }
    table.insert(i);
  }
}

}  // namespace percolith::mesh
