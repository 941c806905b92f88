// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/contact/cell_grid.hpp"
#include "percolith/mechanics/contact/search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "unit/mechanics/test_contact_support.hpp"

namespace percolith::mechanics {
namespace {

using test::at;

std::vector<Candidate> strangers(std::size_t n) {
  std::vector<Candidate> candidates(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto t = static_cast<Index>(i);
    candidates[i] = {t,
                     {mesh::corner_of(t, 0), mesh::corner_of(t, 1), mesh::corner_of(t, 2)},
                     {mesh::none, mesh::none, mesh::none},
                     {}};
  }
  return candidates;
}

std::vector<std::array<Index, 2>> all_near(const std::vector<Candidate>& candidates,
                                           const std::vector<PlacedTriangle>& placed,
                                           double margin) {
  std::vector<std::array<Index, 2>> pairs;
  for (Index a = 0; a < static_cast<Index>(placed.size()); ++a) {
    for (Index b = a + 1; b < static_cast<Index>(placed.size()); ++b) {
      if (may_touch(candidates[at(a)], candidates[at(b)]) &&
          are_near(placed[at(a)], placed[at(b)], margin)) {
        pairs.push_back({a, b});
      }
    }
  }
  return pairs;
}

/// Distance of two triangles that do not overlap, from the corners of each to the edges of the
/// other.
double distance(const Corners& a, const Corners& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [of, to] : {std::pair{a, b}, std::pair{b, a}}) {
    for (const Point& p : of) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Point along = to[(i + 1) % 3] - to[i];
        const double share = std::clamp(dot(p - to[i], along) / dot(along, along), 0.0, 1.0);
        const Point gap = p - (to[i] + share * along);
        least = std::min(least, std::sqrt(dot(gap, gap)));
      }
    }
  }
  return least;
}

RC_GTEST_PROP(ContactSearch, FindsWhatComparingAllWithAllFinds, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(0, 200);
  std::mt19937 random(*rc::gen::arbitrary<unsigned>());
  const double spread = *rc::gen::element(0.5, 3.0, 40.0, 1e6);
  const double margin = *rc::gen::element(0.0, 0.1, 2.0);
  std::uniform_real_distribution<double> place(-spread, spread);
  std::vector<PlacedTriangle> soup;
  for (std::size_t i = 0; i < count; ++i) {
    // Now and then a platen a hundred times as large.
    const double size = *rc::gen::inRange(0, 20) == 0 ? 100.0 : 1.0;
    const Corners t = test::random_triangle(random);
    soup.push_back(
        {{place(random), place(random)}, {0.1, 0.0}, size * (t[1] - t[0]), size * (t[2] - t[0])});
  }
  const auto candidates = strangers(count);
  Execution execution;
  const PairList list = find_pairs(candidates, soup, margin, execution);
  RC_ASSERT(list.pair == all_near(candidates, soup, margin));
  for (Index c = 0; c < static_cast<Index>(count); ++c) {
    for (Index p = list.start[at(c)]; p < list.start[at(c) + 1]; ++p) {
      RC_ASSERT(list.pair[at(p)][0] == c);
    }
    for (const Index p : list.as_second.row(c)) {
      RC_ASSERT(list.pair[at(p)][1] == c);
    }
  }
  RC_ASSERT(list.as_second.entry.size() == list.pair.size());
}

TEST(ContactSearch, LeavesOutNothingThatIsNearerThanTheMargin) {
  std::mt19937 random(4);
  int near = 0;
  int left_out = 0;
  for (int i = 0; i < 3000; ++i) {
    const Corners a = test::random_triangle(random);
    const Corners b = test::random_triangle(random, {0.9, 0.4});
    const PlacedTriangle pa = test::placed(a);
    const PlacedTriangle pb = test::placed(b);
    if (distance(a, b) < 0.1) {
      ++near;
      EXPECT_TRUE(are_near(pa, pb, 0.1));
    }
    left_out += are_near(pa, pb, 0.1) ? 0 : 1;
  }
  EXPECT_GT(near, 100);
  EXPECT_GT(left_out, 500);
}

TEST(ContactSearch, OnePlatenDoesNotPutAllIntoOneCell) {
  const double n = 60.0;
  std::vector<PlacedTriangle> placed;
  for (double x = 0.0; x < n; x += 1.0) {
    for (double y = 0.0; y < n; y += 1.0) {
      placed.push_back({{x, y}, {}, {0.9, 0.0}, {0.0, 0.9}});
    }
  }
  placed.push_back({{0.0, -500.0}, {}, {500.0, 0.0}, {0.0, 499.95}});
  std::vector<Box> boxes;
  for (const PlacedTriangle& t : placed) {
    boxes.push_back(box_of(t, 0.05));
  }
  const CellGrid grid(boxes);
  std::size_t fullest = 0;
  const auto all = grid.range_of(static_cast<Index>(boxes.size()) - 1);
  for (Index row = all.first_row; row <= all.last_row; ++row) {
    for (Index column = all.first_column; column <= all.last_column; ++column) {
      fullest = std::max(fullest, grid.cell(column, row).size());
    }
  }
  EXPECT_LE(fullest, 100u);
}

TEST(ContactSearch, WhatWasThrownFarDoesNotMakeTheCellsCoarse) {
  std::vector<Box> boxes;
  for (int x = 0; x < 60; ++x) {
    for (int y = 0; y < 60; ++y) {
      boxes.push_back(box_of({{1.0 * x, 1.0 * y}, {}, {0.9, 0.0}, {0.0, 0.9}}, 0.05));
    }
  }
  for (const Point& far : {Point{1e7, 0.0}, Point{-1e6, 1e9}}) {
    boxes.push_back(box_of({far, {}, {0.9, 0.0}, {0.0, 0.9}}, 0.05));
  }
  const CellGrid grid(boxes);
  std::size_t fullest = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto range = grid.range_of(static_cast<Index>(i));
    fullest = std::max(fullest, grid.cell(range.first_column, range.first_row).size());
  }
  EXPECT_LE(fullest, 20u);
}

TEST(ContactSearch, ASmallBodyFarAwayIsSearchedAsWellAsTheRest) {
  std::vector<PlacedTriangle> placed;
  const auto add = [&](int columns, int rows, Point corner) {
    for (int x = 0; x < columns; ++x) {
      for (int y = 0; y < rows; ++y) {
        placed.push_back({corner + Point{0.8 * x, 0.8 * y}, {}, {0.9, 0.0}, {0.0, 0.9}});
      }
    }
  };
  add(80, 80, {0.0, 0.0});
  add(7, 7, {5000.0, -300.0});
  std::vector<Box> boxes;
  for (const PlacedTriangle& t : placed) {
    boxes.push_back(box_of(t, 0.05));
  }
  const CellGrid grid(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto range = grid.range_of(static_cast<Index>(i));
    EXPECT_LE(grid.cell(range.first_column, range.first_row).size(), 30u);
  }
  const auto candidates = strangers(placed.size());
  Execution execution;
  const PairList found = find_pairs(candidates, placed, 0.1, execution);
  EXPECT_EQ(found.pair, all_near(candidates, placed, 0.1));
}

TEST(ContactSearch, PlacesThatAreNoNumbersAreLeftOut) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  std::vector<PlacedTriangle> placed(5, {{0.0, 0.0}, {}, {1.0, 0.0}, {0.0, 1.0}});
  placed[1].shift.x = nothing;
  placed[2].leg_1.y = infinite;
  placed[3].leg_2.x = nothing;
  Execution execution;
  const PairList list = find_pairs(strangers(5), placed, 0.1, execution);
  EXPECT_EQ(list.pair, (std::vector<std::array<Index, 2>>{{0, 4}}));
}

TEST(ContactSearch, BondsRoundAVertexKeepTrianglesFromTouching) {
  test::Bodies bodies(percolith::test::make_grid({.columns = 3, .rows = 3}), {}, 1);
  bodies.advance();
  const mesh::Mesh& mesh = bodies.mesh();
  const auto neighbours_apart = [&] {
    Index pairs = 0;
    for (Index a = 0; a < mesh.triangles(); ++a) {
      for (Index b = a + 1; b < mesh.triangles(); ++b) {
        bool shared = false;
        for (const Index v : mesh.triangle_vertex[at(a)]) {
          const auto& other = mesh.triangle_vertex[at(b)];
          shared = shared || std::find(other.begin(), other.end(), v) != other.end();
        }
        pairs += shared ? 0 : 1;
      }
    }
    return pairs;
  };
  // Bonded everywhere: at most those that share no vertex.
  EXPECT_LE(bodies.contact().listed_pairs(), neighbours_apart());
  const Index before = bodies.contact().listed_pairs();
  // One broken joint inside: its faces may touch although the vertices at its ends are whole.
  const Index j = percolith::test::joint_between(mesh, {1.0 / 3, 1.0 / 3}, {2.0 / 3, 1.0 / 3});
  bodies.tied()[at(j)] = 0;
  bodies.touch()[at(j)] = 1;
  bodies.refresh();
  bodies.advance();
  EXPECT_EQ(bodies.contact().listed_pairs(), before + 1);
  // Where the joint itself acts, they may not.
  bodies.touch()[at(j)] = 0;
  bodies.refresh();
  bodies.advance();
  EXPECT_EQ(bodies.contact().listed_pairs(), before);
}

TEST(ContactSearch, JointsThatActKeepTheirFacesApartEvenWithAllVerticesSplit) {
  test::Bodies bodies(percolith::test::make_grid({.columns = 3, .rows = 3}));
  bodies.advance();
  const Index before = bodies.contact().listed_pairs();
  bodies.touch().assign(bodies.touch().size(), 0);
  bodies.refresh();
  bodies.advance();
  EXPECT_EQ(bodies.contact().listed_pairs(), before - bodies.mesh().joints());
}

}  // namespace
}  // namespace percolith::mechanics
