// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/derived_values.hpp"
#include "percolith/runner/finish_text.hpp"

#include <gmock/gmock.h>

namespace percolith::runner {
namespace {

simulation::Summary summary() {
  simulation::Summary summary;
  summary.end_time = 0.25;
  summary.steps = 1200;
  summary.last.balance.relative_error = 3e-15;
  return summary;
}

TEST(FinishText, TellsTheErrorOfTheMassBalance) {
  EXPECT_EQ(finish_text(summary(), false, "a.results"),
            "finished at time 0.25 s after 1200 steps, mass balance error 3.0e-15; results in "
            "a.results");
  EXPECT_EQ(finish_text(summary(), true, "a.results"),
            "finished the steady state, mass balance error 3.0e-15; results in a.results");
}

TEST(FinishText, TellsWhetherAFlowHasSettled) {
  simulation::Summary flow = summary();
  flow.reached_rest = true;
  flow.settlement = simulation::Settlement{8.3e-4, false};
  EXPECT_EQ(finish_text(flow, false, "a.results"),
            "finished at time 0.25 s after 1200 steps, settled: what is stored and given up is "
            "0.00083 of what flows through, mass balance error 3.0e-15; results in a.results");
  flow.reached_rest = false;
  EXPECT_THAT(finish_text(flow, false, "a.results"),
              testing::HasSubstr("steps, not settled: what is stored and given up is 0.00083 of "));
  flow.reached_rest = true;
  flow.settlement->is_rest = true;
  EXPECT_THAT(finish_text(flow, false, "a.results"),
              testing::HasSubstr("after 1200 steps, settled: the fluid is at rest, mass"));
}

TEST(FinishText, TellsTheErrorOfTheEnergyBalanceInMechanics) {
  simulation::Summary mechanics = summary();
  mechanics.mechanics = {{"fragments", 3}, {"energy_error", 2e-5}};
  EXPECT_EQ(finish_text(mechanics, false, "a.results"),
            "finished at time 0.25 s after 1200 steps, mass balance error 3.0e-15, energy balance "
            "error 2.0e-05; results in a.results");
  mechanics.last.has_flow = false;
  EXPECT_EQ(finish_text(mechanics, false, "a.results"),
            "finished at time 0.25 s after 1200 steps, energy balance error 2.0e-05; results in "
            "a.results");
  mechanics.reached_rest = true;
  mechanics.mechanics.pop_back();
  EXPECT_EQ(finish_text(mechanics, false, "a.results"),
            "finished at time 0.25 s after 1200 steps, at rest; results in a.results");
}

TEST(ResultLines, TellBrokenJointsAndTheReactionsThereWere) {
  simulation::Summary mechanics = summary();
  EXPECT_TRUE(result_lines(mechanics).empty());
  mechanics.mechanics = {{"broken_joints", 12},
                         {"broken_joints_tensile", 9},
                         {"broken_joints_shear", 1},
                         {"broken_joints_mixed", 2}};
  mechanics.peak_reactions = {{"boundary.top", 0.0, -785400.25, 0.0, 3.25e-3},
                              {"boundary.side", 0.0, 0.0, 0.0, 0.0}};
  EXPECT_EQ(
      result_lines(mechanics),
      (std::vector<std::string>{
          "joints that broke: 12 (9 in tension, 1 in shear, 2 mixed)",
          "largest reaction of boundary.top: x 0 N/m at 0 s, y -7.854e+05 N/m at 0.00325 s"}));
}

TEST(ResultLines, TellTheRateOfEachConditionOfAFlow) {
  simulation::Summary flow = summary();
  flow.last.rate = {{"boundary.in", 1.25e-6}, {"boundary.out", -1.5e-6}, {"source.dry", 0.0}};
  EXPECT_EQ(result_lines(flow),
            (std::vector<std::string>{"boundary.in: 1.25e-06 m2/s into the rock",
                                      "boundary.out: 1.5e-06 m2/s out of the rock",
                                      "source.dry: no flow"}));
  flow.mechanics = {{"broken_joints", 0}};
  EXPECT_EQ(result_lines(flow).size(), 1u);
}

TEST(ResultLines, TellWhatFluidDidInACoupledRun) {
  simulation::Summary coupled = summary();
  coupled.mechanics = {{"broken_joints", 8},       {"broken_joints_tensile", 7},
                       {"broken_joints_shear", 0}, {"broken_joints_mixed", 1},
                       {"crack_length_m", 0.68},   {"filled_crack_length_m", 0.62},
                       {"leaked_m2", 1.52e-6}};
  coupled.last.balance.by_condition = {
      {"boundary.rim", 1.0}, {"source.pump", 1e-4}, {"source.well", 2e-3}};
  coupled.peak_pressures = {{"source.pump", 3.184e6, 4.1e-3}};
  EXPECT_EQ(
      result_lines(coupled),
      (std::vector<std::string>{
          "joints that broke: 8 (7 in tension, 0 in shear, 1 mixed)",
          "source.pump: 0.0001 m2 (m3 per metre of thickness) injected, highest pressure 3.18 MPa "
          "at "
          "0.0041 s",
          "source.well: 0.002 m2 (m3 per metre of thickness) injected",
          "cracks: 0.68 m open to fluid, 0.62 m of it full; 1.52e-06 m2 leaked into the "
          "rock"}));
  coupled.mechanics.back().second = -2e-6;
  EXPECT_EQ(result_lines(coupled).back(), "cracks: 0.68 m open to fluid, 0.62 m of it full; "
                                          "2e-06 m2 came in from the rock");
  coupled.last.has_flow = false;
  EXPECT_EQ(result_lines(coupled).size(), 1u);
}

std::vector<std::string> names(const std::vector<case_file::DerivedValue>& values) {
  std::vector<std::string> result;
  for (const case_file::DerivedValue& value : values) {
    result.push_back(value.name + " = " + value.value + " " + value.unit);
  }
  return result;
}

TEST(DerivedValues, AreThoseOfThePhysics) {
  simulation::CheckReport report;
  report.triangles = 8;
  report.pore_nodes = 9;
  report.crack_nodes = 2;
  report.smallest_edge = 0.5;
  report.limits = {{"all together", 1e-3, {}}};
  EXPECT_EQ(
      names(derived_values(report, "1.2")),
      (std::vector<std::string>{"version of percolith = 1.2 ", "triangles = 8 ", "pore nodes = 9 ",
                                "crack nodes = 2 ", "smallest edge = 0.5 m",
                                "limit of the explicit step by all together = 0.001 s"}));
  report.mechanics = {{"apparent_modulus_Pa", 2e9}, {"tied joints", 1234567}};
  report.pore_nodes = 0;
  EXPECT_EQ(names(derived_values(report, "1.2")),
            (std::vector<std::string>{"version of percolith = 1.2 ", "triangles = 8 ",
                                      "smallest edge = 0.5 m", "apparent_modulus_Pa = 2000000000 ",
                                      "tied joints = 1234567 ",
                                      "limit of the explicit step by all together = 0.001 s"}));
}

}  // namespace
}  // namespace percolith::runner
