// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/hash.hpp"

#include <fmt/format.h>

#include <bit>

namespace percolith {
namespace {

constexpr std::uint64_t prime = 1099511628211ULL;

}  // namespace

void StateHash::add(std::span<const double> values) {
  for (const double value : values) {
    state_ = (state_ ^ std::bit_cast<std::uint64_t>(value)) * prime;
    // A multiplication moves no bit downwards: fold, so that high bits count too.
    state_ ^= state_ >> 32U;
  }
}

std::string StateHash::text() const {
  return fmt::format("{:016x}", state_);
}

void ByteHash::add(std::string_view bytes) {
  for (const char byte : bytes) {
    state_ = (state_ ^ static_cast<unsigned char>(byte)) * prime;
  }
}

std::string ByteHash::text() const {
  return fmt::format("{:016x}", state_);
}

}  // namespace percolith
