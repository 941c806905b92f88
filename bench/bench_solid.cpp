// SPDX-License-Identifier: BSD-3-Clause
// Time of a step of mechanics, per triangle and per phase, on one and two threads: intact rock with
// joints on every edge, and the same rock broken along every joint with all triangles in contact.
// The state after the same steps must have the same bits for the serial reference and any number
// of threads.
#include <fmt/format.h>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bench/support/measure.hpp"
#include "bench/support/results.hpp"
#include "bench/support/solid_case.hpp"
#include "bench/support/triad.hpp"

namespace {

using namespace percolith;
using namespace percolith::bench;

constexpr std::array<const char*, 5> phases{"joints", "triangles and motion", "contact search",
                                            "contact force", "breakage"};

struct Case {
  std::string name;
  std::string size;
  std::int32_t triangles = 0;
  SolidCase what;
  double limit = 0.0;  ///< ns/triangle-step on one thread; 0: none
  int steps = 0;
  int repeats = 0;
};

/// Steps at the start that do not count: the first one searches for contact.
constexpr int first_steps = 2;

/// What the steps of a case take in one way to make them, s, and what they come to.
struct Timing {
  double step = 0.0;                    ///< mean over the steps of the best time of each
  std::map<std::string, double> phase;  ///< mean of a step
  std::string hash;
  Index triangles = 0, listed = 0, touching = 0;
  double bytes = 0.0;  ///< that a step of intact rock moves
};

/// Makes the same steps several times from the same start: other programs disturb a step now and
/// then, but hardly the same one each time.
Timing time_steps(const Case& c, Backend backend, int threads, int repeats) {
  std::vector<Best> best(static_cast<std::size_t>(c.steps));
  Timing timing;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    SolidBench bench = make_solid(c.triangles, c.what);
    Execution execution(backend, threads);
    for (int i = 0; i < first_steps; ++i) {
      static_cast<void>(bench.dynamics.advance(bench.dt, execution));
    }
    const Execution::WallTimes before = execution.wall_time();
    for (Best& step : best) {
      const Stopwatch watch;
      static_cast<void>(bench.dynamics.advance(bench.dt, execution));
      step.add(watch.seconds());
    }
    for (const auto& [name, seconds] : execution.wall_time()) {
      const auto found = before.find(name);
      const double at_start = found == before.end() ? 0.0 : found->second;
      timing.phase[name] += (seconds - at_start) / (c.steps * repeats);
    }
    StateHash hash;
    bench.dynamics.add_to(hash);
    timing.hash = hash.text();
    timing.triangles = bench.dynamics.model().mesh.triangles();
    timing.listed = bench.dynamics.contact().listed_pairs();
    timing.touching = bench.dynamics.contact().touching_pairs();
    const SolidTraffic traffic = solid_traffic(bench.dynamics.model());
    timing.bytes = traffic.joints + traffic.triangles;
  }
  for (const Best& step : best) {
    timing.step += step.value() / c.steps;
  }
  return timing;
}

void print_table(const Case& c, const std::array<Timing, 3>& ways) {
  fmt::print("\n{} triangles, {}; state", ways[0].triangles, c.name);
  for (const Timing& way : ways) {
    fmt::print(" {}", way.hash);
  }
  fmt::print("\n  {:<30}{:>10}{:>10}{:>10}\n", "ns/triangle", "serial", "1 thread", "2 threads");
  const auto row = [&](const std::string& name, const std::function<double(const Timing&)>& of) {
    fmt::print("  {:<30}", name);
    for (const Timing& way : ways) {
      fmt::print("{:>10.2f}", 1e9 * of(way) / way.triangles);
    }
    fmt::print("\n");
  };
  for (const char* phase : phases) {
    row(fmt::format("{}, mean", phase), [&](const Timing& way) {
      const auto found = way.phase.find(phase);
      return found == way.phase.end() ? 0.0 : found->second;
    });
  }
  row("whole step, best of repeats", [](const Timing& way) { return way.step; });
}

void report_bandwidth(const std::string& name, const std::array<Timing, 3>& ways,
                      Results& results) {
  for (int threads = 1; threads <= 2; ++threads) {
    const Timing& way = ways[static_cast<std::size_t>(threads)];
    const double triad = triad_bandwidth(static_cast<std::size_t>(way.bytes), threads);
    const double share = way.bytes / way.step / triad;
    fmt::print("  triad of the same size, {} thread{}: {:.1f} GB/s; the step uses {:.0f} % of it\n",
               threads, threads == 1 ? "" : "s", 1e-9 * triad, 100.0 * share);
    results.report(fmt::format("{}.{}_threads.share_of_triad", name, threads), share, "1");
  }
}

/// Returns ns/triangle-step on one thread.
double measure_case(const Case& c, Results& results) {
  const std::array<Timing, 3> ways{time_steps(c, Backend::serial, 1, c.repeats),
                                   time_steps(c, Backend::host, 1, c.repeats),
                                   time_steps(c, Backend::host, 2, c.repeats)};
  print_table(c, ways);
  const auto& [serial, one, two] = ways;
  const std::string name = fmt::format("solid.{}.{}", c.name, c.size);
  const double nanoseconds = 1e9 * one.step / one.triangles;
  if (c.limit > 0.0) {
    results.at_most(name + ".1_thread", nanoseconds, "ns/triangle-step", c.limit);
  } else {
    results.report(name + ".1_thread", nanoseconds, "ns/triangle-step");
  }
  results.report(name + ".2_threads", 1e9 * two.step / two.triangles, "ns/triangle-step");
  results.must_hold(name + ".same_bits", serial.hash == one.hash && one.hash == two.hash);
  // At 1e6 triangles both wait for memory: what vectors gain is judged where it lies in the caches.
  if (c.limit > 0.0) {
    results.at_most(name + ".host_over_serial", one.step / serial.step, "1", 1.0 / 3.5);
  } else {
    results.report(name + ".host_over_serial", one.step / serial.step, "1");
  }
  if (c.what.broken) {
    fmt::print("  {} pairs listed, {} touch at the end\n", one.listed, one.touching);
    results.report(name + ".one_over_two_threads", one.step / two.step, "1");
  } else {
    report_bandwidth(name, ways, results);
    results.at_most(name + ".two_over_one_thread", two.step / one.step, "1", 1.0 / 1.8);
  }
  return nanoseconds;
}

void measure(Results& results) {
  measure_case({"intact", "1e5", 100'000, {}, 30.0, 40, 20}, results);
  measure_case({"intact", "1e6", 1'000'000, {}, 0.0, 6, 3}, results);
  const SolidCase broken{true};
  const double small = measure_case({"broken", "1e5", 100'000, broken, 500.0, 30, 3}, results);
  const double large = measure_case({"broken", "1e6", 1'000'000, broken, 0.0, 30, 1}, results);
  results.at_most("solid.broken.1e6_over_1e5", large / small, "1", 1.5);
}

}  // namespace

int main(int argc, char** argv) {
  return percolith::bench::run_benchmark(argc, argv, measure);
}
