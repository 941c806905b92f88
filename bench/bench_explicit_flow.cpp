// SPDX-License-Identifier: BSD-3-Clause
// Time of an explicit flow step, per triangle and per phase, on one and two threads; the state
// after the same steps must have the same bits for the serial reference and any number of threads.
#include "percolith/core/hash.hpp"
#include "percolith/seepage/explicit_step.hpp"
#include "percolith/seepage/step_limit.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

#include "bench/support/flow_case.hpp"
#include "bench/support/measure.hpp"
#include "bench/support/results.hpp"
#include "bench/support/traffic.hpp"
#include "bench/support/triad.hpp"

namespace {

using namespace percolith;
using namespace percolith::bench;

constexpr std::array<const char*, 5> phases{"pore flow", "joint flow", "crack flow",
                                            "pore contents", "crack contents"};

std::string hash_of(const seepage::State& state) {
  StateHash hash;
  for (const auto* values : {&state.pressure, &state.saturation, &state.content,
                             &state.content_carry, &state.crack_pressure, &state.crack_saturation,
                             &state.crack_content, &state.crack_content_carry}) {
    hash.add(*values);
  }
  return hash.text();
}

/// One way to run the same steps, with its own copy of the model.
class Runner {
public:
  Runner(const seepage::Model& model, Backend backend, int threads)
      : model_(model), execution_(backend, threads), scheme_(model_) {}

  /// Advances by `steps` and keeps the best time of a step as a whole and of each phase.
  void advance(int steps, double dt) {
    for (int i = 0; i < steps; ++i) {
      const Execution::WallTimes before = execution_.wall_time();
      const Stopwatch watch;
      scheme_.advance(model_, dt, execution_);
      step_.add(watch.seconds());
      for (const auto& [phase, seconds] : execution_.wall_time()) {
        const auto it = before.find(phase);
        phase_[phase].add(seconds - (it == before.end() ? 0.0 : it->second));
      }
    }
  }
  [[nodiscard]] double step() const { return step_.value(); }
  [[nodiscard]] double phase(const std::string& name) const { return phase_.at(name).value(); }
  [[nodiscard]] bool has(const std::string& name) const { return phase_.count(name) > 0; }
  [[nodiscard]] std::string hash() const { return hash_of(model_.state); }

private:
  seepage::Model model_;
  Execution execution_;
  seepage::ExplicitStep scheme_;
  Best step_;
  std::map<std::string, Best> phase_;
};

struct Case {
  std::string name;
  FlowCase flow;
};

void measure_case(const Case& c, const mesh::Mesh& mesh, Results& results) {
  constexpr int rounds = 4;
  const bool large = mesh.triangles() > 300'000;
  const int steps = large ? 5 : 40;
  const seepage::Model model = make_flow_model(mesh, c.flow);
  const double dt = 0.5 * seepage::step_limits(seepage::make_flow_graph(model)).back().step;
  Runner serial(model, Backend::serial, 1);
  Runner one(model, Backend::host, 1);
  Runner two(model, Backend::host, 2);
  for (int round = 0; round < rounds; ++round) {
    serial.advance(steps, dt);
    one.advance(steps, dt);
    two.advance(steps, dt);
  }
  const double count = model.mesh.triangles();
  const auto nanoseconds = [&](double seconds) { return 1e9 * seconds / count; };
  const std::string size = large ? "1e6" : "1e5";
  fmt::print("\n{} triangles, {}; state {} {} {}\n", model.mesh.triangles(), c.name, serial.hash(),
             one.hash(), two.hash());
  fmt::print("  {:<16}{:>10}{:>10}{:>10}{:>10}{:>11}{:>11}\n", "ns/triangle", "serial", "1 thread",
             "2 threads", "bytes", "GB/s, 1", "GB/s, 2");
  double bytes = 0.0;
  const auto row = [&](const std::string& name, double s, double t1, double t2, double b) {
    fmt::print("  {:<16}{:>10.2f}{:>10.2f}{:>10.2f}{:>10.0f}{:>11.1f}{:>11.1f}\n", name,
               nanoseconds(s), nanoseconds(t1), nanoseconds(t2), b / count, 1e-9 * b / t1,
               1e-9 * b / t2);
  };
  const std::map<std::string, double> traffic = step_traffic(model);
  for (const char* phase : phases) {
    if (!one.has(phase)) {
      continue;
    }
    const double b = traffic.at(phase);
    bytes += b;
    row(phase, serial.phase(phase), one.phase(phase), two.phase(phase), b);
  }
  row("whole step", serial.step(), one.step(), two.step(), bytes);
  const std::array<const Runner*, 2> runner{&one, &two};
  for (int threads = 1; threads <= 2; ++threads) {
    const double step = runner[static_cast<std::size_t>(threads - 1)]->step();
    const double triad = triad_bandwidth(step_footprint(model), threads);
    const std::string name =
        fmt::format("explicit.{}.{}.{}_thread{}", c.name, size, threads, threads == 1 ? "" : "s");
    fmt::print("  triad of the same size, {} thread{}: {:.1f} GB/s; the step uses {:.0f} % of it\n",
               threads, threads == 1 ? "" : "s", 1e-9 * triad, 100.0 * bytes / step / triad);
    results.report(name, nanoseconds(step), "ns/triangle-step");
    results.report(name + ".share_of_triad", bytes / step / triad, "1");
  }
  const std::string name = fmt::format("explicit.{}.{}", c.name, size);
  results.report(name + ".host_over_serial", one.step() / serial.step(), "1");
  results.must_hold(name + ".same_bits", serial.hash() == one.hash() && one.hash() == two.hash());
}

void measure(Results& results) {
  FlowCase tied;
  FlowCase finite;
  finite.joints = seepage::PoreJoints::finite;
  FlowCase tied_partly = tied;
  tied_partly.partly_empty = true;
  FlowCase finite_partly = finite;
  finite_partly.partly_empty = true;
  for (const std::int32_t triangles : {100'000, 1'000'000}) {
    const mesh::Mesh mesh = make_flow_mesh(triangles);
    for (const Case& c :
         {Case{"tied_full", tied}, Case{"tied_partly_empty", tied_partly},
          Case{"finite_full", finite}, Case{"finite_partly_empty", finite_partly}}) {
      measure_case(c, mesh, results);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  return percolith::bench::run_benchmark(argc, argv, measure);
}
