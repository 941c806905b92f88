// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace percolith::mesh {

/// Walks over the bytes of a `.msh` file, text or binary, and knows the place of every error. It
/// never reads past the end of the bytes; it does not own them.
class GmshCursor {
public:
  /// `file` is the name used in messages.
  GmshCursor(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

  /// From here on `number` reads binary values; `foreign_order` when the bytes of a value stand in
  /// the order of another kind of machine.
  void switch_to_binary(bool foreign_order) {
    binary_ = true;
    foreign_order_ = foreign_order;
  }
  [[nodiscard]] bool binary() const { return binary_; }

  /// Name of the section being read (`$Nodes`), for messages.
  void set_section(std::string_view section) { section_ = section; }
  [[nodiscard]] std::string_view section() const { return section_; }

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] std::size_t position() const { return position_; }
  [[nodiscard]] std::string_view rest() const { return bytes_.substr(position_); }
  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - position_; }

  /// Skips white space; true when nothing else is left.
  bool at_end() {
    skip_space();
    return position_ == bytes_.size();
  }

  /// Next word between white space. Throws InputError at the end of the file.
  std::string_view word() {
    skip_space();
    const std::size_t begin = position_;
    while (position_ < bytes_.size() && !is_space(bytes_[position_])) {
      ++position_;
    }
    if (position_ == begin) {
      fail_truncated();
    }
    return bytes_.substr(begin, position_ - begin);
  }

  /// Rest of the current line without its end, which is skipped.
  std::string_view line();

  /// Skips everything up to and including `mark`. Throws InputError when it does not follow.
  void skip_past(std::string_view mark);

  /// Next word must be `expected`. Throws InputError otherwise.
  void expect(std::string_view expected);

  /// A number written as text, also in a binary file. Throws InputError when the next word is not
  /// a number of type `T` or does not fit.
  template <class T>
  T text_number() {
    const std::string_view text = word();
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      fail_number(text, error == std::errc::result_out_of_range, std::integral<T>);
    }
    return value;
  }

  /// The next number, as the file writes it: text, or `sizeof(T)` bytes.
  template <class T>
  T number() {
    return binary_ ? raw<T>() : text_number<T>();
  }

  /// A binary value. Throws InputError when fewer bytes are left.
  template <class T>
  T raw() {
    if (remaining() < sizeof(T)) {
      fail_truncated();
    }
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), bytes_.data() + position_, sizeof(T));
    position_ += sizeof(T);
    if (foreign_order_) {
      std::reverse(bytes.begin(), bytes.end());
    }
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  /// Checks, before anything is allocated for them, that `count` items can still follow: each
  /// takes `bytes` when binary and is written as `numbers` numbers in text. Throws InputError.
  void require(std::uint64_t count, std::uint64_t bytes, std::uint64_t numbers,
               std::string_view what) const;

  /// Throws InputError at the last word or value read. Adds line (text) or byte (binary).
  [[noreturn]] void fail(const std::string& reason, const std::string& allowed = {}) const;
  /// Throws InputError: the file ends in the middle of a section.
  [[noreturn]] void fail_truncated() const;

private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip_space() {
    while (position_ < bytes_.size() && is_space(bytes_[position_])) {
      ++position_;
    }
  }
  [[nodiscard]] int line_number() const;
  [[noreturn]] void fail_number(std::string_view text, bool too_large, bool whole) const;

  std::string_view bytes_;
  std::string file_;
  std::string_view section_;
  std::size_t position_ = 0;
  bool binary_ = false;
  bool foreign_order_ = false;
};

}  // namespace percolith::mesh
