// SPDX-License-Identifier: BSD-3-Clause
#include "bench/support/results.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>

namespace percolith::bench {

void Results::report(const std::string& name, double value, const std::string& unit) {
  figures_.push_back({name, value, unit, std::nullopt, "report"});
}

void Results::at_most(const std::string& name, double value, const std::string& unit,
                      double limit) {
  figures_.push_back({name, value, unit, limit, "max"});
}

void Results::must_hold(const std::string& name, bool holds) {
  figures_.push_back({name, holds ? 1.0 : 0.0, "1", 1.0, "min"});
}

void Results::write(const std::string& path) const {
  nlohmann::json list = nlohmann::json::array();
  for (const Figure& f : figures_) {
    list.push_back({{"name", f.name},
                    {"value", f.value},
                    {"unit", f.unit},
                    {"limit", f.limit ? nlohmann::json(*f.limit) : nlohmann::json()},
                    {"sense", f.sense}});
  }
  std::ofstream file(path);
  file << list.dump(1) << '\n';
  if (!file.flush()) {
    throw std::runtime_error(path + ": cannot be written");
  }
}

int run_benchmark(int argc, char** argv, void (*measure)(Results&)) {
  try {
    Results results;
    measure(results);
    if (argc > 1) {
      results.write(argv[1]);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: error: %s\n", argv[0], error.what());
    return 1;
  }
}

}  // namespace percolith::bench
