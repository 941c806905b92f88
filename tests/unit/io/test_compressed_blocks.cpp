// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/compressed_blocks.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace percolith {
namespace {

constexpr std::size_t reals_per_block = io::block_size / sizeof(double);
// Bytes of a block that is stored: header and checksum, and a length for each part.
constexpr std::size_t stored(std::size_t bytes) {
  constexpr std::size_t most_of_a_part = 65535;
  return bytes + 6 + 5 * ((bytes + most_of_a_part - 1) / most_of_a_part);
}

std::vector<std::uint64_t> header(const std::string& packed) {
  std::uint64_t blocks = 0;
  std::memcpy(&blocks, packed.data(), sizeof blocks);
  std::vector<std::uint64_t> numbers(3 + blocks);
  std::memcpy(numbers.data(), packed.data(), numbers.size() * sizeof(std::uint64_t));
  return numbers;
}

// Compressed sizes of the blocks.
std::vector<std::uint64_t> block_sizes(const std::string& packed) {
  const std::vector<std::uint64_t> numbers = header(packed);
  return {numbers.begin() + 3, numbers.end()};
}

std::vector<double> unpacked(const std::string& packed, std::size_t count) {
  std::vector<double> values(count);
  auto* to = reinterpret_cast<Bytef*>(values.data());
  const auto* from = reinterpret_cast<const Bytef*>(packed.data()) + 8 * header(packed).size();
  uLongf room = count * sizeof(double);
  for (const std::uint64_t size : block_sizes(packed)) {
    uLongf got = room;
    if (uncompress(to, &got, from, size) != Z_OK) {
      return {};
    }
    to += got;
    room -= got;
    from += size;
  }
  EXPECT_EQ(room, 0U);
  EXPECT_EQ(reinterpret_cast<const char*>(from), packed.data() + packed.size());
  return values;
}

// Between 0 and 1, with every digit in use.
std::vector<double> random_reals(std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<double> values(count);
  std::generate(values.begin(), values.end(),
                [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; });
  return values;
}

std::string pack(const std::vector<double>& values) {
  return io::compress_blocks(std::as_bytes(std::span(values)), io::Content::reals);
}

TEST(CompressedBlocks, StoreRealsThatHardlyShrink) {
  const std::vector<double> values = random_reals(2 * reals_per_block + 1000);
  const std::string result = pack(values);
  EXPECT_EQ(header(result),
            (std::vector<std::uint64_t>{3, io::block_size, 8000, stored(io::block_size),
                                        stored(io::block_size), stored(8000)}));
  EXPECT_EQ(unpacked(result, values.size()), values);
  EXPECT_EQ(pack(values), result);
}

TEST(CompressedBlocks, PackEachBlockAsItIsWorth) {
  std::vector<double> values = random_reals(3 * reals_per_block);
  std::fill_n(values.begin() + reals_per_block, reals_per_block, 2.5);
  const std::string result = pack(values);
  const std::vector<std::uint64_t> sizes = block_sizes(result);
  ASSERT_EQ(sizes.size(), 3U);
  EXPECT_EQ(sizes[0], stored(io::block_size));
  EXPECT_LT(sizes[1], io::block_size / 4);
  EXPECT_EQ(sizes[2], stored(io::block_size));
  EXPECT_EQ(unpacked(result, values.size()), values);
}

TEST(CompressedBlocks, PackVectorsOfThePlaneWhoseThirdComponentIsNothing) {
  std::vector<double> values = random_reals(3 * reals_per_block);
  for (std::size_t i = 2; i < values.size(); i += 3) {
    values[i] = 0;
  }
  const std::string result = pack(values);
  for (const std::uint64_t size : block_sizes(result)) {
    EXPECT_LT(size, io::block_size * 3 / 4);
  }
  EXPECT_EQ(unpacked(result, values.size()), values);
}

TEST(CompressedBlocks, MayBeNone) {
  EXPECT_EQ(header(pack({})), (std::vector<std::uint64_t>{0, io::block_size, 0}));
}

}  // namespace
}  // namespace percolith
