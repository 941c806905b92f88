// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/seepage/flow_graph.hpp"
#include "percolith/seepage/graph_conditions.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace percolith::seepage {

/// Which nodes are held at a pressure in an implicit or steady solve: partly empty ones at the
/// reference pressure, open seepage faces at the outside pressure. The set is found by iteration:
/// solve, move the nodes that contradict their membership, repeat.
class ActiveSet {
public:
  explicit ActiveSet(const FlowGraph& graph)
      : held_(static_cast<std::size_t>(graph.nodes()), 0), empty_(held_), face_open_(held_) {}

  /// Starts a step: nodes whose content says so are partly empty, faces stay as they were.
  void start(const Model& model, const FlowGraph& graph, const GraphState& state);
  /// Opens every seepage face, as a steady solution starts; true when there is any.
  bool open_faces(const GraphConditions& conditions);
  /// Puts held nodes at their pressures.
  void hold(const Model& model, const GraphConditions& conditions, double time,
            GraphState& state) const;

  /// Compares a solution with the set; returns true when any node changed sides. `source` per node
  /// (m2/s) and `storage_rate` as in PressureSystem, `inflow` the node inflows of the solution.
  bool update_faces(const Model& model, const GraphConditions& conditions, double time,
                    std::span<const double> source, std::span<const double> storage_rate,
                    std::span<const double> inflow, const GraphState& state);
  /// Empties full nodes below the reference pressure, solves for the saturation of partly empty
  /// ones from the donors downwards, and fills those that would overflow. `largest_change` becomes
  /// the largest change of a saturation.
  bool update_saturations(const Model& model, const FlowGraph& graph,
                          const GraphConditions& conditions, double dt,
                          std::span<const CompensatedSum> content_before,
                          std::span<const double> rate, std::span<const double> conductance,
                          GraphState& state, double& largest_change);

  [[nodiscard]] std::span<const std::uint8_t> held() const { return held_; }
  [[nodiscard]] bool any_empty() const { return empties_ > 0; }
  [[nodiscard]] bool is_empty(Index node) const {
    return empty_[static_cast<std::size_t>(node)] != 0;
  }
  [[nodiscard]] bool is_open_face(Index node) const {
    return face_open_[static_cast<std::size_t>(node)] != 0;
  }
  void describe_state(StateArchive& archive);

private:
  void set_empty(Index node, bool empty);
  std::vector<std::uint8_t> held_, empty_, face_open_;
  Index empties_ = 0;
};

/// Pressure below which round-off cannot be told from suction: a share of the largest pressure.
[[nodiscard]] double pressure_tolerance(const GraphState& state, double reference_pressure);

}  // namespace percolith::seepage
