// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_cursor.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace percolith::mesh {

/// The nodes of a file and the way from a node's tag to its index. Tags may be sparse and huge:
/// memory grows with the number of nodes only.
class GmshNodes {
public:
  void reserve(std::size_t count);

  /// Adds a node; `place` is x, y, z in m. Throws InputError at the cursor when a coordinate is
  /// not finite.
  void add(std::uint64_t tag, const std::array<double, 3>& place, const GmshCursor& cursor);

  /// Builds the lookup. Throws InputError at the cursor when a tag stands twice.
  void finish(const GmshCursor& cursor);

  /// Index of the node with this tag. Throws InputError at the cursor when there is none.
  [[nodiscard]] std::int32_t index(std::uint64_t tag, const GmshCursor& cursor) const {
    // A tag below the lowest one wraps round to a huge offset.
    const std::uint64_t offset = tag - lowest_tag_;
    const std::int32_t found = offset < by_offset_.size() ? by_offset_[offset] : search(tag);
    if (found < 0) {
      fail_unknown(tag, cursor);
    }
    return found;
  }

  [[nodiscard]] std::size_t size() const { return places_.size(); }
  /// x, y, z in m of node `i`.
  [[nodiscard]] const std::array<double, 3>& place(std::int32_t i) const {
    return places_[static_cast<std::size_t>(i)];
  }

private:
  void build_by_offset(const GmshCursor& cursor, std::uint64_t range);
  void build_sorted(const GmshCursor& cursor);
  [[nodiscard]] std::int32_t search(std::uint64_t tag) const;
  [[noreturn]] static void fail_unknown(std::uint64_t tag, const GmshCursor& cursor);

  std::vector<std::array<double, 3>> places_;
  std::vector<std::uint64_t> tags_;
  std::uint64_t lowest_tag_ = 0;
  std::vector<std::int32_t> by_offset_;                         ///< when the tags are dense
  std::vector<std::pair<std::uint64_t, std::int32_t>> by_tag_;  ///< sorted, when they are sparse
};

}  // namespace percolith::mesh
