// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/quasi_static.hpp"

#include "percolith/core/error.hpp"
#include "percolith/coupling/breakage.hpp"
#include "percolith/coupling/compliance.hpp"
#include "percolith/coupling/motion_to_volume.hpp"
#include "percolith/coupling/pressure_rise.hpp"
#include "percolith/coupling/pressure_to_force.hpp"
#include "percolith/mechanics/pressed_faces.hpp"
#include "percolith/mechanics/state.hpp"
#include "percolith/seepage/state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percolith::coupling {
namespace {

/// Iterations between flow and motion that a part of a step may take.
constexpr int most_iterations = 60;
/// The shortest part of a step is 2^-10 of it.
constexpr int most_halvings = 10;
/// Of these iterations, those after which the rock is not at rest because cracks run on in it: in
/// motion, and on the way of the whole rock.
constexpr int most_restless = 600;
constexpr int most_growths = 60;
/// Cracks may grow on the way of the whole rock as long as its books miss no more than this share
/// of what bonds and friction took, or that of the work of the fluid: they miss more where rock
/// jumps.
constexpr double largest_miss = 0.02;
constexpr double largest_miss_of_fluid = 1e-3;
/// And as long as the medium takes no more than this many times what bonds and friction took,
/// besides what the rock keeps: a crack that runs under pressures which do not fall in time gets
/// energy that its fluid does not have.
constexpr double largest_loss = 3.0;
/// Evaluations of the forces in which the rock must come to rest as a whole.
constexpr int most_pulls = 600;
/// Steps of damped motion between two solutions of the flow while cracks run.
constexpr int steps_with_cracks = 25;
/// Iterations without a break after which cracks are taken to have stopped.
constexpr int calm_enough = 5;
/// Steps of damped motion between two of them once cracks have stopped; and steps in a row, while
/// waves pass, in which forces must be in balance.
constexpr int most_swings = 4000;
constexpr int swings_at_rest = 50;
/// The least force that the rock has to balance, over the internal forces.
constexpr double least_force = 1e-5;
/// Bounds of the factor on the compliance of cracks, and of its change in an iteration.
constexpr double stiffest = 0.1;
constexpr double softest = 256.0;
constexpr double most_softening = 4.0;
/// Rock may break in a part of a step whose pressures rise by this share of the largest at most:
/// what breaks in a longer one breaks under pressures that it would not have let come up.
constexpr double largest_rise = 0.05;

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

/// Whether cracks have grown steadily between two moments: their energy is accounted for, and
/// little of it is lost on the way.
bool grew_steadily(const mechanics::EnergyBalance& a, const mechanics::EnergyBalance& b) {
  const double spent = std::abs(b.fracture - a.fracture) + std::abs(b.friction - a.friction);
  const double allowed =
      std::max(largest_miss * spent, largest_miss_of_fluid * std::abs(b.fluid - a.fluid));
  const double kept = std::abs((b.elastic + b.joint) - (a.elastic + a.joint));
  return std::abs(b.residual - a.residual) <= allowed &&
         std::abs(b.damping - a.damping) <= largest_loss * spent + kept;
}

/// A sentence with a space before it, or nothing where nothing broke.
std::string place_of_last_break(const mechanics::Model& rock, const mechanics::Changes& changes) {
  if (changes.broke.empty()) {
    return {};
  }
  const Point middle = rock.mesh.middle_of(rock.mesh.joint[at(changes.broke.back().joint)].vertex);
  return fmt::format(" Of the {} joints that broke the last lies at ({:.3g}, {:.3g}).",
                     changes.broke.size(), middle.x, middle.y);
}

}  // namespace

QuasiStatic::QuasiStatic(CoupledModel& model, const QuasiStaticOptions& options)
    : model_(&model), options_(options), relaxation_(model.rock),
      soft_pores_(pore_compliance(model)) {
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
  changes_ = {};
  bookings_.clear();
  time_ = start;
  gave_up_ = false;
  // So that a run that was resumed goes on like one that was not.
  relaxation_.forget();
  const Moment before = present_moment();
  iterations_ = 0;
  parts_ = 0;
  advance_part(dt, 0, before, execution);
  if (gave_up_) {
    go_back(before);
    return {};
  }
  seepage::book_step(water, bookings_, dt);
  water.state.time = start + dt;
  model_->rock.model().motion.time = start + dt;
  return std::move(changes_);
}

/// From `start`, which is now.
void QuasiStatic::advance_part(double dt, int halvings, const Moment& start, Execution& execution) {
  Ending ending = solve_as_whole(dt, halvings < most_halvings, execution);
  if (ending.wants_motion && !gave_up_) {
    try_again_from(start);
    pace_ = Pace::swinging;
    ending = solve(dt, halvings < most_halvings, execution);
  }
  if (gave_up_) {
    return;
  }
  if (ending.is_solved) {
    accept(dt);
    return;
  }
  if (halvings == most_halvings) {
    refuse(dt, ending);
  }
  try_again_from(start);
  advance_part(0.5 * dt, halvings + 1, start, execution);
  if (!gave_up_) {
    advance_part(0.5 * dt, halvings + 1, present_moment(), execution);
  }
}

/// Cracks that grow steadily are followed as well; those that run on want motion.
QuasiStatic::Ending QuasiStatic::solve_as_whole(double dt, bool may_be_too_long,
                                                Execution& execution) {
  const mechanics::EnergyBalance before = model_->rock.energy(execution);
  pace_ = Pace::pulling;
  Ending ending = solve(dt, may_be_too_long, execution);
  if (ending.broke && !ending.is_too_long) {
    const mechanics::EnergyBalance after = model_->rock.energy(execution);
    ending.wants_motion = !ending.is_solved || !grew_steadily(before, after);
  }
  return ending;
}

void QuasiStatic::accept(double dt) {
  ++parts_;
  const auto booked = flow_->bookings();
  bookings_.insert(bookings_.end(), booked.begin(), booked.end());
  leaked_ += flow_->leaked_from_cracks(model_->water);
  const KeptCrackPressures kept(model_->water);
  flow_->apply(model_->water);
  time_ += dt;
}

QuasiStatic::Ending QuasiStatic::solve(double dt, bool may_be_too_long, Execution& execution) {
  measure(execution);
  PressureRise rise(model_->water);
  Approach approach;
  bool broke = false;
  int settled = 0;
  int restless = 0;
  const int patience = pace_ == Pace::pulling ? most_growths : most_restless;
  while (settled < most_iterations && restless < patience) {
    ++iterations_;
    const std::vector<double> before = pressures_of(model_->water);
    if (!solve_flow(dt, execution)) {
      return {.broke = broke};
    }
    flow_->show_pressures(model_->water);
    approach.see(before, pressures_of(model_->water), model_->water.state.pressure.size(),
                 softness_);
    if (is_settled(approach)) {
      return {.is_solved = true, .broke = broke, .distance = approach.distance()};
    }
    soften(approach);
    if (!broke) {
      rise.see(model_->water);
    }
    model_->rock.model().motion.time = time_ + dt;
    relax(execution);
    if (pace_ == Pace::pulling && !is_at_rest_ && !broke_) {
      return {.wants_motion = true};
    }
    broke = broke || broke_;
    (is_at_rest_ ? settled : restless) += 1;
    if (gave_up_ || (may_be_too_long && broke && rise.largest() > largest_rise)) {
      return {.is_too_long = true, .broke = broke, .distance = approach.distance()};
    }
    measure(execution);
    if (broke_ || !is_at_rest_) {
      approach.forget();
    }
  }
  return {.broke = broke, .distance = approach.distance()};
}

/// The first pressures are those of a rock that has not felt this step yet.
bool QuasiStatic::is_settled(const Approach& approach) const {
  return approach.softness() && is_at_rest_ && !broke_ &&
         approach.distance() < options_.pressure_tolerance;
}

void QuasiStatic::soften(const Approach& approach) {
  if (approach.softness()) {
    const double found = *approach.softness();
    const double wanted = found > 0.0 ? found : most_softening * softness_;
    softness_ =
        std::clamp(std::clamp(wanted, softness_ / most_softening, most_softening * softness_),
                   stiffest, softest);
  }
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

/// Towards the balance of forces under the present pressures, as far as the pace goes.
void QuasiStatic::relax(Execution& execution) {
  broke_ = false;
  is_at_rest_ = false;
  apply_pressures(*model_);
  switch (pace_) {
  case Pace::pulling:
    pull_to_rest(execution);
    break;
  case Pace::following:
    follow_cracks(execution);
    break;
  case Pace::swinging:
    swing_to_rest(execution);
    break;
  case Pace::settling:
    settle(execution);
    break;
  }
  relaxation_.end(execution);
}

/// Where rock breaks, so that the fluid is asked before it goes on, or lies so that it goes nowhere
/// as a whole, it ends short of rest.
void QuasiStatic::pull_to_rest(Execution& execution) {
  relaxation_.begin(execution);
  for (int step = 1; step <= most_pulls && !is_asked_to_stop(); ++step) {
    take(relaxation_.pull(execution), execution);
    if (broke_ || relaxation_.is_lost()) {
      return;
    }
    is_at_rest_ = is_balanced();
    if (is_at_rest_) {
      return;
    }
  }
}

/// Some steps from rest before the fluid is asked again: what breaks must feel at once how the
/// pressure falls in the room that it makes.
void QuasiStatic::follow_cracks(Execution& execution) {
  relaxation_.begin(execution);
  for (int step = 0; step < steps_with_cracks && !is_asked_to_stop(); ++step) {
    take(relaxation_.swing(execution), execution);
  }
  calm_ = broke_ ? 0 : calm_ + 1;
  if (calm_ == calm_enough) {
    pace_ = Pace::swinging;
  }
}

void QuasiStatic::swing_to_rest(Execution& execution) {
  relaxation_.begin(execution);
  int balanced = 0;
  for (int step = 1; step <= most_swings && !is_asked_to_stop() && !broke_; ++step) {
    take(relaxation_.swing(execution), execution);
    balanced = is_balanced() ? balanced + 1 : 0;
    is_at_rest_ = balanced == swings_at_rest;
    if (is_at_rest_) {
      return;
    }
  }
  follow_or(Pace::settling);
}

/// What motion has brought near to rest goes the last, slow part of the way as a whole.
void QuasiStatic::settle(Execution& execution) {
  pull_to_rest(execution);
  if (!is_at_rest_) {
    follow_or(Pace::swinging);
  }
}

void QuasiStatic::follow_or(Pace other) {
  pace_ = broke_ ? Pace::following : other;
  calm_ = 0;
}

/// Takes over what a step of the relaxation changed.
void QuasiStatic::take(mechanics::Changes changes, Execution& execution) {
  if (note(std::move(changes))) {
    broke_ = true;
    // New faces feel the fluid from the next solution of the flow on.
    measure(execution);
    apply_pressures(*model_);
  }
  mechanics::measure_faces(model_->rock.model(), execution);
}

/// The force of the fluid on the faces of cracks, if there are any, is what the rock has to
/// balance; stress from elsewhere may be much larger in a large block and tells nothing of the
/// cracks.
double QuasiStatic::force_to_balance() const {
  const mechanics::Model& rock = model_->rock.model();
  double on_faces = 0.0;
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    on_faces += rock.joints.length[at(faces.joint)] *
                (std::abs(faces.pressure[0]) + std::abs(faces.pressure[1]));
  }
  const double internal = rock.energy.internal;
  return on_faces > 0.0 ? std::clamp(on_faces, least_force * internal, internal) : internal;
}

double QuasiStatic::unbalanced_ratio() const {
  const double force = force_to_balance();
  return force > 0.0 ? model_->rock.model().energy.unbalanced / force : 0.0;
}

Doing QuasiStatic::doing() const {
  const auto broke = static_cast<std::int64_t>(changes_.broke.size());
  switch (pace_) {
  case Pace::pulling:
    break;
  case Pace::swinging:
  case Pace::settling:
    return {"damped motion to rest", time_, broke};
  case Pace::following:
    return {"cracks run", time_, broke};
  }
  return {"fluid and rock settle", time_, broke};
}

bool QuasiStatic::is_asked_to_stop() {
  gave_up_ = gave_up_ || (stop_ && stop_());
  return gave_up_;
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

QuasiStatic::Moment QuasiStatic::present_moment() {
  Moment moment{{}, changes_.broke.size(), changes_.parted.size()};
  StateWriter writer([&](std::string_view bytes) { moment.state.append(bytes); });
  writer("rock", model_->rock);
  writer("water", model_->water);
  writer("scheme", *this);
  return moment;
}

void QuasiStatic::go_back(const Moment& moment) {
  StateReader reader(moment.state, "start of the step");
  reader("rock", model_->rock);
  reader("water", model_->water);
  model_->rock.model().pores.pressure = model_->water.state.pressure;
  model_->water.swelling = model_->rock.model().pores.growth;
  reader("scheme", *this);
  changes_.broke.erase(changes_.broke.begin() + static_cast<std::ptrdiff_t>(moment.broke),
                       changes_.broke.end());
  changes_.parted.erase(changes_.parted.begin() + static_cast<std::ptrdiff_t>(moment.parted),
                        changes_.parted.end());
}

/// Rock and fluid go back; what was learned and what it took stays.
void QuasiStatic::try_again_from(const Moment& moment) {
  const int iterations = iterations_;
  const double softness = softness_;
  go_back(moment);
  iterations_ = iterations;
  softness_ = softness;
  relaxation_.forget();
}

void QuasiStatic::refuse(double dt, const Ending& ending) const {
  const char* const way_out =
      ending.is_too_long || !changes_.broke.empty()
          ? "A rock that breaks through suddenly has none: time.scheme = \"explicit\" follows it"
      : is_at_rest_ ? "Raise time.tolerance or lower time.balance_tolerance"
                    : "Forces that stay out of balance want a higher time.balance_tolerance";
  const std::string last = place_of_last_break(model_->rock.model(), changes_);
  throw SolverError(fmt::format(
      "rock and fluid find no common state at time {:.9g} s even with a step of {:.3g} s; the "
      "results up to the last output are kept. The pressures are still {:.2g} of the largest "
      "away, allowed: {:g} (time.tolerance); the unbalanced force is {:.2g} of that to be "
      "balanced, allowed: {:g} (time.balance_tolerance).{} {}",
      time_, dt, ending.distance, options_.pressure_tolerance, unbalanced_ratio(),
      options_.balance_tolerance, last, way_out));
}

/// Volumes follow the rock; pressures stay as the flow found them.
void QuasiStatic::measure(Execution& execution) {
  seepage::Model& water = model_->water;
  const KeptCrackPressures kept(water);
  take_volumes(*model_, execution);
  seepage::take_growth(water);
}

}  // namespace percolith::coupling
