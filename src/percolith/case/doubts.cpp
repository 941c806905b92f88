// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::case_file {

void Doubts::judge(const std::string& key, double value, const Plausible& range,
                   const std::string& advice) {
  if (locations_.given(key) && !range.holds(value)) {
    add(key, fmt::format("is {:g} {}, {}. {}{}", value, range.unit, range.range,
                         question(key, value, range), advice));
  }
}

void Doubts::add(const std::string& key, const std::string& doubt) {
  const Written written = locations_.nearest(key);
  warnings_.emplace_back(written.location.line,
                         fmt::format("{}: warning: {}{} {}", to_text(written.location), key,
                                     written.value.empty() ? "" : " = " + written.value, doubt));
}

std::vector<std::string> Doubts::take() {
  std::stable_sort(warnings_.begin(), warnings_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> texts;
  for (auto& [line, text] : warnings_) {
    texts.push_back(std::move(text));
  }
  return texts;
}

// Asks whether the value is meant; a number without a unit may be one of a usual unit.
std::string Doubts::question(const std::string& key, double value, const Plausible& range) const {
  const std::string& text = locations_.nearest(key).value;
  const bool has_unit = text.find_first_of("\"'[{") != std::string::npos;
  const auto unit = std::find_if(range.usual.begin(), range.usual.end(), [&](const auto& usual) {
    const double usually = value * usual.factor;
    return range.holds(usually) && usually <= range.usual_most;
  });
  if (has_unit || unit == range.usual.end()) {
    return "Is that meant?";
  }
  const std::string usual = fmt::format("{:g} {}", value, unit->name);
  return fmt::format("Is that meant? A number without a unit is in {}; {} is written \"{}\"",
                     range.unit, usual, usual);
}

}  // namespace percolith::case_file
