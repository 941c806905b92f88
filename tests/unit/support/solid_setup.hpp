// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "unit/support/setup.hpp"

// Setups of dry rock for tests, and an observer that keeps the events too.
namespace percolith::test {

/// A breakable block on `plain_mesh` or a grid, without loads, supports and gravity.
inline simulation::Setup solid_setup() {
  simulation::Setup setup;
  setup.model.physics = simulation::Physics::mechanics;
  setup.model.gravity = 0.0;
  simulation::Material rock;
  rock.regions = {"rock"};
  rock.solid.density = 2500.0;
  rock.solid.young_modulus = 10e9;
  rock.solid.poisson_ratio = 0.25;
  rock.strength.tensile_strength = 5e6;
  rock.strength.cohesion = 15e6;
  rock.strength.friction_angle = 0.6;
  rock.strength.mode_1_energy = 400.0;
  rock.strength.mode_2_energy = 900.0;
  setup.material["sandstone"] = rock;
  setup.time.end = 1e-3;
  setup.output.fields = true;
  return setup;
}

inline simulation::BoundaryCondition on(const std::string& group) {
  simulation::BoundaryCondition condition;
  condition.groups = {group};
  return condition;
}

class SolidRecorder : public Recorder {
public:
  void on_events(const std::vector<simulation::BreakEvent>& now) override {
    events.insert(events.end(), now.begin(), now.end());
  }
  std::vector<simulation::BreakEvent> events;
};

/// The value of a name in a history row or summary.
inline double value_of(const std::vector<simulation::NamedValue>& values, const std::string& name) {
  for (const auto& [key, value] : values) {
    if (key == name) {
      return value;
    }
  }
  ADD_FAILURE() << "no value " << name;
  return 0.0;
}

/// The value of a name in the results of a summary or a check, counts among them.
inline double value_of(const std::vector<simulation::NamedResult>& results,
                       const std::string& name) {
  std::vector<simulation::NamedValue> values;
  for (const auto& [key, result] : results) {
    values.emplace_back(
        key, std::visit([](auto number) { return static_cast<double>(number); }, result));
  }
  return value_of(values, name);
}

/// A field of the matrix frame that is one number a cell.
inline std::vector<double> cell_values(const simulation::Frame& frame, const std::string& name) {
  for (const simulation::FrameField& field : frame.matrix.cell_fields) {
    if (field.name == name) {
      return std::get<std::vector<double>>(field.values);
    }
  }
  ADD_FAILURE() << "no field " << name;
  return {};
}

}  // namespace percolith::test
