// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/mechanics/corner_force.hpp"
#include "percolith/mechanics/model.hpp"
#include "percolith/time/schedule.hpp"

#include <array>
#include <vector>

namespace percolith::mechanics {

/// A traction on undeformed boundary edges, Pa over time.
struct EdgeTraction {
  std::vector<Index> edges;  ///< of `Mesh::boundary`
  Schedule x, y;
};

/// A pressure that pushes along the normal of the deformed edges, Pa over time.
struct EdgePressure {
  std::vector<Index> edges;
  Schedule pressure;
};

/// A force on one corner over time, N/m.
struct PointLoad {
  Index corner = 0;
  double share = 1.0;
  Schedule x, y;
};

/// A dashpot on a corner that lets waves leave (Lysmer): force -C v, C = rho L/2 (c_p n n + c_s t
/// t).
struct Dashpot {
  Index corner = 0;
  Tensor resistance;  ///< C, kg/(m s)
};

/// Forces of regions that were taken out, fading over time, and those of the fluid that fills the
/// opening instead: as much as the former have faded, it pushes along the normals of the deformed
/// walls.
struct FadingSupport {
  double start = 0.0;     ///< s
  double duration = 0.0;  ///< s
  std::vector<CornerForce> force{};
  double pressure = 0.0;                     ///< Pa, of the fluid on the walls
  std::vector<std::array<Index, 2>> wall{};  ///< corners of each edge, as its triangle goes round
  /// Share of the force that is left at time `t`.
  [[nodiscard]] double left(double t) const;
};

/// All forces from outside but gravity.
struct LoadList {
  std::vector<EdgeTraction> traction;
  std::vector<EdgePressure> pressure;
  std::vector<CornerForce> constant;
  std::vector<PointLoad> point;
  std::vector<Dashpot> dashpot;
  std::vector<FadingSupport> fading;
};

/// Applies a list of loads to a model.
class LoadSet {
public:
  LoadSet(const mesh::Mesh& mesh, LoadList list);

  /// Sets the loads of the model to those of its present time and motion, and books the work of the
  /// dashpots over the second half of the last step.
  void apply(Model& model);
  /// Books the work of the dashpots over the first half of a step of `dt` (s) just made.
  void book_absorbed(Model& model, double dt) const;

  /// Adds forces that fade, of regions taken out, and those of the fluid that comes instead.
  void add_fading(const mesh::Mesh& mesh, FadingSupport support);
  /// The first time after `t` at which a schedule jumps or bends.
  [[nodiscard]] double next_break(double t) const;
  [[nodiscard]] const LoadList& list() const { return list_; }
  /// Largest resistance (kg/(m s)) of the dashpots at a corner of each triangle; empty without any.
  [[nodiscard]] std::vector<double> resistances(const mesh::Mesh& mesh) const;
  /// What is not given by the case: forces that fade, and the drag of the dashpots.
  void describe_state(StateArchive& archive, const mesh::Mesh& mesh);

private:
  void add_edges(Model& model) const;
  void add_points(Model& model) const;
  void add_supports(Model& model) const;
  void find_corners(const mesh::Mesh& mesh);
  LoadList list_;
  std::vector<Index> corners_;  // that have a load, ascending
  std::vector<Point> drag_;     // of the dashpots at the last `apply`, N/m
};

/// Dashpots of boundary edges, with the wave speeds of the rock behind them.
[[nodiscard]] std::vector<Dashpot> absorbing_edges(const Model& model,
                                                   std::span<const Index> edges);

}  // namespace percolith::mechanics
