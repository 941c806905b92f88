// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/hash.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace percolith {
namespace {

std::string hash_of(const std::vector<double>& values) {
  StateHash hash;
  hash.add(values);
  return hash.text();
}

TEST(StateHash, EqualStatesHaveEqualHashes) {
  StateHash one_by_one;
  one_by_one.add(1.5);
  one_by_one.add(-2.0);
  EXPECT_EQ(one_by_one.text(), hash_of({1.5, -2.0}));
  EXPECT_EQ(hash_of({}).size(), 16u);
}

TEST(StateHash, TellsEveryBitAndTheOrderApart) {
  std::set<std::string> seen{hash_of({}),         hash_of({0.0}),      hash_of({-0.0}),
                             hash_of({0.0, 0.0}), hash_of({1.0, 2.0}), hash_of({2.0, 1.0})};
  EXPECT_EQ(seen.size(), 6u);
  // One digit in the last place, anywhere in a long state.
  const std::vector<double> state(1000, 1e5 / 3);
  seen = {hash_of(state)};
  for (std::size_t i = 0; i < state.size(); ++i) {
    auto other = state;
    other[i] = std::nextafter(other[i], 0.0);
    seen.insert(hash_of(other));
  }
  EXPECT_EQ(seen.size(), state.size() + 1);
}

}  // namespace
}  // namespace percolith
