// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/csv.hpp"

#include <fmt/format.h>

namespace percolith::io {

void CsvLine::separate() {
  if (!first_) {
    text_ += ',';
  }
  first_ = false;
}

CsvLine& CsvLine::add(double value) {
  separate();
  text_ += fmt::format("{}", value == 0.0 ? 0.0 : value);
  return *this;
}

CsvLine& CsvLine::add(std::int64_t value) {
  separate();
  text_ += fmt::format("{}", value);
  return *this;
}

CsvLine& CsvLine::add(std::string_view text) {
  separate();
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    text_ += text;
    return *this;
  }
  text_ += '"';
  for (const char character : text) {
    text_ += character;
    if (character == '"') {
      text_ += '"';
    }
  }
  text_ += '"';
  return *this;
}

CsvLine& CsvLine::add_empty() {
  separate();
  return *this;
}

std::string file_name_of(std::string_view name) {
  constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                     "0123456789_-+.";
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool kept = plain.find(name[i]) != std::string_view::npos && (i > 0 || name[i] != '.');
    result += kept ? std::string(1, name[i])
                   : fmt::format("%{:02X}", static_cast<unsigned char>(name[i]));
  }
  return result;
}

}  // namespace percolith::io
