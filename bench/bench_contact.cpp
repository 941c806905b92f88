// SPDX-License-Identifier: BSD-3-Clause
// Time of contact in a block that is broken along every joint, its 1e5 triangles pushed into each
// other at random: forces of one step, and a search; the same bits on one thread and two.
#include "percolith/mechanics/contact/contact.hpp"

#include <fmt/format.h>

#include <random>

#include "bench/support/grid_mesh.hpp"
#include "bench/support/measure.hpp"
#include "bench/support/results.hpp"

namespace {

using namespace percolith;
using namespace percolith::bench;

/// Every triangle moved as a whole by up to `share` of a cell.
struct Rubble {
  mesh::Mesh mesh;
  std::vector<double> ux, uy, vx, vy;
  double cell = 0.0;

  Rubble(std::int32_t triangles, double share) {
    const std::int32_t n = cells_for(triangles);
    mesh = mesh::build_mesh(grid_mesh(n));
    cell = 1.0 / n;
    for (auto* values : {&ux, &uy, &vx, &vy}) {
      values->assign(at(mesh.corners()), 0.0);
    }
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> shift(-share * cell, share * cell);
    for (Index t = 0; t < mesh.triangles(); ++t) {
      const double x = shift(random);
      const double y = shift(random);
      for (Index k = 0; k < 3; ++k) {
        const auto slot = at(mesh::corner_of(t, k));
        ux[slot] = x;
        uy[slot] = y;
        vx[slot] = -x;
        vy[slot] = y;
      }
    }
  }
  [[nodiscard]] mechanics::CornerMotion motion() const { return {ux, uy, vx, vy}; }
};

mechanics::Contact make_contact(const Rubble& rubble) {
  const std::size_t n = rubble.mesh.triangle_vertex.size();
  mechanics::Contact contact(rubble.mesh, {std::vector<double>(n, 1e10),
                                           std::vector<double>(n, 1e10 / rubble.cell),
                                           std::vector<double>(n, 0.6)});
  const std::vector<std::uint8_t> candidate(n, 1);
  const std::vector<std::uint8_t> tied(rubble.mesh.joint.size(), 0);
  const std::vector<std::uint8_t> touch(rubble.mesh.joint.size(), 1);
  const mesh::NodeMap fans(rubble.mesh, tied);
  contact.topology_changed(rubble.mesh, {candidate, &fans, touch});
  return contact;
}

std::string hash_after_steps(const Rubble& rubble, int threads) {
  Execution execution(Backend::host, threads);
  mechanics::Contact contact = make_contact(rubble);
  for (int i = 0; i < 3; ++i) {
    contact.advance(rubble.mesh, rubble.motion(), 0.0, 1e-4, execution);
  }
  StateHash hash;
  contact.add_to(hash);
  return hash.text();
}

void measure(Results& results) {
  const Rubble rubble(100'000, 0.002);
  Execution execution(Backend::host, 1);
  mechanics::Contact contact = make_contact(rubble);
  Best step;
  Best search;
  for (int round = 0; round < 40; ++round) {
    const bool far = round % 10 == 0;
    const Stopwatch watch;
    contact.advance(rubble.mesh, rubble.motion(), far ? rubble.cell : 0.0, 1e-4, execution);
    (far ? search : step).add(watch.seconds());
  }
  const double count = rubble.mesh.triangles();
  const double pairs = contact.listed_pairs();
  fmt::print("\n{} triangles, {:.2f} pairs a triangle, {:.2f} of them overlap\n", count,
             pairs / count, contact.touching_pairs() / count);
  const auto row = [&](const char* text, const std::string& name, double seconds) {
    fmt::print("  {:<28}{:>8.1f} ns/triangle {:>8.1f} ns/pair\n", text, 1e9 * seconds / count,
               1e9 * seconds / pairs);
    results.report("contact.1e5." + name, 1e9 * seconds / count, "ns/triangle");
  };
  row("forces of a step", "forces", step.value());
  row("a search", "search", search.value() - step.value());
  results.must_hold("contact.1e5.same_bits",
                    hash_after_steps(rubble, 1) == hash_after_steps(rubble, 2));
}

}  // namespace

int main(int argc, char** argv) {
  return percolith::bench::run_benchmark(argc, argv, measure);
}
