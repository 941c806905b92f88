// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/joined_rock.hpp"

#include "percolith/mechanics/joint.hpp"
#include "percolith/mechanics/joint_points.hpp"
#include "percolith/mechanics/triangle.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace percolith::mechanics {
namespace {

using Eigen::Matrix2d;
using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;
using StrainMatrix = Eigen::Matrix<double, 3, 2>;

/// Stiffness of the ground that all of a loose part stands on, which it needs to have any, over the
/// largest modulus, all nodes together; and the same where supports hold, perhaps not from all
/// sides.
constexpr double ground = 0.1;
constexpr double ground_of_held = 1e-5;
/// Share of their range of softening that bonds may go at once.
constexpr double careful = 0.5;

/// Collects the lower half of a symmetric matrix of blocks of two by two, supports applied.
class Blocks {
public:
  explicit Blocks(const JoinedNodes& nodes) : nodes_(&nodes) {}

  void add(Index row, Index column, const Matrix2d& stiffness) {
    const Matrix2d block = nodes_->free[at(row)] * stiffness * nodes_->free[at(column)];
    for (Index r = 0; r < 2; ++r) {
      for (Index c = 0; c < 2; ++c) {
        if (2 * row + r >= 2 * column + c) {
          entries_.emplace_back(2 * row + r, 2 * column + c, block(r, c));
        }
      }
    }
  }
  /// Gives directions that supports hold a stiffness (N/m per metre) and all a ground to stand on.
  Matrix matrix(double modulus) {
    for (Index node = 0; node < nodes_->count; ++node) {
      const double soft = nodes_->loose_part[at(node)] != mesh::none ? ground : ground_of_held;
      const Matrix2d held = Matrix2d::Identity() - nodes_->free[at(node)] +
                            soft / nodes_->count * Matrix2d::Identity();
      for (Index r = 0; r < 2; ++r) {
        for (Index c = 0; c <= r; ++c) {
          entries_.emplace_back(2 * node + r, 2 * node + c, modulus * held(r, c));
        }
      }
    }
    Matrix result(2 * nodes_->count, 2 * nodes_->count);
    result.setFromTriplets(entries_.begin(), entries_.end());
    return result;
  }

private:
  const JoinedNodes* nodes_;
  std::vector<Eigen::Triplet<double, Index>> entries_;
};

/// Strain-displacement matrices of the corners, 1/m.
std::array<StrainMatrix, 3> strain_matrices(const TriangleShape<double>& shape) {
  const double s = shape.inverse_double_area;
  const Point one = s * Point{shape.b.y, -shape.b.x};
  const Point two = s * Point{-shape.a.y, shape.a.x};
  const std::array<Point, 3> gradient{Point{-(one.x + two.x), -(one.y + two.y)}, one, two};
  std::array<StrainMatrix, 3> matrices;
  for (std::size_t k = 0; k < 3; ++k) {
    matrices[k] << gradient[k].x, 0.0, 0.0, gradient[k].y, gradient[k].y, gradient[k].x;
  }
  return matrices;
}

/// Returns the modulus across, for comparison, Pa.
double add_triangle(const Model& model, Index t, const JoinedNodes& nodes, Blocks& blocks) {
  const Triangles& all = model.triangles;
  const TriangleShape<double> shape =
      triangle_shape(Point{all.ax[at(t)], all.ay[at(t)]}, Point{all.bx[at(t)], all.by[at(t)]});
  const auto& d = model.material[at(all.material[at(t)])].stiffness;
  Eigen::Matrix3d law;
  law << d.xx_xx, d.xx_yy, d.xx_xy, d.xx_yy, d.yy_yy, d.yy_xy, d.xx_xy, d.yy_xy, d.xy_xy;
  const auto strain = strain_matrices(shape);
  const double area = 0.5 / shape.inverse_double_area;
  for (Index i = 0; i < 3; ++i) {
    for (Index k = 0; k < 3; ++k) {
      blocks.add(nodes.of_corner[at(mesh::corner_of(t, i))],
                 nodes.of_corner[at(mesh::corner_of(t, k))],
                 area * strain[at(i)].transpose() * law * strain[at(k)]);
    }
  }
  return std::max(d.xx_xx, d.yy_yy);
}

void add_soft_joint(const Model& model, const SoftJoint& joint, const JoinedNodes& nodes,
                    Blocks& blocks) {
  const auto& corner = model.mesh.joint[at(joint.joint)].corner;
  const double half = 0.5 * model.mesh.joint_length(joint.joint);
  const Eigen::Vector2d n(joint.across.x, joint.across.y);
  const Eigen::Vector2d s(joint.along.x, joint.along.y);
  for (std::size_t g = 0; g < 2; ++g) {
    const Matrix2d k =
        half * (joint.normal[g] * n * n.transpose() + joint.shear[g] * s * s.transpose());
    const auto weight = [g](std::size_t i) { return gauss_weight(i % 2 == 0 ? g : 1 - g); };
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t m = 0; m < 4; ++m) {
        const double sign = i / 2 == m / 2 ? 1.0 : -1.0;
        blocks.add(nodes.of_corner[at(corner[i / 2][i % 2])],
                   nodes.of_corner[at(corner[m / 2][m % 2])], sign * weight(i) * weight(m) * k);
      }
    }
  }
}

Matrix stiffness_of(const Model& model, const std::vector<SoftJoint>& soft,
                    const JoinedNodes& nodes) {
  Blocks blocks(nodes);
  double modulus = 0.0;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    if (model.triangles.inverse_mass[at(t)] > 0.0) {
      modulus = std::max(modulus, add_triangle(model, t, nodes, blocks));
    }
  }
  for (const SoftJoint& joint : soft) {
    add_soft_joint(model, joint, nodes, blocks);
  }
  return blocks.matrix(modulus);
}

void project(const JoinedNodes& nodes, Eigen::VectorXd& vector) {
  for (Index n = 0; n < nodes.count; ++n) {
    vector.segment<2>(2 * n) = (nodes.free[at(n)] * vector.segment<2>(2 * n)).eval();
  }
}

}  // namespace

struct JoinedRock::Factor {
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower> of;
  bool is_usable = false;
};

JoinedRock::JoinedRock(const Model& model)
    : table_(joint_table(model)), factor_(std::make_unique<Factor>()) {}
JoinedRock::~JoinedRock() = default;

void JoinedRock::refresh(const Model& model) {
  std::vector<SoftJoint> soft = soft_joints(model, table_);
  if (is_known_ && about_the_same(soft, soft_)) {
    return;
  }
  is_known_ = true;
  soft_ = std::move(soft);
  nodes_ = joined_nodes(model, soft_);
  factor_->of.compute(stiffness_of(model, soft_, nodes_));
  factor_->is_usable =
      factor_->of.info() == Eigen::Success && (factor_->of.vectorD().array() > 0.0).all();
}

void JoinedRock::find_way(const Model& model, std::span<const double> pull,
                          std::span<double> way) const {
  std::fill(way.begin(), way.end(), 0.0);
  if (!factor_->is_usable) {
    return;
  }
  const auto each_corner = [&](const auto& visit) {
    for (std::size_t c = 0; c < nodes_.of_corner.size(); ++c) {
      if (nodes_.of_corner[c] != mesh::none) {
        visit(2 * c, 2 * nodes_.of_corner[c]);
      }
    }
  };
  Eigen::VectorXd load = Eigen::VectorXd::Zero(2 * nodes_.count);
  each_corner([&](std::size_t i, Index unknown) {
    load[unknown] += pull[i];
    load[unknown + 1] += pull[i + 1];
  });
  project(nodes_, load);
  Eigen::VectorXd of_nodes = factor_->of.solve(load);
  project(nodes_, of_nodes);
  each_corner([&](std::size_t i, Index unknown) {
    way[i] = of_nodes[unknown];
    way[i + 1] = of_nodes[unknown + 1];
  });
  if (nodes_.loose_parts > 0) {
    keep_loose_parts(model, nodes_, way);
  }
}

double JoinedRock::careful_share(const Model& model, std::span<const double> way) const {
  double fastest = 0.0;  // over what is allowed
  for (const SoftJoint& joint : soft_) {
    if (model.joints.state[at(joint.joint)] != JointState::bonded) {
      continue;
    }
    const auto& corner = model.mesh.joint[at(joint.joint)].corner;
    const auto& law = table_[at(model.joints.strength[at(joint.joint)])];
    for (std::size_t end = 0; end < 2; ++end) {
      const std::size_t a = 2 * at(corner[0][end]);
      const std::size_t b = 2 * at(corner[1][end]);
      const Point apart{way[b] - way[a], way[b + 1] - way[a + 1]};
      fastest = std::max({fastest, std::abs(dot(apart, joint.across)) * law.opening_range,
                          std::abs(dot(apart, joint.along)) * law.slip_range});
    }
  }
  return fastest > careful ? careful / fastest : 1.0;
}

double JoinedRock::share_to_meeting(const Model& model, std::span<const double> way,
                                    double unbalanced) const {
  const double force = unbalanced / std::max<double>(1.0, static_cast<double>(soft_.size()));
  double share = 1.0;
  for (const SoftJoint& soft : soft_) {
    const Index j = soft.joint;
    if (model.joints.state[at(j)] != JointState::broken) {
      continue;
    }
    const JointPoints now = joint_openings(model, j);
    const double give = force / (model.joints.full_stiffness[at(j)] * model.joints.length[at(j)]);
    const auto& corner = model.mesh.joint[at(j)].corner;
    for (std::size_t end = 0; end < 2; ++end) {
      const std::size_t a = 2 * at(corner[0][end]);
      const std::size_t b = 2 * at(corner[1][end]);
      const double parting = dot(Point{way[b] - way[a], way[b + 1] - way[a + 1]}, now.place.across);
      // Contact knows where faces are, not with what opening joints began.
      const double open = dot(now.place.apart[end], now.place.across);
      if (open > 0.0 && parting < -(open + give)) {
        share = std::min(share, -(open + give) / parting);
      }
    }
  }
  return share;
}

}  // namespace percolith::mechanics
