// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/compensated.hpp"
#include "percolith/mesh/mesh.hpp"
#include "percolith/mesh/node_map.hpp"
#include "percolith/seepage/content.hpp"
#include "percolith/seepage/node_blocks.hpp"

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

  /// The same for nodes anywhere, whose slots stand at `node`, and their storage S (m2/Pa) and void
  /// volume (m2) given; keeps their growth.
  template <class Lane>
  PERCOLITH_DEVICE FluidState<typename Lane::Real>
  advance_at(const mesh::Index* node, typename Lane::Real sum, typename Lane::Real grown,
             typename Lane::Real stores, typename Lane::Real voids) const {
    using Real = typename Lane::Real;
    Real value = Lane::gather(content, node);
    Real rest = Lane::gather(carry, node);
    add_compensated(value, rest, sum * Real(dt));
    Lane::scatter(content, node, value);
    Lane::scatter(carry, node, rest);
    if (swelling != nullptr) {
      Lane::scatter(growth, node, grown);
    }
    return fluid_state<Real>(value + rest, grown, stores, voids, reference_pressure, can_empty);
  }
};

/// Advances the nodes of the blocks: each gathers the inflow of its corners in ascending order.
struct BlockContents {
  static constexpr bool vectorised = true;
  ContentViews views;
  const mesh::Index* start;
  const mesh::Index* corner;
  const mesh::Index* triangle;
  const double* storage;
  const double* void_volume;

  BlockContents(const ContentViews& contents, const NodeBlocks& blocks)
      : views(contents), start(blocks.start.data()), corner(blocks.corner.data()),
        triangle(blocks.triangle.data()), storage(blocks.storage.data()),
        void_volume(blocks.void_volume.data()) {}

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane) const {
    using Real = typename Lane::Real;
    const mesh::Index* entry = start + lane.first / block_width;
    const mesh::Index first = entry[0] + lane.first % block_width;
    const mesh::Index last = entry[1];
    Real sum(0.0);
    for (mesh::Index k = first; k < last; k += block_width) {
      sum += Lane::gather(views.inflow, corner + k);
    }
    Real grown(0.0);
    if (views.swelling != nullptr) {
      for (mesh::Index k = first; k < last; k += block_width) {
        grown += Lane::gather(views.swelling, triangle + k);
      }
      grown = grown * Real(1.0 / 3.0);
    }
    const mesh::Index* node = corner + first;
    const auto fluid = views.advance_at<Lane>(node, sum, grown, Lane::load(storage + lane.first),
                                              Lane::load(void_volume + lane.first));
    for (mesh::Index k = first; k < last; k += block_width) {
      Lane::scatter(views.pressure, corner + k, fluid.pressure);
    }
    // Most nodes stay full: what does not change is not written.
    if (views.can_empty && any(Lane::gather(views.saturation, node) != fluid.saturation)) {
      for (mesh::Index k = first; k < last; k += block_width) {
        Lane::scatter(views.saturation, corner + k, fluid.saturation);
      }
    }
  }
};

/// Advances the pore nodes at single vertices, one after the other.
struct NodeContents {
  ContentViews views;
  const mesh::Mesh* mesh;
  const mesh::NodeMap* nodes;
  const mesh::Index* vertex;

  void operator()(ScalarLane lane) const {
    const auto corners = mesh->vertex_corners.row(vertex[lane.first]);
    for (const mesh::Index node : corners) {
      if (nodes->leader(node) == node) {
        advance(corners, node);
      }
    }
  }

private:
  /// Only those that `node` leads.
  void advance(std::span<const mesh::Index> corners, mesh::Index node) const {
    double sum = 0.0;
    double grown = 0.0;
    for (const mesh::Index c : corners) {
      if (nodes->leader(c) == node) {
        sum += views.inflow[c];
        grown += views.swelling != nullptr ? views.swelling[mesh::triangle_of(c)] : 0.0;
      }
    }
    const auto fluid = views.advance_at<ScalarLane>(&node, sum, grown * (1.0 / 3.0),
                                                    views.storage[node], views.void_volume[node]);
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
