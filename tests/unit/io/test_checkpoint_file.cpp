// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/io/checkpoint_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "unit/io/temporary_folder.hpp"

namespace percolith::io {
namespace {

using test::read_text;
using test::write_text;

const CheckpointOrigin origin{"percolith 1", "case", "mesh", "a/case.toml"};

class CheckpointFiles : public testing::Test {
protected:
  CheckpointFiles() : path(folder / "checkpoint.bin"), values(300'000) {
    std::iota(values.begin(), values.end(), 0.5);
    write_checkpoint(path, origin, [&](StateArchive& archive) { archive("values", values); });
  }

  /// What is said of the file with these bytes, without the path before it.
  [[nodiscard]] std::string refusal(const std::string& bytes) const {
    write_text(path, bytes);
    try {
      const CheckpointFile file(path);
    } catch (const FileError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find(path.string() + ": "), 0U);
      return text.substr(path.string().size() + 2);
    }
    return "no error";
  }

  [[nodiscard]] std::string foreign(const CheckpointOrigin& present) const {
    try {
      CheckpointFile(path).require_origin(present);
    } catch (const FileError& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder;
  std::filesystem::path path;
  std::vector<double> values;
};

TEST_F(CheckpointFiles, AreReadBack) {
  const CheckpointFile file(path);
  EXPECT_EQ(file.origin().case_file, "a/case.toml");
  file.require_origin(origin);
  std::vector<double> read(values.size());
  StateReader state = file.state();
  state("values", read);
  EXPECT_EQ(read, values);
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

TEST_F(CheckpointFiles, AreRefusedWhenCutShort) {
  const std::string bytes = read_text(path);
  for (const std::size_t kept : {std::size_t{60}, bytes.size() / 2, bytes.size() - 1}) {
    EXPECT_EQ(refusal(bytes.substr(0, kept)).find("the checkpoint is cut short"), 0U) << kept;
  }
  EXPECT_EQ(refusal(""), "this is no checkpoint, or it has lost its start; nothing was changed");
}

TEST_F(CheckpointFiles, AreRefusedWhenAnyByteIsAnother) {
  const std::string bytes = read_text(path);
  for (const std::size_t place : {bytes.size() / 3, bytes.size() - 17, bytes.size() - 3}) {
    std::string other = bytes;
    other[place] = static_cast<char>(other[place] ^ 1);
    EXPECT_EQ(refusal(other),
              "the checkpoint is damaged: its checksum is not that of its content; nothing was "
              "changed")
        << place;
  }
}

TEST_F(CheckpointFiles, OfAnotherFormatOrPrecisionAreRefused) {
  const std::string bytes = read_text(path);
  std::string other = bytes;
  other.replace(other.find("format 2"), 8, "format 3");
  EXPECT_EQ(
      refusal(other),
      "this program reads \"percolith checkpoint, format 2, reals of 8 bytes\", the file says "
      "\"percolith checkpoint, format 3, reals of 8 bytes\"; nothing was changed");
  other = bytes;
  other.replace(other.find("of 8"), 4, "of 4");
  EXPECT_NE(refusal(other).find("reals of 4 bytes"), std::string::npos);
  other = bytes;
  std::swap(other[other.find('\n') + 1], other[other.find('\n') + 4]);
  EXPECT_NE(refusal(other).find("orders the bytes of numbers otherwise"), std::string::npos);
  EXPECT_NE(refusal("time_s,step\n0,0\n").find("this is no checkpoint"), std::string::npos);
}

TEST_F(CheckpointFiles, OfAnotherOriginAreRefused) {
  CheckpointOrigin present = origin;
  present.case_file = "elsewhere/case.toml";
  EXPECT_EQ(foreign(present), "no error");
  present.mesh_hash = "other";
  EXPECT_NE(foreign(present).find("another mesh than that of mesh.file"), std::string::npos);
  present = origin;
  present.case_hash = "other";
  EXPECT_NE(foreign(present).find("another case than resolved.toml"), std::string::npos);
  present = origin;
  present.program = "percolith 2";
  EXPECT_NE(foreign(present).find("It was written by\npercolith 1\nand this is\npercolith 2"),
            std::string::npos);
}

TEST_F(CheckpointFiles, AFailureLeavesTheOneBefore) {
  const std::string before = read_text(path);
  EXPECT_THROW(write_checkpoint(path, origin,
                                [&](StateArchive& archive) {
                                  archive("values", values);
                                  throw std::runtime_error("no more");
                                }),
               std::runtime_error);
  EXPECT_EQ(read_text(path), before);
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

TEST_F(CheckpointFiles, ThatAreNotThereAreAFileError) {
  EXPECT_THROW(CheckpointFile(folder / "none.bin"), FileError);
}

}  // namespace
}  // namespace percolith::io
