// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"

#include <span>

namespace percolith::seepage {

/// What a condition lets into one node: a volume (m2) in a step, a rate (m2/s) in a steady state;
/// negative when it leaves.
struct Booking {
  Index condition = 0;
  Index vertex = 0;
  double amount = 0.0;
};

/// Adds the bookings of a step of `dt` seconds to the accounts of the model and sets its rates.
/// Consecutive bookings of one condition at one vertex are netted first: what passes between the
/// corners of one vertex neither enters nor leaves.
void book_step(Model& model, std::span<const Booking> bookings, double dt);

/// Sets the rates of the model to those of a steady state; no volume passes.
void book_steady(Model& model, std::span<const Booking> bookings);

}  // namespace percolith::seepage
