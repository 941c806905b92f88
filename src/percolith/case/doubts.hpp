// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/key_locations.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace percolith::case_file {

/// A unit in which a number is often thought, and what it is in SI.
struct UsualUnit {
  std::string_view name;
  double factor = 1.0;
};

/// What rocks have of a quantity, in SI.
struct Plausible {
  static constexpr double none = std::numeric_limits<double>::infinity();
  std::string_view unit;
  double least = -none;
  double most = none;
  std::string_view range;    ///< what is wrong beyond it, in words
  double usual_most = none;  ///< of values in the units in which they are often thought
  std::vector<UsualUnit> usual;

  [[nodiscard]] bool holds(double value) const { return value >= least && value <= most; }
};

/// Collects warnings of options whose values are outside of what rocks have.
class Doubts {
public:
  explicit Doubts(const KeyLocations& locations) : locations_(locations) {}

  /// Judges the `value` (SI) of the option `key`, if it was written; `advice` ends the warning.
  void judge(const std::string& key, double value, const Plausible& range,
             const std::string& advice = {});
  /// A warning of the option `key`, which stands before the `doubt`.
  void add(const std::string& key, const std::string& doubt);
  [[nodiscard]] bool given(const std::string& key) const { return locations_.given(key); }
  /// In the order of the file.
  [[nodiscard]] std::vector<std::string> take();

private:
  [[nodiscard]] std::string question(const std::string& key, double value,
                                     const Plausible& range) const;

  const KeyLocations& locations_;
  std::vector<std::pair<int, std::string>> warnings_;  // with their lines
};

}  // namespace percolith::case_file
