// SPDX-License-Identifier: BSD-3-Clause
#include "bench/support/mesh_file.hpp"

#include <fmt/format.h>

#include <span>

namespace percolith::bench {
namespace {

constexpr int line = 1;  // Gmsh's numbers of element types
constexpr int triangle = 2;

template <class T>
void append(std::string& content, T value) {
  content.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// One block of elements of one type in one physical group; elements are numbered from `number`.
template <std::size_t Corners>
void append_elements(std::string& content, int type, int group,
                     std::span<const std::array<std::int32_t, Corners>> elements, int& number) {
  append(content, type);
  append(content, static_cast<int>(elements.size()));
  append(content, 2);
  for (const auto& element : elements) {
    append(content, number++);
    append(content, group);
    append(content, group);
    for (const std::int32_t point : element) {
      append(content, point + 1);
    }
  }
}

}  // namespace

std::string mesh_file(const mesh::GmshMesh& mesh) {
  std::string content = "$MeshFormat\n2.2 1 8\n";
  append(content, 1);
  content += fmt::format("\n$EndMeshFormat\n$PhysicalNames\n{}\n2 1 \"{}\"\n",
                         mesh.curves.size() + 1, mesh.regions.front());
  std::size_t elements = mesh.triangles.size();
  int group = 1;
  for (const auto& [name, edges] : mesh.curves) {
    content += fmt::format("1 {} \"{}\"\n", ++group, name);
    elements += edges.size();
  }
  content += fmt::format("$EndPhysicalNames\n$Nodes\n{}\n", mesh.points.size());
  for (std::size_t p = 0; p < mesh.points.size(); ++p) {
    append(content, static_cast<int>(p) + 1);
    append(content, mesh.points[p].x);
    append(content, mesh.points[p].y);
    append(content, 0.0);
  }
  content += fmt::format("\n$EndNodes\n$Elements\n{}\n", elements);
  int number = 1;
  append_elements<3>(content, triangle, 1, mesh.triangles, number);
  group = 1;
  for (const auto& [name, edges] : mesh.curves) {
    append_elements<2>(content, line, ++group, edges, number);
  }
  return content + "\n$EndElements\n";
}

}  // namespace percolith::bench
