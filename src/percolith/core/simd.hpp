// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/device.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#if !defined(__CUDACC__)
#include <experimental/simd>
#if defined(__AVX512F__)
#include <immintrin.h>
#endif
#endif

// The only place that knows how the host packs several elements into one register. A kernel sees
// a lane: the number of its first element and the type its reals have.
namespace percolith {

/// Elements in one block of a block-wise array (AoSoA).
inline constexpr std::int32_t block_width = 8;

/// Smallest multiple of the block width that is not below `n`.
PERCOLITH_DEVICE std::int32_t padded(std::int32_t n) {
  return (n + block_width - 1) / block_width * block_width;
}

/// Asks for the memory at `place` ahead of its use; never changes a result. A loop that visits most
/// of an array in order, but not quite, is too irregular for the processor to do so by itself.
PERCOLITH_DEVICE void prefetch(const double* place) {
#if !defined(__CUDA_ARCH__)
  __builtin_prefetch(place);
#else
  static_cast<void>(place);
#endif
}

/// How far ahead, in entries of a per-corner array: further than most neighbours in the mesh are
/// apart in memory, near enough for the caches to keep it (docs/performance.md).
inline constexpr std::int32_t prefetch_distance = 6144;

/// One element at a time: the serial reference, and a thread of a GPU.
struct ScalarLane {
  using Real = double;
  static constexpr std::int32_t width = 1;
  std::int32_t first;

  PERCOLITH_DEVICE static Real load(const double* from) { return *from; }
  PERCOLITH_DEVICE static void store(double* to, Real value) { *to = value; }
  PERCOLITH_DEVICE static Real gather(const double* from, const std::int32_t* slot) {
    return from[*slot];
  }
  PERCOLITH_DEVICE static void scatter(double* to, const std::int32_t* slot, Real value) {
    to[*slot] = value;
  }
  /// `from[code ^ flip]`, negative where `code` has the bit `sign`.
  PERCOLITH_DEVICE static Real gather_signed(const double* from, const std::int32_t* code,
                                             std::int32_t flip, std::int32_t sign) {
    const double value = from[*code ^ flip];
    return (*code & sign) != 0 ? -value : value;
  }
  /// `value(i)` for every element i of the lane, counted from its first.
  template <class Value>
  PERCOLITH_DEVICE static Real generate(const Value& value) {
    return value(0);
  }
};

PERCOLITH_DEVICE double select(bool condition, double yes, double no) {
  return condition ? yes : no;
}
PERCOLITH_DEVICE double square_root(double x) {
  return std::sqrt(x);
}
PERCOLITH_DEVICE bool any(bool condition) {
  return condition;
}

#if !defined(__CUDACC__)
/// As many consecutive elements as one register holds; never across the border of a block.
struct VectorLane {
  using Real = std::experimental::native_simd<double>;
  static constexpr std::int32_t width = static_cast<std::int32_t>(Real::size());
  static_assert(block_width % width == 0);
  std::int32_t first;

  static Real load(const double* from) { return Real(from, std::experimental::element_aligned); }
  static void store(double* to, Real value) {
    value.copy_to(to, std::experimental::element_aligned);
  }
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
  static Real gather(const double* from, const std::int32_t* slot) {
    return Real(_mm512_i32gather_pd(eight(slot), from, sizeof(double)));
  }
  static void scatter(double* to, const std::int32_t* slot, Real value) {
    _mm512_i32scatter_pd(to, eight(slot), static_cast<__m512d>(value), sizeof(double));
  }
  static Real gather_signed(const double* from, const std::int32_t* code, std::int32_t flip,
                            std::int32_t sign) {
    const __m256i codes = eight(code);
    const __m512d value =
        _mm512_i32gather_pd(_mm256_xor_si256(codes, _mm256_set1_epi32(flip)), from, sizeof(double));
    const __mmask8 negative = _mm256_test_epi32_mask(codes, _mm256_set1_epi32(sign));
    return Real(_mm512_mask_xor_pd(value, negative, value, _mm512_set1_pd(-0.0)));
  }
#else
  static Real gather(const double* from, const std::int32_t* slot) {
    return Real([&](auto element) { return from[slot[element]]; });
  }
  static void scatter(double* to, const std::int32_t* slot, Real value) {
    for (std::size_t element = 0; element < Real::size(); ++element) {
      to[slot[element]] = value[element];
    }
  }
  static Real gather_signed(const double* from, const std::int32_t* code, std::int32_t flip,
                            std::int32_t sign) {
    return Real([&](auto element) {
      const double value = from[code[element] ^ flip];
      return (code[element] & sign) != 0 ? -value : value;
    });
  }
#endif
  template <class Value>
  static Real generate(const Value& value) {
    return Real([&](auto element) { return value(static_cast<std::int32_t>(element)); });
  }

#if defined(__AVX512F__)
private:
  static __m256i eight(const std::int32_t* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  }
#endif
};

inline VectorLane::Real select(VectorLane::Real::mask_type condition, VectorLane::Real yes,
                               VectorLane::Real no) {
  std::experimental::where(condition, no) = yes;
  return no;
}
inline VectorLane::Real square_root(VectorLane::Real x) {
  return std::experimental::sqrt(x);
}
inline bool any(VectorLane::Real::mask_type condition) {
  return std::experimental::any_of(condition);
}
#if defined(__AVX512F__)
// One instruction each, and the same choice as below where both are zero or one is no number.
inline VectorLane::Real larger(VectorLane::Real a, VectorLane::Real b) {
  return VectorLane::Real(_mm512_max_pd(static_cast<__m512d>(a), static_cast<__m512d>(b)));
}
inline VectorLane::Real smaller(VectorLane::Real a, VectorLane::Real b) {
  return VectorLane::Real(_mm512_min_pd(static_cast<__m512d>(a), static_cast<__m512d>(b)));
}
#endif
#endif

/// `a` where it is greater, else `b`: also where either is no number.
template <class Real>
PERCOLITH_DEVICE Real larger(Real a, Real b) {
  return select(a > b, a, b);
}
template <class Real>
PERCOLITH_DEVICE Real smaller(Real a, Real b) {
  return select(a < b, a, b);
}
template <class Real>
PERCOLITH_DEVICE Real magnitude(Real a) {
  return select(a < Real(0.0), -a, a);
}

/// Sums and a maximum that the elements of a loop add to, one place a lane of a block, so that
/// their order does not depend on the width of a register.
template <std::size_t Count>
struct LaneSums {
  std::array<std::array<double, block_width>, Count> sum{};
  std::array<double, block_width> peak{};

  template <class Lane>
  PERCOLITH_DEVICE void add(std::size_t which, Lane lane, typename Lane::Real value) {
    double* place = sum[which].data() + lane.first % block_width;
    Lane::store(place, Lane::load(place) + value);
  }
  template <class Lane>
  PERCOLITH_DEVICE void raise(Lane lane, typename Lane::Real value) {
    double* place = peak.data() + lane.first % block_width;
    Lane::store(place, larger(Lane::load(place), value));
  }
};

}  // namespace percolith
