// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/io/file_output.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace percolith::io {

/// One line of a table (RFC 4180, lines end in a single newline). Numbers are printed with the
/// fewest digits that read back to the same value; zero has no sign.
class CsvLine {
public:
  CsvLine& add(double value);
  CsvLine& add(std::int64_t value);
  /// Puts `text` in quotes where it contains a comma, a quote or a line break.
  CsvLine& add(std::string_view text);
  /// A cell without a value.
  CsvLine& add_empty();
  /// The line with its newline.
  [[nodiscard]] std::string text() const { return text_ + '\n'; }

private:
  void separate();
  std::string text_;
  bool first_ = true;
};

/// `name` as a file name: every byte other than letters, digits, `_`, `-`, `+` and an inner `.`
/// becomes `%` and two hexadecimal digits, so that different names give different files.
[[nodiscard]] std::string file_name_of(std::string_view name);

}  // namespace percolith::io
