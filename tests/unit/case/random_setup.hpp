// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/setup.hpp"

#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace percolith::case_file {

/// Makes setups that a case file could give: every option with values from all its range, and no
/// contradiction between them. All choices come from RapidCheck, so failures shrink.
class RandomSetup {
public:
  simulation::Setup make() {
    simulation::Setup setup;
    setup.title = text();
    make_model(setup);
    make_rocks(setup);
    make_time(setup);
    make_conditions(setup);
    make_output(setup);
    return setup;
  }

private:
  static bool flip() { return *rc::gen::arbitrary<bool>(); }
  static int below(int n) { return *rc::gen::inRange(0, n); }
  /// A positive number with all bits of its fraction at random, over many powers of ten.
  static double positive() {
    const double mantissa =
        1.0 + static_cast<double>(*rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 52)) /
                  static_cast<double>(std::int64_t{1} << 52);
    return mantissa * std::pow(10.0, *rc::gen::inRange(-30, 31));
  }
  static double any() { return flip() ? positive() : -positive(); }
  static double fraction() {
    return static_cast<double>(*rc::gen::inRange<std::int64_t>(1, std::int64_t{1} << 53)) /
           static_cast<double>(std::int64_t{1} << 53);
  }
  static std::string text() {
    return *rc::gen::container<std::string>(
        rc::gen::oneOf(rc::gen::inRange<char>(1, 127), rc::gen::element('"', '\\', '\n', '\t')));
  }
  static std::string name(const std::string& stem, int i) { return stem + std::to_string(i); }
  static simulation::Domain side() {
    return flip() ? simulation::Domain::matrix : simulation::Domain::crack;
  }
  static std::array<double, 2> point() { return {any(), any()}; }

  Schedule schedule(double scale) const {
    if (steady_ || flip()) {
      return Schedule::constant(scale * any());
    }
    Schedule result;
    result.time.clear();
    result.value.clear();
    double time = any();
    for (int i = 0; i <= below(5); ++i) {
      result.time.push_back(time);
      result.value.push_back(scale * any());
      time += std::abs(time) * 1e-3 + 1e-3;
    }
    result.interpolation = flip() ? Interpolation::linear : Interpolation::step;
    return result;
  }

  void make_model(simulation::Setup& setup) {
    setup.mesh.file = flip() ? "a b.msh" : "section.geo";
    if (setup.mesh.file == "section.geo" && flip()) {
      setup.mesh.element_size = positive();
    }
    setup.model.gravity = flip() ? 0.0 : positive();
    if (setup.model.gravity > 0.0) {
      setup.model.head_datum = any();
    }
    if (flip()) {
      setup.model.pore_joints = simulation::PoreJoints::finite;
      setup.model.joint_factor = positive();
    }
    setup.model.saturation_weight =
        flip() ? simulation::SaturationWeight::mean : simulation::SaturationWeight::upstream;
    setup.fluid = {positive(), positive(), positive(), -std::numeric_limits<double>::infinity()};
  }

  void make_rocks(simulation::Setup& setup) {
    for (int i = 0; i <= below(3); ++i) {
      simulation::Material& material = setup.material[name("rock-", i)];
      material.regions = {name("region ", i), name("\"quoted\" ", i)};
      const double xx = positive();
      const double yy = flip() ? xx : xx * fraction();
      material.rock.permeability = {xx, yy, flip() ? 0.0 : 0.9 * std::sqrt(xx * yy) * fraction()};
      material.rock.porosity = fraction();
      if (flip()) {
        material.rock.biot_modulus = positive();
      }
    }
    for (int i = 0; i < below(3); ++i) {
      simulation::FractureGroup& group = setup.fracture[name("fault_", i)];
      group.groups = {name("curve", i)};
      group.fracture.initial_aperture = positive();
      group.fracture.minimum_aperture = flip() ? 0.0 : positive();
      group.fracture.maximum_aperture = flip() ? std::numeric_limits<double>::infinity()
                                               : group.fracture.minimum_aperture + positive();
      if (std::isinf(group.fracture.maximum_aperture) && flip()) {
        group.fracture.transmissivity = positive();
      }
      group.fracture.exchange = positive();
    }
  }

  void make_time(simulation::Setup& setup) {
    simulation::Stepping& time = setup.time;
    time.scheme = *rc::gen::element(simulation::Scheme::implicit, simulation::Scheme::explicit_,
                                    simulation::Scheme::steady);
    steady_ = time.scheme == simulation::Scheme::steady;
    if (steady_) {
      return;
    }
    time.end = positive();
    if (flip()) {
      time.stop_ratio = 0.5 * fraction();
    }
    if (flip()) {
      time.step = positive();
    } else if (time.scheme == simulation::Scheme::implicit) {
      time.initial_step = positive();
      time.maximum_step = *time.initial_step * 2.0;
      time.tolerance = 0.5 * fraction();
    }
    if (time.scheme == simulation::Scheme::explicit_) {
      time.safety = fraction();
    } else if (setup.fracture.count("fault_0") > 0 && flip()) {
      setup.fracture["fault_0"].fracture.exchange = std::numeric_limits<double>::infinity();
    }
  }

  void make_conditions(simulation::Setup& setup) {
    const bool cracks = !setup.fracture.empty();
    for (int i = 0; i < below(4); ++i) {
      simulation::BoundaryCondition& condition = setup.boundary[name("side", i)];
      condition.groups = {name("line", i)};
      const int kind = below(setup.model.gravity > 0.0 ? 4 : 3);
      std::optional<Schedule>* const members[] = {&condition.flux, &condition.pressure,
                                                  &condition.seepage_face, &condition.head};
      *members[kind] = schedule(1.0);
      condition.on = kind == 0 || !cracks ? simulation::Domain::both : side();
    }
    for (int i = 0; i < below(3); ++i) {
      simulation::Source& source = setup.source[name("well", i)];
      if (cracks && flip()) {
        source.fractures = {"fault_0"};
        source.pressure = schedule(1e-3);
      } else {
        source.point = point();
        source.into = cracks ? side() : simulation::Domain::matrix;
        source.rate = schedule(1e3);
      }
    }
    if (!steady_) {
      make_initial(setup, cracks);
    }
  }

  static void make_initial(simulation::Setup& setup, bool cracks) {
    if (flip() && flip()) {
      setup.initial.steady = true;
      return;
    }
    if (flip()) {
      setup.initial.pressure = any();
    } else if (setup.model.gravity > 0.0) {
      (flip() ? setup.initial.head : setup.initial.water_table) = any();
    }
    if (cracks && flip()) {
      setup.initial.crack_pressure = any();
      setup.initial.crack_saturation = 1.0;
    }
  }

  void make_output(simulation::Setup& setup) {
    if (!steady_) {
      for (const double part : {0.25, 0.5, 1.0}) {
        if (flip()) {
          setup.output.times.push_back(part * setup.time.end);
        }
      }
      if (flip()) {
        setup.output.interval = positive();
        setup.output.history_interval = positive();
      }
    }
    setup.output.fields = flip();
    for (int i = 0; i < below(3); ++i) {
      simulation::Probe& probe = setup.probe[name("probe", i)];
      probe.in = setup.fracture.empty() ? simulation::Domain::matrix : side();
      if (flip()) {
        probe.point = point();
      } else {
        probe.from = point();
        probe.to = std::array<double, 2>{any(), (*probe.from)[1] * 2.0};
        probe.points = *rc::gen::inRange(2, 1000001);
      }
    }
  }

  bool steady_ = false;
};

}  // namespace percolith::case_file
