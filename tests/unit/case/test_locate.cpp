// SPDX-License-Identifier: BSD-3-Clause
#include "unit/case/minimal_case.hpp"

namespace percolith::case_file {
namespace {

std::string located(const std::string& key, const std::string& value = {}) {
  const Case known = read(minimal_case, {"fluid.density=900"});
  const InputError error(InputProblem{{}, key, value, "no good", "better"});
  return locate(error, known).what();
}

TEST(Locate, AddsPlaceAndValueOfTheKey) {
  EXPECT_EQ(located("boundary.left.groups"),
            "case.toml:15:10: error: boundary.left.groups = [\"left\"]: no good; allowed: better");
  EXPECT_EQ(located("time.end"),
            "case.toml:19:7: error: time.end = \"1 hour\": no good; allowed: better");
  EXPECT_EQ(located("fluid.density"),
            "--set: error: fluid.density = 900: no good; allowed: better");
}

TEST(Locate, KeepsAValueThatTheErrorBrings) {
  EXPECT_EQ(located("boundary.left.groups", "\"left\""),
            "case.toml:15:10: error: boundary.left.groups = \"left\": no good; allowed: better");
}

TEST(Locate, TakesTheTableOfAKeyThatIsNotGiven) {
  EXPECT_EQ(located("boundary.left.on"),
            "case.toml:14:11: error: boundary.left.on: no good; allowed: better");
  EXPECT_EQ(located("time.end.more"),
            "case.toml:19:7: error: time.end.more: no good; allowed: better");
}

TEST(Locate, TakesTheFileWhereNothingIsKnown) {
  EXPECT_EQ(located("output.times"), "case.toml: error: output.times: no good; allowed: better");
  EXPECT_EQ(located(""), "case.toml: error: no good; allowed: better");
}

TEST(Locate, LeavesAPlaceThatIsKnown) {
  const InputError error(InputProblem{{"rock.msh", 3, 0}, "mesh.file", {}, "no good", {}});
  EXPECT_STREQ(locate(error, read(minimal_case)).what(), "rock.msh:3: error: mesh.file: no good");
}

}  // namespace
}  // namespace percolith::case_file
