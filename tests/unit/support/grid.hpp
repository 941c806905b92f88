// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

// Meshes for tests: a grid of squares, each cut in two, with its points moved at random.
namespace percolith::test {

struct Grid {
  int columns = 4;
  int rows = 4;
  double width = 1.0;
  double height = 1.0;
  Point origin{};
  double jitter = 0.0;  ///< share of a cell an inner point may move
  unsigned seed = 1;    ///< of jitter and diagonals
  bool mixed_diagonals = false;

  [[nodiscard]] std::int32_t point(int column, int row) const {
    return row * (columns + 1) + column;
  }
};

/// A grid with the curves left, right, bottom and top and the surface rock.
inline mesh::GmshMesh make_grid(const Grid& grid) {
  std::mt19937 random(grid.seed);
  std::uniform_real_distribution<double> shift(-grid.jitter, grid.jitter);
  mesh::GmshMesh file;
  file.file = "grid.msh";
  file.regions = {"rock"};
  const double dx = grid.width / grid.columns;
  const double dy = grid.height / grid.rows;
  for (int j = 0; j <= grid.rows; ++j) {
    for (int i = 0; i <= grid.columns; ++i) {
      const bool inner = i > 0 && i < grid.columns && j > 0 && j < grid.rows;
      file.points.push_back({grid.origin.x + dx * (i + (inner ? shift(random) : 0.0)),
                             grid.origin.y + dy * (j + (inner ? shift(random) : 0.0))});
    }
  }
  for (int j = 0; j < grid.rows; ++j) {
    for (int i = 0; i < grid.columns; ++i) {
      const auto a = grid.point(i, j);
      const auto b = grid.point(i + 1, j);
      const auto c = grid.point(i + 1, j + 1);
      const auto d = grid.point(i, j + 1);
      if (grid.mixed_diagonals && random() % 2 == 0) {
        file.triangles.push_back({a, b, d});
        file.triangles.push_back({b, c, d});
      } else {
        file.triangles.push_back({a, b, c});
        file.triangles.push_back({a, c, d});
      }
    }
  }
  file.triangle_region.assign(file.triangles.size(), 0);
  for (int i = 0; i < grid.columns; ++i) {
    file.curves["bottom"].push_back({grid.point(i, 0), grid.point(i + 1, 0)});
    file.curves["top"].push_back({grid.point(i, grid.rows), grid.point(i + 1, grid.rows)});
  }
  for (int j = 0; j < grid.rows; ++j) {
    file.curves["left"].push_back({grid.point(0, j), grid.point(0, j + 1)});
    file.curves["right"].push_back({grid.point(grid.columns, j), grid.point(grid.columns, j + 1)});
  }
  return file;
}

/// Adds a curve along the grid line x = column, between two rows.
inline void add_column_curve(const Grid& grid, mesh::GmshMesh& file, const std::string& name,
                             int column, int first_row, int last_row) {
  for (int j = first_row; j < last_row; ++j) {
    file.curves[name].push_back({grid.point(column, j), grid.point(column, j + 1)});
  }
}

/// Adds a curve along the grid line y = row, between two columns.
inline void add_row_curve(const Grid& grid, mesh::GmshMesh& file, const std::string& name, int row,
                          int first_column, int last_column) {
  for (int i = first_column; i < last_column; ++i) {
    file.curves[name].push_back({grid.point(i, row), grid.point(i + 1, row)});
  }
}

/// The same mesh with points, triangles, corners and the sense of rotation shuffled.
inline mesh::GmshMesh shuffled(const mesh::GmshMesh& file, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::int32_t> number(file.points.size());
  std::iota(number.begin(), number.end(), 0);
  std::shuffle(number.begin(), number.end(), random);
  const auto renumber = [&](std::int32_t p) { return number[static_cast<std::size_t>(p)]; };
  mesh::GmshMesh result = file;
  for (std::size_t i = 0; i < number.size(); ++i) {
    result.points[static_cast<std::size_t>(number[i])] = file.points[i];
  }
  std::vector<std::size_t> order(file.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  for (std::size_t i = 0; i < order.size(); ++i) {
    auto triangle = file.triangles[order[i]];
    std::transform(triangle.begin(), triangle.end(), triangle.begin(), renumber);
    std::rotate(triangle.begin(), triangle.begin() + random() % 3, triangle.end());
    if (random() % 2 == 0) {
      std::swap(triangle[0], triangle[1]);
    }
    result.triangles[i] = triangle;
    result.triangle_region[i] = file.triangle_region[order[i]];
  }
  for (auto& [name, edges] : result.curves) {
    for (auto& edge : edges) {
      edge = {renumber(edge[1]), renumber(edge[0])};
    }
    std::shuffle(edges.begin(), edges.end(), random);
  }
  for (auto& [name, points] : result.point_groups) {
    std::transform(points.begin(), points.end(), points.begin(), renumber);
  }
  return result;
}

}  // namespace percolith::test
