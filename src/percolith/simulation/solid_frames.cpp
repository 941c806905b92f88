// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/joint_points.hpp"
#include "percolith/mechanics/strain.hpp"
#include "percolith/simulation/solid_run.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace percolith::simulation {
namespace {

using mechanics::JointState;
using mesh::Index;

bool is_there(const mechanics::Model& model, Index t) {
  return model.triangles.inverse_mass[at(t)] > 0.0;
}

/// Whether a triangle of a joint was taken out, so that its other face is a wall.
bool beside_removed(const mechanics::Model& model, Index joint) {
  const auto& corner = model.mesh.joint[at(joint)].corner;
  return model.triangles.inverse_mass[at(mesh::triangle_of(corner[0][0]))] == 0.0 ||
         model.triangles.inverse_mass[at(mesh::triangle_of(corner[1][0]))] == 0.0;
}

/// Largest damage of the joints round each triangle; 1 where one is broken.
std::vector<double> triangle_damage(const mechanics::Model& model) {
  std::vector<double> damage(at(model.mesh.triangles()), 0.0);
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    const JointState state = model.joints.state[at(j)];
    if (beside_removed(model, j)) {
      continue;
    }
    double d = std::max(model.joints.damage[0][at(j)], model.joints.damage[1][at(j)]);
    d = state == JointState::closed || state == JointState::broken ? 1.0 : d;
    for (const auto& side : model.mesh.joint[at(j)].corner) {
      double& most = damage[at(mesh::triangle_of(side[0]))];
      most = std::max(most, d);
    }
  }
  return damage;
}

/// Quantities of the triangles, one list each, in the order in which they are written.
struct TriangleFields {
  std::vector<double> xx, yy, xy, zz, first, second, strain_xx, strain_yy, strain_xy, damage;
  std::vector<Point> direction;
  std::vector<std::int32_t> fragment;

  void add(const SolidRun& run, Index t, const std::vector<double>& damages) {
    const mechanics::Model& model = run.dynamics.model();
    const mechanics::TriangleStress stress = mechanics::triangle_stress(model, t);
    const mechanics::Principal p = mechanics::principal(stress.plane);
    const Tensor strain = mechanics::triangle_strain(model, t).strain;
    xx.push_back(stress.plane.xx);
    yy.push_back(stress.plane.yy);
    xy.push_back(stress.plane.xy);
    zz.push_back(stress.across + in_situ_across(run.setup.in_situ.value_or(InSitu{}),
                                                model.mesh.triangle_centre(t)));
    first.push_back(p.first);
    second.push_back(p.second);
    direction.push_back(p.direction);
    strain_xx.push_back(strain.xx);
    strain_yy.push_back(strain.yy);
    strain_xy.push_back(strain.xy);
    damage.push_back(damages[at(t)]);
    fragment.push_back(run.fragments.number[at(t)]);
  }

  [[nodiscard]] std::vector<FrameField> take() {
    return {{"stress_xx_Pa", std::move(xx)},
            {"stress_yy_Pa", std::move(yy)},
            {"stress_xy_Pa", std::move(xy)},
            {"stress_zz_Pa", std::move(zz)},
            {"principal_stress_1_Pa", std::move(first)},
            {"principal_stress_2_Pa", std::move(second)},
            {"principal_direction", std::move(direction)},
            {"strain_xx", std::move(strain_xx)},
            {"strain_yy", std::move(strain_yy)},
            {"strain_xy", std::move(strain_xy)},
            {"damage", std::move(damage)},
            {"fragment", std::move(fragment)}};
  }
};

/// Whether a joint belongs to the picture of the cracks: broken, closed or past its peak, with rock
/// on both sides.
bool is_shown(const mechanics::Model& model, Index j) {
  const JointState state = model.joints.state[at(j)];
  const auto& corner = model.mesh.joint[at(j)].corner;
  if (!is_there(model, mesh::triangle_of(corner[0][0])) ||
      !is_there(model, mesh::triangle_of(corner[1][0]))) {
    return false;
  }
  return state == JointState::closed || state == JointState::broken ||
         std::max(model.joints.damage[0][at(j)], model.joints.damage[1][at(j)]) > 0.0;
}

struct CrackFields {
  std::vector<double> opening, slip, damage, time, released;
  std::vector<std::int32_t> mode, closed;

  void add(const SolidRun& run, Index j) {
    const mechanics::Model& model = run.dynamics.model();
    const mechanics::Joints& joints = model.joints;
    const mechanics::JointPoints points = mechanics::joint_openings(model, j);
    double open = 0.5 * (points.opening[0] + points.opening[1]);
    double slid = 0.5 * (points.slip[0] + points.slip[1]);
    if (!joints.opening_start[0].empty()) {
      open -= 0.5 * (joints.opening_start[0][at(j)] + joints.opening_start[1][at(j)]);
      slid -= 0.5 * (joints.slip_start[0][at(j)] + joints.slip_start[1][at(j)]);
    }
    const bool bonded = joints.state[at(j)] == JointState::bonded;
    opening.push_back(open);
    slip.push_back(slid);
    damage.push_back(bonded ? std::max(joints.damage[0][at(j)], joints.damage[1][at(j)]) : 1.0);
    mode.push_back(bonded ? -1 : run.broken.mode[at(j)]);
    time.push_back(run.broken.time[at(j)]);
    released.push_back(run.broken.released[at(j)]);
    closed.push_back(joints.state[at(j)] == JointState::closed ? 1 : 0);
  }

  [[nodiscard]] std::vector<FrameField> take() {
    return {{"opening_m", std::move(opening)}, {"slip_m", std::move(slip)},
            {"mode", std::move(mode)},         {"damage", std::move(damage)},
            {"break_time_s", std::move(time)}, {"released_energy_J_per_m", std::move(released)},
            {"closed", std::move(closed)}};
  }
};

}  // namespace

MatrixFrame solid_matrix_frame(const SolidRun& run) {
  const mechanics::Model& model = run.dynamics.model();
  MatrixFrame frame;
  std::vector<Index> number(at(model.mesh.corners()), mesh::none);
  std::vector<Point> displacement;
  std::vector<Point> velocity;
  const std::vector<double> damages = triangle_damage(model);
  TriangleFields fields;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    if (!is_there(model, t)) {
      continue;
    }
    std::array<Index, 3> points{};
    for (Index k = 0; k < 3; ++k) {
      const Index node = model.nodes.leader(mesh::corner_of(t, k));
      Index& point = number[at(node)];
      if (point == mesh::none) {
        point = static_cast<Index>(frame.points.size());
        frame.points.push_back(model.mesh.place_of(node));
        displacement.push_back({model.motion.ux[at(node)], model.motion.uy[at(node)]});
        velocity.push_back({model.motion.vx[at(node)], model.motion.vy[at(node)]});
      }
      points[at(k)] = point;
    }
    frame.triangles.push_back(points);
    frame.region.push_back(model.mesh.region[at(t)]);
    fields.add(run, t, damages);
  }
  frame.point_fields = {{"displacement_m", std::move(displacement)},
                        {"velocity_m_per_s", std::move(velocity)}};
  frame.cell_fields = fields.take();
  return frame;
}

CrackFrame solid_crack_frame(const SolidRun& run, std::vector<Index>* joints,
                             std::vector<Index>* vertices) {
  const mechanics::Model& model = run.dynamics.model();
  CrackFrame frame;
  std::vector<Index> number(model.mesh.vertex.size(), mesh::none);
  CrackFields fields;
  const auto materials = static_cast<Index>(run.setup.material.size());
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (!is_shown(model, j)) {
      continue;
    }
    std::array<Index, 2> ends{};
    for (std::size_t end = 0; end < 2; ++end) {
      const Index vertex = model.mesh.joint[at(j)].vertex[end];
      Index& point = number[at(vertex)];
      if (point == mesh::none) {
        point = static_cast<Index>(frame.points.size());
        frame.points.push_back(model.mesh.vertex[at(vertex)]);
        if (vertices != nullptr) {
          vertices->push_back(vertex);
        }
      }
      ends[end] = point;
    }
    frame.segments.push_back(ends);
    if (joints != nullptr) {
      joints->push_back(j);
    }
    // Tables of materials are counted first, then those of the fractures.
    frame.group.push_back(std::max(mechanics::owner_of(model, j) - materials, mesh::none));
    fields.add(run, j);
  }
  frame.cell_fields = fields.take();
  return frame;
}

namespace {

/// Displacement, velocity and stress at a place; none of them is a number where the rock is gone.
std::vector<double> probe_values(const mechanics::Model& model,
                                 const mesh::PlaceInTriangle& place) {
  const auto& [triangle, weight] = place;
  if (!is_there(model, triangle)) {
    return std::vector<double>(7, std::numeric_limits<double>::quiet_NaN());
  }
  const mechanics::Motion& m = model.motion;
  std::array<double, 4> mean{};
  for (Index k = 0; k < 3; ++k) {
    const auto c = at(mesh::corner_of(triangle, k));
    const std::array<double, 4> here{m.ux[c], m.uy[c], m.vx[c], m.vy[c]};
    for (std::size_t i = 0; i < here.size(); ++i) {
      mean[i] += weight[at(k)] * here[i];
    }
  }
  const Tensor s = mechanics::triangle_stress(model, triangle).plane;
  return {mean[0], mean[1], mean[2], mean[3], s.xx, s.yy, s.xy};
}

}  // namespace

std::vector<ProbeSample> read_solid_probes(const SolidRun& run) {
  std::vector<ProbeSample> samples;
  for (const LocatedProbe& probe : run.probes.probes) {
    if (probe.in == Domain::crack) {
      continue;
    }
    ProbeSample sample{probe.name,
                       {"displacement_x_m", "displacement_y_m", "velocity_x_m_per_s",
                        "velocity_y_m_per_s", "stress_xx_Pa", "stress_yy_Pa", "stress_xy_Pa"},
                       {}};
    for (const ProbeTarget& target : probe.targets) {
      sample.rows.push_back({target.place, probe_values(run.dynamics.model(), target.in_matrix)});
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace percolith::simulation
