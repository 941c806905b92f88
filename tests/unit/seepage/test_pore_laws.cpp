// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/execution.hpp"
#include "percolith/seepage/pore.hpp"
#include "percolith/seepage/pore_flow.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>

#include "unit/support/flow_model.hpp"

namespace percolith::seepage {
namespace {

using test::at;
using Triangle = std::array<Point, 3>;

/// Stiffness A/mu grad N_i . k grad N_j of the linear triangle; the gradients are the columns of
/// the inverse of the matrix of the points in homogeneous coordinates.
Eigen::Matrix3d stiffness(const Triangle& p, const Tensor& k, double mu) {
  Eigen::Matrix3d points;
  for (int i = 0; i < 3; ++i) {
    points.row(i) << 1.0, p[static_cast<std::size_t>(i)].x, p[static_cast<std::size_t>(i)].y;
  }
  const Eigen::Matrix<double, 2, 3> gradients = points.inverse().bottomRows<2>();
  Eigen::Matrix2d tensor;
  tensor << k.xx, k.xy, k.xy, k.yy;
  return 0.5 * points.determinant() / mu * gradients.transpose() * tensor * gradients;
}

TEST(PairConductances, AreTheStiffnessOfTheLinearTriangle) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-2.0, 2.0);
  const Tensor k{3e-13, 1e-13, -1.2e-13};
  for (int i = 0; i < 200; ++i) {
    Triangle p{Point{coordinate(random), coordinate(random)},
               Point{coordinate(random), coordinate(random)},
               Point{coordinate(random), coordinate(random)}};
    const double area = 0.5 * cross(p[1] - p[0], p[2] - p[0]);
    if (std::abs(area) < 0.05) {
      continue;
    }
    if (area < 0.0) {
      std::swap(p[1], p[2]);
    }
    const auto c = pair_conductances(p, k, 2e-3);
    const Eigen::Matrix3d expected = stiffness(p, k, 2e-3);
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(c[static_cast<std::size_t>(j)], -expected(j, (j + 1) % 3),
                  1e-12 * expected.norm());
    }
  }
}

TEST(PairConductances, AreNegativeOnlyOppositeAnObtuseAngle) {
  const Tensor k{1e-12, 1e-12, 0.0};
  const auto right = pair_conductances({Point{0, 0}, Point{1, 0}, Point{0, 1}}, k, 1e-3);
  EXPECT_NEAR(right[0], 0.5e-9, 1e-22);
  EXPECT_NEAR(right[1], 0.0, 1e-22);
  EXPECT_NEAR(right[2], 0.5e-9, 1e-22);
  const auto obtuse = pair_conductances({Point{0, 0}, Point{1, 0}, Point{0.5, 0.1}}, k, 1e-3);
  EXPECT_LT(obtuse[0], 0.0);
  EXPECT_GT(obtuse[1], 0.0);
  EXPECT_GT(obtuse[2], 0.0);
}

TEST(DarcyFlux, OfALinearPotentialIsMinusKGradientOverViscosity) {
  const Tensor k{3e-13, 1e-13, -1.2e-13};
  const Point gradient{2e4, -5e3};
  const Triangle p{Point{0.1, 0.2}, Point{1.3, -0.1}, Point{0.7, 0.9}};
  const auto c = pair_conductances(p, k, 1e-3);
  std::array<double, 3> flow{};
  for (std::size_t i = 0; i < 3; ++i) {
    flow[i] = c[i] * (dot(gradient, p[i]) - dot(gradient, p[(i + 1) % 3]));
  }
  const Point q = darcy_flux(p, flow);
  const Point expected = -1.0 / 1e-3 * (k * gradient);
  EXPECT_NEAR(q.x, expected.x, 1e-12 * std::abs(expected.x));
  EXPECT_NEAR(q.y, expected.y, 1e-12 * std::abs(expected.x));
  // The inflow of a corner is -1/2 q.n L with the edge opposite it.
  for (std::size_t i = 0; i < 3; ++i) {
    const Point normal = clockwise(p[(i + 2) % 3] - p[(i + 1) % 3]);
    EXPECT_NEAR(flow[(i + 2) % 3] - flow[i], -0.5 * dot(expected, normal), 1e-20);
  }
}

TEST(PoreFlow, LinearPressureLeavesNothingAtInnerNodes) {
  test::FlowOptions options;
  options.rock.permeability = {3e-13, 1e-13, -1.2e-13};
  Model model = test::make_flow(
      test::make_grid({.columns = 9, .rows = 7, .jitter = 0.3, .mixed_diagonals = true}), options);
  set_pores(model, [](const Point& p) {
    return FluidState<double>{1e6 + 3e5 * p.x - 2e5 * p.y, 1.0};
  });
  std::vector<double> inflow(at(model.mesh.corners()));
  Execution().for_each("flow", model.mesh.triangles(),
                       PoreFlow{model.state.pressure.data(), model.state.saturation.data(),
                                model.pore.conductance.data(), model.pore.lift.data(),
                                inflow.data(), SaturationWeight::upstream, true});
  double scale = 0.0;
  std::vector<double> net(model.mesh.vertex.size(), 0.0);
  std::vector<bool> inner(net.size(), true);
  for (const Index c : test::corners_of(model.mesh)) {
    net[at(model.mesh.vertex_of(c))] += inflow[at(c)];
    scale = std::max(scale, std::abs(inflow[at(c)]));
  }
  for (const auto& edge : model.mesh.boundary) {
    inner[at(edge.vertex[0])] = false;
  }
  for (std::size_t v = 0; v < net.size(); ++v) {
    if (inner[v]) {
      EXPECT_NEAR(net[v], 0.0, 1e-13 * scale);
    }
  }
}

TEST(PairFlow, IsWeightedByTheSaturationOfTheDonor) {
  EXPECT_EQ(pair_flow(2.0, 3.0, 0.25, 0.5), 3.0);    // into the first: the second gives
  EXPECT_EQ(pair_flow(2.0, -3.0, 0.25, 0.5), -1.5);  // out of the first
  // With a negative conductance the fluid runs up the potential, and its donor is the other one.
  EXPECT_EQ(pair_flow(-2.0, 3.0, 0.25, 0.5), -1.5);
  EXPECT_EQ(pair_flow(-2.0, -3.0, 0.25, 0.5), 3.0);
}

TEST(JointExchange, ActsInSeries) {
  // Equal sides: n k/(mu L).
  EXPECT_NEAR(joint_exchange(100.0, 2e-13, 0.05, 2e-13, 0.05, 1e-3), 100.0 * 2e-13 / (1e-3 * 0.05),
              1e-22);
  // Two halves of different conductance: resistances add.
  const double first = 100.0 * 2e-13 / (1e-3 * 0.05);
  const double second = 100.0 * 7e-15 / (1e-3 * 0.02);
  const double h = joint_exchange(100.0, 2e-13, 0.05, 7e-15, 0.02, 1e-3);
  EXPECT_NEAR(1.0 / h, 0.5 / first + 0.5 / second, 1e-12 / h);
  EXPECT_EQ(h, joint_exchange(100.0, 7e-15, 0.02, 2e-13, 0.05, 1e-3));
}

}  // namespace
}  // namespace percolith::seepage
