// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/step_limit.hpp"

#include "percolith/coupling/fluid_stiffness.hpp"
#include "percolith/seepage/crack.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::coupling {
namespace {

double largest_exchange(const seepage::Model& water) {
  double most = 0.0;
  for (const material::Fracture& f : water.fracture) {
    most = std::max(most, f.exchange);
  }
  return most;
}

double length(const Point& a, const Point& b) {
  return std::sqrt(dot(b - a, b - a));
}

double pore_limit(const seepage::Model& water) {
  const double exchange = largest_exchange(water);
  double least = std::numeric_limits<double>::infinity();
  const auto joint_conductance = [&](Index j) {
    return water.pore.joint.empty() ? 0.0 : water.pore.joint[at(j)];
  };
  std::vector<double> across(at(water.mesh.corners()), 0.0);
  for (Index j = 0; j < water.mesh.joints(); ++j) {
    for (const auto& side : water.mesh.joint[at(j)].corner) {
      for (const Index corner : side) {
        across[at(corner)] += joint_conductance(j);
      }
    }
  }
  for (Index t = 0; t < water.mesh.triangles(); ++t) {
    const auto p = water.mesh.triangle_points(t);
    for (Index k = 0; k < 3; ++k) {
      const Index corner = mesh::corner_of(t, k);
      const Index before = mesh::corner_of(t, (k + 2) % 3);
      const double edges =
          length(p[at(k)], p[at((k + 1) % 3)]) + length(p[at((k + 2) % 3)], p[at(k)]);
      const double sum = std::abs(water.pore.conductance[at(corner)]) +
                         std::abs(water.pore.conductance[at(before)]) + across[at(corner)] +
                         0.5 * exchange * edges;
      if (sum > 0.0) {
        least = std::min(least, water.pore.storage[at(corner)] / sum);
      }
    }
  }
  return least;
}

}  // namespace

StepLimit::StepLimit(const CoupledModel& model)
    : pores_(pore_limit(model.water)), pushed_(model.water.mesh.vertex.size()),
      stiffness_(at(model.water.mesh.corners())) {
  const mechanics::Model& rock = model.rock.model();
  const auto penalty = model.rock.contact_penalty();
  for (Index t = 0; t < rock.mesh.triangles(); ++t) {
    triangle_.push_back(mechanics::frequencies(rock, t, penalty.empty() ? 0.0 : penalty[at(t)]));
  }
  const auto limits = mechanics::step_limits(rock, penalty);
  if (!limits.empty()) {
    rock_ = limits.back().step;
  }
}

double StepLimit::motion(const CoupledModel& model) {
  const mechanics::Model& rock = model.rock.model();
  const seepage::Model& water = model.water;
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    const mesh::Joint& joint = rock.mesh.joint[at(faces.joint)];
    for (std::size_t end = 0; end < 2; ++end) {
      pushed_[at(joint.vertex[end])] = 0.0;
      stiffness_[at(joint.corner[0][end])] = 0.0;
      stiffness_[at(joint.corner[1][end])] = 0.0;
    }
  }
  // Half the length of each joint at a crack node pushes on a corner of either side.
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    for (const Index v : rock.mesh.joint[at(faces.joint)].vertex) {
      pushed_[at(v)] += rock.mesh.joint_length(faces.joint);
    }
  }
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    const mesh::Joint& joint = rock.mesh.joint[at(faces.joint)];
    for (std::size_t end = 0; end < 2; ++end) {
      const auto v = at(joint.vertex[end]);
      const double k = fluid_stiffness(rock.mesh.joint_length(faces.joint), pushed_[v],
                                       water.fluid.bulk_modulus, water.crack.void_volume[v]);
      stiffness_[at(joint.corner[0][end])] += k;
      stiffness_[at(joint.corner[1][end])] += k;
    }
  }
  double step = rock_;
  for (const mechanics::PressedFaces& faces : rock.pressed) {
    for (const auto& side : rock.mesh.joint[at(faces.joint)].corner) {
      const Index t = mesh::triangle_of(side[0]);
      const double most = std::max(stiffness_[at(side[0])], stiffness_[at(side[1])]);
      const double inverse_mass = rock.triangles.inverse_mass[at(t)];
      if (inverse_mass > 0.0) {
        step = std::min(step, mechanics::stable_step(rock, triangle_[at(t)], most * inverse_mass));
      }
    }
  }
  return step;
}

double StepLimit::in_new_cracks(const CoupledModel& model) const {
  const mechanics::Model& rock = model.rock.model();
  const seepage::Model& water = model.water;
  double step = std::numeric_limits<double>::infinity();
  for (Index j = 0; j < rock.mesh.joints(); ++j) {
    if (rock.joints.state[at(j)] != mechanics::JointState::bonded) {
      continue;
    }
    // A node in a straight crack has half the volume of the joint on either side.
    const double length = rock.mesh.joint_length(j);
    const double aperture =
        seepage::storage_aperture(water.fracture[at(model.options.group[at(j)])], 0.0);
    const double k =
        fluid_stiffness(length, 2.0 * length, water.fluid.bulk_modulus, length * aperture);
    for (const auto& side : rock.mesh.joint[at(j)].corner) {
      const Index t = mesh::triangle_of(side[0]);
      const double inverse_mass = rock.triangles.inverse_mass[at(t)];
      if (inverse_mass > 0.0) {
        step = std::min(step, mechanics::stable_step(rock, triangle_[at(t)], k * inverse_mass));
      }
    }
  }
  return step;
}

}  // namespace percolith::coupling
