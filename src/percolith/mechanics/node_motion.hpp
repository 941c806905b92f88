// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/motion.hpp"

#include <vector>

// The motion where corners share nodes: what `Move` does in one pass takes three, because a node
// needs the forces of all its corners.
namespace percolith::mechanics {

/// Buffers of the three passes, per corner.
struct NodeBuffers {
  std::vector<double> stress_x, stress_y, viscous_x, viscous_y, joint_x, joint_y;  ///< N/m
  std::vector<double> new_vx, new_vy;                                              ///< m/s

  /// Makes room for `corners` slots; once.
  void resize(Index corners);
};

/// First pass: forces of the stress, and of joints and pore pressure, on every corner.
struct StoreForces {
  static constexpr bool vectorised = true;
  Move move;
  NodeBuffers* buffers;

  template <class Lane>
  void operator()(Lane lane) const {
    const Index first = mesh::corner_of(lane.first, 0);
    const auto u = load_corners<Lane>(move.ux, move.uy, first);
    const auto v = load_corners<Lane>(move.vx, move.vy, first);
    const auto f = move.forces<Lane>(lane.first, first, u, v);
    NodeBuffers& b = *buffers;
    store_corners<Lane>(f.stress, b.stress_x.data(), b.stress_y.data(), first);
    store_corners<Lane>(f.viscous, b.viscous_x.data(), b.viscous_y.data(), first);
    CornerVectors<typename Lane::Real> joint = f.joint;
    for (std::size_t k = 0; k < 3 && move.solid.is_wet(); ++k) {
      joint[k] = joint[k] + f.fluid[k];
    }
    store_corners<Lane>(joint, b.joint_x.data(), b.joint_y.data(), first);
  }
};

/// Second pass: every node at a vertex sums its corners in ascending order and gives them all its
/// new velocity.
struct MoveNodes {
  Move move;
  NodeBuffers* buffers;
  const mesh::Mesh* mesh;
  const mesh::NodeMap* nodes;

  void operator()(ScalarLane lane, LaneSums<terms>& sums) const;

private:
  void move_node(ScalarLane lane, Index node, LaneSums<terms>& sums) const;
};

/// Third pass: books what `Move` books, then takes over velocities and moves.
struct FinishMotion {
  static constexpr bool vectorised = true;
  Move move;
  const NodeBuffers* buffers;

  template <class Lane>
  void operator()(Lane lane, LaneSums<terms>& sums) const {
    using Real = typename Lane::Real;
    const Index t = lane.first;
    const Index first = mesh::corner_of(t, 0);
    const NodeBuffers& b = *buffers;
    const CornerVectors<Real> v = load_corners<Lane>(move.vx, move.vy, first);
    const CornerVectors<Real> fast = load_corners<Lane>(b.new_vx.data(), b.new_vy.data(), first);
    CornerVectors<Real> u = load_corners<Lane>(move.ux, move.uy, first);
    const ForcesByOrigin<Real> f{
        load_corners<Lane>(b.stress_x.data(), b.stress_y.data(), first),
        load_corners<Lane>(b.viscous_x.data(), b.viscous_y.data(), first),
        load_corners<Lane>(b.joint_x.data(), b.joint_y.data(), first),
        move.of_contact<Lane>(t, first),
        move.of_loads<Lane>(t, first),
        move.of_pores<Lane>(t, u),
        move.of_gravity<Lane>(t),
    };
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = u[k] + Real(move.law.dt) * fast[k];
    }
    store_corners<Lane>(fast, move.vx, move.vy, first);
    store_corners<Lane>(u, move.ux, move.uy, first);
    move.keep_growth<Lane>(t, u);
    move.book(lane, f, v, fast, Lane::load(move.inverse_mass + t), sums);
  }
};

}  // namespace percolith::mechanics
