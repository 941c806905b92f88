// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_cursor.hpp"

#include "percolith/mesh/gmsh_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace percolith::mesh {
std::string_view GmshCursor::line() {
  const std::size_t begin = position_;
  const std::size_t end = std::min(bytes_.find('\n', begin), bytes_.size());
  position_ = std::min(end + 1, bytes_.size());
  std::string_view text = bytes_.substr(begin, end - begin);
  if (!text.empty() && text.back() == '\r') {
    text.remove_suffix(1);
  }
  return text;
}

void GmshCursor::skip_past(std::string_view mark) {
  const std::size_t found = bytes_.find(mark, position_);
  if (found == std::string_view::npos) {
    position_ = bytes_.size();
    fail_truncated();
  }
  position_ = found + mark.size();
}

void GmshCursor::expect(std::string_view expected) {
  const std::string_view found = word();
  if (found != expected) {
    fail(fmt::format("expected {}, found '{}': a count in the file is wrong or the file is damaged",
                     expected, printable_text(found)));
  }
}

void GmshCursor::require(std::uint64_t count, std::uint64_t bytes, std::uint64_t numbers,
                         std::string_view what) const {
  // A number of a text file takes at least a digit and a separator; the last separator may lack.
  const std::uint64_t each = binary_ ? bytes : 2 * numbers;
  const std::uint64_t room = remaining() + (binary_ ? 0 : 1);
  if (count > room / each) {
    fail(fmt::format("{} announces {} {}, but only {} bytes follow: the file is truncated or "
                     "damaged",
                     section_, count, what, remaining()));
  }
}

int GmshCursor::line_number() const {
  if (binary_) {
    return 0;
  }
  std::size_t end = position_;
  while (end > 0 && is_space(bytes_[end - 1])) {
    --end;
  }
  const auto lines =
      std::count(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  return static_cast<int>(std::min<std::ptrdiff_t>(lines + 1, std::numeric_limits<int>::max()));
}

void GmshCursor::fail(const std::string& reason, const std::string& allowed) const {
  const std::string place = binary_ ? fmt::format(" (at byte {})", position_) : std::string();
  fail_mesh({file_, line_number(), 0}, reason + place, allowed);
}

void GmshCursor::fail_truncated() const {
  fail(fmt::format("the file ends inside {}: it is truncated; write or copy it again",
                   section_.empty() ? "its header" : printable_text(section_)));
}

void GmshCursor::fail_number(std::string_view text, bool too_large, bool whole) const {
  if (too_large) {
    fail(fmt::format("the number {} in {} is out of range", printable_text(text), section_));
  }
  fail(fmt::format("expected a {} in {}, found '{}'", whole ? "whole number" : "number", section_,
                   printable_text(text)));
}

}  // namespace percolith::mesh
