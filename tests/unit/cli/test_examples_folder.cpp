// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/examples_folder.hpp"
#include "percolith/core/error.hpp"

#include <gtest/gtest.h>

#include "unit/io/temporary_folder.hpp"

namespace percolith::cli {
namespace {

using std::filesystem::exists;

TEST(ExamplesFolder, ListsFoldersWithACase) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "b/case.toml", "");
  test::write_text(folder / "a/case.toml", "");
  test::write_text(folder / "c/other.toml", "");
  const std::vector<Example> examples = list_examples(folder.path());
  ASSERT_EQ(examples.size(), 2U);
  EXPECT_EQ(examples[0].name, "a");
  EXPECT_EQ(examples[1].folder, folder / "b");
}

TEST(CopyFolder, TakesEverythingButResultsAndCaches) {
  const test::TemporaryFolder folder;
  for (const char* file :
       {"case.toml", "mesh/a.msh", "case.results/summary.json", ".hidden", "__pycache__/x.pyc"}) {
    test::write_text(folder / "from" / file, file);
  }
  std::filesystem::create_directory(folder / "to");
  copy_folder(folder / "from", folder / "to");
  EXPECT_EQ(test::read_text(folder / "to/mesh/a.msh"), "mesh/a.msh");
  EXPECT_TRUE(exists(folder / "to/case.toml"));
  EXPECT_FALSE(exists(folder / "to/case.results"));
  EXPECT_FALSE(exists(folder / "to/.hidden"));
  EXPECT_FALSE(exists(folder / "to/__pycache__"));
}

TEST(CopyFolder, RefusesAFolderWithContent) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "from/case.toml", "new");
  test::write_text(folder / "to/case.toml", "mine");
  try {
    copy_folder(folder / "from", folder / "to");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "error: DIR = " + (folder / "to").string() +
                                             ": exists and is not an empty folder; allowed: a new "
                                             "or empty folder");
  }
  EXPECT_EQ(test::read_text(folder / "to/case.toml"), "mine");
}

}  // namespace
}  // namespace percolith::cli
