// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/summary.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace percolith::io {
namespace {

RunRecord record() {
  return {.version = "1.2.3",
          .case_file = "a/case.toml",
          .title = "A \"case\"",
          .outcome = Outcome::finished,
          .reason = "",
          .threads = 2,
          .processor = "P",
          .regions = {"rock"},
          .fractures = {"fault"},
          .warnings = {"a/case.toml:3:1: warning: odd"}};
}

simulation::Summary summary() {
  simulation::Summary summary;
  summary.end_time = 10.5;
  summary.steps = 63;
  summary.rejected_steps = 2;
  summary.iterations = 99;
  summary.wall_time = {{"solve", 1.5}, {"output", 0.25}};
  summary.last.minimum_pressure = -1;
  summary.last.maximum_pressure = 0.1;
  summary.last.minimum_crack_pressure = 2;
  summary.last.maximum_crack_pressure = 3;
  summary.last.balance = {3, 1, 1.5, 9, 0.5, 0.125, {{"boundary.left", 2}}};
  summary.last.rate = {{"boundary.left", 0.75}};
  summary.throughput = 0.5;
  summary.state_hash = "abc";
  summary.warnings = {"coarse"};
  return summary;
}

TEST(Summary, TellsHowTheRunWent) {
  const auto json =
      nlohmann::json::parse(summary_json(record(), summary(), {{"output", 0.5}, {"model", 2}}));
  EXPECT_EQ(json["version"], "1.2.3");
  EXPECT_EQ(json["case_file"], "a/case.toml");
  EXPECT_EQ(json["title"], "A \"case\"");
  EXPECT_EQ(json["outcome"], "finished");
  EXPECT_EQ(json["reason"], "");
  EXPECT_EQ(json["end_time_s"], 10.5);
  EXPECT_EQ(json["steps"], 63);
  EXPECT_EQ(json["rejected_steps"], 2);
  EXPECT_EQ(json["iterations"], 99);
  EXPECT_EQ(json["wall_time_s"],
            (nlohmann::json{{"model", 2.0}, {"output", 0.75}, {"solve", 1.5}}));
  EXPECT_EQ(json["mass_balance"]["in_m2"], 3.0);
  EXPECT_EQ(json["mass_balance"]["out_m2"], 1.0);
  EXPECT_EQ(json["mass_balance"]["stored_m2"], 1.5);
  EXPECT_EQ(json["mass_balance"]["in_place_m2"], 9.0);
  EXPECT_EQ(json["mass_balance"]["error_m2"], 0.5);
  EXPECT_EQ(json["mass_balance"]["relative_error"], 0.125);
  EXPECT_EQ(json["mass_balance"]["by_condition_m2"]["boundary.left"], 2.0);
  EXPECT_EQ(json["throughput_m2_per_s"], 0.5);
  EXPECT_EQ(json["rate_m2_per_s"]["boundary.left"], 0.75);
  EXPECT_EQ(json["extremes"]["minimum_pressure_Pa"], -1.0);
  EXPECT_EQ(json["extremes"]["maximum_pressure_Pa"], 0.1);
  EXPECT_EQ(json["extremes"]["maximum_crack_pressure_Pa"], 3.0);
  EXPECT_EQ(json["state_hash"], "abc");
  EXPECT_EQ(json["warnings"], (nlohmann::json{"a/case.toml:3:1: warning: odd", "coarse"}));
  EXPECT_EQ(json["regions"], nlohmann::json{"rock"});
  EXPECT_EQ(json["fractures"], nlohmann::json{"fault"});
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["processor"], "P");
}

TEST(Summary, TellsWhyARunEndedEarly) {
  RunRecord failed = record();
  failed.outcome = Outcome::failed;
  failed.reason = "pressure is not a number";
  failed.title = "caf\xe9";  // not UTF-8
  simulation::Summary broken = summary();
  broken.last.maximum_pressure = std::numeric_limits<double>::quiet_NaN();
  const auto json = nlohmann::json::parse(summary_json(failed, broken, {}));
  EXPECT_EQ(json["outcome"], "failed");
  EXPECT_EQ(json["reason"], "pressure is not a number");
  EXPECT_TRUE(json["extremes"]["maximum_pressure_Pa"].is_null());
  EXPECT_EQ(json["extremes"]["maximum_crack_pressure_Pa"], 3.0);
  broken.last.maximum_crack_pressure.reset();
  EXPECT_FALSE(nlohmann::json::parse(summary_json(failed, broken, {}))["extremes"].contains(
      "maximum_crack_pressure_Pa"));
  failed.outcome = Outcome::interrupted;
  EXPECT_EQ(nlohmann::json::parse(summary_json(failed, broken, {}))["outcome"], "interrupted");
}

TEST(Summary, OfMechanicsHasItsNamedResultsAndNoneOfFlow) {
  simulation::Summary mechanics = summary();
  mechanics.reached_rest = true;
  mechanics.last.has_flow = false;
  mechanics.mechanics = {{"energy_error", 1e-4},
                         {"broken_joints", 3},
                         {"b_value", std::numeric_limits<double>::quiet_NaN()}};
  mechanics.peak_reactions = {{"boundary.top", 1.5, -4e5, 0.25, 0.5}};
  const auto json = nlohmann::json::parse(summary_json(record(), mechanics, {}));
  EXPECT_EQ(json["mechanics"]["energy_error"], 1e-4);
  EXPECT_TRUE(json["mechanics"]["broken_joints"].is_number_integer());
  EXPECT_EQ(json["mechanics"]["broken_joints"], 3);
  EXPECT_TRUE(json["mechanics"]["b_value"].is_null());
  EXPECT_EQ(json["mechanics"]["peak_reactions"]["boundary.top"],
            (nlohmann::json{
                {"x_N_per_m", 1.5}, {"x_time_s", 0.25}, {"y_N_per_m", -4e5}, {"y_time_s", 0.5}}));
  EXPECT_FALSE(json["mechanics"].contains("peak_pressures"));
  mechanics.peak_pressures = {{"source.pump", 3e6, 0.125}};
  const auto wet = nlohmann::json::parse(summary_json(record(), mechanics, {}));
  EXPECT_EQ(wet["mechanics"]["peak_pressures"]["source.pump"],
            (nlohmann::json{{"pressure_Pa", 3e6}, {"time_s", 0.125}}));
  EXPECT_EQ(json["reached_rest"], true);
  EXPECT_EQ(json["state_hash"], "abc");
  for (const char* key : {"mass_balance", "throughput_m2_per_s", "rate_m2_per_s", "extremes",
                          "rejected_steps", "iterations"}) {
    EXPECT_FALSE(json.contains(key)) << key;
  }
  const auto flow = nlohmann::json::parse(summary_json(record(), summary(), {}));
  EXPECT_FALSE(flow.contains("mechanics"));
  EXPECT_FALSE(flow.contains("reached_rest"));
}

TEST(Summary, TellsHowFarAFlowHasSettled) {
  simulation::Summary flow = summary();
  flow.reached_rest = true;
  flow.settlement = simulation::Settlement{2e-4, false};
  const auto json = nlohmann::json::parse(summary_json(record(), flow, {}));
  EXPECT_EQ(json["reached_rest"], true);
  EXPECT_EQ(json["change_over_throughput"], 2e-4);
}

TEST(Summary, NamesTheProcessor) {
  EXPECT_FALSE(processor_name().empty());
}

}  // namespace
}  // namespace percolith::io
