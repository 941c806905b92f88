// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/coupling/build.hpp"
#include "percolith/coupling/coupled_step.hpp"
#include "percolith/coupling/step_limit.hpp"

#include <functional>
#include <memory>
#include <numeric>
#include <utility>

#include "unit/support/flow_model.hpp"
#include "unit/support/solid_model.hpp"

// Rock with fluid in it for tests.
namespace percolith::test {

/// A grid with a crack, the curve "crack", from the left side to the middle.
inline mesh::GmshMesh notched(const Grid& grid) {
  mesh::GmshMesh file = make_grid(grid);
  add_row_curve(grid, file, "crack", grid.rows / 2, 0, grid.columns / 2);
  return file;
}

struct CoupledOptions {
  SolidOptions solid{};
  FlowOptions flow{};
  double biot = 0.8;
  coupling::JointStress joint_stress = coupling::JointStress::effective;
  coupling::FluidEnters fluid_enters = coupling::FluidEnters::broken;
  coupling::PoreFlow pore_flow = coupling::PoreFlow::explicit_;
  std::function<void(mechanics::Model&)> prepare_rock{};  ///< before it is made wet
  std::function<void(seepage::Model&)> prepare_water{};   ///< cracks, state and conditions
  std::function<mechanics::LoadList(const mechanics::Model&)> loads{};
  std::function<mechanics::SupportSet(mechanics::Model&)> supports{};
};

/// Tied rock with next to no permeability, pressed from all sides by 0.1 MPa.
inline CoupledOptions squeezed() {
  CoupledOptions options;
  options.solid.joints = JointState::tied;
  options.solid.damping.local = 0.7;
  options.flow.rock.permeability = {1e-22, 1e-22, 0.0};
  options.flow.rock.biot_modulus = 10e9;
  options.biot = 0.8;
  options.loads = [](const mechanics::Model& rock) {
    mechanics::LoadList loads;
    std::vector<Index> edges(rock.mesh.boundary.size());
    std::iota(edges.begin(), edges.end(), 0);
    loads.pressure.push_back({edges, Schedule::constant(1e5)});
    return loads;
  };
  return options;
}

/// What its pores take up, Pa: undrained plane strain under equal compression s gives
/// p = s alpha M/(alpha^2 M + lambda + G), with lambda = G for a Poisson's ratio of 0.25.
inline constexpr double squeezed_pressure =
    1e5 * 0.8 * 10e9 / (0.8 * 0.8 * 10e9 + 2.0 * 10e9 / (2.0 * 1.25));

/// Both halves and what binds them; stays where it is.
class Coupled {
public:
  Coupled(const mesh::GmshMesh& file, const CoupledOptions& options)
      : water_(make_water(file, options)), rock_(make_rock(file, options, water_)),
        model_{
            rock_, water_, {options.fluid_enters, std::vector<Index>(water_.mesh.joint.size(), 0)}},
        limit_(model_), step_(model_, options.pore_flow, 0.9 * limit_.pores()),
        in_place_at_start_(seepage::fluid_in_place(water_, Execution())) {}
  Coupled(const Coupled&) = delete;
  Coupled& operator=(const Coupled&) = delete;

  /// Advances by `steps` steps of a share of the longest stable one; returns the joints that broke.
  int advance(int steps, Execution& execution, double share = 0.5) {
    int broke = 0;
    for (int i = 0; i < steps; ++i) {
      broke +=
          static_cast<int>(step_.advance(share * limit_.motion(model_), execution).broke.size());
    }
    return broke;
  }
  int advance(int steps) {
    Execution execution;
    return advance(steps, execution);
  }

  /// Fluid that appeared, over fluid in place and throughput.
  [[nodiscard]] double mass_error() const {
    const double in_place = seepage::fluid_in_place(water_, Execution());
    const double in = water_.passed_in.total();
    const double out = water_.passed_out.total();
    return std::abs(in - out - (in_place - in_place_at_start_)) / (in_place + in + out);
  }
  /// Energy that no term accounts for over the largest work.
  [[nodiscard]] double energy_error() const {
    const auto b = rock_.energy(Execution());
    const double scale = std::max({std::abs(b.external), std::abs(b.fluid), b.kinetic, b.elastic});
    return scale > 0.0 ? std::abs(b.residual) / scale : 0.0;
  }
  [[nodiscard]] std::string bits() const {
    StateHash hash;
    rock_.add_to(hash);
    const seepage::State& s = water_.state;
    for (const auto* field : {&s.pressure, &s.saturation, &s.content, &s.content_carry,
                              &s.crack_pressure, &s.crack_content, &s.crack_content_carry}) {
      hash.add(*field);
    }
    return hash.text();
  }

  [[nodiscard]] mechanics::Dynamics& rock() { return rock_; }
  [[nodiscard]] seepage::Model& water() { return water_; }
  [[nodiscard]] coupling::CoupledModel& model() { return model_; }
  [[nodiscard]] coupling::CoupledStep& step() { return step_; }
  [[nodiscard]] coupling::StepLimit& limit() { return limit_; }

private:
  static seepage::Model make_water(const mesh::GmshMesh& file, const CoupledOptions& options) {
    seepage::Model model = make_flow(file, options.flow);
    if (options.prepare_water) {
      options.prepare_water(model);
    }
    return model;
  }
  static mechanics::Dynamics make_rock(const mesh::GmshMesh& file, const CoupledOptions& options,
                                       const seepage::Model& water) {
    mechanics::Model rock = make_solid(file, options.solid);
    if (options.prepare_rock) {
      options.prepare_rock(rock);
    }
    const std::vector<double> biot(rock.mesh.region_names.size(), options.biot);
    coupling::moisten(rock, water, biot, options.joint_stress);
    mechanics::LoadList loads = options.loads ? options.loads(rock) : mechanics::LoadList{};
    mechanics::SupportSet supports =
        options.supports ? options.supports(rock) : mechanics::SupportSet{};
    return make_dynamics(std::move(rock), std::move(loads), std::move(supports));
  }

  seepage::Model water_;
  mechanics::Dynamics rock_;
  coupling::CoupledModel model_;
  coupling::StepLimit limit_;
  coupling::CoupledStep step_;
  double in_place_at_start_;
};

}  // namespace percolith::test
