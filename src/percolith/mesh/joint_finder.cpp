// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/joint_finder.hpp"

#include <algorithm>
#include <cmath>

namespace percolith::mesh {
namespace {

PlaceOnJoint place_on(const Mesh& mesh, Index joint, const Point& p) {
  const auto& ends = mesh.joint[at(joint)].vertex;
  const Point a = mesh.vertex[at(ends[0])];
  const Point along = mesh.vertex[at(ends[1])] - a;
  const double fraction = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
  const Point gap = p - (a + fraction * along);
  return {joint, fraction, std::sqrt(dot(gap, gap))};
}

}  // namespace

std::optional<PlaceOnJoint> nearest_joint(const Mesh& mesh, std::span<const Index> joints,
                                          const Point& p) {
  std::optional<PlaceOnJoint> best;
  for (const Index j : joints) {
    const PlaceOnJoint place = place_on(mesh, j, p);
    if (!best || place.distance < best->distance) {
      best = place;
    }
  }
  return best;
}

JointFinder::JointFinder(const Mesh& mesh, std::span<const Index> joints, double share)
    : mesh_(&mesh), share_(share) {
  double longest = 0.0;
  for (const Index j : joints) {
    longest = std::max(longest, mesh.joint_length(j));
  }
  size_ = (0.5 + share) * longest;
  by_square_.reserve(joints.size());
  for (const Index j : joints) {
    const auto& ends = mesh.joint[at(j)].vertex;
    by_square_.emplace_back(square_of(0.5 * (mesh.vertex[at(ends[0])] + mesh.vertex[at(ends[1])])),
                            j);
  }
  std::sort(by_square_.begin(), by_square_.end());
}

JointFinder::Square JointFinder::square_of(const Point& p) const {
  return {std::floor(p.x / size_), std::floor(p.y / size_)};
}

std::vector<PlaceOnJoint> JointFinder::near(const Point& p) const {
  std::vector<PlaceOnJoint> places;
  if (by_square_.empty()) {
    return places;
  }
  const auto [column, row] = square_of(p);
  for (const double beside : {-1.0, 0.0, 1.0}) {
    const double x = column + beside;
    auto found = std::lower_bound(by_square_.begin(), by_square_.end(),
                                  std::pair(Square{x, row - 1.0}, Index{0}));
    for (; found != by_square_.end() && found->first <= Square{x, row + 1.0}; ++found) {
      const PlaceOnJoint place = place_on(*mesh_, found->second, p);
      if (place.distance <= share_ * mesh_->joint_length(place.joint)) {
        places.push_back(place);
      }
    }
  }
  std::sort(places.begin(), places.end(), [](const PlaceOnJoint& a, const PlaceOnJoint& b) {
    return std::pair(a.distance, a.joint) < std::pair(b.distance, b.joint);
  });
  return places;
}

}  // namespace percolith::mesh
