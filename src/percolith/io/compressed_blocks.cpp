// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/compressed_blocks.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <new>
#include <vector>

namespace percolith::io {
namespace {

std::string compress_block(std::span<const std::byte> block) {
  uLongf size = compressBound(static_cast<uLong>(block.size()));
  std::string compressed(size, '\0');
  // Level 1: field values hardly shrink further, and higher levels take several times as long.
  const int status = compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
                               reinterpret_cast<const Bytef*>(block.data()),
                               static_cast<uLong>(block.size()), Z_BEST_SPEED);
  if (status != Z_OK) {
    throw std::bad_alloc();  // the only failure left when the bound is respected
  }
  compressed.resize(size);
  return compressed;
}

void append_number(std::string& text, std::uint64_t number) {
  text.append(reinterpret_cast<const char*>(&number), sizeof number);
}

}  // namespace

std::string compress_blocks(std::span<const std::byte> data) {
  const std::size_t count = (data.size() + block_size - 1) / block_size;
  std::vector<std::string> blocks(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t begin = i * block_size;
    blocks[i] = compress_block(data.subspan(begin, std::min(block_size, data.size() - begin)));
  }
  std::string result;
  append_number(result, count);
  append_number(result, block_size);
  append_number(result, data.size() % block_size);
  for (const std::string& block : blocks) {
    append_number(result, block.size());
  }
  for (const std::string& block : blocks) {
    result += block;
  }
  return result;
}

}  // namespace percolith::io
