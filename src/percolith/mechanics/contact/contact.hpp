// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/core/compensated.hpp"
#include "percolith/core/execution.hpp"
#include "percolith/core/hash.hpp"
#include "percolith/core/vec2.hpp"
#include "percolith/mechanics/contact/candidates.hpp"
#include "percolith/mechanics/contact/pair_force.hpp"
#include "percolith/mechanics/contact/pair_rows.hpp"
#include "percolith/mechanics/contact/pair_states.hpp"
#include "percolith/mechanics/contact/placed_triangle.hpp"
#include "percolith/mechanics/corner_force.hpp"
#include "percolith/mesh/mesh.hpp"
#include "percolith/mesh/node_map.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace percolith::mechanics {

/// What contact knows of the triangles, one entry each.
struct ContactProperties {
  std::vector<double> penalty;             ///< p_n of (4), Pa; a pair takes both in series
  std::vector<double> tangential_penalty;  ///< p_t of (6), Pa/m; a pair takes both in series
  std::vector<double> friction;            ///< tan(phi) of (7); a pair takes the smaller one
};

/// Which triangles may touch which.
struct ContactTopology {
  /// Per triangle: 1 where it has a corner on a free boundary or at the end of a joint that is not
  /// bonded; only these are searched. 0 also for triangles that have been taken out.
  std::span<const std::uint8_t> candidate;
  /// Corners that are connected through bonded joints round their vertex share a leader: two
  /// triangles with a shared leader do not touch, unless they face each other across a broken
  /// joint.
  const mesh::NodeMap* fans = nullptr;
  /// Per joint: 1 where its two triangles may touch (it is broken), 0 where a bonded joint or the
  /// friction of a closed one acts between them.
  std::span<const std::uint8_t> faces_touch;
};

/// The force a joint carried when it was given up, to be carried on by the contact of its faces.
struct HandOver {
  Index joint = 0;
  double normal_force = 0.0;  ///< N/m, compression positive
  Point shear_on_first;       ///< N/m, along the joint, on the triangle of side 0
  double stiffness = 0.0;  ///< of the joint, Pa/m: contact does not become much stiffer than that
};

/// What triangles that are taken out leave behind.
struct ContactRelease {
  std::vector<CornerForce> force;  ///< that their contacts gave to the others
  double energy = 0.0;             ///< stored in these contacts, J/m
};

/// Contact of triangles by the overlap potential, (4), (5), with Coulomb friction, (6), (7). Pairs
/// are found on a uniform grid in linear time and kept until something may have moved by half the
/// margin around them.
///
/// A pair that overlaps when it is first looked at (neighbours round a vertex, once they may touch)
/// has an offset taken off its force, so that it starts at zero; as the overlap lessens the offset
/// goes with it. A pair with a hand-over starts with the force of its joint instead: until the
/// faces part, its force is that of the overlap times a factor.
class Contact {
public:
  Contact(const mesh::Mesh& mesh, ContactProperties properties);

  /// To be called before the first step and when joints broke or closed or triangles were taken
  /// out: the pairs are searched anew at the next step. Where `broken` names all joints whose state
  /// has changed since the last call, and they and their fans have only come loose, the pairs stay
  /// and those are added that became possible near these joints. Views are read during the call
  /// only.
  void topology_changed(const mesh::Mesh& mesh, const ContactTopology& topology,
                        std::span<const Index> broken = {});
  /// Gives the contact across a joint the force it starts with; before the next `advance`. Without
  /// effect where the faces of the joint may not touch or are apart.
  void hand_over(const mesh::Mesh& mesh, const HandOver& start);

  /// Forces of the present positions. `travelled` (m) bounds how far any corner has moved since the
  /// last call, `dt` (s) is the step that led here: friction follows the velocities over it.
  void advance(const mesh::Mesh& mesh, const CornerMotion& motion, double travelled, double dt,
               Execution& execution);

  /// Adds a force (N/m) on a corner to those of contact, until the next `advance`.
  void add_force(Index corner, const Point& force);

  /// Ends the contacts of triangles that are about to be taken out, `removed` is 1 for these, with
  /// the forces of the last `advance`; `topology_changed` has to follow.
  [[nodiscard]] ContactRelease release(const mesh::Mesh& mesh, const CornerMotion& motion,
                                       std::span<const std::uint8_t> removed);

  /// N/m, per corner slot; zero where `acts` is zero.
  [[nodiscard]] std::span<const double> force_x() const { return force_x_; }
  [[nodiscard]] std::span<const double> force_y() const { return force_y_; }
  /// Per block of eight triangles: 1 where any corner of it may have a contact force.
  [[nodiscard]] std::span<const std::uint8_t> acts() const { return acts_; }

  /// J/m since the start: the work that tangential forces took from the bodies, as
  /// (f before + f after)/2 times the displacement of each step, less `stored_tangential`.
  [[nodiscard]] double friction_dissipation() const;
  /// Energy in the tangential springs of all pairs, J/m. What a joint hands over appears here.
  [[nodiscard]] double stored_tangential() const;
  /// Energy of the normal forces of the last `advance` at the positions it was given, J/m: for each
  /// pair
  /// factor p (A0_a/A_a int phi_a dA + A0_b/A_b int phi_b dA), see `overlap_force`. Of a pair with
  /// an offset only that part counts which the force did beyond the offset.
  [[nodiscard]] double potential_energy(const mesh::Mesh& mesh, const CornerMotion& motion) const;
  /// Pairs that are looked at, and those of them that overlap.
  [[nodiscard]] Index listed_pairs() const { return states_.size(); }
  [[nodiscard]] Index touching_pairs() const;
  /// Largest depth of an overlap, along its normal force, m; 0 where nothing touches.
  [[nodiscard]] double deepest() const;
  /// Adds all that later steps depend on.
  void add_to(StateHash& hash) const;
  void describe_state(StateArchive& archive);

  /// Pairs of triangles that may touch and overlap by more than `share` of the smaller one's area
  /// where they are now; ascending. For refusing bodies that overlap at the start.
  [[nodiscard]] std::vector<std::array<Index, 2>>
  overlapping(const mesh::Mesh& mesh, const CornerMotion& motion, double share = 1e-6) const;

private:
  [[nodiscard]] PlacedTriangle placed(const mesh::Mesh& mesh, const CornerMotion& motion,
                                      Index triangle) const;
  [[nodiscard]] std::vector<PlacedTriangle>
  place(const mesh::Mesh& mesh, const CornerMotion& motion, Execution& execution) const;
  [[nodiscard]] PairOrigin overlap_of_pair(const mesh::Mesh& mesh, const CornerMotion& motion,
                                           Index pair) const;
  [[nodiscard]] double pressed_energy(const mesh::Mesh& mesh, const CornerMotion& motion,
                                      Index pair) const;
  [[nodiscard]] Surface surface_of(const mesh::Mesh& mesh, Index triangle) const;
  void search(const mesh::Mesh& mesh, const CornerMotion& motion, Execution& execution);
  void carry_over(PairStates& states, const PairRows& rows);
  void add_pairs(const mesh::Mesh& mesh, const CornerMotion& motion, Execution& execution);
  void make_room();
  void set_blocks();
  void apply_hand_overs();
  void clear_forces();
  void describe_pair_forces(StateArchive& archive);

  struct PendingHandOver {
    std::array<Index, 2> triangle;
    HandOver start;
    double largest_factor = 1.0;
    void describe_state(StateArchive& archive);
  };

  ContactProperties properties_;
  std::vector<std::array<Index, 3>> triangle_joints_;
  CornerPlaces undeformed_;
  std::vector<Candidate> candidates_;  // ascending
  std::vector<Index> blocks_;          // of triangles, that have any candidate, ascending
  std::vector<Index> loosened_;        // triangles at joints that broke since the last step
  PairStates states_;
  PairRows rows_;
  std::vector<PairForceBlock> forces_;  // only grows; most of it is not in use
  std::vector<PairHandOver> handed_;
  std::vector<PendingHandOver> pending_;
  bool stale_ = true;                    // the pairs must be searched
  bool starts_ = false;                  // there are pairs that have not been looked at
  double margin_ = 0.0;                  // m
  double travelled_ = 0.0;               // m, since the search
  CompensatedSum friction_dissipation_;  // J/m, up to the search
  std::vector<double> force_x_, force_y_;
  std::vector<Index> added_;  // corners that were given forces since the last step
  std::vector<std::uint8_t> acts_;
};

}  // namespace percolith::mechanics
