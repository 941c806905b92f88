// SPDX-License-Identifier: BSD-3-Clause
#include "unit/case/minimal_case.hpp"
#include "unit/case/temporary_folder.hpp"

namespace percolith::case_file {
namespace {

Schedule pressure_of(const std::string& value) {
  return *read(minimal_case, {"boundary.left.pressure=" + value})
              .setup.boundary.at("left")
              .pressure;
}

std::string pressure_error(const std::string& value) {
  return error_set({"boundary.left.pressure=" + value});
}

TEST(ScheduleReading, Constant) {
  EXPECT_EQ(pressure_of("3e5"), Schedule::constant(3e5));
  EXPECT_EQ(pressure_of("3 bar"), Schedule::constant(3e5));
}

TEST(ScheduleReading, Table) {
  EXPECT_EQ(pressure_of("{times=[0, 10], values=[1, 2]}"),
            (Schedule{{0.0, 10.0}, {1.0, 2.0}, Interpolation::linear}));
  EXPECT_EQ(pressure_of("{times=[0, \"1 min\"], values=[\"1 kPa\", 2], interpolation=\"step\"}"),
            (Schedule{{0.0, 60.0}, {1000.0, 2.0}, Interpolation::step}));
  EXPECT_EQ(pressure_of("{times=[0, \"30 s\", 1], values=[1, 2, 3], time_unit=\"min\", "
                        "value_unit=\"kPa\"}"),
            (Schedule{{0.0, 30.0, 60.0}, {1000.0, 2000.0, 3000.0}, Interpolation::linear}));
}

TEST(ScheduleReading, TableErrors) {
  const std::string table = "--set: error: boundary.left.pressure = ";
  const std::string forms =
      "expects a table of times and values, or of a CSV file; allowed: { times = [...], values = "
      "[...] } or { file = \"...\", time_column = \"...\", value_column = \"...\" }";
  EXPECT_EQ(pressure_error("{times=[0]}"), table + "{ times = [0] }: " + forms);
  EXPECT_EQ(pressure_error("{}"), table + "{ }: " + forms);
  EXPECT_EQ(pressure_error("{file=\"a\", times=[0]}"),
            table + "{ file = \"a\", times = [0] }: " + forms);
  EXPECT_EQ(pressure_error("{times=[0], values=[1, 2]}"),
            table +
                "{ times = [0], values = [1, 2] }: 1 times and 2 values; allowed: as many values "
                "as times, at least one");
  EXPECT_EQ(pressure_error("{times=[], values=[]}"),
            table + "{ times = [], values = [] }: 0 times and 0 values; allowed: as many values as "
                    "times, at least one");
  EXPECT_EQ(pressure_error("[1, 2]"),
            table +
                "[1, 2]: expects a number or a table, found a list; allowed: a number in Pa, or "
                "a text with a unit of pressure such as \"2 MPa\", or { times = [...], values = "
                "[...] }");
}

TEST(ScheduleReading, EntryErrors) {
  EXPECT_EQ(pressure_error("{times=[0, 5, 5], values=[1, 2, 3]}"),
            "--set: error: boundary.left.pressure.times = 5: times do not increase; allowed: times "
            "that strictly increase; for a jump, interpolation = \"step\"");
  EXPECT_EQ(
      pressure_error("{times=[0, \"5\"], values=[1, 2]}"),
      "--set: error: boundary.left.pressure.times = \"5\": missing unit; allowed: a number in "
      "s, or a text with a unit of time such as \"3 hour\"");
  EXPECT_EQ(pressure_error("{times=[0], values=[\"1 m\"]}"),
            "--set: error: boundary.left.pressure.values = \"1 m\": the unit \"m\" is not one of "
            "pressure; allowed: a number in Pa, or a text with a unit of pressure such as \"2 "
            "MPa\"");
  EXPECT_EQ(pressure_error("{times=[inf], values=[0]}"),
            "--set: error: boundary.left.pressure.times = inf: out of range; allowed: a finite "
            "number of s");
  EXPECT_EQ(pressure_error("{times=0, values=[0]}"),
            "--set: error: boundary.left.pressure.times = 0: expects a list of numbers, found a "
            "number; allowed: [...], each a number in s, or a text with a unit of time such as \"3 "
            "hour\"");
}

TEST(ScheduleReading, UnitErrors) {
  EXPECT_EQ(
      pressure_error("{times=[0], values=[0], time_unit=\"Pa\"}"),
      "--set: error: boundary.left.pressure.time_unit = \"Pa\": the unit \"Pa\" is not one of "
      "time; allowed: a unit of time, such as that of \"3 hour\"");
}

TEST(ScheduleReading, UnknownKeyNamesTheNearest) {
  EXPECT_EQ(pressure_error("{time=[0], values=[0]}"),
            "--set: error: boundary.left.pressure.time: unknown option; the nearest valid name is "
            "\"times\"; allowed: \"times\", \"values\", \"file\", \"time_column\", "
            "\"value_column\", \"time_unit\", \"value_unit\", \"interpolation\"");
}

class ScheduleFile : public testing::Test {
protected:
  Schedule flux_of(const std::string& table) {
    return *read_flux(table).setup.boundary.at("right").flux;
  }

  Case read_flux(const std::string& table) {
    const std::string text =
        minimal_case + "[boundary.right]\ngroups = [\"right\"]\nflux = " + table + "\n";
    return read_case_text(text, folder_.path() / "case.toml");
  }

  /// The message without the path of the folder.
  std::string error_of_flux(const std::string& table) {
    try {
      (void)read_flux(table);
    } catch (const InputErrors& errors) {
      std::string text = errors.what();
      const std::string path = folder_.path().string() + "/";
      for (std::size_t at = text.find(path); at != std::string::npos; at = text.find(path)) {
        text.erase(at, path.size());
      }
      return text;
    }
    return {};
  }

  TemporaryFolder folder_;
};

TEST_F(ScheduleFile, ReadsNamedColumns) {
  folder_.write("pump.csv", "\xEF\xBB\xBF# a test\r\n\"time, hours\",pressure,rate\r\n0,5,1\r\n"
                            "\r\n1, 6, 2 \r\n");
  EXPECT_EQ(
      flux_of("{ file = \"pump.csv\", time_column = \"time, hours\", value_column = \"rate\", "
              "time_unit = \"hour\", value_unit = \"km/s\", interpolation = \"step\" }"),
      (Schedule{{0.0, 3600.0}, {1000.0, 2000.0}, Interpolation::step}));
}

TEST_F(ScheduleFile, ReadsTheOnlyTwoColumnsWithoutNames) {
  folder_.write("pump.csv", "t,q\n0,1\n2 min,1 mm/s\n");
  EXPECT_EQ(flux_of("{ file = \"pump.csv\" }"),
            (Schedule{{0.0, 120.0}, {1.0, 1e-3}, Interpolation::linear}));
}

TEST_F(ScheduleFile, ErrorsNameTheLine) {
  folder_.write("pump.csv", "t,q\n0,1\n# note\n1,high\n");
  EXPECT_EQ(error_of_flux("{ file = \"pump.csv\" }"),
            "pump.csv:4: error: boundary.right.flux = \"high\": not a number with a unit; allowed: "
            "a number in m/s, or a text with a unit of flux such as \"1e-8 m/s\"");
  folder_.write("pump.csv", "t,q\n0,1\n0,2\n");
  EXPECT_EQ(
      error_of_flux("{ file = \"pump.csv\" }"),
      "pump.csv:3: error: boundary.right.flux = 0: times do not increase; allowed: times that "
      "strictly increase; for a jump, interpolation = \"step\"");
  folder_.write("pump.csv", "t,q\n0,1,2\n");
  EXPECT_EQ(error_of_flux("{ file = \"pump.csv\" }"),
            "pump.csv:2: error: boundary.right.flux.file: 3 cells in a row of a table with 2 "
            "columns");
  folder_.write("pump.csv", "t,q\n0,\"1\n");
  EXPECT_EQ(
      error_of_flux("{ file = \"pump.csv\" }"),
      "pump.csv:2: error: boundary.right.flux.file: a double quote is not closed on its line");
}

TEST_F(ScheduleFile, ErrorsOfTheFileAsAWhole) {
  EXPECT_EQ(
      error_of_flux("{ file = \"none.csv\" }"),
      "case.toml:22:17: error: boundary.right.flux.file = \"none.csv\": none.csv: no such file");
  folder_.write("empty.csv", "t,q\n");
  EXPECT_EQ(error_of_flux("{ file = \"empty.csv\" }"),
            "case.toml:22:17: error: boundary.right.flux.file = \"empty.csv\": empty.csv: the file "
            "has no row below its column names");
}

TEST_F(ScheduleFile, ErrorsOfColumns) {
  folder_.write("pump.csv", "t,p,q\n0,1,2\n");
  EXPECT_EQ(
      error_of_flux("{ file = \"pump.csv\", time_column = \"t\", value_column = \"Q\" }"),
      "case.toml:22:63: error: boundary.right.flux.value_column = \"Q\": pump.csv has no such "
      "column; allowed: \"t\", \"p\", \"q\"");
  EXPECT_EQ(error_of_flux("{ file = \"pump.csv\" }"),
            "case.toml:22:8: error: boundary.right.flux.time_column = { file = \"pump.csv\" }: "
            "pump.csv does not have two columns, so the one to use must be named; allowed: \"t\", "
            "\"p\", \"q\"");
}

}  // namespace
}  // namespace percolith::case_file
