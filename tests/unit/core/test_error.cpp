// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"

#include <gtest/gtest.h>

namespace percolith {
namespace {

TEST(DescribeProblem, SaysWhereWhatWhyAndWhatIsAllowed) {
  EXPECT_EQ(describe_problem({{"case.toml", 12, 3},
                              "material.rock.nu",
                              "0.6",
                              "Poisson's ratio is too large",
                              "0 to 0.5"}),
            "case.toml:12:3: error: material.rock.nu = 0.6: Poisson's ratio is too large; "
            "allowed: 0 to 0.5");
}

TEST(DescribeProblem, LeavesOutWhatIsUnknown) {
  EXPECT_EQ(describe_problem({{}, "", "", "no mesh", ""}), "error: no mesh");
  EXPECT_EQ(describe_problem({{"a.msh", 0, 4}, "", "", "truncated", ""}),
            "a.msh: error: truncated");
  EXPECT_EQ(describe_problem({{"a.msh", 7, 0}, "", "", "truncated", ""}),
            "a.msh:7: error: truncated");
  EXPECT_EQ(describe_problem({{"", 7, 2}, "time.end", "", "missing", "a time"}),
            "error: time.end: missing; allowed: a time");
  // A value without a key has nothing it belongs to.
  EXPECT_EQ(describe_problem({{}, "", "3", "odd", ""}), "error: odd");
}

TEST(Errors, CarryTheExitCodeOfTheirFamily) {
  const InputError input({{}, "time.end", "", "missing", ""});
  EXPECT_EQ(input.exit_code(), ExitCode::input);
  EXPECT_EQ(input.problem().key, "time.end");
  EXPECT_STREQ(input.what(), "error: time.end: missing");
  EXPECT_EQ(SolverError("x").exit_code(), ExitCode::solver);
  EXPECT_EQ(FileError("x").exit_code(), ExitCode::file);
  EXPECT_EQ(static_cast<int>(ExitCode::input), 2);
  EXPECT_EQ(static_cast<int>(ExitCode::solver), 3);
  EXPECT_EQ(static_cast<int>(ExitCode::file), 4);
}

}  // namespace
}  // namespace percolith
