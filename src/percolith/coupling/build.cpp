// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/build.hpp"

#include "percolith/coupling/pressure_to_force.hpp"
#include "percolith/mechanics/build.hpp"
#include "percolith/mechanics/joint.hpp"
#include "percolith/mechanics/pressed_faces.hpp"
#include "percolith/mechanics/wet_joints.hpp"

#include <algorithm>
#include <array>

namespace percolith::coupling {
namespace {

using mechanics::JointState;

void add_biot(mechanics::Model& rock, const seepage::Model& water, std::span<const double> biot) {
  const mesh::Mesh& mesh = rock.mesh;
  const auto n = at(padded(mesh.triangles()));
  rock.pores.biot.assign(n, 0.0);
  rock.pores.stiffness.assign(n, 0.0);
  rock.pores.growth.assign(n, 0.0);
  for (Index t = 0; t < mesh.triangles(); ++t) {
    const Index region = mesh.region[at(t)];
    const double alpha = biot[at(region)];
    rock.pores.biot[at(t)] = alpha;
    rock.pores.stiffness[at(t)] = alpha * alpha * water.biot_modulus(region);
  }
}

double biot_of(const mechanics::Model& rock, Index joint) {
  const auto& corner = rock.mesh.joint[at(joint)].corner;
  return 0.5 * (rock.pores.biot[at(mesh::triangle_of(corner[0][0]))] +
                rock.pores.biot[at(mesh::triangle_of(corner[1][0]))]);
}

void add_joint_pores(mechanics::Model& rock, const seepage::Model& water) {
  const std::size_t n = rock.joints.ex.size();
  rock.pores.joint_share.assign(n, 0.0);
  for (std::size_t g = 0; g < 2; ++g) {
    rock.pores.push[g].assign(n, 0.0);
    rock.pores.opening[g].assign(n, 0.0);
  }
  for (Index j = 0; j < rock.mesh.joints(); ++j) {
    if (rock.joints.state[at(j)] == JointState::bonded && !water.cracks.is_broken(j)) {
      rock.pores.joint_share[at(j)] = biot_of(rock, j);
    }
  }
}

/// Tension (Pa) at the two integration points whose forces on the ends balance a pressure that acts
/// on each end with half of the joint.
std::array<double, 2> tension_of(const std::array<double, 2>& pressure) {
  const double near = mechanics::gauss_weight(0);
  const double far = mechanics::gauss_weight(1);
  const double scale = 1.0 / (near - far);
  return {scale * (near * pressure[0] - far * pressure[1]),
          scale * (near * pressure[1] - far * pressure[0])};
}

void relieve_triangles(mechanics::Model& rock, const seepage::Model& water) {
  for (Index t = 0; t < rock.mesh.triangles(); ++t) {
    double mean = 0.0;
    for (Index k = 0; k < 3; ++k) {
      mean += water.state.pressure[at(mesh::corner_of(t, k))] / 3.0;
    }
    rock.triangles.initial_xx[at(t)] += rock.pores.biot[at(t)] * mean;
    rock.triangles.initial_yy[at(t)] += rock.pores.biot[at(t)] * mean;
  }
}

void relieve_joints(mechanics::Model& rock, const seepage::Model& water) {
  for (Index j = 0; j < rock.mesh.joints(); ++j) {
    const auto& ends = rock.mesh.joint[at(j)].vertex;
    const std::array<double, 2> tension =
        water.cracks.is_broken(j) ? tension_of({water.state.crack_pressure[at(ends[0])],
                                                water.state.crack_pressure[at(ends[1])]})
                                  : mechanics::push_in_joint(rock, j);
    for (std::size_t g = 0; g < 2; ++g) {
      rock.joints.opening_start[g][at(j)] += tension[g] / rock.joints.full_stiffness[at(j)];
    }
  }
  mechanics::start_closed_joints(rock);
}

/// Whether there is any pressure to balance.
bool is_pressed(const mechanics::Model& rock, const seepage::Model& water) {
  const auto not_zero = [](double p) { return p != 0.0; };
  const auto& open = water.cracks.open_nodes();
  const auto corners = water.state.pressure.begin() + rock.mesh.corners();
  return std::any_of(water.state.pressure.begin(), corners, not_zero) ||
         std::any_of(open.begin(), open.end(),
                     [&](Index v) { return water.state.crack_pressure[at(v)] != 0.0; });
}

void press_cracks(mechanics::Model& rock, const seepage::Model& water) {
  mechanics::add_pressed(rock, water.cracks.broken_joints());
  Execution serial(Backend::serial);
  mechanics::measure_faces(rock, serial);
  press_by(rock, water);
}

}  // namespace

void moisten(mechanics::Model& rock, const seepage::Model& water, std::span<const double> biot,
             JointStress joint_stress) {
  rock.pores.pressure = water.state.pressure;
  add_biot(rock, water, biot);
  if (joint_stress == JointStress::effective) {
    add_joint_pores(rock, water);
  }
  if (is_pressed(rock, water)) {
    mechanics::make_room_for_stress(rock);
    relieve_triangles(rock, water);
    relieve_joints(rock, water);
  }
  if (!rock.pores.joint_share.empty() && !rock.joints.opening_start[0].empty()) {
    // Openings count from where they start, so that nothing is worked at first.
    for (std::size_t g = 0; g < 2; ++g) {
      rock.pores.opening[g] = rock.joints.opening_start[g];
    }
  }
  press_cracks(rock, water);
}

}  // namespace percolith::coupling
