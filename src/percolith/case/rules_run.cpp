// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace percolith::case_file {

namespace {

using simulation::Domain;
using simulation::Scheme;

void check_time(Rules& rules) {
  const simulation::Stepping& time = rules.setup().time;
  if (time.scheme != Scheme::steady && !rules.given("time.end")) {
    rules.fail("time.end", {"time.scheme"}, "required but missing: the time at which the run ends",
               to_text(positive, "s") +
                   (rules.has_motion() ? "" : ", or time.scheme = \"steady\""));
  }
  if (time.initial_step && time.maximum_step && *time.initial_step > *time.maximum_step) {
    rules.fail("time.initial_step", {"time.maximum_step"}, "greater than maximum_step",
               fmt::format("at most {} s", *time.maximum_step));
  }
}

/// A steady state has no time at which a schedule could be read.
void check_constant(Rules& rules, const std::string& key, const std::optional<Schedule>& schedule) {
  if (schedule && !schedule->is_constant()) {
    rules.fail(key, {"time.scheme"}, "changes over time, which a steady run has not",
               "a constant, or time.scheme = \"implicit\"");
  }
}

void check_steady(Rules& rules) {
  if (rules.setup().time.scheme != Scheme::steady) {
    return;
  }
  for (const auto& [name, condition] : rules.setup().boundary) {
    const std::string path = "boundary." + name;
    check_constant(rules, path + ".pressure", condition.pressure);
    check_constant(rules, path + ".head", condition.head);
    check_constant(rules, path + ".flux", condition.flux);
    check_constant(rules, path + ".seepage_face", condition.seepage_face);
  }
  for (const auto& [name, source] : rules.setup().source) {
    check_constant(rules, "source." + name + ".rate", source.rate);
    check_constant(rules, "source." + name + ".pressure", source.pressure);
  }
}

void check_output(Rules& rules) {
  const std::vector<double>& times = rules.setup().output.times;
  const bool increasing =
      std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end();
  const double end = rules.setup().time.end;
  if (!increasing) {
    rules.fail("output.times", {}, "times do not increase", "times that strictly increase");
  } else if (!times.empty() && times.back() > end) {
    rules.fail("output.times", {"time.end", "time.scheme"},
               fmt::format("{} s is after the end of the run", times.back()),
               fmt::format("at most {} s", end));
  }
}

void check_probe(Rules& rules, const std::string& path, const simulation::Probe& probe) {
  const bool point = rules.given(path + ".point");
  const bool from = rules.given(path + ".from");
  const bool to = rules.given(path + ".to");
  const std::string allowed = "point, or from and to";
  if (point && (from || to)) {
    rules.fail(path + (from ? ".from" : ".to"), {}, "contradicts \"point\", which is given too",
               allowed);
  } else if (!point && !(from && to)) {
    rules.fail(path, {}, from || to ? "one end of the line is missing" : "the place is missing",
               allowed);
  }
  if (probe.from && probe.to && *probe.from == *probe.to) {
    rules.fail(path + ".to", {path + ".from"}, "both ends of the line are the same point",
               "two points that differ");
  }
  if (probe.in == Domain::crack && rules.setup().fracture.empty()) {
    rules.fail(path + ".in", {"fracture"}, "the case has no fracture", "a table [fracture.NAME]");
  }
}

}  // namespace

void check_physics(Rules& rules) {
  const Scheme scheme = rules.setup().time.scheme;
  const bool is_quasi_static = scheme == Scheme::quasi_static;
  if (is_quasi_static && !rules.is_coupled()) {
    rules.fail("time.scheme", {"model.physics"}, "only coupled runs are quasi-static",
               rules.has_motion() ? "\"explicit\", or none"
                                  : "\"implicit\", \"explicit\" or \"steady\"");
  } else if (rules.has_motion() && !is_quasi_static && scheme != Scheme::explicit_) {
    rules.fail("time.scheme", {"model.physics"}, "the motion of rock is advanced explicitly",
               rules.is_coupled() ? "\"explicit\", \"quasi_static\", or none"
                                  : "\"explicit\", or none");
  }
}

void check_run(Rules& rules) {
  check_time(rules);
  check_steady(rules);
  check_output(rules);
  for (const auto& [name, probe] : rules.setup().probe) {
    check_probe(rules, "probe." + name, probe);
  }
}

}  // namespace percolith::case_file
