// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/triangle_finder.hpp"
#include "percolith/seepage/model.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"

#include <map>
#include <string>
#include <vector>

namespace percolith::simulation {

/// Pair flows of a triangle (m2/s, from corner i to i+1) in the present state, saturation weights
/// included; the Darcy flux of a picture is made of the flows that move the contents.
[[nodiscard]] std::array<double, 3> triangle_flows(const seepage::Model& model,
                                                   mesh::Index triangle);
/// Flow along a broken joint (m2/s) from its first to its second vertex in the present state.
[[nodiscard]] double crack_flow(const seepage::Model& model, mesh::Index joint);

/// Fields of matrix and cracks in the present state. `head_datum` in m.
[[nodiscard]] MatrixFrame matrix_frame(const seepage::Model& model, double head_datum);
[[nodiscard]] CrackFrame crack_frame(const seepage::Model& model, double head_datum);

/// The points of all probes, found once in the mesh.
class ProbeReader {
public:
  /// Throws InputError (key `probe.NAME...`) for a point outside of the rock, or in a crack where
  /// there is none within half an edge. Points of a line in a crack that are farther away than
  /// that, and points of a line outside of the rock, are left out with a warning; a line without
  /// any point is refused.
  ProbeReader(const std::map<std::string, Probe>& probes, const seepage::Model& model,
              double head_datum);
  [[nodiscard]] std::vector<ProbeSample> read(const seepage::Model& model) const;
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
  struct Target {
    Point place;
    mesh::PlaceInTriangle in_matrix;
    mesh::PlaceOnJoint in_crack;
  };
  struct Located {
    std::string name;
    Domain in = Domain::matrix;
    std::vector<Target> targets;
  };
  [[nodiscard]] ProbeRow matrix_row(const seepage::Model& model, const Target& target) const;
  [[nodiscard]] ProbeRow crack_row(const seepage::Model& model, const Target& target) const;
  std::vector<Located> probes_;
  std::vector<std::string> warnings_;
  double head_datum_;
};

}  // namespace percolith::simulation
