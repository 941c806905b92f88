// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "unit/support/solid_model.hpp"

namespace percolith::test {

/// The two halves of a unit square with the joint between them; side 1 is led past side 0.
class JointPair {
public:
  /// A straight way at constant speed: opening and slip (m), and steps.
  struct Leg {
    Point way;
    int steps = 1;
  };

  /// `pressed` (m): how far side 1 is pushed into side 0 from the start.
  JointPair(const mechanics::JointKind& kind, std::vector<Leg> legs, double pressed = 0.0,
            JointState state = JointState::bonded)
      : legs_(std::move(legs)), dynamics_(build(kind, pressed, state)) {}

  /// Leads side 1 along the next leg.
  mechanics::Changes move() {
    mechanics::Changes all;
    Execution execution;
    for (int i = 0; i < legs_.at(next_).steps; ++i) {
      const mechanics::Changes changes = dynamics_.advance(dt, execution);
      all.broke.insert(all.broke.end(), changes.broke.begin(), changes.broke.end());
      all.parted.insert(all.parted.end(), changes.parted.begin(), changes.parted.end());
    }
    ++next_;
    return all;
  }

  /// Force of the joint on side 0 in the last step, across and along, N/m.
  [[nodiscard]] Point joint_force() const {
    const double* f = model().joints.force.data();
    return to_joint({f[0] + f[2 * block_width], f[block_width] + f[3 * block_width]});
  }
  /// Force of contact on side 0 in the last step, across and along, N/m.
  [[nodiscard]] Point contact_force() const {
    Point sum{};
    const Index t = mesh::triangle_of(model().mesh.joint[0].corner[0][0]);
    for (Index k = 0; k < 3; ++k) {
      const auto c = at(mesh::corner_of(t, k));
      sum = sum + Point{dynamics_.contact().force_x()[c], dynamics_.contact().force_y()[c]};
    }
    return to_joint(sum);
  }
  [[nodiscard]] mechanics::EnergyBalance energy() const { return dynamics_.energy(Execution()); }
  [[nodiscard]] const mechanics::Model& model() const { return dynamics_.model(); }
  [[nodiscard]] const mechanics::Dynamics& dynamics() const { return dynamics_; }

  static constexpr double dt = 1e-6;
  static constexpr double length = 1.4142135623730951;

  /// k of the joint, Pa/m.
  static double stiffness() { return 20 * 10e9 / (2 * std::sqrt(0.5 / std::sqrt(3.0))); }
  static double opening_at_failure(const mechanics::JointKind& kind) {
    const double f = kind.strength.tensile_strength;
    return f / stiffness() + kind.strength.mode_1_energy / (material::softening_integral * f);
  }
  /// Under a pressure in Pa.
  static double slip_at_failure(const mechanics::JointKind& kind, double pressure = 0.0) {
    const double c = kind.strength.cohesion;
    return (c + pressure * kind.friction) / stiffness() +
           kind.strength.mode_2_energy / (material::softening_integral * c);
  }

private:
  mechanics::Dynamics build(const mechanics::JointKind& kind, double pressed, JointState state) {
    mechanics::Model model =
        make_solid(make_grid({.columns = 1, .rows = 1}), {.kind = kind, .joints = state});
    along_ = (1.0 / length) * Point{model.joints.ex[0], model.joints.ey[0]};
    std::vector<Schedule> speed(2, Schedule{{}, {}, Interpolation::step});
    double time = 0.0;
    for (const Leg& leg : legs_) {
      const Point v = (1.0 / (leg.steps * dt)) * to_plane(leg.way);
      speed[0].time.push_back(time);
      speed[0].value.push_back(v.x);
      speed[1].time.push_back(time);
      speed[1].value.push_back(v.y);
      time += leg.steps * dt;
    }
    std::vector<mechanics::Held> held;
    const Index moving = mesh::triangle_of(model.mesh.joint[0].corner[1][0]);
    const Point start = to_plane({-pressed, 0.0});
    for_each_corner(model.mesh, [&](Index t, Index c) {
      held.push_back({c, {1.0, 0.0}, t == moving ? 1 : 0});
      held.push_back({c, {0.0, 1.0}, t == moving ? 2 : 0});
      if (t == moving) {
        model.motion.ux[at(c)] = start.x;
        model.motion.uy[at(c)] = start.y;
      }
    });
    using Kind = mechanics::PrescribedMotion::Kind;
    mechanics::SupportSet supports(model,
                                   {{"rest", Kind::velocity, Schedule{}},
                                    {"moving", Kind::velocity, speed[0]},
                                    {"moving", Kind::velocity, speed[1]}},
                                   held);
    return make_dynamics(std::move(model), {}, std::move(supports));
  }
  [[nodiscard]] Point to_plane(Point p) const { return p.x * clockwise(along_) + p.y * along_; }
  [[nodiscard]] Point to_joint(Point p) const {
    return {dot(p, clockwise(along_)), dot(p, along_)};
  }

  std::vector<Leg> legs_;
  std::size_t next_ = 0;
  Point along_;
  mechanics::Dynamics dynamics_;
};

}  // namespace percolith::test
