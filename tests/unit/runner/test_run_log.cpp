// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/runner/run_log.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "unit/io/temporary_folder.hpp"

namespace percolith::runner {
namespace {

TEST(RunLog, DatesEveryLineAndShowsWarnings) {
  const test::TemporaryFolder folder;
  std::string shown;
  RunLog log(folder / "run.log", [&](const std::string& line) { shown += line + '\n'; });
  log.information("begins");
  log.on_warning("coarse mesh");
  log.on_located_warning("case.toml:3:1: warning: renamed");
  log.error("ends");
  EXPECT_EQ(shown, "warning: coarse mesh\ncase.toml:3:1: warning: renamed\n");
  const std::string date = R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d[+-]\d\d:\d\d )";
  EXPECT_TRUE(std::regex_match(
      test::read_text(folder / "run.log"),
      std::regex(date + "info: begins\n" + date + "warning: coarse mesh\n" + date +
                 "warning: case.toml:3:1: warning: renamed\n" + date + "error: ends\n")))
      << test::read_text(folder / "run.log");
}

TEST(RunLog, TellsWhereALineCannotBeWritten) {
  RunLog log("/dev/full", [](const std::string&) {});
  try {
    log.information("begins");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_EQ(std::string(error.what()).find("/dev/full: cannot write the log: "), 0U)
        << error.what();
  }
}

TEST(RunLog, TellsWhereItCannotBeOpened) {
  const test::TemporaryFolder folder;
  try {
    const RunLog log(folder.path(), [](const std::string&) {});
    FAIL();
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(": cannot open the log: "), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace percolith::runner
