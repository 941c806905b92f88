// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/conditions.hpp"
#include "percolith/seepage/model.hpp"

#include <map>
#include <string>
#include <vector>

namespace percolith::simulation {

/// Collects conditions and sees to it that no two of them say different things about one place.
class ConditionList {
public:
  explicit ConditionList(const seepage::Model& model) : model_(&model) {}

  /// Starts a condition: `name` is its table (`boundary.left`), `option` the option whose value it
  /// takes (`pressure`), for messages.
  void begin(const std::string& name, const std::string& option, const Schedule& schedule);

  /// Pressure of the present condition at a vertex: `factor * schedule + offset`, Pa. Throws
  /// InputError where another condition prescribes another pressure there, or where it falls below
  /// the cavitation pressure.
  void prescribe_pores(mesh::Index vertex, double factor, double offset);
  void prescribe_crack(mesh::Index vertex, double factor, double offset);
  /// Seepage face of the present condition at a vertex; throws as above for a second face with
  /// another outside pressure.
  void seepage_face_pores(mesh::Index vertex);
  void seepage_face_crack(mesh::Index vertex);
  /// Inflow `factor * schedule`, m2/s.
  void rate_into_corner(mesh::Index corner, double factor);
  void rate_into_crack(mesh::Index vertex, double factor);

  /// Claims a boundary edge; throws InputError where another condition has it.
  void claim_edge(mesh::Index edge, const std::string& key);

  /// The conditions; seepage faces are left out where a pressure is prescribed.
  [[nodiscard]] seepage::Conditions take();

private:
  using Owners = std::map<mesh::Index, seepage::NodeCondition>;  // by vertex

  [[nodiscard]] seepage::NodeCondition present(mesh::Index place, double factor,
                                               double offset) const;
  /// True when the vertex was free; throws on contradiction, also with the owners of the other
  /// field where crack and pores share one pressure.
  bool claim_vertex(Owners& owners, const Owners& others, mesh::Index vertex,
                    const seepage::NodeCondition& condition);
  void require_agreement(mesh::Index vertex, const seepage::NodeCondition& condition,
                         const seepage::NodeCondition& other) const;
  void check_cavitation(mesh::Index vertex, const seepage::NodeCondition& condition) const;
  [[nodiscard]] std::string key() const;

  const seepage::Model* model_;
  seepage::Conditions conditions_;
  Owners pore_owner_, crack_owner_;  // of prescribed pressures
  Owners pore_face_, crack_face_;    // of seepage faces
  std::map<mesh::Index, mesh::Index> edge_owner_;
};

}  // namespace percolith::simulation
