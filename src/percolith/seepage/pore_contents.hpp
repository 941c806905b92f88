// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/compensated.hpp"
#include "percolith/mesh/mesh.hpp"
#include "percolith/mesh/node_map.hpp"
#include "percolith/seepage/content.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace percolith::seepage {

/// What advancing the contents of pore nodes reads and writes; one entry per corner slot.
struct ContentViews {
  double* content;
  double* carry;
  const double* storage;
  const double* void_volume;
  double* pressure;
  double* saturation;
  const double* inflow;
  double* growth;          ///< per node
  const double* swelling;  ///< per triangle: growth of its pores, m2; null in a rock at rest
  mesh::Index corners;     ///< slots
  double reference_pressure;
  bool can_empty;
  double dt;

  /// Adds `sum` (m2/s) times dt to the contents in slots `first` on, (23), and derives the fluid's
  /// state, (24), with the growth (m2) that the nodes have now.
  template <class Lane>
  PERCOLITH_DEVICE FluidState<typename Lane::Real>
  advance(mesh::Index first, typename Lane::Real sum, typename Lane::Real grown) const {
    using Real = typename Lane::Real;
    Real value = Lane::load(content + first);
    Real rest = Lane::load(carry + first);
    add_compensated(value, rest, sum * Real(dt));
    Lane::store(content + first, value);
    Lane::store(carry + first, rest);
    const Real s = Lane::load(storage + first);
    // Padding slots store nothing: keep them from dividing zero by zero.
    return fluid_state<Real>(value + rest, grown, select(s > Real(0.0), s, Real(1.0)),
                             can_empty ? Lane::load(void_volume + first) : Real(1.0),
                             reference_pressure, can_empty);
  }
};

/// Advances the pore nodes at a vertex: each gathers the inflow of its corners in ascending order.
struct NodeContents {
  ContentViews views;
  const mesh::Mesh* mesh;
  const mesh::NodeMap* nodes;

  void operator()(ScalarLane lane) const {
    const auto corners = mesh->vertex_corners.row(lane.first);
    if (nodes->whole()[static_cast<std::size_t>(lane.first)] != 0) {
      advance(corners);
      return;
    }
    for (const mesh::Index node : corners) {
      if (nodes->leader(node) == node) {
        advance(corners, node);
      }
    }
  }

private:
  /// All corners of the vertex are one node.
  void advance(std::span<const mesh::Index> corners) const {
    const mesh::Index node = corners.front();
    const mesh::Index ahead = std::min(node + prefetch_distance, views.corners - 1);
    prefetch(views.inflow + ahead);
    prefetch(views.pressure + ahead);
    double sum = 0.0;
    for (const mesh::Index c : corners) {
      sum += views.inflow[c];
    }
    double grown = 0.0;
    if (views.swelling != nullptr) {
      for (const mesh::Index c : corners) {
        grown += views.swelling[mesh::triangle_of(c)];
      }
      grown *= 1.0 / 3.0;
      views.growth[node] = grown;
    }
    const auto fluid = views.advance<ScalarLane>(node, sum, grown);
    const bool refilled = views.saturation[node] != fluid.saturation;
    for (const mesh::Index c : corners) {
      views.pressure[c] = fluid.pressure;
    }
    // Most nodes stay full: what does not change is not written.
    if (refilled) {
      for (const mesh::Index c : corners) {
        views.saturation[c] = fluid.saturation;
      }
    }
  }

  /// Only those that `node` leads.
  void advance(std::span<const mesh::Index> corners, mesh::Index node) const {
    double sum = 0.0;
    double grown = 0.0;
    for (const mesh::Index c : corners) {
      sum += nodes->leader(c) == node ? views.inflow[c] : 0.0;
      if (views.swelling != nullptr && nodes->leader(c) == node) {
        grown += views.swelling[mesh::triangle_of(c)];
      }
    }
    grown *= 1.0 / 3.0;
    if (views.swelling != nullptr) {
      views.growth[node] = grown;
    }
    const auto fluid = views.advance<ScalarLane>(node, sum, grown);
    for (const mesh::Index c : corners) {
      if (nodes->leader(c) == node) {
        views.pressure[c] = fluid.pressure;
        views.saturation[c] = fluid.saturation;
      }
    }
  }
};

/// Advances the pore nodes of a triangle where no joint is tied: every corner is its own node.
struct CornerContents {
  static constexpr bool vectorised = true;
  ContentViews views;

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane) const {
    using Real = typename Lane::Real;
    Real grown(0.0);
    if (views.swelling != nullptr) {
      grown = Real(1.0 / 3.0) * Lane::load(views.swelling + lane.first);
    }
    for (mesh::Index k = 0; k < 3; ++k) {
      const mesh::Index slot = mesh::corner_of(lane.first, k);
      if (views.swelling != nullptr) {
        Lane::store(views.growth + slot, grown);
      }
      const auto fluid = views.advance<Lane>(slot, Lane::load(views.inflow + slot), grown);
      Lane::store(views.pressure + slot, fluid.pressure);
      if (views.can_empty) {
        Lane::store(views.saturation + slot, fluid.saturation);
      }
    }
  }
};

}  // namespace percolith::seepage
