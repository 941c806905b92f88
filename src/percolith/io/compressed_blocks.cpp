// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/compressed_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <new>

namespace percolith::io {
namespace {

// A zlib compressor that keeps its memory from block to block.
class Compressor {
public:
  explicit Compressor(Content content) {
    // The digits of real numbers hardly ever repeat, so that looking for more than runs takes
    // twice the time for a few per cent; higher levels than 1 take several times as long.
    const int strategy = content == Content::reals ? Z_RLE : Z_DEFAULT_STRATEGY;
    if (deflateInit2(&stream_, Z_BEST_SPEED, Z_DEFLATED, MAX_WBITS, MAX_MEM_LEVEL, strategy) !=
        Z_OK) {
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

}  // namespace

std::string compress_blocks(std::span<const std::byte> data, Content content) {
  Compressor compressor(content);
  std::string header;
  append_number(header, (data.size() + block_size - 1) / block_size);
  append_number(header, block_size);
  append_number(header, data.size() % block_size);
  std::string blocks;
  for (std::size_t begin = 0; begin < data.size(); begin += block_size) {
    const auto block = data.subspan(begin, std::min(block_size, data.size() - begin));
    append_number(header, compressor.append(block, blocks));
  }
  return header + blocks;
}

}  // namespace percolith::io
