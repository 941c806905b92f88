// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/contact/placed_triangle.hpp"
#include "percolith/mesh/mesh.hpp"

#include <span>
#include <vector>

namespace percolith::mechanics {

using mesh::Index;

/// An axis-parallel box, m; empty where low exceeds high.
struct Box {
  Point low{1e100, 1e100};
  Point high{-1e100, -1e100};
  [[nodiscard]] bool empty() const { return !(low.x <= high.x && low.y <= high.y); }
};

/// The box round a triangle, wider by `gap` on each side; empty where it is not finite.
[[nodiscard]] Box box_of(const PlacedTriangle& triangle, double gap);

inline bool boxes_meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Boxes sorted into the cells of a uniform grid; a box is in every cell it meets. The grid has
/// room for the cells of a window that holds most boxes and goes on beyond it: further cells share
/// the room of those inside, column by column and row by row, so that boxes far away, few or many,
/// put neither many boxes into one cell nor all others into coarse ones.
class CellGrid {
public:
  /// Cells have about the mean size of the boxes, more where a few boxes are so large that they
  /// would be in more cells than there are boxes.
  explicit CellGrid(std::span<const Box> boxes);

  /// First and last column and row that a box meets; any numbers.
  struct Range {
    Index first_column = 0, last_column = -1, first_row = 0, last_row = -1;
  };
  [[nodiscard]] const Range& range_of(Index box) const { return ranges_[at(box)]; }
  /// The same of any box that is not empty.
  [[nodiscard]] Range range_of(const Box& box) const;
  /// Boxes in a cell and in those it shares its room with, ascending; a box may be given more than
  /// once in a row.
  [[nodiscard]] std::span<const Index> cell(Index column, Index row) const {
    return cells_.row(inside(row, rows_) * columns_ + inside(column, columns_));
  }

private:
  /// The number within the window that a column or row shares its room with.
  static Index inside(Index number, Index count) {
    if (number >= 0 && number < count) {
      return number;
    }
    const Index rest = number % count;
    return rest < 0 ? rest + count : rest;
  }
  void choose_cells(std::span<const Box> boxes);
  void set_ranges(std::span<const Box> boxes, double size, const Point& extent);
  [[nodiscard]] bool too_many(double boxes) const;
  void fill();

  Point low_;
  double inverse_size_ = 0.0;  // 1/m
  Index columns_ = 1, rows_ = 1;
  std::vector<Range> ranges_;
  mesh::IndexTable cells_;
};

}  // namespace percolith::mechanics
