// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/csv.hpp"
#include "percolith/io/events.hpp"
#include "percolith/io/history.hpp"
#include "percolith/io/probes.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace percolith::io {
namespace {

TEST(CsvLine, PrintsTheFewestDigitsThatReadBack) {
  EXPECT_EQ(CsvLine().add(0.1).add(1e-20).add(3.0).add(1.0 / 3).text(),
            "0.1,1e-20,3,0.3333333333333333\n");
  for (const double value : {0.1 + 0.2, 1e300, 5e-300, 123456789.123456789}) {
    EXPECT_EQ(std::stod(CsvLine().add(value).text()), value);
  }
  EXPECT_EQ(CsvLine().add(std::numeric_limits<double>::quiet_NaN()).text(), "nan\n");
}

TEST(CsvLine, PrintsZeroWithoutASign) {
  EXPECT_EQ(CsvLine().add(-0.0).add(0.0).add(-1e-300).text(), "0,0,-1e-300\n");
}

TEST(CsvLine, QuotesTextThatNeedsIt) {
  EXPECT_EQ(CsvLine().add(std::string_view("a,b")).add(std::string_view("say \"x\"")).text(),
            "\"a,b\",\"say \"\"x\"\"\"\n");
  EXPECT_EQ(CsvLine().add(std::int64_t{1}).add_empty().add(std::string_view("p")).text(), "1,,p\n");
}

TEST(FileNameOf, KeepsPlainNamesAndMakesOthersSafe) {
  EXPECT_EQ(file_name_of("well_1.top"), "well_1.top");
  EXPECT_EQ(file_name_of("../x"), "%2E.%2Fx");
  EXPECT_EQ(file_name_of("a b%"), "a%20b%25");
}

simulation::HistoryRow row() {
  simulation::HistoryRow row;
  row.time = 2.5;
  row.step = 4;
  row.step_size = 0.5;
  row.minimum_pressure = -1;
  row.maximum_pressure = 1e5;
  row.minimum_crack_pressure = 10;
  row.maximum_crack_pressure = 20;
  row.minimum_saturation = 0.5;
  row.balance = {3, 1, 1.5, 9, 0.5, 0.125, {}};
  row.rate = {{"boundary.left", 0.25}, {"source.a,b", -0.75}};
  return row;
}

TEST(History, NamesEveryColumnWithItsUnit) {
  EXPECT_EQ(history_header(row()),
            "time_s,step,step_size_s,minimum_pressure_Pa,maximum_pressure_Pa,"
            "minimum_crack_pressure_Pa,maximum_crack_pressure_Pa,minimum_saturation,in_m2,out_m2,"
            "stored_m2,in_place_m2,error_m2,relative_error,boundary.left_m2_per_s,"
            "\"source.a,b_m2_per_s\"\n");
}

TEST(History, WritesOneLineARow) {
  EXPECT_EQ(history_line(row()), "2.5,4,0.5,-1,100000,10,20,0.5,3,1,1.5,9,0.5,0.125,0.25,-0.75\n");
  simulation::HistoryRow without_cracks = row();
  without_cracks.minimum_crack_pressure.reset();
  without_cracks.maximum_crack_pressure.reset();
  EXPECT_EQ(history_line(without_cracks),
            "2.5,4,0.5,-1,100000,,,0.5,3,1,1.5,9,0.5,0.125,0.25,-0.75\n");
}

TEST(History, OfMechanicsHasItsOwnColumnsOnly) {
  simulation::HistoryRow mechanics;
  mechanics.time = 2.5;
  mechanics.step = 4;
  mechanics.step_size = 0.5;
  mechanics.has_flow = false;
  mechanics.mechanics = {{"kinetic_J_per_m", 0.25}, {"boundary.a,b.reaction_x_N_per_m", -3}};
  EXPECT_EQ(history_header(mechanics),
            "time_s,step,step_size_s,kinetic_J_per_m,\"boundary.a,b.reaction_x_N_per_m\"\n");
  EXPECT_EQ(history_line(mechanics), "2.5,4,0.5,0.25,-3\n");
}

simulation::BreakEvent event(simulation::BreakMode mode) {
  return {.time = 1e-3,
          .step = 40,
          .place = {0.25, -0.5},
          .mode = mode,
          .length = 0.125,
          .released_energy = 2.5,
          .magnitude = -2.75,
          .material = "granite, grey"};
}

TEST(Events, NameEveryColumnWithItsUnit) {
  EXPECT_EQ(events_header(), "time_s,step,x_m,y_m,mode,length_m,released_energy_J_per_m,"
                             "magnitude,material\n");
}

TEST(Events, WriteOneLineABrokenJoint) {
  using simulation::BreakMode;
  EXPECT_EQ(event_lines({}), "");
  EXPECT_EQ(event_lines({event(BreakMode::tensile), event(BreakMode::shear)}),
            "0.001,40,0.25,-0.5,tensile,0.125,2.5,-2.75,\"granite, grey\"\n"
            "0.001,40,0.25,-0.5,shear,0.125,2.5,-2.75,\"granite, grey\"\n");
  EXPECT_NE(event_lines({event(BreakMode::mixed)}).find(",mixed,"), std::string::npos);
}

TEST(Probes, WriteOneLineAPoint) {
  const simulation::ProbeSample sample{
      "line", {"pressure_Pa", "saturation"}, {{{0, 1}, {5e4, 1}}, {{0.5, 1}, {4e4, 0.5}}}};
  EXPECT_EQ(probe_header(sample), "time_s,x_m,y_m,pressure_Pa,saturation\n");
  EXPECT_EQ(probe_lines(10, sample), "10,0,1,50000,1\n10,0.5,1,40000,0.5\n");
}

TEST(Probes, LeaveTheCellsEmptyWhereThereIsNoRock) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const simulation::ProbeSample sample{
      "tunnel", {"velocity_x_m_per_s", "stress_xx_Pa"}, {{{0, 1}, {none, none}}}};
  EXPECT_EQ(probe_lines(10, sample), "10,0,1,,\n");
}

TEST(Probes, RefuseRowsThatDoNotFitTheColumns) {
  const simulation::ProbeSample sample{"line", {"pressure_Pa"}, {{{0, 1}, {}}}};
  EXPECT_THROW((void)probe_lines(0, sample), std::invalid_argument);
}

}  // namespace
}  // namespace percolith::io
