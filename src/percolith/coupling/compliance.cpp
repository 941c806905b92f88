// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/compliance.hpp"

#include "percolith/core/disjoint_sets.hpp"
#include "percolith/mechanics/build.hpp"

namespace percolith::coupling {
namespace {

/// Length of the crack that hangs together at each vertex, m.
std::vector<double> connected_lengths(const mechanics::Model& rock) {
  DisjointSets cracks(rock.mesh.vertices());
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    const auto& ends = rock.mesh.joint[at(faces.joint)].vertex;
    cracks.merge(ends[0], ends[1]);
  }
  std::vector<double> length(rock.mesh.vertex.size(), 0.0);
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    length[at(cracks.root(rock.mesh.joint[at(faces.joint)].vertex[0]))] +=
        rock.mesh.joint_length(faces.joint);
  }
  std::vector<double> of_vertex(length.size());
  for (std::size_t v = 0; v < length.size(); ++v) {
    of_vertex[v] = length[at(cracks.root(static_cast<Index>(v)))];
  }
  return of_vertex;
}

}  // namespace

std::vector<double> pore_compliance(const CoupledModel& model) {
  const mechanics::Model& rock = model.rock.model();
  std::vector<double> compliance(at(rock.mesh.corners()), 0.0);
  for (Index t = 0; t < rock.mesh.triangles(); ++t) {
    const material::ElasticRock& r = rock.material[at(rock.triangles.material[at(t)])].rock;
    const double shear = r.young_modulus / (2.0 * (1.0 + r.poisson_ratio));
    const double bulk = shear / (1.0 - 2.0 * r.poisson_ratio);  // lambda + G
    const double alpha = rock.pores.biot[at(t)];
    for (Index k = 0; k < 3; ++k) {
      compliance[at(mesh::corner_of(t, k))] = alpha * alpha * rock.mesh.area(t) / 3.0 / bulk;
    }
  }
  return compliance;
}

std::vector<double> crack_compliance(const CoupledModel& model) {
  const mechanics::Model& rock = model.rock.model();
  const std::vector<double> connected = connected_lengths(rock);
  std::vector<double> compliance(rock.mesh.vertex.size(), 0.0);
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    const double half = 0.5 * rock.mesh.joint_length(faces.joint);
    const bool is_closed = faces.compression > 0.0;
    for (const Index v : rock.mesh.joint[at(faces.joint)].vertex) {
      compliance[at(v)] +=
          is_closed ? half / rock.joints.full_stiffness[at(faces.joint)]
                    : half * 3.0 * connected[at(v)] / mechanics::softer_modulus(rock, faces.joint);
    }
  }
  return compliance;
}

std::vector<double> pressures_of(const seepage::Model& water) {
  std::vector<double> all = water.state.pressure;
  for (const Index v : water.cracks.open_nodes()) {
    all.push_back(water.state.crack_pressure[at(v)]);
  }
  return all;
}

}  // namespace percolith::coupling
