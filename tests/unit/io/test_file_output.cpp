// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/io/file_output.hpp"

#include <gtest/gtest.h>

#include "unit/io/file_size_limit.hpp"
#include "unit/io/temporary_folder.hpp"

namespace percolith::io {
namespace {

template <class Work>
std::string file_error(const Work& work) {
  try {
    work();
  } catch (const FileError& error) {
    EXPECT_EQ(error.exit_code(), ExitCode::file);
    return error.what();
  }
  return "no error";
}

TEST(AtomicFile, AppearsWithItsCommit) {
  const test::TemporaryFolder folder;
  AtomicFile file(folder / "a.txt");
  file.write("one ");
  file.write("two");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  file.commit(Durability::synced);
  EXPECT_EQ(test::read_text(folder / "a.txt"), "one two");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.part"));
}

TEST(AtomicFile, LeavesTheEarlierFileWithoutCommit) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.txt", "earlier");
  {
    AtomicFile file(folder / "a.txt");
    file.write("new");
  }
  EXPECT_EQ(test::read_text(folder / "a.txt"), "earlier");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.part"));
}

TEST(AtomicFile, KeepsTheEarlierFileWhereNoMoreFits) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.txt", "earlier");
  const test::FileSizeLimit limit(1000);
  const std::string message = file_error(
      [&] { write_file(folder / "a.txt", std::string(5000, 'x'), Durability::buffered); });
  EXPECT_EQ(message, (folder / "a.txt").string() +
                         ": cannot write the file: File too large; raise the file size limit "
                         "(ulimit -f)");
  EXPECT_EQ(test::read_text(folder / "a.txt"), "earlier");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.part"));
}

TEST(AtomicFile, NamesAFolderThatIsMissing) {
  const test::TemporaryFolder folder;
  const std::string message = file_error([&] { AtomicFile(folder.path() / "none" / "a.txt"); });
  EXPECT_NE(message.find("a.txt.part: cannot open the file: No such file or directory"),
            std::string::npos)
      << message;
}

TEST(AppendFile, GrowsByLines) {
  const test::TemporaryFolder folder;
  AppendFile file(folder / "t.csv");
  file.append("a,b\n");
  file.append("1,2\n");
  EXPECT_EQ(test::read_text(folder / "t.csv"), "a,b\n1,2\n");
}

TEST(AppendFile, IsCutBackToWholeLinesWhereNoMoreFits) {
  const test::TemporaryFolder folder;
  AppendFile file(folder / "t.csv");
  file.append("first\n");
  const test::FileSizeLimit limit(10);
  const std::string message = file_error([&] { file.append("second line\n"); });
  EXPECT_NE(message.find("t.csv: cannot write the file: File too large"), std::string::npos)
      << message;
  EXPECT_EQ(test::read_text(folder / "t.csv"), "first\n");
}

TEST(AppendFile, TellsThatTheDiskIsFull) {
  AppendFile file("/dev/full");
  EXPECT_EQ(file_error([&] { file.append("line\n"); }),
            "/dev/full: cannot write the file: No space left on device; free some space or choose "
            "another --output");
}

TEST(MakeFolder, NamesWhatStandsInTheWay) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "file", "");
  const std::string message = file_error([&] { make_folder(folder / "file/sub"); });
  EXPECT_NE(message.find("file/sub: cannot make the folder: Not a directory"), std::string::npos)
      << message;
}

}  // namespace
}  // namespace percolith::io
