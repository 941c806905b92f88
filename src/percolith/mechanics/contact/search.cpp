// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/search.hpp"

#include "percolith/mechanics/contact/cell_grid.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace percolith::mechanics {
namespace {

/// True where an edge of `triangle` has the other one beyond it by more than `margin`.
bool is_beyond(const Corners& triangle, const Corners& other, double margin) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point edge = triangle[(i + 1) % 3] - triangle[i];
    const double nearest =
        std::max({beside_edge(triangle, i, other[0]), beside_edge(triangle, i, other[1]),
                  beside_edge(triangle, i, other[2])});
    if (nearest < 0.0 && nearest * nearest > margin * margin * dot(edge, edge)) {
      return true;
    }
  }
  return false;
}

/// Calls `visit(b)` once for every b > a whose box meets that of a.
template <class Visit>
void for_each_partner(const CellGrid& grid, std::span<const Box> boxes, Index a,
                      const Visit& visit) {
  const CellGrid::Range own = grid.range_of(a);
  const Box box = boxes[at(a)];
  for (Index row = own.first_row; row <= own.last_row; ++row) {
    for (Index column = own.first_column; column <= own.last_column; ++column) {
      Index last = a;
      for (const Index b : grid.cell(column, row)) {
        if (b <= last || !boxes_meet(box, boxes[at(b)])) {
          continue;
        }
        last = b;
        // Of the cells that both are in, the first one counts.
        const CellGrid::Range& other = grid.range_of(b);
        if (column == std::max(own.first_column, other.first_column) &&
            row == std::max(own.first_row, other.first_row)) {
          visit(b);
        }
      }
    }
  }
}

/// Calls `visit(i)` for the boxes that meet another one, maybe more than once.
template <class Visit>
void for_each_box(const CellGrid& grid, std::span<const Box> boxes, const Box& box,
                  const Visit& visit) {
  if (box.empty()) {
    return;
  }
  const CellGrid::Range range = grid.range_of(box);
  for (Index row = range.first_row; row <= range.last_row; ++row) {
    for (Index column = range.first_column; column <= range.last_column; ++column) {
      for (const Index i : grid.cell(column, row)) {
        if (boxes_meet(box, boxes[at(i)])) {
          visit(i);
        }
      }
    }
  }
}

/// Counts the boxes of all cells that box a is in: no fewer than it has partners.
struct CountPartners {
  const CellGrid* grid;
  Index* count;

  void operator()(ScalarLane lane) const {
    const CellGrid::Range own = grid->range_of(lane.first);
    std::size_t found = 0;
    for (Index row = own.first_row; row <= own.last_row; ++row) {
      for (Index column = own.first_column; column <= own.last_column; ++column) {
        found += grid->cell(column, row).size();
      }
    }
    count[lane.first] = static_cast<Index>(found);
  }
};

/// Writes the partners of a that may touch it and are near, ascending, and how many they are.
struct FindPartners {
  const CellGrid* grid;
  std::span<const Box> boxes;
  std::span<const Candidate> candidates;
  std::span<const PlacedTriangle> placed;
  double margin;
  const Index* start;
  Index* partner;
  Index* count;

  void operator()(ScalarLane lane) const {
    const auto a = at(lane.first);
    Index* const first = partner + start[a];
    Index* end = first;
    for_each_partner(*grid, boxes, lane.first, [&](Index b) {
      if (may_touch(candidates[a], candidates[at(b)]) &&
          are_near(placed[a], placed[at(b)], margin)) {
        *end++ = b;
      }
    });
    std::sort(first, end);
    count[a] = static_cast<Index>(end - first);
  }
};

/// For each candidate the pairs in which it is the second one.
mesh::IndexTable second_places(const PairList& list) {
  mesh::IndexTable table;
  table.start.assign(list.start.size(), 0);
  for (const auto& pair : list.pair) {
    ++table.start[at(pair[1]) + 1];
  }
  std::partial_sum(table.start.begin(), table.start.end(), table.start.begin());
  table.entry.resize(list.pair.size());
  std::vector<Index> next(table.start.begin(), table.start.end() - 1);
  for (std::size_t p = 0; p < list.pair.size(); ++p) {
    table.entry[at(next[at(list.pair[p][1])]++)] = static_cast<Index>(p);
  }
  return table;
}

std::vector<Index> row_starts(std::span<const Index> count) {
  std::vector<Index> start(count.size() + 1, 0);
  std::partial_sum(count.begin(), count.end(), start.begin() + 1);
  return start;
}

PairList collect(std::span<const Index> start, std::span<const Index> count,
                 std::span<const Index> partner) {
  PairList list;
  list.start = row_starts(count);
  list.pair.reserve(at(list.start.back()));
  for (std::size_t a = 0; a < count.size(); ++a) {
    for (const Index b : partner.subspan(at(start[a]), at(count[a]))) {
      list.pair.push_back({static_cast<Index>(a), b});
    }
  }
  list.as_second = second_places(list);
  return list;
}

}  // namespace

bool are_near(const PlacedTriangle& a, const PlacedTriangle& b, double margin) {
  if (!boxes_meet(box_of(a, 0.5 * margin), box_of(b, 0.5 * margin))) {
    return false;
  }
  // The edges of an inverted triangle face the wrong way.
  if (!(twice_area(a) > 0.0 && twice_area(b) > 0.0)) {
    return true;
  }
  const PlacedPair pair = place_pair(a, b);
  return !is_beyond(pair.first, pair.second, margin) && !is_beyond(pair.second, pair.first, margin);
}

PairList find_pairs(std::span<const Candidate> candidates, std::span<const PlacedTriangle> placed,
                    double margin, Execution& execution) {
  const auto begin = std::chrono::steady_clock::now();
  const auto n = static_cast<Index>(candidates.size());
  std::vector<Box> boxes(candidates.size());
  std::transform(placed.begin(), placed.end(), boxes.begin(),
                 [&](const PlacedTriangle& t) { return box_of(t, 0.5 * margin); });
  const CellGrid grid(boxes);
  std::vector<Index> count(candidates.size());
  execution.book("contact search", begin);
  execution.for_each("contact search", n, CountPartners{&grid, count.data()});
  const auto middle = std::chrono::steady_clock::now();
  const std::vector<Index> start = row_starts(count);
  std::vector<Index> partner(at(start.back()));
  execution.book("contact search", middle);
  execution.for_each("contact search", n,
                     FindPartners{&grid, boxes, candidates, placed, margin, start.data(),
                                  partner.data(), count.data()});
  const auto end = std::chrono::steady_clock::now();
  PairList list = collect(start, count, partner);
  execution.book("contact search", end);
  return list;
}

std::vector<std::array<Index, 2>> find_pairs_of(std::span<const Index> triangles,
                                                std::span<const Candidate> candidates,
                                                const std::function<PlacedTriangle(Index)>& placed,
                                                double margin) {
  std::vector<Index> own;
  std::vector<Box> boxes;
  for (const Index t : triangles) {
    const auto found =
        std::lower_bound(candidates.begin(), candidates.end(), t,
                         [](const Candidate& c, Index wanted) { return c.triangle < wanted; });
    own.push_back(static_cast<Index>(found - candidates.begin()));
    boxes.push_back(box_of(placed(t), 0.5 * margin));
  }
  const CellGrid grid(boxes);
  std::vector<std::array<Index, 2>> pairs;
  for (Index c = 0; c < static_cast<Index>(candidates.size()); ++c) {
    const PlacedTriangle here = placed(candidates[at(c)].triangle);
    for_each_box(grid, boxes, box_of(here, 0.5 * margin), [&](Index i) {
      const Index a = own[at(i)];
      if (a != c && may_touch(candidates[at(a)], candidates[at(c)]) &&
          are_near(placed(triangles[at(i)]), here, margin)) {
        pairs.push_back({std::min(a, c), std::max(a, c)});
      }
    });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace percolith::mechanics
