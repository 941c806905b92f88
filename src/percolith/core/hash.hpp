// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace percolith {

/// Hash of the bit patterns of numbers (FNV-1a over 64-bit words): equal states have equal
/// hashes, so two runs are compared by one short text.
class StateHash {
public:
  void add(std::span<const double> values);
  void add(double value) { add(std::span<const double>(&value, 1)); }
  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const;

private:
  std::uint64_t state_ = 14695981039346656037ULL;
};

/// Hash of bytes (FNV-1a): any single byte that differs gives another value. Against mistakes, not
/// against intent.
class ByteHash {
public:
  void add(std::string_view bytes);
  [[nodiscard]] std::uint64_t value() const { return state_; }
  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const;

private:
  std::uint64_t state_ = 14695981039346656037ULL;
};

}  // namespace percolith
