// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/quasi_static.hpp"

#include "percolith/core/error.hpp"
#include "percolith/coupling/breakage.hpp"
#include "percolith/coupling/compliance.hpp"
#include "percolith/coupling/motion_to_volume.hpp"
#include "percolith/coupling/pressure_to_force.hpp"
#include "percolith/mechanics/pressed_faces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace percolith::coupling {
namespace {

constexpr int most_iterations = 60;
constexpr int most_halvings = 10;
constexpr int most_motion_steps = 20'000;
constexpr int motion_steps_between_checks = 25;
/// The unbalanced force swings while waves pass: rest is where it is small this often in a row.
constexpr int checks_at_rest = 3;
/// An iteration that contracts less than so takes the rock for softer.
constexpr double least_contraction = 0.8;
constexpr double softest = 256.0;

/// Keeps the pressures of cracks while volumes change: derived from contents they would answer to
/// the last digits of the volumes, because the fluid is so much stiffer than the rock.
class KeptCrackPressures {
public:
  explicit KeptCrackPressures(seepage::Model& water)
      : water_(&water), open_(water.cracks.open_nodes()) {
    for (const Index v : open_) {
      pressure_.push_back(water.state.crack_pressure[at(v)]);
      saturation_.push_back(water.state.crack_saturation[at(v)]);
    }
  }
  KeptCrackPressures(const KeptCrackPressures&) = delete;
  KeptCrackPressures& operator=(const KeptCrackPressures&) = delete;
  ~KeptCrackPressures() {
    for (std::size_t i = 0; i < open_.size(); ++i) {
      water_->state.crack_pressure[at(open_[i])] = pressure_[i];
      water_->state.crack_saturation[at(open_[i])] = saturation_[i];
    }
  }

private:
  seepage::Model* water_;
  std::vector<Index> open_;
  std::vector<double> pressure_, saturation_;
};

}  // namespace

QuasiStatic::QuasiStatic(CoupledModel& model, const QuasiStaticOptions& options)
    : model_(&model), options_(options), soft_pores_(pore_compliance(model)) {
  network_changed();
}

void QuasiStatic::network_changed() {
  flow_ = std::make_unique<seepage::ImplicitFlow>(model_->water);
}

void QuasiStatic::describe_state(StateArchive& archive) {
  if (archive.reads()) {
    network_changed();
  }
  archive("flow", *flow_);
  archive("leaked", leaked_);
  archive("softness", softness_);
  archive("iterations", iterations_);
  archive("parts", parts_);
}

mechanics::Changes QuasiStatic::advance(double dt, Execution& execution) {
  seepage::Model& water = model_->water;
  const double start = water.state.time;
  iterations_ = 0;
  parts_ = 0;
  changes_ = {};
  bookings_.clear();
  time_ = start;
  advance_part(dt, 0, execution);
  seepage::book_step(water, bookings_, dt);
  water.state.time = start + dt;
  model_->rock.model().motion.time = start + dt;
  return std::move(changes_);
}

void QuasiStatic::advance_part(double dt, int halvings, Execution& execution) {
  if (solve(dt, execution)) {
    ++parts_;
    const auto booked = flow_->bookings();
    bookings_.insert(bookings_.end(), booked.begin(), booked.end());
    leaked_ += flow_->leaked_from_cracks(model_->water);
    {
      const KeptCrackPressures kept(model_->water);
      flow_->apply(model_->water);
    }
    time_ += dt;
    return;
  }
  if (halvings == most_halvings) {
    throw SolverError(fmt::format(
        "rock and fluid find no common state at time {:.9g} s even with a step of {:.3g} s; the "
        "results up to the last output are kept. A rock that breaks through suddenly has none: "
        "time.scheme = \"explicit\" follows it",
        time_, dt));
  }
  advance_part(0.5 * dt, halvings + 1, execution);
  advance_part(0.5 * dt, halvings + 1, execution);
}

bool QuasiStatic::solve(double dt, Execution& execution) {
  measure(execution);
  softness_ = std::max(1.0, 0.8 * softness_);
  double last_change = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    ++iterations_;
    before_ = pressures_of(model_->water);
    if (!solve_flow(dt, execution)) {
      return false;
    }
    flow_->show_pressures(model_->water);
    const double change = largest_change();
    // The first pressures are those of a rock that has not felt this step yet.
    if (iteration > 0 && is_at_rest_ && !broke_ && change < options_.pressure_tolerance) {
      return true;
    }
    if (iteration > 1 && !broke_ && change > least_contraction * last_change) {
      softness_ = std::min(2.0 * softness_, softest);
    }
    last_change = broke_ ? std::numeric_limits<double>::infinity() : change;
    model_->rock.model().motion.time = time_ + dt;
    relax(execution);
    measure(execution);
  }
  return false;
}

bool QuasiStatic::solve_flow(double dt, Execution& execution) {
  flow_->refresh(model_->water);
  set_compliance();
  return flow_->attempt(model_->water, time_, dt, execution, compliance_);
}

void QuasiStatic::set_compliance() {
  const std::vector<double> cracks = crack_compliance(*model_);
  const seepage::FlowGraph& graph = flow_->graph();
  compliance_.assign(at(graph.nodes()), 0.0);
  for (Index n = 0; n < graph.nodes(); ++n) {
    for (const Index member : graph.members.row(n)) {
      if (member < 0) {
        compliance_[at(n)] += softness_ * cracks[at(-1 - member)];
      } else {
        model_->water.pore_nodes.for_each_corner(model_->water.mesh, member, [&](Index corner) {
          compliance_[at(n)] += soft_pores_[at(corner)];
        });
      }
    }
  }
}

double QuasiStatic::largest_change() const {
  const std::vector<double> now = pressures_of(model_->water);
  double change = 0.0;
  double largest = 1e-300;
  for (std::size_t i = 0; i < std::min(now.size(), before_.size()); ++i) {
    change = std::max(change, std::abs(now[i] - before_[i]));
    largest = std::max(largest, std::abs(now[i]));
  }
  return change / largest;
}

void QuasiStatic::relax(Execution& execution) {
  mechanics::Model& rock = model_->rock.model();
  const double time = rock.motion.time;
  broke_ = false;
  is_at_rest_ = false;
  int calm = 0;
  apply_pressures(*model_);
  for (int step = 1; step <= most_motion_steps; ++step) {
    const bool broke = note(model_->rock.advance(options_.motion_step, execution));
    rock.motion.time = time;
    broke_ = broke_ || broke;
    const bool check = step % motion_steps_between_checks == 0;
    if (check) {
      calm = model_->rock.unbalanced_ratio() < options_.balance_tolerance ? calm + 1 : 0;
    }
    if (calm == checks_at_rest) {
      is_at_rest_ = true;
      return;
    }
    if (broke) {
      // New faces feel the fluid from the next solution of the flow on.
      measure(execution);
      apply_pressures(*model_);
    }
    mechanics::measure_faces(rock, execution);
  }
}

bool QuasiStatic::note(mechanics::Changes changes) {
  const KeptCrackPressures kept(model_->water);
  const bool opened = !open_network(*model_, changes).empty();
  if (opened) {
    network_changed();
  }
  changes_.broke.insert(changes_.broke.end(), changes.broke.begin(), changes.broke.end());
  changes_.parted.insert(changes_.parted.end(), changes.parted.begin(), changes.parted.end());
  return opened || !changes.broke.empty();
}

/// Volumes follow the rock; pressures stay as the flow found them.
void QuasiStatic::measure(Execution& execution) {
  seepage::Model& water = model_->water;
  const KeptCrackPressures kept(water);
  take_volumes(*model_, execution);
  seepage::take_growth(water);
}

}  // namespace percolith::coupling
