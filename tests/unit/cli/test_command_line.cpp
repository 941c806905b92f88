// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/command_line.hpp"
#include "percolith/core/error.hpp"

#include <gtest/gtest.h>

namespace percolith::cli {
namespace {

Command parse(const std::vector<std::string>& arguments) {
  return parse_command_line(arguments);
}

std::string refusal(const std::vector<std::string>& arguments) {
  try {
    (void)parse(arguments);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string answer(const std::vector<std::string>& arguments) {
  return std::get<Answer>(parse(arguments)).text;
}

TEST(CommandLine, ReadsAllOptionsOfRun) {
  const auto run = std::get<RunOptions>(
      parse({"run", "a/case.toml", "--output", "out", "--threads", "3", "--set", "time.end=3 hour",
             "--set", "output.times=[1, 2]", "--force", "--quiet"}));
  EXPECT_EQ(run.case_file, "a/case.toml");
  EXPECT_EQ(run.output, "out");
  EXPECT_EQ(run.threads, 3);
  EXPECT_EQ(run.overrides, (std::vector<std::string>{"time.end=3 hour", "output.times=[1, 2]"}));
  EXPECT_TRUE(run.force);
  EXPECT_TRUE(run.quiet);
}

TEST(CommandLine, LeavesRunItsDefaults) {
  const auto run = std::get<RunOptions>(parse({"run", "case.toml"}));
  EXPECT_FALSE(run.output.has_value());
  EXPECT_FALSE(run.threads.has_value());
  EXPECT_TRUE(run.overrides.empty());
  EXPECT_FALSE(run.force);
  EXPECT_FALSE(run.quiet);
}

TEST(CommandLine, ResumesInPlaceOfACase) {
  const auto run =
      std::get<RunOptions>(parse({"run", "--resume", "out", "--threads", "2", "--quiet"}));
  EXPECT_EQ(run.resume, "out");
  EXPECT_TRUE(run.case_file.empty());
  EXPECT_EQ(refusal({"run", "case.toml", "--resume", "out"}),
            "error: CASE excludes --resume; see percolith run --help");
  EXPECT_EQ(refusal({"run", "--resume", "out", "--force"}),
            "error: --force excludes --resume; see percolith run --help");
}

TEST(CommandLine, TakesOneValueAfterEachSet) {
  const auto run = std::get<RunOptions>(parse({"run", "--set", "a=1", "case.toml"}));
  EXPECT_EQ(run.case_file, "case.toml");
  EXPECT_EQ(run.overrides, std::vector<std::string>{"a=1"});
  const auto check = std::get<CheckOptions>(parse({"check", "case.toml", "--set=initial.head=-5"}));
  EXPECT_EQ(check.overrides, std::vector<std::string>{"initial.head=-5"});
}

TEST(CommandLine, ReadsTheOtherCommands) {
  EXPECT_FALSE(std::get<SchemaOptions>(parse({"schema"})).reference);
  EXPECT_TRUE(std::get<SchemaOptions>(parse({"schema", "--reference"})).reference);
  EXPECT_FALSE(std::get<NewOptions>(parse({"new"})).example.has_value());
  const auto copy = std::get<NewOptions>(parse({"new", "strip", "mine"}));
  EXPECT_EQ(copy.example, "strip");
  EXPECT_EQ(copy.folder, "mine");
}

TEST(CommandLine, RefusesWithAHintWhereHelpIs) {
  EXPECT_EQ(refusal({}),
            "error: no command given; allowed: run, check, schema, new, plot, report; see "
            "percolith --help");
  EXPECT_EQ(refusal({"run"}), "error: CASE is required; see percolith run --help");
  EXPECT_EQ(refusal({"run", "case.toml", "--thread", "2"}),
            "error: unknown argument --thread, did you mean --threads?; see percolith run --help");
  EXPECT_EQ(refusal({"check", "case.toml", "other.toml"}),
            "error: unknown argument other.toml; see percolith check --help");
  EXPECT_EQ(refusal({"run", "case.toml", "--threads", "0"}),
            "error: --threads: Value 0 not in range 1 to 1024; see percolith run --help");
  EXPECT_EQ(refusal({"run", "case.toml", "--threads", "many"}),
            "error: --threads: Value many not in range 1 to 1024; see percolith run --help");
}

TEST(CommandLine, AnswersHelpWithAnExample) {
  for (const std::string command : {"run", "check", "schema", "new"}) {
    const std::string text = answer({command, "--help"});
    EXPECT_NE(text.find("Example: percolith " + command), std::string::npos) << text;
  }
  const std::string text = answer({"--help"});
  EXPECT_NE(text.find("Exit codes: 0 success, 2 bad input"), std::string::npos) << text;
  EXPECT_NE(text.find("percolith plot DIR"), std::string::npos) << text;
}

TEST(CommandLine, AnswersTheVersion) {
  const std::string text = answer({"--version"});
  EXPECT_EQ(text.find("percolith "), 0U) << text;
  EXPECT_NE(text.find("compiled by "), std::string::npos) << text;
}

}  // namespace
}  // namespace percolith::cli
