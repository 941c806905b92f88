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

CoupledStep::CoupledStep(CoupledModel& model, PoreFlow pore_flow, double pore_limit)
    : model_(&model), pore_limit_(pore_limit) {
  if (pore_flow == PoreFlow::explicit_) {
    pores_.emplace(model.water, seepage::Fields::pores);
  }
  implicit_ = make_implicit();
}

std::unique_ptr<seepage::ImplicitFlow> CoupledStep::make_implicit() const {
  return std::make_unique<seepage::ImplicitFlow>(model_->water, pores_ ? seepage::Network::cracks
                                                                       : seepage::Network::all);
}

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
  if (pores_) {
    pores_->network_changed(model_->water);
  }
  implicit_ = make_implicit();
}

void CoupledStep::describe_state(StateArchive& archive) {
  if (archive.reads()) {
    network_changed();
  }
  archive("implicit", *implicit_);
  archive("leaked", leaked_);
  archive("iterations", iterations_);
}

void CoupledStep::flow(double dt, Execution& execution) {
  seepage::Model& water = model_->water;
  const double t = water.state.time;
  bookings_.clear();
  iterations_ = 0;
  const auto start = std::chrono::steady_clock::now();
  if (pores_) {
    if (!water.cracks.broken_joints().empty()) {
      flow_implicitly(t, dt, 0, execution);
    }
    execution.book("crack flow", start);
    flow_in_pores(t, dt, execution);
  } else {
    seepage::take_growth(water);
    flow_implicitly(t, dt, 0, execution);
    execution.book("implicit flow", start);
  }
  seepage::book_step(water, bookings_, dt);
  water.state.time = t + dt;
}

void CoupledStep::flow_implicitly(double t, double dt, int halvings, Execution& execution) {
  constexpr int most_halvings = 12;
  implicit_->refresh(model_->water);
  if (implicit_->attempt(model_->water, t, dt, execution)) {
    iterations_ += implicit_->iterations();
    leaked_ += implicit_->leaked_from_cracks(model_->water);
    implicit_->apply(model_->water);
    const auto booked = implicit_->bookings();
    bookings_.insert(bookings_.end(), booked.begin(), booked.end());
    return;
  }
  if (halvings == most_halvings) {
    throw SolverError(fmt::format(
        "the flow in the {} found no solution at time {:.9g} s even with a step of {:.3g} s{}; the "
        "results up to the last output are kept. Look for a rate that takes more fluid than there "
        "is, or cracks pressed shut with too small a minimum_aperture",
        pores_ ? "cracks" : "cracks and pores", t, dt, narrowest_place(model_->water)));
  }
  flow_implicitly(t, 0.5 * dt, halvings + 1, execution);
  flow_implicitly(t + 0.5 * dt, 0.5 * dt, halvings + 1, execution);
}

void CoupledStep::flow_in_pores(double t, double dt, Execution& execution) {
  const double steps = std::max(1.0, std::ceil(dt / pore_limit_));
  const double part = dt / steps;
  for (double k = 0.0; k < steps; k += 1.0) {
    pores_->step(model_->water, t + k * part, part, execution, bookings_);
  }
}

}  // namespace percolith::coupling
