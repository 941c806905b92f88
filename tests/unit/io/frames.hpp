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

}  // namespace percolith::test
