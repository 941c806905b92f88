// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace percolith::mechanics {
namespace {

// A place further out than this comes from a motion that has blown up.
constexpr double farthest = 1e100;
// Cells, and entries of all cells together, for each box.
constexpr double most_cells = 4.0;
constexpr double most_entries = 16.0;

Index cell_number(double offset, double size, Index cells) {
  return static_cast<Index>(std::clamp(offset / size, 0.0, static_cast<double>(cells - 1)));
}

}  // namespace

Box box_of(const PlacedTriangle& triangle, double gap) {
  const Point corner = triangle.origin + triangle.shift;
  const auto [x_low, x_high] = std::minmax({0.0, triangle.leg_1.x, triangle.leg_2.x});
  const auto [y_low, y_high] = std::minmax({0.0, triangle.leg_1.y, triangle.leg_2.y});
  const Box box{{corner.x + x_low - gap, corner.y + y_low - gap},
                {corner.x + x_high + gap, corner.y + y_high + gap}};
  const auto inside = [](const Point& p) {
    return std::abs(p.x) < farthest && std::abs(p.y) < farthest;
  };
  const bool finite = inside(corner) && inside(triangle.leg_1) && inside(triangle.leg_2);
  return finite ? box : Box{};
}

CellGrid::CellGrid(std::span<const Box> boxes) {
  choose_cells(boxes);
  fill(boxes);
}

CellGrid::Range CellGrid::range_of(const Box& box) const {
  if (box.empty()) {
    return {};
  }
  return {cell_number(box.low.x - low_.x, size_, columns_),
          cell_number(box.high.x - low_.x, size_, columns_),
          cell_number(box.low.y - low_.y, size_, rows_),
          cell_number(box.high.y - low_.y, size_, rows_)};
}

void CellGrid::resize(double size, const Point& extent) {
  constexpr double most = 1 << 20;
  size_ = size;
  columns_ = static_cast<Index>(std::min(extent.x / size, most)) + 1;
  rows_ = static_cast<Index>(std::min(extent.y / size, most)) + 1;
}

void CellGrid::choose_cells(std::span<const Box> boxes) {
  Box all{{farthest, farthest}, {-farthest, -farthest}};
  double sum = 0.0;
  double count = 0.0;
  for (const Box& box : boxes) {
    if (!box.empty()) {
      all.low = {std::min(all.low.x, box.low.x), std::min(all.low.y, box.low.y)};
      all.high = {std::max(all.high.x, box.high.x), std::max(all.high.y, box.high.y)};
      sum += std::max(box.high.x - box.low.x, box.high.y - box.low.y);
      count += 1.0;
    }
  }
  if (!(sum > 0.0)) {
    return;
  }
  low_ = all.low;
  const Point extent = all.high - all.low;
  resize(sum / count, extent);
  const auto too_many = [&] {
    return static_cast<double>(columns_) * static_cast<double>(rows_) > most_cells * count + 16.0 ||
           entries(boxes) > most_entries * count + 16.0;
  };
  while (too_many() && (columns_ > 1 || rows_ > 1)) {
    resize(1.5 * size_, extent);
  }
}

double CellGrid::entries(std::span<const Box> boxes) const {
  double sum = 0.0;
  for (const Box& box : boxes) {
    const Range r = range_of(box);
    sum += static_cast<double>(r.last_column - r.first_column + 1) *
           static_cast<double>(r.last_row - r.first_row + 1);
  }
  return sum;
}

void CellGrid::fill(std::span<const Box> boxes) {
  const auto visit = [&](const auto& add) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Range r = range_of(boxes[i]);
      for (Index row = r.first_row; row <= r.last_row; ++row) {
        for (Index column = r.first_column; column <= r.last_column; ++column) {
          add(at(row * columns_ + column), static_cast<Index>(i));
        }
      }
    }
  };
  cells_.start.assign(at(columns_ * rows_) + 1, 0);
  visit([&](std::size_t cell, Index) { ++cells_.start[cell + 1]; });
  std::partial_sum(cells_.start.begin(), cells_.start.end(), cells_.start.begin());
  cells_.entry.resize(at(cells_.start.back()));
  std::vector<Index> next(cells_.start.begin(), cells_.start.end() - 1);
  visit([&](std::size_t cell, Index i) { cells_.entry[at(next[cell]++)] = i; });
}

}  // namespace percolith::mechanics
