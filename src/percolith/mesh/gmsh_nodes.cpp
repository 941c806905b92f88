// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percolith::mesh {
namespace {

[[noreturn]] void fail_twice(std::uint64_t tag, const GmshCursor& cursor) {
  cursor.fail(fmt::format("node {} is listed twice", tag));
}

}  // namespace

void GmshNodes::reserve(std::size_t count) {
  places_.reserve(count);
  tags_.reserve(count);
}

void GmshNodes::add(std::uint64_t tag, const std::array<double, 3>& place,
                    const GmshCursor& cursor) {
  if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2])) {
    cursor.fail(fmt::format("node {} has a coordinate that is not finite: ({}, {}, {})", tag,
                            place[0], place[1], place[2]));
  }
  places_.push_back(place);
  tags_.push_back(tag);
}

void GmshNodes::finish(const GmshCursor& cursor) {
  if (tags_.empty()) {
    return;
  }
  const auto [lowest, highest] = std::minmax_element(tags_.begin(), tags_.end());
  lowest_tag_ = *lowest;
  const std::uint64_t range = *highest - *lowest;
  constexpr std::uint64_t sparse = 4;
  if (range / sparse < tags_.size()) {
    build_by_offset(cursor, range + 1);
  } else {
    build_sorted(cursor);
  }
  tags_.clear();
  tags_.shrink_to_fit();
}

void GmshNodes::build_by_offset(const GmshCursor& cursor, std::uint64_t range) {
  by_offset_.assign(range, -1);
  std::int32_t index = 0;
  for (const std::uint64_t tag : tags_) {
    std::int32_t& slot = by_offset_[tag - lowest_tag_];
    if (slot >= 0) {
      fail_twice(tag, cursor);
    }
    slot = index++;
  }
}

void GmshNodes::build_sorted(const GmshCursor& cursor) {
  by_tag_.reserve(tags_.size());
  for (const std::uint64_t tag : tags_) {
    by_tag_.emplace_back(tag, static_cast<std::int32_t>(by_tag_.size()));
  }
  std::sort(by_tag_.begin(), by_tag_.end());
  const auto twice = std::adjacent_find(by_tag_.begin(), by_tag_.end(),
                                        [](auto& a, auto& b) { return a.first == b.first; });
  if (twice != by_tag_.end()) {
    fail_twice(twice->first, cursor);
  }
}

std::int32_t GmshNodes::search(std::uint64_t tag) const {
  const auto found =
      std::lower_bound(by_tag_.begin(), by_tag_.end(), std::pair{tag, std::int32_t{0}});
  return found != by_tag_.end() && found->first == tag ? found->second : -1;
}

void GmshNodes::fail_unknown(std::uint64_t tag, const GmshCursor& cursor) {
  cursor.fail(fmt::format("an element uses node {}, which $Nodes does not list", tag));
}

}  // namespace percolith::mesh
