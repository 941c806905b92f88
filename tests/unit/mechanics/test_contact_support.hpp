// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/contact/contact.hpp"
#include "percolith/mechanics/contact/overlap.hpp"
#include "percolith/mechanics/contact/overlap_force.hpp"

#include <array>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "unit/support/grid.hpp"
#include "unit/support/places.hpp"

// Triangles that come into contact, for tests.
namespace percolith::mechanics::test {

using percolith::test::at;

inline PlacedTriangle placed(const Corners& t) {
  return {t[0], {0.0, 0.0}, t[1] - t[0], t[2] - t[0]};
}

/// Three points at random in a square of side 1 round a centre, counter-clockwise and no splinter.
inline Corners random_triangle(std::mt19937& random, Point centre = {0.0, 0.0}) {
  std::uniform_real_distribution<double> place(-0.5, 0.5);
  for (;;) {
    Corners t;
    for (Point& p : t) {
      p = centre + Point{place(random), place(random)};
    }
    const double twice = cross(t[1] - t[0], t[2] - t[0]);
    if (std::abs(twice) > 0.1) {
      if (twice < 0.0) {
        std::swap(t[1], t[2]);
      }
      return t;
    }
  }
}

struct Material {
  double penalty = 1e9;
  double tangential_penalty = 2e9;
  double friction = 0.5;
};

/// A mesh with a state of motion and its contact. Triangles keep the numbers they were given with.
class Bodies {
public:
  explicit Bodies(mesh::GmshMesh file, const Material& material = {}, unsigned char bonded = 0)
      : mesh_(numbered(std::move(file))), number_(mesh_.triangle_vertex.size()),
        tied_(mesh_.joint.size(), bonded), touch_(mesh_.joint.size(), bonded == 0 ? 1 : 0),
        candidate_(mesh_.triangle_vertex.size(), 1), contact_(mesh_, properties(material)) {
    for (auto* values : {&ux_, &uy_, &vx_, &vy_}) {
      values->assign(at(mesh_.corners()), 0.0);
    }
    for (Index t = 0; t < mesh_.triangles(); ++t) {
      number_[at(mesh_.region[at(t)])] = t;
    }
    refresh();
  }

  /// Separate triangles.
  static Bodies of(const std::vector<Corners>& triangles, const Material& material = {}) {
    mesh::GmshMesh file;
    file.file = "triangles.msh";
    for (const Corners& t : triangles) {
      const auto first = static_cast<std::int32_t>(file.points.size());
      file.points.insert(file.points.end(), t.begin(), t.end());
      file.triangles.push_back({first, first + 1, first + 2});
    }
    return Bodies(std::move(file), material);
  }

  /// Tells the contact that these joints broke; none: that all may have changed.
  void refresh(std::span<const Index> broken = {}) {
    const mesh::NodeMap fans(mesh_, tied_);
    contact_.topology_changed(mesh_, {candidate_, &fans, touch_}, broken);
  }
  void move(Index triangle, Point by) {
    for (Index k = 0; k < 3; ++k) {
      ux_[slot(triangle, k)] += by.x;
      uy_[slot(triangle, k)] += by.y;
    }
  }
  void set_velocity(Index triangle, Point v) {
    for (Index k = 0; k < 3; ++k) {
      vx_[slot(triangle, k)] = v.x;
      vy_[slot(triangle, k)] = v.y;
    }
  }
  void advance(double travelled, double dt, Execution& execution) {
    contact_.advance(mesh_, motion(), travelled, dt, execution);
  }
  void advance(double travelled = 0.0, double dt = 0.0) { advance(travelled, dt, execution_); }
  [[nodiscard]] Point force(Index triangle) const {
    Point sum;
    for (Index k = 0; k < 3; ++k) {
      sum = sum + corner_force(triangle, k);
    }
    return sum;
  }
  [[nodiscard]] Point corner_force(Index triangle, Index k) const {
    return {contact_.force_x()[slot(triangle, k)], contact_.force_y()[slot(triangle, k)]};
  }
  [[nodiscard]] Point corner(Index triangle, Index k) const {
    const auto s = slot(triangle, k);
    return mesh_.place_of(static_cast<Index>(s)) + Point{ux_[s], uy_[s]};
  }
  [[nodiscard]] std::size_t slot(Index triangle, Index k) const {
    return at(mesh::corner_of(number_[at(triangle)], k));
  }
  [[nodiscard]] CornerMotion motion() const { return {ux_, uy_, vx_, vy_}; }
  [[nodiscard]] double potential_energy() const {
    return contact_.potential_energy(mesh_, motion());
  }
  [[nodiscard]] const mesh::Mesh& mesh() const { return mesh_; }
  [[nodiscard]] Index triangle(Index given) const { return number_[at(given)]; }
  Contact& contact() { return contact_; }
  std::vector<std::uint8_t>& tied() { return tied_; }
  std::vector<std::uint8_t>& touch() { return touch_; }
  std::vector<std::uint8_t>& candidate() { return candidate_; }
  std::vector<double>& ux() { return ux_; }
  std::vector<double>& uy() { return uy_; }

private:
  static mesh::Mesh numbered(mesh::GmshMesh file) {
    file.regions.clear();
    file.triangle_region.clear();
    for (std::size_t t = 0; t < file.triangles.size(); ++t) {
      file.triangle_region.push_back(static_cast<std::int32_t>(t));
      file.regions.push_back(std::to_string(t));
    }
    return mesh::build_mesh(file);
  }
  [[nodiscard]] ContactProperties properties(const Material& m) const {
    const std::size_t n = mesh_.triangle_vertex.size();
    return {std::vector<double>(n, m.penalty), std::vector<double>(n, m.tangential_penalty),
            std::vector<double>(n, m.friction)};
  }

  mesh::Mesh mesh_;
  std::vector<Index> number_;
  std::vector<std::uint8_t> tied_, touch_, candidate_;
  std::vector<double> ux_, uy_, vx_, vy_;
  Contact contact_;
  Execution execution_;
};

/// A wide triangle below whose upper edge lies at y = 0, and a small one above that stands on its
/// corner or lies on its edge at height 0.
inline const Corners floor_triangle{Point{2.0, 0.0}, Point{-2.0, 0.0}, Point{0.0, -3.0}};
inline const Corners pointed{Point{0.0, 0.0}, Point{0.5, 0.8}, Point{-0.5, 0.8}};
inline const Corners flat{Point{-0.5, 0.0}, Point{0.5, 0.0}, Point{0.0, 0.8}};

}  // namespace percolith::mechanics::test
