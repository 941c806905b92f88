// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"
#include "percolith/simulation/probe_places.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"

#include <map>
#include <span>
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

/// Reads probes of a flow model at points found once in the mesh. A point in a crack reads the
/// nearest open one within half an edge; where none has come yet it is dry: saturation, aperture
/// and flux 0, at the pressure of the air.
class ProbeReader {
public:
  /// `cracks` are the joints that are open or may open in time. Throws InputError as
  /// `locate_probes` does. Warns of points at which no crack is open yet.
  ProbeReader(const std::map<std::string, Probe>& probes, const seepage::Model& model,
              std::span<const mesh::Index> cracks, double head_datum);
  [[nodiscard]] std::vector<ProbeSample> read(const seepage::Model& model) const;
  [[nodiscard]] const std::vector<std::string>& warnings() const { return places_.warnings; }

private:
  [[nodiscard]] ProbeRow matrix_row(const seepage::Model& model, const ProbeTarget& target) const;
  [[nodiscard]] ProbeRow dry_row(const seepage::Model& model, const ProbeTarget& target) const;
  [[nodiscard]] ProbeRow crack_row(const seepage::Model& model, const ProbeTarget& target) const;
  ProbePlaces places_;
  double head_datum_;
};

}  // namespace percolith::simulation
