// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/option.hpp"

#include <fmt/format.h>

#include <cmath>

namespace percolith::case_file {

bool Bounds::contains(double value) const {
  const bool above = value > low || (low_included && value == low);
  const bool below = value < high || (high_included && value == high);
  return above && below;
}

std::string to_text(const Bounds& bounds, std::string_view unit) {
  const std::string suffix = unit == "1" ? "" : fmt::format(" {}", unit);
  const bool has_low = std::isfinite(bounds.low);
  const bool has_high = std::isfinite(bounds.high);
  const char* const below = bounds.high_included ? "<=" : "<";
  std::string text;
  if (has_low && has_high) {
    return fmt::format("{} {} value {} {}{}", bounds.low, bounds.low_included ? "<=" : "<", below,
                       bounds.high, suffix);
  }
  if (has_low) {
    text = fmt::format("{}{} {}{}", bounds.high_included ? "" : "a finite number ",
                       bounds.low_included ? ">=" : ">", bounds.low, suffix);
  } else if (has_high) {
    text = fmt::format("{}{} {}{}", bounds.low_included ? "" : "a finite number ", below,
                       bounds.high, suffix);
  } else {
    text = unit == "1" ? "a finite number" : fmt::format("a finite number of {}", unit);
  }
  if (!has_low && bounds.low_included) {
    text += " or -inf";
  }
  if (!has_high && bounds.high_included) {
    text += " or inf";
  }
  return text;
}

std::string join_key(const std::string& path, std::string_view name) {
  return path.empty() ? std::string(name) : fmt::format("{}.{}", path, name);
}

std::string quoted(std::string_view name) {
  return fmt::format("\"{}\"", name);
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) {
    text += text.empty() ? "" : ", ";
    text += quoted(name);
  }
  return text;
}

}  // namespace percolith::case_file
