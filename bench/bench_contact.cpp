// SPDX-License-Identifier: BSD-3-Clause
// Time of contact in a block that is broken along every joint, its triangles pushed into each other
// at random: forces of one step, a search, and a step after one joint broke; the same bits on one
// thread and two.
#include "percolith/mechanics/contact/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
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

/// Joints that are left to break.
constexpr Index last_joints = 20;

/// The contact of rubble, all of whose joints are broken but the last ones.
class Contacts {
public:
  Contacts(const Rubble& rubble, int threads)
      : rubble_(&rubble), execution_(Backend::host, threads),
        contact_(rubble.mesh, properties(rubble)),
        candidate_(rubble.mesh.triangle_vertex.size(), 1), bonded_(rubble.mesh.joint.size(), 0),
        touch_(rubble.mesh.joint.size(), 1) {
    std::fill_n(bonded_.begin(), last_joints, std::uint8_t{1});
    std::fill_n(touch_.begin(), last_joints, std::uint8_t{0});
    contact_.topology_changed(rubble.mesh, topology());
  }
  /// Seconds of a step after a way of `travelled`.
  double advance(double travelled) {
    const Stopwatch watch;
    contact_.advance(rubble_->mesh, rubble_->motion(), travelled, 1e-4, execution_);
    return watch.seconds();
  }
  /// Seconds of a step in which a joint comes loose.
  double break_joint(Index joint) {
    bonded_[at(joint)] = 0;
    touch_[at(joint)] = 1;
    const std::array<Index, 1> broken{joint};
    const mechanics::ContactTopology now = topology();
    const Stopwatch watch;
    contact_.topology_changed(rubble_->mesh, now, broken);
    return watch.seconds() + advance(0.0);
  }
  [[nodiscard]] std::string hash() const {
    StateHash hash;
    contact_.add_to(hash);
    return hash.text();
  }
  [[nodiscard]] const mechanics::Contact& contact() const { return contact_; }

private:
  static mechanics::ContactProperties properties(const Rubble& rubble) {
    const std::size_t n = rubble.mesh.triangle_vertex.size();
    return {std::vector<double>(n, 1e10), std::vector<double>(n, 1e10 / rubble.cell),
            std::vector<double>(n, 0.6)};
  }
  mechanics::ContactTopology topology() {
    fans_.emplace(rubble_->mesh, bonded_);
    return {candidate_, &*fans_, touch_};
  }

  const Rubble* rubble_;
  Execution execution_;
  mechanics::Contact contact_;
  std::vector<std::uint8_t> candidate_, bonded_, touch_;
  std::optional<mesh::NodeMap> fans_;
};

struct Timing {
  double step = 0.0, search = 0.0, broken = 0.0;
};

Timing best_of(const Rubble& rubble, int threads, int rounds) {
  Contacts contacts(rubble, threads);
  contacts.advance(0.0);
  Best step;
  Best search;
  Best broken;
  for (int round = 0; round < rounds; ++round) {
    step.add(contacts.advance(0.0));
    if (round % 10 == 0) {
      search.add(contacts.advance(rubble.cell));
    }
  }
  for (Index joint = 0; joint < last_joints; ++joint) {
    broken.add(contacts.break_joint(joint));
  }
  return {step.value(), search.value() - step.value(), broken.value()};
}

void measure_size(Results& results, std::int32_t triangles, const std::string& size, int rounds) {
  const Rubble rubble(triangles, 0.002);
  const Timing one = best_of(rubble, 1, rounds);
  const Timing two = best_of(rubble, 2, rounds);
  Contacts first(rubble, 1);
  Contacts second(rubble, 2);
  for (int i = 0; i < 3; ++i) {
    first.advance(0.0);
    second.advance(0.0);
  }
  const double count = rubble.mesh.triangles();
  fmt::print("\n{} triangles, {:.2f} pairs a triangle, {:.2f} of them overlap; ns/triangle\n",
             count, first.contact().listed_pairs() / count,
             first.contact().touching_pairs() / count);
  fmt::print("  {:<32}{:>10}{:>10}\n", "", "1 thread", "2 threads");
  const auto row = [&](const char* text, const std::string& name, double Timing::*member) {
    const double t1 = 1e9 * one.*member / count;
    const double t2 = 1e9 * two.*member / count;
    fmt::print("  {:<32}{:>10.1f}{:>10.1f}\n", text, t1, t2);
    results.report(fmt::format("contact.{}.{}.1_thread", size, name), t1, "ns/triangle");
    results.report(fmt::format("contact.{}.{}.2_threads", size, name), t2, "ns/triangle");
  };
  row("forces of a step", "forces", &Timing::step);
  row("a search", "search", &Timing::search);
  row("a step in which a joint breaks", "joint_breaks", &Timing::broken);
  results.must_hold(fmt::format("contact.{}.same_bits", size), first.hash() == second.hash());
}

void measure(Results& results) {
  measure_size(results, 8'000, "8e3", 500);
  measure_size(results, 100'000, "1e5", 60);
}

}  // namespace

int main(int argc, char** argv) {
  return percolith::bench::run_benchmark(argc, argv, measure);
}
