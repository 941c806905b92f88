// SPDX-License-Identifier: BSD-3-Clause
// Time of a step of mechanics, per triangle and per phase, on one and two threads: intact rock with
// joints on every edge, and the same rock broken along every joint with all triangles in contact.
// The state after the same steps must have the same bits for the serial reference and any number
// of threads.
#include <fmt/format.h>

#include <array>
#include <functional>
#include <string>
#include <utility>

#include "bench/support/measure.hpp"
#include "bench/support/results.hpp"
#include "bench/support/solid_case.hpp"
#include "bench/support/triad.hpp"

namespace {

using namespace percolith;
using namespace percolith::bench;

constexpr std::array<const char*, 5> phases{"joints", "triangles and motion", "contact search",
                                            "contact force", "breakage"};

/// One way to make the same steps, with its own copy of the rock.
class Runner {
public:
  Runner(SolidBench start, Backend backend, int threads)
      : bench_(std::move(start)), execution_(backend, threads) {}

  /// Makes steps that do not count, until the state is the one to be measured.
  void warm_up(int steps) {
    make(steps);
    before_ = execution_.wall_time();
  }
  /// Makes a round of steps and keeps the best mean of a round, the mean of all, and that of each
  /// phase.
  void advance(int steps) {
    const Stopwatch watch;
    make(steps);
    const double seconds = watch.seconds();
    best_.add(seconds / steps);
    total_ += seconds;
    steps_ += steps;
  }
  [[nodiscard]] double best() const { return best_.value(); }
  [[nodiscard]] double mean() const { return total_ / steps_; }
  [[nodiscard]] double phase(const std::string& name) const {
    const auto in = [&](const Execution::WallTimes& times) {
      const auto found = times.find(name);
      return found == times.end() ? 0.0 : found->second;
    };
    return (in(execution_.wall_time()) - in(before_)) / steps_;
  }
  [[nodiscard]] std::string hash() const {
    StateHash hash;
    bench_.dynamics.add_to(hash);
    return hash.text();
  }
  [[nodiscard]] const mechanics::Dynamics& dynamics() const { return bench_.dynamics; }

private:
  void make(int steps) {
    for (int i = 0; i < steps; ++i) {
      static_cast<void>(bench_.dynamics.advance(bench_.dt, execution_));
    }
  }

  SolidBench bench_;
  Execution execution_;
  Execution::WallTimes before_;
  Best best_;
  double total_ = 0.0;
  int steps_ = 0;
};

struct Case {
  std::string name;
  std::string size;
  std::int32_t triangles = 0;
  SolidCase what;
  double limit = 0.0;  ///< ns/triangle-step on one thread; 0: none
  int warm_up = 0;     ///< steps before the first round
  int steps = 0;       ///< of a round
  int rounds = 0;
};

void print_table(const Case& c, const Runner& serial, const Runner& one, const Runner& two,
                 const std::function<double(double)>& nanoseconds) {
  fmt::print("\n{} triangles, {}; state {} {} {}\n", one.dynamics().model().mesh.triangles(),
             c.name, serial.hash(), one.hash(), two.hash());
  fmt::print("  {:<22}{:>10}{:>10}{:>10}\n", "ns/triangle", "serial", "1 thread", "2 threads");
  const auto row = [&](const std::string& name, double s, double t1, double t2) {
    fmt::print("  {:<22}{:>10.2f}{:>10.2f}{:>10.2f}\n", name, nanoseconds(s), nanoseconds(t1),
               nanoseconds(t2));
  };
  for (const char* phase : phases) {
    row(phase, serial.phase(phase), one.phase(phase), two.phase(phase));
  }
  row("whole step", serial.mean(), one.mean(), two.mean());
  row("best round", serial.best(), one.best(), two.best());
}

double measure_case(const Case& c, Results& results) {
  Runner serial(make_solid(c.triangles, c.what), Backend::serial, 1);
  Runner one(make_solid(c.triangles, c.what), Backend::host, 1);
  Runner two(make_solid(c.triangles, c.what), Backend::host, 2);
  for (Runner* runner : {&serial, &one, &two}) {
    runner->warm_up(c.warm_up);
  }
  for (int round = 0; round < c.rounds; ++round) {
    serial.advance(c.steps);
    one.advance(c.steps);
    two.advance(c.steps);
  }
  const double count = one.dynamics().model().mesh.triangles();
  const auto nanoseconds = [&](double seconds) { return 1e9 * seconds / count; };
  print_table(c, serial, one, two, nanoseconds);
  const std::string name = fmt::format("solid.{}.{}", c.name, c.size);
  if (c.limit > 0.0) {
    results.at_most(name + ".1_thread", nanoseconds(one.best()), "ns/triangle-step", c.limit);
  } else {
    results.report(name + ".1_thread", nanoseconds(one.best()), "ns/triangle-step");
  }
  results.report(name + ".2_threads", nanoseconds(two.best()), "ns/triangle-step");
  results.report(name + ".one_over_two_threads", one.best() / two.best(), "1");
  results.must_hold(name + ".same_bits", serial.hash() == one.hash() && one.hash() == two.hash());
  if (c.what.broken) {
    fmt::print("  {} pairs listed, {} touch\n", one.dynamics().contact().listed_pairs(),
               one.dynamics().contact().touching_pairs());
  } else {
    const SolidTraffic traffic = solid_traffic(one.dynamics().model());
    const double bytes = traffic.joints + traffic.triangles;
    for (int threads = 1; threads <= 2; ++threads) {
      const double step = threads == 1 ? one.best() : two.best();
      const double triad = triad_bandwidth(static_cast<std::size_t>(bytes), threads);
      fmt::print(
          "  triad of the same size, {} thread{}: {:.1f} GB/s; the step uses {:.0f} % of it\n",
          threads, threads == 1 ? "" : "s", 1e-9 * triad, 100.0 * bytes / step / triad);
      results.report(fmt::format("{}.{}_threads.share_of_triad", name, threads),
                     bytes / step / triad, "1");
    }
    results.at_most(name + ".host_over_serial", one.best() / serial.best(), "1", 1.0 / 3.5);
  }
  return nanoseconds(one.best());
}

void measure(Results& results) {
  measure_case({"intact", "1e5", 100'000, {}, 30.0, 2, 10, 16}, results);
  measure_case({"intact", "1e6", 1'000'000, {}, 0.0, 1, 3, 5}, results);
  const SolidCase broken{true};
  const double small = measure_case({"broken", "1e5", 100'000, broken, 500.0, 10, 5, 10}, results);
  const double large = measure_case({"broken", "1e6", 1'000'000, broken, 0.0, 10, 2, 3}, results);
  results.at_most("solid.broken.1e6_over_1e5", large / small, "1", 1.5);
}

}  // namespace

int main(int argc, char** argv) {
  return percolith::bench::run_benchmark(argc, argv, measure);
}
