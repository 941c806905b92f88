// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/error.hpp"
#include "percolith/mesh/gmsh_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

// Small meshes as the content of `.msh` files, to be spoilt by the tests of the reader.
namespace percolith::mesh::samples {

inline const std::string data = "tests/unit/mesh/data/";

/// The parts of a text file. As it stands: the unit square cut along the diagonal from (0, 0).
struct TextMesh {
  std::string format = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
  std::string names = "$PhysicalNames\n2\n1 5 \"left\"\n2 7 \"rock\"\n$EndPhysicalNames\n";
  std::vector<std::string> nodes = {"1 0 0 0", "2 1 0 0", "3 1 1 0", "4 0 1 0"};
  std::vector<std::string> elements = {"1 1 2 5 1 4 1", "2 2 2 7 1 1 2 3", "3 2 2 7 1 1 3 4"};

  [[nodiscard]] std::string text() const {
    return format + names + section("Nodes", nodes) + section("Elements", elements);
  }
  static std::string section(const std::string& name, const std::vector<std::string>& lines) {
    std::string text = "$" + name + "\n" + std::to_string(lines.size()) + "\n";
    for (const std::string& line : lines) {
      text += line + "\n";
    }
    return text + "$End" + name + "\n";
  }
};

/// The same square in version 4.1.
struct TextMesh41 {
  std::string format = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  std::string names = "$PhysicalNames\n2\n1 5 \"left\"\n2 7 \"rock\"\n$EndPhysicalNames\n";
  std::string entities = "$Entities\n0 1 1 0\n1 0 0 0 0 1 0 1 5 0\n"
                         "1 0 0 0 1 1 0 1 7 1 1\n$EndEntities\n";
  std::string nodes = "$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                      "$EndNodes\n";
  std::string elements = "$Elements\n2 3 1 3\n1 1 1 1\n1 4 1\n2 1 2 2\n2 1 2 3\n3 1 3 4\n"
                         "$EndElements\n";

  [[nodiscard]] std::string text() const { return format + names + entities + nodes + elements; }
};

/// Writes numbers as bytes, in the order of this machine or reversed.
class BinaryText {
public:
  explicit BinaryText(bool reversed) : reversed_(reversed) {}
  BinaryText& text(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  template <class T>
  BinaryText& numbers(const std::vector<T>& values) {
    for (const T& value : values) {
      std::string bytes(sizeof(T), '\0');
      std::memcpy(bytes.data(), &value, sizeof(T));
      if (reversed_) {
        std::reverse(bytes.begin(), bytes.end());
      }
      bytes_ += bytes;
    }
    return *this;
  }
  BinaryText& ints(const std::vector<std::int32_t>& values) { return numbers(values); }
  BinaryText& sizes(const std::vector<std::uint64_t>& values) { return numbers(values); }
  BinaryText& reals(const std::vector<double>& values) { return numbers(values); }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
  bool reversed_;
  std::string bytes_;
};

/// The message of the InputError or FileError that `action` throws; "no error" when it throws none.
template <class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// A mesh by places instead of indices, so that files that number differently compare equal; in
/// units of 1e-12 m, because text files keep 16 digits only.
struct Places {
  using Place = std::array<long long, 2>;
  std::vector<std::pair<std::string, std::vector<Place>>> items;
  friend bool operator==(const Places&, const Places&) = default;
};

inline Places places_of(const GmshMesh& mesh) {
  Places places;
  const auto add = [&](const std::string& name, const auto& indices) {
    std::vector<Places::Place> corners;
    for (const std::int32_t index : indices) {
      const Point& point = mesh.points[static_cast<std::size_t>(index)];
      corners.push_back({std::llround(1e12 * point.x), std::llround(1e12 * point.y)});
    }
    std::sort(corners.begin(), corners.end());
    places.items.emplace_back(name, corners);
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    add("region " + mesh.regions[static_cast<std::size_t>(mesh.triangle_region[i])],
        mesh.triangles[i]);
  }
  for (const auto& [name, edges] : mesh.curves) {
    for (const auto& edge : edges) {
      add("curve " + name, edge);
    }
  }
  for (const auto& [name, points] : mesh.point_groups) {
    add("points " + name, points);
  }
  std::sort(places.items.begin(), places.items.end());
  return places;
}

}  // namespace percolith::mesh::samples
