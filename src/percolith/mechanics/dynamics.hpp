// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/core/execution.hpp"
#include "percolith/core/hash.hpp"
#include "percolith/mechanics/breakage.hpp"
#include "percolith/mechanics/contact/contact.hpp"
#include "percolith/mechanics/energy.hpp"
#include "percolith/mechanics/loads.hpp"
#include "percolith/mechanics/node_motion.hpp"
#include "percolith/mechanics/supports.hpp"

namespace percolith::mechanics {

/// Advances the rock by explicit steps (theory.md section 12): forces from the present positions,
/// velocities from the forces, positions from the velocities, then what has failed breaks.
class Dynamics {
public:
  Dynamics(Model model, LoadList loads, SupportSet supports, ContactProperties contact);

  /// One step of `dt` seconds; the caller keeps dt below the stability limit.
  Changes advance(double dt, Execution& execution);

  /// One step of rock that creeps towards rest: leaves as velocity what the forces of the present
  /// places give masses at rest in `dt` (s), and lets it move the rock as long. The velocities
  /// before are those by which the rock has come here; time stands still.
  Changes creep(double dt, Execution& execution);
  /// The same of rock that stays, for a `shift` after it.
  Changes pull(double dt, Execution& execution);
  /// Moves the corners, on which `pull` has left its velocities, by `way` (m), x and y in turn per
  /// corner slot, and books works and energies.
  void shift(std::span<const double> way, double dt, Execution& execution);
  /// Takes all velocities away, and their energy as damping would. Corners go back to where they
  /// were in the middle of the last step: works are booked up to there.
  void halt(Execution& execution);

  /// Takes regions' triangles out at the present time; the forces they gave to the rest fade over
  /// `duration` (s), while a fluid of `pressure` (Pa) comes to press on the walls they leave.
  void take_out(std::span<const Index> triangles, double duration, double pressure = 0.0);

  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] Model& model() { return model_; }
  [[nodiscard]] const Contact& contact() const { return contact_; }
  [[nodiscard]] const SupportSet& supports() const { return supports_; }
  [[nodiscard]] const LoadSet& loads() const { return loads_; }
  [[nodiscard]] std::span<const double> contact_penalty() const { return contact_penalty_; }
  /// Sum of |unbalanced force| over the sum of |internal force| of the last step; 0 at rest.
  [[nodiscard]] double unbalanced_ratio() const;
  [[nodiscard]] EnergyBalance energy(const Execution& execution) const;
  /// Triangle pairs that overlap now, for a start that must have none.
  [[nodiscard]] std::vector<std::array<Index, 2>> overlapping() const;
  /// Adds all that later steps depend on.
  void add_to(StateHash& hash) const;
  /// All that later steps, and reports of them, depend on.
  void describe_state(StateArchive& archive);

private:
  void set_joint_forces(Execution& execution);
  Changes step(const MotionLaw& law, Execution& execution);
  LaneTotals<terms> move(const MotionLaw& law, Execution& execution);
  void book(const LaneTotals<terms>& totals, double dt);
  void book_works(const LaneTotals<terms>& totals);
  void start_contact();
  void renew_contact(const Changes& changes);

  Model model_;
  JointTable table_;
  LoadSet loads_;
  SupportSet supports_;
  std::vector<double> contact_penalty_;
  Contact contact_;
  std::vector<std::uint8_t> candidate_;    // per triangle, see `contact_candidates`
  std::vector<std::uint8_t> faces_touch_;  // per joint: 1 where it is broken
  NodeBuffers buffers_;
  EnergyStart start_;
  double travelled_ = 0.0;  // in the last step, m
};

/// Per triangle: 1 where it has a corner on the boundary or at the end of a joint that is neither
/// tied nor bonded.
[[nodiscard]] std::vector<std::uint8_t> contact_candidates(const Model& model);

}  // namespace percolith::mechanics
