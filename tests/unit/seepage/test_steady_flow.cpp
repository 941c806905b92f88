// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/seepage/steady_flow.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "unit/support/flow_model.hpp"

namespace percolith::seepage {
namespace {

using test::at;

const test::Grid wide_grid{.columns = 12, .rows = 10, .jitter = 0.3, .mixed_diagonals = true};

bool on_edge(const Point& p) {
  return p.x == 0.0 || p.x == 1.0 || p.y == 0.0 || p.y == 1.0;
}

/// Prescribes a field on the whole boundary of the unit square, solves, and returns the largest
/// error.
template <class Field>
double error_of(const test::Grid& grid, const test::FlowOptions& options, const Field& field,
                unsigned numbering = 0) {
  auto file = test::make_grid(grid);
  Model model = test::make_flow(numbering == 0 ? file : test::shuffled(file, numbering), options);
  test::prescribe_pores(model, "all", Schedule::constant(1.0), on_edge, field);
  Execution execution;
  (void)solve_steady(model, execution);
  double error = 0.0;
  for (const Index c : test::corners_of(model.mesh)) {
    error = std::max(error, std::abs(model.state.pressure[at(c)] - field(model.mesh.place_of(c))));
  }
  return error;
}

TEST(SteadyFlow, IsExactForLinearFieldsWithAFullTensor) {
  test::FlowOptions options;
  options.rock.permeability = {3e-13, 1e-13, -1.2e-13};
  const auto field = [](const Point& p) { return 1e6 + 3e5 * p.x - 7e5 * p.y; };
  for (const unsigned numbering : {0u, 1u, 2u}) {
    EXPECT_LT(error_of(wide_grid, options, field, numbering), 1e-12 * 1e6);
  }
}

TEST(SteadyFlow, ErrorOfASmoothFieldFallsWithTheSquareOfTheElementSize) {
  test::FlowOptions options;
  options.rock.permeability = {3e-13, 1e-13, -1.2e-13};
  // p = exp(a.x) sin(b.x) has div(k grad p) = 0 when a.k a = b.k b and a.k b = 0.
  Eigen::Matrix2d k;
  k << 3.0, -1.2, -1.2, 1.0;
  const Eigen::Matrix2d root =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(k).operatorInverseSqrt();
  const auto field = [&](const Point& p) {
    const Eigen::Vector2d turned = root * Eigen::Vector2d(p.x, p.y);
    return 1e6 * (10.0 + std::exp(turned[0]) * std::sin(turned[1]));
  };
  double coarse = 0.0;
  for (const int n : {8, 16, 32, 64}) {
    const double fine = error_of({.columns = n, .rows = n}, options, field);
    if (coarse > 0.0) {
      EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.25) << n;
    }
    coarse = fine;
  }
}

double flow_through_strip(PoreJoints joints, double factor, SteadyResult* result = nullptr) {
  test::FlowOptions options;
  options.joints = joints;
  options.joint_factor = factor;
  Model model = test::make_flow(test::make_grid(wide_grid), options);
  test::prescribe_pores(model, "left", 1e5, [](const Point& p) { return p.x == 0.0; });
  test::prescribe_pores(model, "right", 0.0, [](const Point& p) { return p.x == 1.0; });
  Execution execution;
  const SteadyResult solved = solve_steady(model, execution);
  EXPECT_NEAR(model.rate[0], -model.rate[1], 1e-10 * solved.throughput);
  EXPECT_NEAR(solved.throughput, model.rate[0], 1e-12 * solved.throughput);
  if (result != nullptr) {
    *result = solved;
  }
  return model.rate[0];
}

TEST(SteadyFlow, FiniteJointsApproachTheTiedLimitAsOneOverN) {
  const double tied = flow_through_strip(PoreJoints::tied, 1.0);
  EXPECT_NEAR(tied, 1e-13 * 1e5 / 1e-3, 1e-12 * tied);
  const double coarse = tied - flow_through_strip(PoreJoints::finite, 50.0);
  const double middle = tied - flow_through_strip(PoreJoints::finite, 100.0);
  const double fine = tied - flow_through_strip(PoreJoints::finite, 200.0);
  EXPECT_GT(fine, 0.0);
  EXPECT_NEAR(coarse / middle, 2.0, 0.05);
  EXPECT_NEAR(middle / fine, 2.0, 0.03);
  // About 0.76/n for triangles of even size; a few times that at most for these.
  EXPECT_LT(middle / tied, 3.0 / 100.0);
}

TEST(SteadyFlow, GravityIsBalancedByTheHydrostaticPressure) {
  test::FlowOptions options;
  options.gravity = 9.81;
  Model model = test::make_flow(test::make_grid(wide_grid), options);
  test::prescribe_pores(model, "top", 0.0, [](const Point& p) { return p.y == 1.0; });
  Execution execution;
  const auto result = solve_steady(model, execution);
  for (const Index c : test::corners_of(model.mesh)) {
    EXPECT_NEAR(model.state.pressure[at(c)], 9810.0 * (1.0 - model.mesh.place_of(c).y), 1e-8);
  }
  EXPECT_LT(result.throughput, 1e-12 * 1e-13 * 9810.0 / 1e-3);
}

TEST(SteadyFlow, AFractureAcrossTheFlowAddsTheResistanceOfItsTwoFaces) {
  const test::Grid grid{.columns = 8, .rows = 6};
  auto file = test::make_grid(grid);
  test::add_column_curve(grid, file, "wall", 4, 0, 6);
  for (const double exchange : {1e-12, 1e-10, test::infinity}) {
    test::FlowOptions options;
    options.fracture = {{.initial_aperture = 1e-5, .transmissivity = 1e-20, .exchange = exchange}};
    Model model = test::make_flow(file, options);
    test::break_curve(model, "wall");
    test::prescribe_pores(model, "left", 1e5, [](const Point& p) { return p.x == 0.0; });
    test::prescribe_pores(model, "right", 0.0, [](const Point& p) { return p.x == 1.0; });
    Execution execution;
    (void)solve_steady(model, execution);
    const double flux = 1e5 / (1e-3 / 1e-13 + 2.0 / exchange);
    EXPECT_NEAR(model.rate[0], flux, 1e-11 * flux);
    const auto corners = model.mesh.joint[at(model.mesh.curves.at("wall").joints[2])].corner;
    double left = model.state.pressure[at(corners[0][0])];
    double right = model.state.pressure[at(corners[1][0])];
    if (test::centroid(model.mesh, mesh::triangle_of(corners[0][0])).x > 0.5) {
      std::swap(left, right);
    }
    // Half the pressure is lost before the wall and half after it: the crack is in the middle.
    EXPECT_NEAR(test::crack_pressure(model, {0.5, 0.5}), 5e4, 1e-6);
    EXPECT_NEAR(left - right, 2.0 * flux / exchange, 1e-6);
  }
}

TEST(SteadyFlow, AFractureAlongTheFlowCarriesItsTransmissivity) {
  const test::Grid grid{.columns = 8, .rows = 6};
  auto file = test::make_grid(grid);
  test::add_row_curve(grid, file, "drain", 3, 0, 8);
  test::FlowOptions options;
  options.fracture = {{.initial_aperture = 1e-5, .transmissivity = 4e-13}};
  Model model = test::make_flow(file, options);
  test::break_curve(model, "drain");
  test::prescribe_pores(model, "left", 1e5, [](const Point& p) { return p.x == 0.0; });
  test::prescribe_pores(model, "right", 0.0, [](const Point& p) { return p.x == 1.0; });
  Execution execution;
  (void)solve_steady(model, execution);
  EXPECT_NEAR(model.rate[0], (1e-13 + 4e-13) * 1e5 / 1e-3, 1e-12 * model.rate[0]);
}

TEST(SteadyFlow, FiniteJointsAndInfiniteExchangeGoTogether) {
  // An unbroken joint may join two corners that a fracture already gives one pressure.
  const test::Grid grid{.columns = 8, .rows = 6, .jitter = 0.2, .mixed_diagonals = true};
  auto file = test::make_grid(grid);
  test::add_row_curve(grid, file, "drain", 3, 0, 8);
  test::add_column_curve(grid, file, "branch", 4, 1, 3);
  test::FlowOptions options;
  options.joints = PoreJoints::finite;
  options.fracture = {{.initial_aperture = 1e-5, .transmissivity = 4e-13}};
  Model model = test::make_flow(file, options);
  test::break_curve(model, "drain");
  test::break_curve(model, "branch");
  test::prescribe_pores(model, "left", 1e5, [](const Point& p) { return p.x == 0.0; });
  test::prescribe_pores(model, "right", 0.0, [](const Point& p) { return p.x == 1.0; });
  Execution execution;
  const auto result = solve_steady(model, execution);
  EXPECT_NEAR(model.rate[0], -model.rate[1], 1e-10 * result.throughput);
  EXPECT_NEAR(model.rate[0], 5e-13 * 1e5 / 1e-3, 0.05 * model.rate[0]);
  const FlowGraph graph = make_flow_graph(model);
  for (Index e = 0; e < graph.edges(); ++e) {
    EXPECT_NE(graph.from[at(e)], graph.to[at(e)]);
  }
}

TEST(SteadyFlow, SourcesAreBalancedByTheBoundary) {
  Model model = test::make_flow(test::make_grid(wide_grid), {});
  test::prescribe_pores(model, "edge", 1e5, on_edge);
  test::inject_pores(model, "well", Schedule::constant(3e-9), {0.5, 0.5});
  Execution execution;
  const auto result = solve_steady(model, execution);
  EXPECT_EQ(model.rate[1], 3e-9);
  EXPECT_NEAR(model.rate[0], -3e-9, 1e-12 * 3e-9);
  EXPECT_NEAR(result.throughput, 3e-9, 1e-20);
  EXPECT_GT(test::pore_pressure(model, {0.5, 0.5}), 1e5);
}

TEST(SteadyFlow, ASeepageFaceLetsFluidOutButNotIn) {
  for (const bool out : {true, false}) {
    Model model = test::make_flow(test::make_grid(wide_grid), {});
    test::prescribe_pores(model, "left", out ? 1e5 : 1e4,
                          [](const Point& p) { return p.x == 0.0; });
    test::face_pores(model, "right", out ? 1e4 : 1e5, [](const Point& p) { return p.x == 1.0; });
    Execution execution;
    (void)solve_steady(model, execution);
    const double expected = out ? 9e4 * 1e-13 / 1e-3 : 0.0;
    EXPECT_NEAR(model.rate[0], expected, 1e-11 * 9e-6);
    EXPECT_NEAR(model.rate[1], -expected, 1e-11 * 9e-6);
    EXPECT_NEAR(test::pore_pressure(model, {1.0, 0.5}), 1e4, 1e-6);
  }
}

TEST(SteadyFlow, SuctionIsRefusedWithItsPlace) {
  const auto solve = [](double cavitation) {
    test::FlowOptions options;
    options.fluid.cavitation_pressure = cavitation;
    Model model = test::make_flow(test::make_grid(wide_grid), options);
    test::prescribe_pores(model, "left", 1e4, [](const Point& p) { return p.x == 0.0; });
    test::inject_pores(model, "pump", Schedule::constant(-1e-5), {1.0, 0.0});
    Execution execution;
    (void)solve_steady(model, execution);
    return test::pore_pressure(model, {1.0, 0.0});
  };
  EXPECT_LT(solve(-test::infinity), -1e4);
  try {
    (void)solve(0.0);
    FAIL() << "no error";
  } catch (const SolverError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("steady flow needs a pressure of -"), std::string::npos) << text;
    EXPECT_NE(text.find("Pa at the pore node at (1, 0), below the cavitation pressure of 0 Pa: "
                        "the rock would drain there. Use time.scheme = \"implicit\""),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("fluid.cavitation_pressure = \"-inf\""), std::string::npos);
  }
}

TEST(SteadyFlow, EveryPartNeedsAGivenPressure) {
  const test::Grid grid{.columns = 8, .rows = 6};
  auto file = test::make_grid(grid);
  test::add_column_curve(grid, file, "wall", 4, 0, 6);
  test::FlowOptions options;
  options.fracture = {{.initial_aperture = 1e-5, .transmissivity = {}, .exchange = 0.0}};
  Model model = test::make_flow(file, options);
  test::break_curve(model, "wall");
  const auto missing = [&] {
    const FlowGraph graph = make_flow_graph(model);
    const auto node = node_without_datum(graph, make_graph_conditions(model, graph));
    return node ? std::string(graph.kind(*node)) + (graph.place(model, *node).x < 0.5   ? " left"
                                                    : graph.place(model, *node).x > 0.5 ? " right"
                                                                                        : " wall")
                : std::string();
  };
  EXPECT_NE(missing(), "");
  test::prescribe_pores(model, "left", 1e4, [](const Point& p) { return p.x == 0.0; });
  EXPECT_NE(missing(), "");
  test::face_pores(model, "right", 0.0, [](const Point& p) { return p.x == 1.0; });
  EXPECT_EQ(missing(), "crack node wall");
  test::prescribe_crack(model, "well", Schedule::constant(1e4), {0.5, 0.5});
  EXPECT_EQ(missing(), "");
}

}  // namespace
}  // namespace percolith::seepage
