// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/error.hpp"

#include <map>
#include <string>

namespace percolith::case_file {

/// What the user wrote for an option, and where.
struct Written {
  FileLocation location;
  std::string value;  ///< as text, shortened; empty for a table
};

/// `file:line:column`, or the file where no line is known.
[[nodiscard]] std::string to_text(const FileLocation& at);

/// Every option and table the user wrote, by dotted path.
class KeyLocations {
public:
  KeyLocations() = default;
  explicit KeyLocations(FileLocation file) : file_(std::move(file)) {}

  void add(const std::string& key, Written written) { written_[key] = std::move(written); }
  /// True where the user wrote this option or table.
  [[nodiscard]] bool given(const std::string& key) const { return written_.count(key) > 0; }
  /// Location and value of the option; of the innermost table or option that holds it, with an
  /// empty value, where it was not written; of the file where none of them was.
  [[nodiscard]] Written nearest(const std::string& key) const;

private:
  FileLocation file_;
  std::map<std::string, Written> written_;
};

}  // namespace percolith::case_file
