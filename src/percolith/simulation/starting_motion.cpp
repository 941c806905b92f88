// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/starting_motion.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace percolith::simulation {
namespace {

using mesh::Index;

void require_one_a_vertex(const mesh::Mesh& mesh, const std::vector<Point>& values,
                          const char* key) {
  if (!values.empty() && values.size() != mesh.vertex.size()) {
    throw InputError({{},
                      key,
                      "",
                      fmt::format("there are {} values", values.size()),
                      fmt::format("one for each of the {} vertices", mesh.vertex.size())});
  }
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!std::isfinite(values[v].x) || !std::isfinite(values[v].y)) {
      throw InputError({{},
                        key,
                        fmt::format("({:g}, {:g}) at ({:g}, {:g})", values[v].x, values[v].y,
                                    mesh.vertex[v].x, mesh.vertex[v].y),
                        "not finite",
                        "finite values"});
    }
  }
}

void refuse_turned_triangles(const mesh::Mesh& mesh, const std::vector<Point>& displacement) {
  if (displacement.empty()) {
    return;
  }
  for (const auto& vertices : mesh.triangle_vertex) {
    std::array<Point, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = mesh.vertex[at(vertices[k])] + displacement[at(vertices[k])];
    }
    if (!(cross(p[1] - p[0], p[2] - p[0]) > 0.0)) {
      throw InputError({{},
                        "displacement",
                        "",
                        fmt::format("turns the triangle at ({:g}, {:g}) over",
                                    mesh.vertex[at(vertices[0])].x, mesh.vertex[at(vertices[0])].y),
                        "displacements that leave every triangle an area"});
    }
  }
}

void give(const mesh::Mesh& mesh, const std::vector<Point>& values, std::vector<double>& x,
          std::vector<double>& y) {
  if (values.empty()) {
    return;
  }
  for (Index t = 0; t < mesh.triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Index c = mesh::corner_of(t, k);
      const Point& value = values[at(mesh.vertex_of(c))];
      x[at(c)] = value.x;
      y[at(c)] = value.y;
    }
  }
}

}  // namespace

void set_motion(mechanics::Model& rock, const StartingMotion& start) {
  require_one_a_vertex(rock.mesh, start.displacement, "displacement");
  require_one_a_vertex(rock.mesh, start.velocity, "velocity");
  refuse_turned_triangles(rock.mesh, start.displacement);
  give(rock.mesh, start.displacement, rock.motion.ux, rock.motion.uy);
  give(rock.mesh, start.velocity, rock.motion.vx, rock.motion.vy);
}

}  // namespace percolith::simulation
