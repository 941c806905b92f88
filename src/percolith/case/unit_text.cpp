// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/units.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <system_error>

namespace percolith::case_file {

namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
/// Letters of any alphabet, and the signs that are units themselves.
bool is_unit_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%' ||
         static_cast<unsigned char>(c) >= 0x80U;
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

/// Whether the number that begins at `first` is an exponent: it follows a unit or a bracket,
/// perhaps with `^`, `**` or a sign between.
bool is_exponent(std::string_view unit, std::size_t first) {
  std::size_t i = first;
  if (i > 0 && (unit[i - 1] == '-' || unit[i - 1] == '+')) {
    --i;
  }
  if (i > 0 && unit[i - 1] == '^') {
    return true;
  }
  if (i > 1 && unit[i - 1] == '*' && unit[i - 2] == '*') {
    return true;
  }
  return i > 0 && (is_unit_letter(unit[i - 1]) || unit[i - 1] == ')');
}

}  // namespace

std::optional<NumberWithUnit> split_number(std::string_view text) {
  std::string_view rest = without_blanks(text);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (rest == "inf" || rest == "+inf") {
    return NumberWithUnit{infinity, {}};
  }
  if (rest == "-inf") {
    return NumberWithUnit{-infinity, {}};
  }
  if (!rest.empty() && rest.front() == '+') {
    rest.remove_prefix(1);
    if (!rest.empty() && rest.front() == '-') {
      return std::nullopt;
    }
  }
  const std::size_t sign = !rest.empty() && rest.front() == '-' ? 1 : 0;
  if (rest.size() <= sign || (!is_digit(rest[sign]) && rest[sign] != '.')) {
    return std::nullopt;
  }
  double number = 0.0;
  const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (failure != std::errc{}) {
    return std::nullopt;
  }
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return NumberWithUnit{number, without_blanks(rest)};
}

std::string misread_unit(std::string_view unit) {
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i])) {
      continue;
    }
    const std::size_t first = i;
    while (i < unit.size() && is_digit(unit[i])) {
      ++i;
    }
    const bool dotted = i + 1 < unit.size() && unit[i] == '.' && is_digit(unit[i + 1]);
    const bool pointed = first > 0 && unit[first - 1] == '.';
    if (dotted || pointed) {
      return fmt::format("the unit \"{}\" has a fractional exponent or factor", unit);
    }
    if (!is_exponent(unit, first) && unit.substr(first, i - first) != "1") {
      return fmt::format("the unit \"{}\" holds a number that is not an exponent", unit);
    }
    // UDUNITS reads m^1/2 as half a metre.
    const bool divided = i + 1 < unit.size() && unit[i] == '/' && is_digit(unit[i + 1]);
    if (divided && is_exponent(unit, first)) {
      return fmt::format("the unit \"{}\" has a fractional exponent or factor", unit);
    }
  }
  return {};
}

}  // namespace percolith::case_file
