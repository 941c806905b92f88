// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "unit/case/minimal_case.hpp"

namespace percolith::case_file {
namespace {

const std::array<Rename, 3> renames{{{"time.duration", "time.end", "0.3"},
                                     {"boundary.*.imposed", "boundary.*.pressure", "0.3"},
                                     {"earth.gravity", "model.gravity", "0.4"}}};

Case read_renamed(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return read_case_text(text, "case.toml", overrides, renames);
}

TEST(Renames, OldNamesAreReadWithAWarning) {
  const Case result =
      read_renamed(minimal_case + "[boundary.right]\ngroups = [\"right\"]\nimposed = \"2 kPa\"\n");
  EXPECT_EQ(result.setup.boundary.at("right").pressure, Schedule::constant(2000.0));
  EXPECT_EQ(result.warnings,
            std::vector<std::string>{
                "case.toml:22:1: warning: boundary.right.imposed is now called "
                "boundary.right.pressure; the old name is understood until version 0.3"});
}

TEST(Renames, OldNamesMayStandInOtherTablesAndInOverrides) {
  const Case result =
      read_renamed(minimal_case, {"model=", "earth.gravity=9.81", "time.end=", "time.duration=5"});
  EXPECT_EQ(result.setup.model.gravity, 9.81);
  EXPECT_EQ(result.setup.time.end, 5.0);
  ASSERT_EQ(result.warnings.size(), 2U);
  EXPECT_EQ(result.warnings[0],
            "--set: warning: time.duration is now called time.end; the old name "
            "is understood until version 0.3");
}

TEST(Renames, OldAndNewNameTogetherAreAnError) {
  try {
    (void)read_renamed(minimal_case + "duration = 3\n");
    FAIL() << "both names were accepted";
  } catch (const InputErrors& errors) {
    EXPECT_STREQ(errors.what(), "case.toml:20:1: error: time.duration = 3: given twice: it is the "
                                "old name of time.end; allowed: time.end");
  }
}

TEST(Renames, ErrorsOfAnOldNameNameTheNewOne) {
  try {
    (void)read_renamed(minimal_case, {"time.end=", "time.duration=-3"});
    FAIL() << "a negative end was accepted";
  } catch (const InputErrors& errors) {
    EXPECT_STREQ(errors.what(),
                 "--set: error: time.end = -3: out of range; allowed: a finite number > 0 s");
  }
}

TEST(Renames, WithoutARenameTheNameIsUnknown) {
  EXPECT_EQ(error_with("duration = 3\n").substr(0, 52),
            "case.toml:20:1: error: time.duration: unknown option");
}

}  // namespace
}  // namespace percolith::case_file
