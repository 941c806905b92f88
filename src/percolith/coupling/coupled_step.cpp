// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/coupled_step.hpp"

#include "percolith/core/error.hpp"
#include "percolith/coupling/breakage.hpp"
#include "percolith/coupling/motion_to_volume.hpp"
#include "percolith/coupling/pressure_to_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace percolith::coupling {
namespace {

/// The crack node with the least room per length of its joints, in words.
std::string narrowest_place(const seepage::Model& water) {
  mesh::Index narrowest = mesh::none;
  double least = std::numeric_limits<double>::infinity();
  for (const mesh::Index v : water.cracks.open_nodes()) {
    double half_length = 0.0;
    for (const mesh::Index j : water.mesh.vertex_joints.row(v)) {
      half_length += water.cracks.is_broken(j) ? 0.5 * water.mesh.joint_length(j) : 0.0;
    }
    const double aperture = water.crack.void_volume[at(v)] / half_length;
    if (aperture < least) {
      least = aperture;
      narrowest = v;
    }
  }
  if (narrowest == mesh::none) {
    return {};
  }
  const Point p = water.mesh.vertex[at(narrowest)];
  return fmt::format("; the crack node with the least room, an aperture of {:.3g} m, is at "
                     "({:.6g}, {:.6g})",
                     least, p.x, p.y);
}

}  // namespace

CoupledStep::CoupledStep(CoupledModel& model, double pore_limit)
    : model_(&model), pore_limit_(pore_limit), pores_(model.water, seepage::Fields::pores),
      cracks_(std::make_unique<seepage::ImplicitFlow>(model.water, seepage::Network::cracks)) {}

mechanics::Changes CoupledStep::advance(double dt, Execution& execution) {
  apply_pressures(*model_);
  mechanics::Changes changes = model_->rock.advance(dt, execution);
  const auto start = std::chrono::steady_clock::now();
  if (!open_network(*model_, changes).empty()) {
    network_changed();
  }
  execution.book("breakage", start);
  take_volumes(*model_, execution);
  flow(dt, execution);
  return changes;
}

void CoupledStep::network_changed() {
  pores_.network_changed(model_->water);
  cracks_ = std::make_unique<seepage::ImplicitFlow>(model_->water, seepage::Network::cracks);
}

void CoupledStep::describe_state(StateArchive& archive) {
  if (archive.reads()) {
    network_changed();
  }
  archive("cracks", *cracks_);
  archive("leaked", leaked_);
  archive("iterations", iterations_);
}

void CoupledStep::flow(double dt, Execution& execution) {
  seepage::Model& water = model_->water;
  const double t = water.state.time;
  bookings_.clear();
  iterations_ = 0;
  const auto start = std::chrono::steady_clock::now();
  if (!water.cracks.broken_joints().empty()) {
    flow_in_cracks(t, dt, 0, execution);
  }
  execution.book("crack flow", start);
  flow_in_pores(t, dt, execution);
  seepage::book_step(water, bookings_, dt);
  water.state.time = t + dt;
}

void CoupledStep::flow_in_cracks(double t, double dt, int halvings, Execution& execution) {
  constexpr int most_halvings = 12;
  cracks_->refresh(model_->water);
  if (cracks_->attempt(model_->water, t, dt, execution)) {
    iterations_ += cracks_->iterations();
    leaked_ += cracks_->leaked_from_cracks(dt);
    cracks_->apply(model_->water);
    const auto booked = cracks_->bookings();
    bookings_.insert(bookings_.end(), booked.begin(), booked.end());
    return;
  }
  if (halvings == most_halvings) {
    throw SolverError(fmt::format(
        "the flow in the cracks found no solution at time {:.9g} s even with a step of {:.3g} s{}; "
        "the results up to the last output are kept. Look for a rate that takes more fluid than "
        "there is, or cracks pressed shut with too small a minimum_aperture",
        t, dt, narrowest_place(model_->water)));
  }
  flow_in_cracks(t, 0.5 * dt, halvings + 1, execution);
  flow_in_cracks(t + 0.5 * dt, 0.5 * dt, halvings + 1, execution);
}

void CoupledStep::flow_in_pores(double t, double dt, Execution& execution) {
  const double steps = std::max(1.0, std::ceil(dt / pore_limit_));
  const double part = dt / steps;
  for (double k = 0.0; k < steps; k += 1.0) {
    pores_.step(model_->water, t + k * part, part, execution, bookings_);
  }
}

}  // namespace percolith::coupling
