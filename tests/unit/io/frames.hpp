// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

namespace percolith::test {

/// Two triangles on a square that a crack along the diagonal separates.
inline simulation::Frame cracked_square(double time) {
  simulation::Frame frame;
  frame.time = time;
  frame.step = 7;
  simulation::MatrixFrame& matrix = frame.matrix;
  matrix.points = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  matrix.triangles = {{0, 1, 2}, {3, 4, 5}};
  matrix.region = {0, 1};
  matrix.pressure = {1e5, 2e5, 3e5, 4e5, 5e5, 0.1 + 0.2};
  matrix.head = {1, 2, 3, 4, 5, 6};
  matrix.saturation = {1, 1, 0.5, 1, 1, 1.0 / 3};
  matrix.flux = {{1e-6, -2e-6}, {3e-6, 4e-6}};
  simulation::CrackFrame& cracks = frame.cracks;
  cracks.points = {{0, 0}, {1, 1}};
  cracks.segments = {{0, 1}};
  cracks.group = {3};
  cracks.pressure = {2.5e5, 3.5e5};
  cracks.head = {7, 8};
  cracks.saturation = {1, 0.25};
  cracks.aperture = {1e-4};
  cracks.flux = {-5e-7};
  return frame;
}

/// The same square in a run of mechanics: it has fields of its own and none of flow, and the crack
/// belongs to no fracture group.
inline simulation::Frame broken_square(double time) {
  simulation::Frame frame = cracked_square(time);
  simulation::MatrixFrame& matrix = frame.matrix;
  matrix.pressure.clear();
  matrix.head.clear();
  matrix.saturation.clear();
  matrix.flux.clear();
  matrix.point_fields = {{"displacement_m", std::vector<Point>(6, {1e-3, -2e-3})}};
  matrix.cell_fields = {{"damage", std::vector<double>{0.25, 1.0 / 3}},
                        {"fragment", std::vector<std::int32_t>{0, 1}},
                        {"principal_direction", std::vector<Point>{{1, 0}, {0.6, 0.8}}}};
  simulation::CrackFrame& cracks = frame.cracks;
  cracks.group = {-1};
  cracks.pressure.clear();
  cracks.head.clear();
  cracks.saturation.clear();
  cracks.aperture.clear();
  cracks.flux.clear();
  cracks.cell_fields = {{"opening_m", std::vector<double>{2e-5}},
                        {"mode", std::vector<std::int32_t>{-1}}};
  return frame;
}

}  // namespace percolith::test
