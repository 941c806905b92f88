// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/closed_joints.hpp"

#include "percolith/material/friction.hpp"
#include "percolith/mechanics/build.hpp"
#include "percolith/mechanics/joint_points.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::mechanics {
namespace {

/// Slip over the length of a joint beyond which its faces are left to contact.
constexpr double facing_share = 0.1;
/// The same where in-situ stress presses the faces together.
constexpr double pressed_share = 1.0;
/// Opening over the length beyond which its faces have parted: above round-off, far below any
/// deformation.
constexpr double parting_share = 1e-9;

/// Traction at a point with friction brought up to date, and the energy sliding spent, J/m2.
struct ClosedTraction {
  material::JointTraction<double> traction;
  double loss = 0.0;
};

ClosedTraction traction_of(const ClosedJoint& closed, const JointPoints& points, std::size_t g) {
  const double normal = closed.stiffness * std::min(0.0, points.opening[g]);
  const auto friction =
      material::friction_step(closed.shear[g], closed.stiffness, closed.slip[g] - points.slip[g],
                              -normal * closed.friction);
  return {{normal, friction.force}, friction.loss};
}

/// Whether the faces have parted, or slid so far that they no longer face each other.
bool has_ended(const Model& model, const ClosedJoint& closed, const JointPoints& points,
               double length) {
  if (std::min(points.opening[0], points.opening[1]) > parting_share * length) {
    return true;
  }
  // In-situ stress presses faces that do not overlap: contact could not carry it on.
  const bool pressed = !model.joints.opening_start[0].empty() &&
                       model.joints.opening_start[0][at(closed.joint)] < 0.0;
  const double slipped = 0.5 * std::abs((points.slip[0] - closed.slip_at_start[0]) +
                                        (points.slip[1] - closed.slip_at_start[1]));
  return slipped > (pressed ? pressed_share : facing_share) * length;
}

/// Force on end 1 of both faces that goes with a turn of the joint, N/m; end 0 has the opposite
/// one. Opening o = a.n and slip s = a.l at a point change by the way a of the faces and by the
/// turn of the joint, dl = n (n.dm)/|m| and dn = -l (n.dm)/|m| with its mean edge m, so that the
/// work of the tractions, t_n do + t_s ds, has the part (t_s a.n - t_n a.l) (n.dm)/|m| besides that
/// of the forces of the faces on each other.
Point turn_of(const ClosedJoint& closed, const Model& model, const JointPoints& points,
              const std::array<material::JointTraction<double>, 2>& t, double length) {
  const auto& corner = model.mesh.joint[at(closed.joint)].corner;
  const auto u = [&](std::size_t side, std::size_t end) {
    const auto i = at(corner[side][end]);
    return Point{model.motion.ux[i], model.motion.uy[i]};
  };
  const auto j = at(closed.joint);
  const Point mean = Point{model.joints.ex[j], model.joints.ey[j]} +
                     0.5 * ((u(0, 1) - u(0, 0)) + (u(1, 1) - u(1, 0)));
  double moment = 0.0;
  for (std::size_t g = 0; g < 2; ++g) {
    const Point apart = apart_at(points.place, g);
    moment += 0.5 * length *
              (t[g].shear * dot(apart, points.place.across) -
               t[g].normal * dot(apart, points.place.along));
  }
  return (-0.5 * moment / std::sqrt(dot(mean, mean))) * points.place.across;
}

struct ClosedForces {
  Model* model;

  void operator()(ScalarLane lane) const {
    ClosedJoint& closed = model->closed[at(lane.first)];
    const JointPoints k = joint_openings(*model, closed.joint);
    const double length = model->mesh.joint_length(closed.joint);
    std::array<material::JointTraction<double>, 2> t;
    double spent = 0.0;
    for (std::size_t g = 0; g < 2; ++g) {
      const ClosedTraction now = traction_of(closed, k, g);
      t[g] = now.traction;
      spent += now.loss;
      closed.shear[g] = t[g].shear;
      closed.slip[g] = k.slip[g];
    }
    closed.loss = 0.5 * length * spent;
    closed.ended = has_ended(*model, closed, k, length);
    closed.turn = turn_of(closed, *model, k, t, length);
    set_force(model->joints, closed.joint, joint_forces(k.place, length, t));
  }
};

double stored_in(const ClosedJoint& closed, const JointPoints& k, double length) {
  double stored = 0.0;
  for (std::size_t g = 0; g < 2; ++g) {
    const auto t = traction_of(closed, k, g).traction;
    stored += 0.25 * length * (t.normal * t.normal + t.shear * t.shear) / closed.stiffness;
  }
  return stored;
}

}  // namespace

void add_closed_joints(Model& model, Execution& execution) {
  if (model.closed.empty()) {
    return;
  }
  const auto n = static_cast<Index>(model.closed.size());
  execution.for_each("closed joints", n, ClosedForces{&model});
  model.energy.closed_friction +=
      execution.sum(n, [&](Index i) { return model.closed[at(i)].loss; });
}

void add_turns(const Model& model, Contact& contact) {
  for (const ClosedJoint& closed : model.closed) {
    for (const auto& side : model.mesh.joint[at(closed.joint)].corner) {
      contact.add_force(side[0], -1.0 * closed.turn);
      contact.add_force(side[1], closed.turn);
    }
  }
}

std::vector<ClosedJointEnd> ended_closed_joints(const Model& model) {
  std::vector<ClosedJointEnd> ended;
  for (const ClosedJoint& closed : model.closed) {
    if (!closed.ended) {
      continue;
    }
    const JointPoints k = joint_openings(model, closed.joint);
    const double length = model.mesh.joint_length(closed.joint);
    ClosedJointEnd end{closed.joint, 0.0, {}, closed.stiffness};
    for (std::size_t g = 0; g < 2; ++g) {
      const auto [t, loss] = traction_of(closed, k, g);
      end.normal_force -= 0.5 * length * t.normal;
      end.shear_on_first = end.shear_on_first + 0.5 * length * t.shear * k.place.along;
      end.friction += 0.5 * length * loss;
    }
    ended.push_back(end);
  }
  return ended;
}

double stored_in_closed_joints(const Model& model, double back) {
  double stored = 0.0;
  for (const ClosedJoint& closed : model.closed) {
    stored += stored_in(closed, joint_openings(model, closed.joint, back),
                        model.mesh.joint_length(closed.joint));
  }
  return stored;
}

std::array<material::JointTraction<double>, 2> closed_tractions(const Model& model,
                                                                const ClosedJoint& closed) {
  const JointPoints k = joint_openings(model, closed.joint);
  return {traction_of(closed, k, 0).traction, traction_of(closed, k, 1).traction};
}

double closed_friction_since(const Model& model, double back) {
  double spent = 0.0;
  for (const ClosedJoint& closed : model.closed) {
    const JointPoints k = joint_openings(model, closed.joint, back);
    for (std::size_t g = 0; g < 2; ++g) {
      spent += 0.5 * model.mesh.joint_length(closed.joint) * traction_of(closed, k, g).loss;
    }
  }
  return spent;
}

}  // namespace percolith::mechanics
