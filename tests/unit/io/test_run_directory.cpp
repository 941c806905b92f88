// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/io/run_directory.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "unit/io/temporary_folder.hpp"

namespace percolith::io {
namespace {

std::string refusal(const std::filesystem::path& path, Existing existing) {
  for (const bool only_ask : {true, false}) {
    try {
      if (only_ask) {
        RunDirectory::require_usable(path, existing);
      } else {
        RunDirectory::open(path, existing);
      }
    } catch (const InputError& error) {
      if (only_ask) {
        continue;  // open must say the same
      }
      return error.what();
    }
    return only_ask ? "require_usable does not refuse" : "open does not refuse";
  }
  return "";
}

void write_results(const std::filesystem::path& path) {
  for (const char* name :
       {"resolved.toml", "summary.json", "history.csv", "events.csv", "fragments.csv", "matrix.pvd",
        "cracks.pvd", "checkpoint.bin", "run.log", "matrix.pvd.part", "fields/matrix_000000.vtu",
        "fields/cracks_000001.vtu", "fields/matrix_000002.vtu.part", "probes/a.csv"}) {
    test::write_text(path / name, "old");
  }
}

TEST(RunDirectory, IsNamedAfterTheCaseInTheCurrentFolder) {
  EXPECT_EQ(RunDirectory::default_path("cases/strip.toml"), "strip.results");
}

TEST(RunDirectory, IsMadeWithTheFoldersAboveIt) {
  const test::TemporaryFolder folder;
  const RunDirectory directory = RunDirectory::open(folder / "a/b", Existing::refuse);
  EXPECT_EQ(directory.path(), folder / "a/b");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b"));
}

TEST(RunDirectory, TakesAnEmptyFolder) {
  const test::TemporaryFolder folder;
  EXPECT_NO_THROW(RunDirectory::open(folder.path(), Existing::refuse));
}

TEST(RunDirectory, TakesAFolderThatAKilledRunHasLeftBeforeItBegan) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "run.log", "");
  test::write_text(folder / "resolved.toml.part", "half");
  EXPECT_NO_THROW(RunDirectory::open(folder.path(), Existing::refuse));
}

TEST(RunDirectory, KeepsEarlierResultsWithoutForce) {
  const test::TemporaryFolder folder;
  write_results(folder.path());
  const std::string found = "error: --output = " + folder.path().string() +
                            ": the folder holds results of an earlier run; allowed: ";
  const std::string rest = "--force to replace them, or another --output";
  EXPECT_EQ(refusal(folder.path(), Existing::refuse),
            found + "--resume to go on with an unfinished run, " + rest);
  std::filesystem::remove(folder / "checkpoint.bin");
  EXPECT_EQ(refusal(folder.path(), Existing::refuse), found + rest);
  EXPECT_EQ(test::read_text(folder / "history.csv"), "old");
}

TEST(RunDirectory, ReplacesOnlyWhatARunWrites) {
  const test::TemporaryFolder folder;
  write_results(folder.path());
  test::write_text(folder / "notes.txt", "mine");
  test::write_text(folder / "fields/picture.png", "mine");
  test::write_text(folder / "my_history.csv", "mine");
  const RunDirectory directory = RunDirectory::open(folder.path(), Existing::replace);
  std::set<std::string> left;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    if (!entry.is_directory()) {
      left.insert(std::filesystem::relative(entry.path(), folder.path()).string());
    }
  }
  EXPECT_EQ(left, (std::set<std::string>{"run.log", "resolved.toml", "notes.txt",
                                         "fields/picture.png", "my_history.csv"}));
  EXPECT_EQ(test::read_text(folder / "run.log"), "");
}

TEST(RunDirectory, NeverReplacesAFolderThatHoldsNoResults) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "thesis.tex", "mine");
  test::write_text(folder / "history.csv", "mine");
  EXPECT_EQ(refusal(folder.path(), Existing::replace),
            "error: --output = " + folder.path().string() +
                ": the folder is not empty and holds no results of a run; allowed: a new or empty "
                "folder");
  EXPECT_EQ(test::read_text(folder / "history.csv"), "mine");
}

TEST(RunDirectory, RefusesAFile) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "file", "mine");
  EXPECT_EQ(refusal(folder / "file", Existing::replace),
            "error: --output = " + (folder / "file").string() +
                ": is not a folder; allowed: the name of a folder");
}

TEST(RunDirectory, IsRefusedWhileAnotherRunHoldsIt) {
  const test::TemporaryFolder folder;
  {
    const RunDirectory directory = RunDirectory::open(folder / "r", Existing::refuse);
    test::write_text(folder / "r/resolved.toml", "new");
    EXPECT_EQ(refusal(folder / "r", Existing::replace),
              "error: --output = " + (folder / "r").string() +
                  ": another run is writing to this folder; allowed: another --output, or wait for "
                  "that run to end");
    EXPECT_EQ(test::read_text(folder / "r/resolved.toml"), "new");
  }
  EXPECT_NO_THROW(RunDirectory::open(folder / "r", Existing::replace));
}

TEST(RunDirectory, AskingChangesNothing) {
  const test::TemporaryFolder folder;
  RunDirectory::require_usable(folder / "new", Existing::refuse);
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
  write_results(folder.path());
  RunDirectory::require_usable(folder.path(), Existing::replace);
  EXPECT_EQ(test::read_text(folder / "summary.json"), "old");
}

}  // namespace
}  // namespace percolith::io
