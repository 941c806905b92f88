// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace percolith::bench {

/// What a benchmark program found, for bench/run.py.
class Results {
public:
  /// A figure without a limit.
  void report(const std::string& name, double value, const std::string& unit);
  /// A figure that must not exceed `limit`.
  void at_most(const std::string& name, double value, const std::string& unit, double limit);
  /// A statement that must hold: 1 when it does.
  void must_hold(const std::string& name, bool holds);
  /// Writes all figures as JSON: a list of {name, value, unit, limit, sense}. Throws
  /// std::runtime_error when the file cannot be written.
  void write(const std::string& path) const;

private:
  struct Figure {
    std::string name;
    double value;
    std::string unit;
    std::optional<double> limit;
    std::string sense;
  };
  std::vector<Figure> figures_;
};

/// Runs `measure`, which fills in the results, and writes them to the file named by the only
/// argument of the program, if there is one. Returns the exit code.
int run_benchmark(int argc, char** argv, void (*measure)(Results&));

}  // namespace percolith::bench
