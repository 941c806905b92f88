// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace percolith::mechanics {
namespace {

// A place further out than this comes from a motion that has blown up.
constexpr double farthest = 1e100;
// Cells, and entries of all cells together, for each box.
constexpr double most_cells = 4.0;
constexpr double most_entries = 16.0;

Index cell_number(double cell) {
  constexpr double furthest_cell = 1e9;
  return static_cast<Index>(std::floor(std::clamp(cell, -furthest_cell, furthest_cell)));
}

Index cells_along(double extent, double size) {
  constexpr double most = 1 << 20;
  return static_cast<Index>(std::min(extent / size, most)) + 1;
}

/// Where most of the places lie: between their outer hundredths and as far again on both sides, but
/// no further than they reach.
std::pair<double, double> most_of(std::vector<double>& place) {
  const auto [least, greatest] = std::minmax_element(place.begin(), place.end());
  const std::pair<double, double> all{*least, *greatest};
  const auto rank = static_cast<std::ptrdiff_t>(place.size() / 100);
  std::nth_element(place.begin(), place.begin() + rank, place.end());
  const double low = place[static_cast<std::size_t>(rank)];
  std::nth_element(place.begin(), place.end() - 1 - rank, place.end());
  const double high = *(place.end() - 1 - rank);
  const double width = high - low;
  return {std::max(all.first, low - width), std::min(all.second, high + width)};
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

CellGrid::CellGrid(std::span<const Box> boxes) : ranges_(boxes.size()) {
  choose_cells(boxes);
  fill();
}

void CellGrid::set_ranges(std::span<const Box> boxes, double size, const Point& extent) {
  columns_ = cells_along(extent.x, size);
  rows_ = cells_along(extent.y, size);
  inverse_size_ = 1.0 / size;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].empty()) {
      ranges_[i] = range_of(boxes[i]);
    }
  }
}

CellGrid::Range CellGrid::range_of(const Box& box) const {
  const Point low = inverse_size_ * (box.low - low_);
  const Point high = inverse_size_ * (box.high - low_);
  return {cell_number(low.x), cell_number(high.x), cell_number(low.y), cell_number(high.y)};
}

bool CellGrid::too_many(double boxes) const {
  double entries = 0.0;
  for (const Range& r : ranges_) {
    entries += static_cast<double>(r.last_column - r.first_column + 1) *
               static_cast<double>(r.last_row - r.first_row + 1);
  }
  const double cells = static_cast<double>(columns_) * static_cast<double>(rows_);
  return cells > most_cells * boxes + 16.0 || entries > most_entries * boxes + 16.0;
}

void CellGrid::choose_cells(std::span<const Box> boxes) {
  std::vector<double> x;
  std::vector<double> y;
  double sum = 0.0;
  for (const Box& box : boxes) {
    if (!box.empty()) {
      x.push_back(0.5 * (box.low.x + box.high.x));
      y.push_back(0.5 * (box.low.y + box.high.y));
      sum += std::max(box.high.x - box.low.x, box.high.y - box.low.y);
    }
  }
  if (!(sum > 0.0)) {
    return;
  }
  const auto count = static_cast<double>(x.size());
  double size = sum / count;
  const auto [x_low, x_high] = most_of(x);
  const auto [y_low, y_high] = most_of(y);
  low_ = {x_low - size, y_low - size};
  const Point extent{x_high + size - low_.x, y_high + size - low_.y};
  set_ranges(boxes, size, extent);
  while (too_many(count)) {
    size *= 1.5;
    set_ranges(boxes, size, extent);
  }
}

void CellGrid::fill() {
  const auto visit = [&](const auto& add) {
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const Range& r = ranges_[i];
      for (Index row = r.first_row; row <= r.last_row; ++row) {
        for (Index column = r.first_column; column <= r.last_column; ++column) {
          add(at(inside(row, rows_) * columns_ + inside(column, columns_)), static_cast<Index>(i));
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
