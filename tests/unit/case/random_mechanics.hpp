// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/setup.hpp"

#include <rapidcheck.h>

#include <string>

namespace percolith::case_file {

/// Makes setups of mechanics that a case file could give, as RandomSetup does for seepage.
class RandomMechanics {
public:
  simulation::Setup make() {
    simulation::Setup setup;
    setup.mesh.file = "block.msh";
    setup.model.physics = simulation::Physics::mechanics;
    setup.model.plane = flip() ? simulation::Plane::stress : simulation::Plane::strain;
    setup.model.gravity = flip() ? 0.0 : positive();
    make_rocks(setup);
    make_fractures(setup);
    make_in_situ(setup);
    make_boundaries(setup);
    make_bodies(setup);
    make_rest(setup);
    return setup;
  }

private:
  static bool flip() { return *rc::gen::arbitrary<bool>(); }
  static int below(int n) { return *rc::gen::inRange(0, n); }
  /// From 2^-53 to 1 with all bits at random.
  static double fraction() {
    return static_cast<double>(*rc::gen::inRange<std::int64_t>(1, std::int64_t{1} << 53)) /
           static_cast<double>(std::int64_t{1} << 53);
  }
  static double positive() { return 1e6 * fraction(); }
  static double any() { return flip() ? positive() : -positive(); }
  static std::optional<double> perhaps(double value) {
    return flip() ? std::optional<double>(value) : std::nullopt;
  }
  static std::string name(const std::string& stem, int i) { return stem + std::to_string(i); }

  static Schedule schedule() {
    if (flip()) {
      return Schedule::constant(any());
    }
    const double start = any();
    return {{start, start + 1.0 + fraction()},
            {any(), any()},
            flip() ? Interpolation::linear : Interpolation::step};
  }
  static std::optional<Schedule> perhaps_schedule() {
    return flip() ? std::optional<Schedule>(schedule()) : std::nullopt;
  }

  static material::JointStrength strength() {
    material::JointStrength result;
    result.tensile_strength = positive();
    result.cohesion = positive();
    result.friction_angle = fraction();
    result.residual_friction_angle = perhaps(fraction());
    result.mode_1_energy = positive();
    result.mode_2_energy = positive();
    result.joint_penalty = perhaps(positive());
    return result;
  }

  static void make_rocks(simulation::Setup& setup) {
    for (int i = 0; i <= below(3); ++i) {
      simulation::Material& material = setup.material[name("rock", i)];
      material.regions = {name("region ", i)};
      material.solid.density = positive();
      material.solid.young_modulus = positive();
      material.solid.poisson_ratio = 0.49 * fraction();
      if (flip()) {
        material.solid.normal_young_modulus = material.solid.young_modulus * fraction();
        material.solid.normal_shear_modulus = perhaps(positive());
        material.solid.bedding_angle = any();
        material.solid.normal_poisson_ratio =
            perhaps(material.solid.poisson_ratio * *material.solid.normal_young_modulus /
                    material.solid.young_modulus);
      }
      if (flip()) {
        material.joints = simulation::RockJoints::elastic;
        material.strength.friction_angle = fraction();
      } else {
        material.strength = strength();
        material.weibull_modulus = perhaps(positive());
        material.weibull_seed = material.weibull_modulus ? below(1000) : 1;
      }
    }
  }

  static void make_fractures(simulation::Setup& setup) {
    for (int i = 0; i < below(3); ++i) {
      simulation::FractureGroup& group = setup.fracture[name("fault", i)];
      group.groups = {name("curve", i)};
      if (flip()) {
        group.bond = simulation::Bond::cohesive;
        group.strength = strength();
      } else {
        group.strength.friction_angle = perhaps(fraction());
        group.strength.residual_friction_angle = perhaps(fraction());
      }
    }
  }

  static void make_in_situ(simulation::Setup& setup) {
    if (flip()) {
      setup.in_situ = {any(), any(), any(), any(), flip() ? any() : 0.0, 0.0, any()};
      if (setup.model.plane == simulation::Plane::strain) {
        setup.in_situ->stress_zz = any();
        setup.in_situ->gradient_zz = any();
      }
    }
  }

  static void make_boundaries(simulation::Setup& setup) {
    for (int i = 0; i < below(5); ++i) {
      simulation::BoundaryCondition& condition = setup.boundary[name("side", i)];
      condition.groups = {name("line", i)};
      switch (below(5)) {
      case 0:
        condition.fixed = true;
        break;
      case 1:
        condition.roller = true;
        break;
      case 2:
        (flip() ? condition.displacement_x : condition.velocity_x) = schedule();
        (flip() ? condition.displacement_y : condition.velocity_y) = perhaps_schedule();
        break;
      case 3:
        condition.normal_pressure = schedule();
        break;
      default:
        condition.traction_x = schedule();
        condition.traction_y = perhaps_schedule();
        condition.in_situ = setup.in_situ && flip();
        condition.absorbing = flip();
      }
    }
  }

  static void make_bodies(simulation::Setup& setup) {
    for (int i = 0; i < below(3); ++i) {
      simulation::Body& body = setup.body[name("body", i)];
      body.regions = {name("region ", i)};
      body.rigid = flip();
      if (body.rigid) {
        body.velocity_x = perhaps_schedule();
        body.velocity_y = perhaps_schedule();
      } else {
        body.initial_velocity_x = any();
        body.initial_velocity_y = perhaps(any());
      }
    }
    for (int i = 0; i < below(3); ++i) {
      setup.point_force[name("force", i)] = {{any(), any()}, perhaps_schedule(), schedule()};
    }
  }

  static void make_rest(simulation::Setup& setup) {
    setup.time.scheme = simulation::Scheme::explicit_;
    setup.time.end = positive();
    setup.time.step = perhaps(positive());
    setup.time.safety = fraction();
    setup.time.stop_ratio = perhaps(0.5 * fraction());
    setup.time.mass_scaling_step = perhaps(positive());
    for (int i = 0; i < below(3); ++i) {
      setup.excavation[name("tunnel", i)] = {
          {name("hole", i)}, setup.time.end * fraction(), flip() ? 0.0 : positive()};
    }
    setup.damping.nodal_viscosity = flip() ? 0.0 : positive();
    (flip() ? setup.damping.element_viscosity : setup.damping.viscosity_ratio) = positive();
    setup.damping.local = 0.5 * fraction();
    setup.contact = {perhaps(positive()), perhaps(positive())};
  }
};

}  // namespace percolith::case_file
