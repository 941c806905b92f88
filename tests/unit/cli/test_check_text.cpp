// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/check_text.hpp"

#include <gtest/gtest.h>

namespace percolith::cli {
namespace {

simulation::CheckReport report() {
  simulation::CheckReport report;
  report.triangles = 200;
  report.vertices = 121;
  report.joints = 280;
  report.broken_joints = 10;
  report.boundary_edges = 40;
  report.pore_nodes = 131;
  report.crack_nodes = 11;
  report.unknowns = 142;
  report.area = 1.5;
  report.smallest_edge = 0.05;
  report.largest_edge = 0.1;
  report.smallest_angle = 30.04;
  report.largest_angle = 90;
  report.smallest_angle_place = {0.25, 0.5};
  report.region_area = {{"rock", 1.5}};
  report.fracture_length_by_group = {{"fault", 1.0}};
  report.limits = {{"crack flow", 1e-6, {0.5, 0.5}},
                   {"pore flow", 2e-3, {0.1, 0.2}},
                   {"all together", 0.8e-6, {0.5, 0.5}}};
  return report;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CheckText, ShowsCountsAndMeshQuality) {
  const std::string text = check_text(report(), {});
  EXPECT_TRUE(has(text, "triangles              200    vertices               121")) << text;
  EXPECT_TRUE(has(text, "joints                 280    broken joints           10")) << text;
  EXPECT_TRUE(has(text, "edges           0.05 to 0.1 m")) << text;
  EXPECT_TRUE(has(text, "angles          30.0 to 90.0 degree, smallest at (0.25, 0.5) m")) << text;
  EXPECT_TRUE(has(text, "region rock: 1.5 m2")) << text;
  EXPECT_TRUE(has(text, "fracture fault: 1 m")) << text;
  EXPECT_TRUE(has(text, "unknowns               142")) << text;
}

TEST(CheckText, MarksTheLimitThatRules) {
  const std::string text = check_text(report(), {});
  EXPECT_TRUE(has(text, "crack flow           1e-06 s at (0.5, 0.5) m  <- rules\n")) << text;
  EXPECT_TRUE(has(text, "pore flow            0.002 s at (0.1, 0.2) m\n")) << text;
}

TEST(CheckText, TellsWhatTheSchemeMakesOfTheLimits) {
  simulation::Stepping stepping;
  stepping.end = 1;
  stepping.safety = 0.5;
  stepping.scheme = simulation::Scheme::explicit_;
  EXPECT_TRUE(has(check_text(report(), stepping),
                  "scheme explicit: step 4e-07 s, about 2.5e+06 steps to the end"));
  stepping.step = 1e-7;
  EXPECT_TRUE(has(check_text(report(), stepping),
                  "scheme explicit: step 1e-07 s, about 1e+07 steps to the end"));
  stepping.scheme = simulation::Scheme::implicit;
  EXPECT_TRUE(has(check_text(report(), stepping), "the step is ruled by time.tolerance"));
  stepping.scheme = simulation::Scheme::steady;
  const std::string steady = check_text(report(), stepping);
  EXPECT_TRUE(has(steady, "unknowns               142\n  scheme steady: takes no time step\n"))
      << steady;
  EXPECT_FALSE(has(steady, "Limits"));
}

simulation::CheckReport mechanics_report() {
  simulation::CheckReport mechanics = report();
  mechanics.pore_nodes = 0;
  mechanics.mechanics = {{"cohesive_length_over_element_size", 4.5},
                         {"tied joints", 1234567},
                         {"apparent_modulus_Pa", 29.123456e9}};
  mechanics.limits = {{"joints", 2e-8, {0.5, 0.5}},
                      {"triangles", 3e-8, {0.1, 0.2}},
                      {"all together", 1e-8, {0.5, 0.5}}};
  return mechanics;
}

TEST(CheckText, ShowsTheNumbersOfMechanicsInPlaceOfTheNodesOfFlow) {
  const std::string text = check_text(mechanics_report(), {});
  EXPECT_TRUE(has(text, "Mechanics\n"
                        "  cohesive_length_over_element_size         4.5\n"
                        "  tied joints                           1234567\n"
                        "  apparent_modulus_Pa                2.9123e+10\n"
                        "Limits of the explicit time step\n"))
      << text;
  EXPECT_FALSE(has(text, "Flow")) << text;
  EXPECT_FALSE(has(text, "pore nodes")) << text;
  EXPECT_FALSE(has(check_text(report(), {}), "Mechanics"));
}

TEST(CheckText, TakesMechanicsAsExplicitWhateverTheScheme) {
  simulation::Stepping stepping;
  stepping.end = 1;
  stepping.safety = 0.5;
  const std::string text = check_text(mechanics_report(), stepping);
  EXPECT_TRUE(has(text, "joints               2e-08 s at (0.5, 0.5) m  <- rules\n")) << text;
  EXPECT_TRUE(has(text, "scheme explicit, safety 0.5: step 5e-09 s, about 2e+08 steps to the end"))
      << text;
  EXPECT_FALSE(has(text, "implicit")) << text;
  stepping.step = 1e-9;
  EXPECT_TRUE(has(check_text(mechanics_report(), stepping),
                  "scheme explicit, safety 0.5: step 1e-09 s, about 1e+09 steps to the end"));
}

TEST(CheckText, ToleratesAModelWithoutLimits) {
  simulation::CheckReport bare = report();
  bare.limits.clear();
  EXPECT_TRUE(has(check_text(bare, {}), "none: nothing flows"));
  bare.mechanics = {{"bodies", 1}};
  EXPECT_TRUE(has(check_text(bare, {}), "none: nothing moves"));
}

}  // namespace
}  // namespace percolith::cli
