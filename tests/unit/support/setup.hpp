// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/error.hpp"
#include "percolith/simulation/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "unit/support/grid.hpp"

// Setups for tests and an observer that keeps what it is told.
namespace percolith::test {

/// A steady flow from left to right through one rock, without gravity.
inline simulation::Setup plain_setup() {
  simulation::Setup setup;
  setup.model.gravity = 0.0;
  setup.material["sandstone"] = {
      {"rock"}, {.permeability = {1e-13, 1e-13, 0.0}, .porosity = 0.2, .biot_modulus = {}}};
  setup.boundary["inlet"].groups = {"left"};
  setup.boundary["inlet"].pressure = Schedule::constant(1e5);
  setup.boundary["outlet"].groups = {"right"};
  setup.boundary["outlet"].pressure = Schedule::constant(0.0);
  setup.time.scheme = simulation::Scheme::steady;
  return setup;
}

inline simulation::FractureGroup
fracture_group(const std::string& curve, double aperture,
               double exchange = std::numeric_limits<double>::infinity()) {
  simulation::FractureGroup group;
  group.groups = {curve};
  group.fracture.initial_aperture = aperture;
  group.fracture.exchange = exchange;
  return group;
}

/// The grid most setups run on, with two curves inside: `upright` reaches the top, `level` neither
/// side.
inline const Grid plain_grid{.columns = 8, .rows = 8};

inline mesh::GmshMesh plain_mesh(const Grid& grid = plain_grid) {
  mesh::GmshMesh file = make_grid(grid);
  const int column = grid.columns / 2;
  const int row = grid.rows / 2;
  add_column_curve(grid, file, "upright", column, grid.rows / 4, grid.rows);
  add_row_curve(grid, file, "level", row, 1, grid.columns - 1);
  file.point_groups["well"] = {grid.point(column, row)};
  return file;
}

class Recorder : public simulation::Observer {
public:
  void on_progress(const simulation::Progress& p) override { progress.push_back(p); }
  void on_history(const simulation::HistoryRow& row) override { history.push_back(row); }
  void on_frame(const simulation::Frame& frame) override { frames.push_back(frame); }
  void on_probes(double time, const std::vector<simulation::ProbeSample>& samples) override {
    probe_times.push_back(time);
    probes.push_back(samples);
  }
  void on_warning(const std::string& text) override { warnings.push_back(text); }

  std::vector<simulation::Progress> progress;
  std::vector<simulation::HistoryRow> history;
  std::vector<simulation::Frame> frames;
  std::vector<double> probe_times;
  std::vector<std::vector<simulation::ProbeSample>> probes;
  std::vector<std::string> warnings;
};

inline bool never() {
  return false;
}

/// Builds and runs; returns the summary.
inline simulation::Summary run(const simulation::Setup& setup, const mesh::GmshMesh& mesh,
                               Recorder& recorder) {
  simulation::Simulation simulation(setup, mesh);
  simulation.run(recorder, never);
  return simulation.summary();
}

/// Expects an InputError under `key` whose message contains `text`.
inline void expect_input_error(const std::function<void()>& action, const std::string& key,
                               const std::string& text) {
  try {
    action();
    ADD_FAILURE() << "no error; expected " << key << ": " << text;
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem().key, key);
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos)
        << "said:     " << error.what() << "\nexpected: " << text;
  }
}

/// Expects that a setup cannot be built on the plain mesh.
inline void expect_refused(const simulation::Setup& setup, const std::string& key,
                           const std::string& text) {
  expect_input_error([&] { simulation::Simulation(setup, plain_mesh()); }, key, text);
}

}  // namespace percolith::test
