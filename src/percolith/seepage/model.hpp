// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/compensated.hpp"
#include "percolith/core/execution.hpp"
#include "percolith/core/tensor2.hpp"
#include "percolith/material/fluid.hpp"
#include "percolith/material/fracture.hpp"
#include "percolith/material/pore_rock.hpp"
#include "percolith/mesh/crack_network.hpp"
#include "percolith/mesh/mesh.hpp"
#include "percolith/mesh/node_map.hpp"
#include "percolith/seepage/conditions.hpp"
#include "percolith/seepage/content.hpp"
#include "percolith/seepage/options.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

// Everything the flow works on. Arrays "per corner" have one entry per corner slot, padding
// included; those "per node" use the slot of the node's leader and are meaningless elsewhere.
namespace percolith::seepage {

/// What never changes in the pores.
struct PoreProperties {
  std::vector<double> conductance;  ///< per corner: pair (k, k+1) of the triangle, m2/(Pa s)
  std::vector<double> lift;         ///< per corner: rho_w g y, Pa
  std::vector<double> storage;      ///< per corner: V0/M, m2/Pa
  std::vector<double> void_volume;  ///< per corner: phi V0, m2
  std::vector<double> joint;        ///< per joint: 1/2 h_j L of finite joints; empty when tied
};

/// What belongs to the broken joints and the open crack nodes.
struct CrackProperties {
  std::vector<Index> group;  ///< per joint: fracture group, or `none`
  /// Per joint and end [end]: opening u_n since time zero, m.
  std::array<std::vector<double>, 2> opening;
  std::vector<double> compression;  ///< per joint: effective, on closed faces, Pa
  std::vector<double> aperture;     ///< per joint: hydraulic aperture, m
  std::vector<double> conductance;  ///< per joint: along the crack, m2/(Pa s)
  std::vector<double> exchange;     ///< per joint: to each facing corner, m2/(Pa s)
  std::vector<double> void_volume;  ///< per vertex: present volume of the crack node, m2
  std::vector<double> lift;         ///< per vertex: rho_w g y, Pa
};

/// What flows and is conserved (theory.md section 2): contents are stored, pressures and
/// saturations derived.
struct State {
  double time = 0.0;                        ///< s
  std::vector<double> pressure;             ///< per corner, Pa; equal at all corners of a node
  std::vector<double> saturation;           ///< per corner, 1; equal at all corners of a node
  std::vector<double> content;              ///< per node: excess, m2
  std::vector<double> content_carry;        ///< per node: what rounding lost
  std::vector<double> storage;              ///< per node: sum over its corners, m2/Pa
  std::vector<double> void_volume;          ///< per node: sum over its corners, m2
  std::vector<double> growth;               ///< per node: of its voids since time zero, m2
  std::vector<double> crack_pressure;       ///< per vertex, Pa
  std::vector<double> crack_saturation;     ///< per vertex, 1
  std::vector<double> crack_content;        ///< per vertex: excess over its present volume, m2
  std::vector<double> crack_content_carry;  ///< per vertex
};

/// A flow problem: mesh, topology, properties, conditions and state.
struct Model {
  mesh::Mesh mesh;
  material::Fluid fluid;
  double gravity = 0.0;  ///< m/s2
  PoreJoints pore_joints = PoreJoints::tied;
  SaturationWeight weight = SaturationWeight::upstream;
  std::vector<material::PoreRock> rock;      ///< per region
  std::vector<material::Fracture> fracture;  ///< per fracture group
  mesh::CrackNetwork cracks;
  std::vector<std::uint8_t> tied;  ///< per joint: its corners share pore nodes
  mesh::NodeMap pore_nodes;
  PoreProperties pore;
  CrackProperties crack;
  /// Per triangle: growth of its pores, m2: kept by whoever computes the motion of the rock; empty
  /// in a rock at rest.
  std::span<const double> swelling{};
  Conditions conditions;
  State state;
  /// Fluid let in by each condition since time zero, m2.
  std::vector<CompensatedSum> let_in;
  /// Rate of each condition in the last step, m2/s into the model.
  std::vector<double> rate;
  /// Fluid that entered and that left since time zero, vertex by vertex, m2; both positive. One
  /// condition may do both.
  CompensatedSum passed_in, passed_out;
  /// The same per second in the last step, m2/s.
  double rate_in = 0.0, rate_out = 0.0;

  /// Whether voids may empty; if not every node is always full.
  [[nodiscard]] bool can_empty() const { return std::isfinite(fluid.cavitation_pressure); }
  /// Pressure of a full node without excess, Pa.
  [[nodiscard]] double reference_pressure() const {
    return can_empty() ? fluid.cavitation_pressure : 0.0;
  }
  [[nodiscard]] double biot_modulus(Index region) const;
  /// Storage of a crack node, V/K_w, m2/Pa.
  [[nodiscard]] double crack_storage(Index vertex) const {
    return crack.void_volume[static_cast<std::size_t>(vertex)] / fluid.bulk_modulus;
  }
};

/// Builds a model without cracks, full at the reference pressure. `rock` has one entry per region
/// of the mesh, `joint_factor` is n of finite joints (theory.md section 4).
[[nodiscard]] Model make_model(mesh::Mesh mesh, const material::Fluid& fluid, double gravity,
                               std::vector<material::PoreRock> rock,
                               std::vector<material::Fracture> fracture, PoreJoints joints,
                               double joint_factor, SaturationWeight weight);

/// Breaks joints and lets them belong to fracture group `group`: the network grows, pore nodes
/// split, each part keeping its pressure or saturation, and the new volume joins empty, so no
/// fluid appears. The order of `joints` does not matter; joints broken in several calls give the
/// same network and nodes bit for bit, and the same contents to round-off.
void break_joints(Model& model, std::span<const Index> joints, Index group);

/// Gives a pore node an excess and derives pressure and saturation at all its corners.
void set_pore_content(Model& model, Index node, CompensatedSum content);
/// Gives a crack node an excess and derives its pressure and saturation.
void set_crack_content(Model& model, Index vertex, CompensatedSum content);

/// Brings the growth of the pore nodes at a vertex up to date with the swelling of its triangles;
/// contents stay, pressures follow.
void take_swelling(Model& model, Index vertex);

/// Brings the growth of all pore nodes up to date; contents and pressures stay.
void take_growth(Model& model);

/// What the faces of a broken joint have moved apart since time zero.
struct CrackOpening {
  Index joint = 0;
  std::array<double, 2> opening{};  ///< u_n at the ends, m
  double compression = 0.0;         ///< effective normal stress on closed faces, Pa
};

/// Gives broken joints new openings and compressions: conductances follow from the mean of the
/// ends, (28), volumes from each end (theory.md section 5). The fluid stays, pressures follow.
void open_cracks(Model& model, std::span<const CrackOpening> openings);

/// Fluid in pores and cracks, m2: void volume plus excess.
[[nodiscard]] double fluid_in_place(const Model& model, const Execution& execution);

}  // namespace percolith::seepage
