// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/joined_nodes.hpp"

#include "percolith/core/disjoint_sets.hpp"

namespace percolith::mechanics {
namespace {

using Eigen::Matrix2d;

void number_nodes(const Model& model, JoinedNodes& nodes) {
  DisjointSets joined(model.mesh.corners());
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (is_whole(model, j)) {
      const auto& corner = model.mesh.joint[at(j)].corner;
      joined.merge(corner[0][0], corner[1][0]);
      joined.merge(corner[0][1], corner[1][1]);
    }
  }
  nodes.of_corner.assign(model.motion.ux.size(), mesh::none);
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    for (Index k = 0; k < 3 && model.triangles.inverse_mass[at(t)] > 0.0; ++k) {
      const Index corner = mesh::corner_of(t, k);
      Index& number = nodes.of_corner[at(joined.root(corner))];
      if (number == mesh::none) {
        number = nodes.count++;
      }
      nodes.of_corner[at(corner)] = number;
    }
  }
}

Matrix2d projection(const Model& model, Index corner) {
  const Index record = model.constraints.record[at(corner / mesh::corners_per_block)];
  if (record == mesh::none) {
    return Matrix2d::Identity();
  }
  const auto place = at(record * mesh::corners_per_block + corner % mesh::corners_per_block);
  const Constraints& c = model.constraints;
  Matrix2d p;
  p << c.pxx[place], c.pxy[place], c.pxy[place], c.pyy[place];
  return p;
}

void set_supports(const Model& model, JoinedNodes& nodes) {
  nodes.free.assign(at(nodes.count), Matrix2d::Identity());
  for (std::size_t c = 0; c < nodes.of_corner.size(); ++c) {
    if (nodes.of_corner[c] == mesh::none) {
      continue;
    }
    const Matrix2d p = projection(model, static_cast<Index>(c));
    Matrix2d& of_node = nodes.free[at(nodes.of_corner[c])];
    if (of_node.isIdentity(0.0)) {
      of_node = p;
    } else if (!p.isIdentity(0.0) && !of_node.isApprox(p)) {
      of_node.setZero();
    }
  }
}

DisjointSets parts_of(const Model& model, const std::vector<SoftJoint>& soft,
                      const JoinedNodes& nodes) {
  DisjointSets parts(nodes.count);
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const Index first = nodes.of_corner[at(mesh::corner_of(t, 0))];
    for (Index k = 1; k < 3 && first != mesh::none; ++k) {
      parts.merge(first, nodes.of_corner[at(mesh::corner_of(t, k))]);
    }
  }
  for (const SoftJoint& joint : soft) {
    if (joint.normal[0] + joint.normal[1] > 0.0) {
      const auto& corner = model.mesh.joint[at(joint.joint)].corner;
      parts.merge(nodes.of_corner[at(corner[0][0])], nodes.of_corner[at(corner[1][0])]);
    }
  }
  return parts;
}

void find_loose_parts(const Model& model, const std::vector<SoftJoint>& soft, JoinedNodes& nodes) {
  DisjointSets parts = parts_of(model, soft, nodes);
  std::vector<std::uint8_t> held(at(nodes.count), 0);
  for (Index n = 0; n < nodes.count; ++n) {
    if (!nodes.free[at(n)].isIdentity(0.0)) {
      held[at(parts.root(n))] = 1;
    }
  }
  std::vector<Index> number(at(nodes.count), mesh::none);
  nodes.loose_part.assign(at(nodes.count), mesh::none);
  for (Index n = 0; n < nodes.count; ++n) {
    const auto root = at(parts.root(n));
    if (held[root] == 0) {
      if (number[root] == mesh::none) {
        number[root] = nodes.loose_parts++;
      }
      nodes.loose_part[at(n)] = number[root];
    }
  }
}

/// How a loose part moves as a whole.
struct LoosePart {
  double corners = 0.0;
  Point middle{}, way{};
  double turn = 0.0, inertia = 0.0;
};

}  // namespace

JoinedNodes joined_nodes(const Model& model, const std::vector<SoftJoint>& soft) {
  JoinedNodes nodes;
  number_nodes(model, nodes);
  set_supports(model, nodes);
  find_loose_parts(model, soft, nodes);
  return nodes;
}

void keep_loose_parts(const Model& model, const JoinedNodes& nodes, std::span<double> way) {
  std::vector<LoosePart> parts(at(nodes.loose_parts));
  const auto each_corner = [&](const auto& visit) {
    for (Index corner = 0; corner < static_cast<Index>(nodes.of_corner.size()); ++corner) {
      const Index node = nodes.of_corner[at(corner)];
      if (node != mesh::none && nodes.loose_part[at(node)] != mesh::none) {
        const Point place = model.mesh.vertex[at(model.mesh.vertex_of(corner))];
        visit(parts[at(nodes.loose_part[at(node)])], place, 2 * at(corner));
      }
    }
  };
  each_corner([&](LoosePart& part, const Point& place, std::size_t i) {
    part.corners += 1.0;
    part.middle = part.middle + place;
    part.way = part.way + Point{way[i], way[i + 1]};
  });
  for (LoosePart& part : parts) {
    part.middle = (1.0 / part.corners) * part.middle;
    part.way = (1.0 / part.corners) * part.way;
  }
  each_corner([&](LoosePart& part, const Point& place, std::size_t i) {
    const Point arm = place - part.middle;
    part.turn += cross(arm, Point{way[i], way[i + 1]});
    part.inertia += dot(arm, arm);
  });
  each_corner([&](const LoosePart& part, const Point& place, std::size_t i) {
    const Point arm = place - part.middle;
    const double turn = part.turn / part.inertia;
    way[i] -= part.way.x - turn * arm.y;
    way[i + 1] -= part.way.y + turn * arm.x;
  });
}

}  // namespace percolith::mechanics
