// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/io/results_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "unit/io/file_size_limit.hpp"
#include "unit/io/frames.hpp"
#include "unit/io/temporary_folder.hpp"
#include "unit/io/vtu_decoder.hpp"

namespace percolith::io {
namespace {

using std::filesystem::exists;

TEST(ResultsWriter, WritesSeriesTablesAndProbes) {
  const test::TemporaryFolder folder;
  ResultsWriter writer(folder.path());
  const std::vector<simulation::ProbeSample> samples = {{"well", {"pressure_Pa"}, {{{0, 1}, {5}}}}};
  for (const double time : {0.0, 0.1}) {
    simulation::HistoryRow row;
    row.time = time;
    writer.on_history(row);
    writer.on_frame(test::cracked_square(time));
    writer.on_probes(time, samples);
  }
  EXPECT_EQ(test::read_text(folder / "matrix.pvd"),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
            "<Collection>\n"
            "<DataSet timestep=\"0\" part=\"0\" file=\"fields/matrix_000000.vtu\"/>\n"
            "<DataSet timestep=\"0.1\" part=\"0\" file=\"fields/matrix_000001.vtu\"/>\n"
            "</Collection>\n</VTKFile>\n");
  EXPECT_TRUE(exists(folder / "fields/matrix_000001.vtu"));
  EXPECT_TRUE(exists(folder / "fields/cracks_000001.vtu"));
  EXPECT_NE(test::read_text(folder / "cracks.pvd").find("timestep=\"0.1\""), std::string::npos);
  EXPECT_EQ(test::read_text(folder / "probes/well.csv"),
            "time_s,x_m,y_m,pressure_Pa\n0,0,1,5\n0.1,0,1,5\n");
  const std::string history = test::read_text(folder / "history.csv");
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 3);
  EXPECT_EQ(history.find("time_s,step,"), 0U);
}

/// Every file of a folder with its content.
std::map<std::string, std::string> content(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files[entry.path().string()] = test::read_text(entry.path());
    }
  }
  return files;
}

void report_all(ResultsWriter& writer, double time, bool cracked) {
  simulation::HistoryRow row;
  row.time = time;
  writer.on_history(row);
  simulation::Frame frame = test::cracked_square(time);
  if (!cracked) {
    frame.cracks = {};
  }
  writer.on_frame(frame);
  writer.on_probes(time, {{"a b", {"pressure_Pa"}, {{{0, 1}, {5}}}}});
  simulation::BreakEvent event;
  event.time = time;
  writer.on_events({event});
  writer.on_fragments(time, {simulation::FragmentRow{}});
}

TEST(ResultsWriter, GoesOnFromWhereItWasAndTakesBackTheRest) {
  const test::TemporaryFolder folder;
  std::string bytes;
  std::map<std::string, std::string> kept;
  {
    ResultsWriter writer(folder.path());
    report_all(writer, 0.0, false);
    writer.sync();
    StateWriter state([&](std::string_view part) { bytes += part; });
    state("results", writer);
    kept = content(folder.path());
    report_all(writer, 1.0, true);
    report_all(writer, 2.0, true);
    test::write_text(folder / "fields/matrix_000003.vtu.part", "half");
    test::write_text(folder / "fields/matrix_notes.txt", "mine");
  }
  const auto before = content(folder.path());
  kept[(folder / "fields/matrix_notes.txt").string()] = "mine";
  StateReader state(bytes, "checkpoint");
  ResultsWriter writer(folder.path());
  state("results", writer);
  EXPECT_EQ(content(folder.path()), before);
  writer.on_resume(0.5, 1);
  EXPECT_EQ(content(folder.path()), kept);
  report_all(writer, 1.0, true);
  report_all(writer, 2.0, true);
  auto after = before;
  after.erase((folder / "fields/matrix_000003.vtu.part").string());
  EXPECT_EQ(content(folder.path()), after);
}

TEST(ResultsWriter, RefusesTablesThatHaveLostRows) {
  const test::TemporaryFolder folder;
  std::string bytes;
  {
    ResultsWriter writer(folder.path());
    report_all(writer, 0.0, false);
    StateWriter state([&](std::string_view part) { bytes += part; });
    state("results", writer);
  }
  test::write_text(folder / "events.csv", "time_s\n");
  StateReader state(bytes, "checkpoint");
  ResultsWriter writer(folder.path());
  try {
    state("results", writer);
    ADD_FAILURE() << "no error";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("events.csv: the file has 7 bytes"), std::string::npos)
        << error.what();
  }
}

TEST(ResultsWriter, StartsTheCrackSeriesWithTheFirstCrack) {
  const test::TemporaryFolder folder;
  ResultsWriter writer(folder.path());
  simulation::Frame intact = test::cracked_square(0);
  intact.cracks = {};
  writer.on_frame(intact);
  EXPECT_FALSE(exists(folder / "cracks.pvd"));
  writer.on_frame(test::cracked_square(1));
  EXPECT_NE(test::read_text(folder / "cracks.pvd").find("cracks_000001.vtu"), std::string::npos);
}

TEST(ResultsWriter, AppendsEventsAsTheyCome) {
  const test::TemporaryFolder folder;
  ResultsWriter writer(folder.path());
  EXPECT_FALSE(exists(folder / "events.csv"));
  writer.on_events({});
  const std::string header = "time_s,step,x_m,y_m,mode,length_m,released_energy_J_per_m,"
                             "magnitude,material\n";
  EXPECT_EQ(test::read_text(folder / "events.csv"), header);
  simulation::BreakEvent event;
  event.time = 0.5;
  event.material = "rock";
  writer.on_events({event});
  event.time = 0.75;
  writer.on_events({event});
  EXPECT_EQ(test::read_text(folder / "events.csv"),
            header + "0.5,0,0,0,tensile,0,0,0,rock\n0.75,0,0,0,tensile,0,0,0,rock\n");
}

TEST(ResultsWriter, AppendsTheFragmentsOfEveryFrame) {
  const test::TemporaryFolder folder;
  ResultsWriter writer(folder.path());
  EXPECT_FALSE(exists(folder / "fragments.csv"));
  writer.on_fragments(0.0, {{0, 8, 2.0, {0.5, 1.0}, {0.0, 0.0}}});
  writer.on_fragments(
      1.5, {{0, 5, 1.25, {0.25, 1.0}, {-1.0, 0.0}}, {1, 3, 0.75, {1.0, 0.5}, {2.0, -4.0}}});
  EXPECT_EQ(test::read_text(folder / "fragments.csv"),
            "time_s,fragment,triangles,area_m2,x_m,y_m,velocity_x_m_per_s,velocity_y_m_per_s\n"
            "0,0,8,2,0.5,1,0,0\n"
            "1.5,0,5,1.25,0.25,1,-1,0\n"
            "1.5,1,3,0.75,1,0.5,2,-4\n");
}

TEST(ResultsWriter, LeavesWholeLinesOfEventsWhereTheDiskFillsUp) {
  const test::TemporaryFolder folder;
  ResultsWriter writer(folder.path());
  writer.on_events({simulation::BreakEvent{}});
  const std::string before = test::read_text(folder / "events.csv");
  {
    const test::FileSizeLimit limit(200);
    const std::vector<simulation::BreakEvent> many(20);
    EXPECT_THROW(writer.on_events(many), FileError);
  }
  EXPECT_EQ(test::read_text(folder / "events.csv"), before);
}

TEST(ResultsWriter, KeepsProbesWithOddNamesInTheirFolder) {
  const test::TemporaryFolder folder;
  ResultsWriter writer(folder.path());
  writer.on_probes(0, {{"../up", {"pressure_Pa"}, {}}});
  EXPECT_TRUE(exists(folder / "probes/%2E.%2Fup.csv"));
}

TEST(ResultsWriter, LeavesAWholeSeriesWhereTheDiskFillsUp) {
  const test::TemporaryFolder folder;
  ResultsWriter writer(folder.path());
  writer.on_frame(test::cracked_square(0));
  const std::string before = test::read_text(folder / "matrix.pvd");
  {
    const test::FileSizeLimit limit(200);
    try {
      writer.on_frame(test::cracked_square(1));
      FAIL();
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find("fields/matrix_000001.vtu: cannot write the file"),
                std::string::npos)
          << error.what();
    }
  }
  EXPECT_EQ(test::read_text(folder / "matrix.pvd"), before);
  EXPECT_FALSE(exists(folder / "fields/matrix_000001.vtu"));
  EXPECT_FALSE(exists(folder / "fields/matrix_000001.vtu.part"));
  const test::VtuDecoder first(test::read_text(folder / "fields/matrix_000000.vtu"));
  EXPECT_EQ(first.array<double>("Float64", "pressure_Pa").size(), 6U);
}

}  // namespace
}  // namespace percolith::io
