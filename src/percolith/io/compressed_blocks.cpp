// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/compressed_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <new>

namespace percolith::io {
namespace {

// A zlib compressor that keeps its memory from block to block.
class Compressor {
public:
  Compressor(int level, int strategy) {
    if (deflateInit2(&stream_, level, Z_DEFLATED, MAX_WBITS, MAX_MEM_LEVEL, strategy) != Z_OK) {
      throw std::bad_alloc();
    }
  }
  ~Compressor() { deflateEnd(&stream_); }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  // Appends the compressed block to `result` and returns its size.
  std::size_t append(std::span<const std::byte> block, std::string& result) {
    deflateReset(&stream_);
    const std::size_t start = result.size();
    result.resize(start + deflateBound(&stream_, static_cast<uLong>(block.size())));
    // zlib reads through a pointer to values that are not const, and does not write there.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(block.data()));
    stream_.avail_in = static_cast<uInt>(block.size());
    stream_.next_out = reinterpret_cast<Bytef*>(result.data() + start);
    stream_.avail_out = static_cast<uInt>(result.size() - start);
    deflate(&stream_, Z_FINISH);  // cannot fail: the bound leaves room for the whole block
    result.resize(start + stream_.total_out);
    return stream_.total_out;
  }

private:
  z_stream stream_{};
};

void append_number(std::string& text, std::uint64_t number) {
  text.append(reinterpret_cast<const char*>(&number), sizeof number);
}

// Whether a code for single bytes, all that real numbers leave to a compressor but for runs, would
// save less than a tenth of the block.
bool hardly_shrinks(std::span<const std::byte> block) {
  constexpr double bits_worth_it = 0.9 * 8;  // of a byte
  // A counter that was written just before is slow to read, and the same byte often comes twice.
  std::array<std::array<std::uint32_t, 256>, 4> counts{};
  for (std::size_t i = 0; i < block.size(); ++i) {
    ++counts[i % counts.size()][std::to_integer<std::size_t>(block[i])];
  }
  const auto size = static_cast<double>(block.size());
  double bits = 0;
  for (std::size_t value = 0; value < counts[0].size(); ++value) {
    const double count = counts[0][value] + counts[1][value] + counts[2][value] + counts[3][value];
    bits += count > 0 ? count * std::log2(size / count) : 0.0;
  }
  return bits > bits_worth_it * size;
}

}  // namespace

std::string compress_blocks(std::span<const std::byte> data, Content content) {
  // The digits of real numbers hardly ever repeat, so that looking for more than runs takes twice
  // the time for a few per cent; higher levels than 1 take several times as long.
  const bool are_reals = content == Content::reals;
  Compressor packing(Z_BEST_SPEED, are_reals ? Z_RLE : Z_DEFAULT_STRATEGY);
  Compressor storing(Z_NO_COMPRESSION, Z_DEFAULT_STRATEGY);
  std::string header;
  append_number(header, (data.size() + block_size - 1) / block_size);
  append_number(header, block_size);
  append_number(header, data.size() % block_size);
  std::string blocks;
  for (std::size_t begin = 0; begin < data.size(); begin += block_size) {
    const auto block = data.subspan(begin, std::min(block_size, data.size() - begin));
    Compressor& chosen = are_reals && hardly_shrinks(block) ? storing : packing;
    append_number(header, chosen.append(block, blocks));
  }
  return header + blocks;
}

}  // namespace percolith::io
