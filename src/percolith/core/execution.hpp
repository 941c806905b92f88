// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/simd.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace percolith {

/// Where kernels run: one element after the other on one thread (the reference), or in vector
/// lanes on several threads. Both give the same bits.
enum class Backend { serial, host };

/// A kernel that may be called with several elements at once says so by this member.
template <class Kernel>
concept VectorKernel = requires {
  requires Kernel::vectorised;
};

/// What a loop with `LaneSums` came to.
template <std::size_t Count>
struct LaneTotals {
  std::array<double, Count> sum{};
  double peak = 0.0;  ///< never below zero
};

/// Runs loops and keeps the wall time spent in each.
///
/// A kernel is a small function object that holds views by value; `kernel(lane)` handles the
/// elements of the lane, writes only what belongs to them, and reads nothing that the same loop
/// writes. So the result does not depend on the number of threads.
class Execution {
public:
  /// Seconds by the name of the loop.
  using WallTimes = std::map<std::string, double, std::less<>>;

  explicit Execution(Backend backend = Backend::host, int threads = 1)
      : backend_(backend), threads_(backend == Backend::serial ? 1 : threads) {}

  [[nodiscard]] int threads() const { return threads_; }
  [[nodiscard]] Backend backend() const { return backend_; }

  /// Calls `kernel` for the elements 0 .. n-1. For a vector kernel the arrays behind it are padded
  /// to whole blocks, and the padding is handled too.
  template <class Kernel>
  void for_each(std::string_view name, std::int32_t n, const Kernel& kernel) {
    const auto start = std::chrono::steady_clock::now();
    if constexpr (VectorKernel<Kernel>) {
      if (backend_ == Backend::host) {
        run<VectorLane>(padded(n), kernel);
      } else {
        run<ScalarLane>(padded(n), kernel);
      }
    } else {
      run<ScalarLane>(n, kernel);
    }
    book(name, start);
  }

  /// Calls `kernel(lane, end)` for the elements 0 .. n-1 in chunks of `length`, from the first of
  /// the lane on: for kernels that pick the elements that need work and fill registers with them.
  template <class Kernel>
  void for_each_chunk(std::string_view name, std::int32_t n, std::int32_t length,
                      const Kernel& kernel) {
    const auto start = std::chrono::steady_clock::now();
    if (backend_ == Backend::host) {
      run_chunks<VectorLane>(n, length, kernel);
    } else {
      run_chunks<ScalarLane>(n, length, kernel);
    }
    book(name, start);
  }

  /// Like `for_each` for a kernel that also sums: `kernel(lane, sums)` adds to a `LaneSums`.
  /// The sums run over chunks of fixed length and so do not depend on the number of threads.
  template <std::size_t Count, class Kernel>
  LaneTotals<Count> sum_each(std::string_view name, std::int32_t n, const Kernel& kernel) {
    const auto start = std::chrono::steady_clock::now();
    LaneTotals<Count> totals;
    if constexpr (VectorKernel<Kernel>) {
      totals = backend_ == Backend::host ? run_sums<Count, VectorLane>(padded(n), kernel)
                                         : run_sums<Count, ScalarLane>(padded(n), kernel);
    } else {
      totals = run_sums<Count, ScalarLane>(n, kernel);
    }
    book(name, start);
    return totals;
  }

  /// Sum of `term(i)` over 0 .. n-1 in blocks of fixed length: the same bits for any number of
  /// threads.
  template <class Term>
  [[nodiscard]] double sum(std::int32_t n, const Term& term) const {
    constexpr std::int32_t length = 1024;
    const std::int32_t blocks = (n + length - 1) / length;
    std::vector<double> partial(static_cast<std::size_t>(blocks));
#pragma omp parallel for schedule(static) num_threads(threads_) if (n > smallest_parallel)
    for (std::int32_t b = 0; b < blocks; ++b) {
      const std::int32_t end = b + 1 < blocks ? (b + 1) * length : n;
      double total = 0.0;
      for (std::int32_t i = b * length; i < end; ++i) {
        total += term(i);
      }
      partial[static_cast<std::size_t>(b)] = total;
    }
    double total = 0.0;
    for (const double part : partial) {
      total += part;
    }
    return total;
  }

  /// Adds the time since `start` to the account of `name`.
  void book(std::string_view name, std::chrono::steady_clock::time_point start) {
    auto found = wall_time_.find(name);
    if (found == wall_time_.end()) {
      found = wall_time_.emplace(name, 0.0).first;
    }
    found->second +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  /// Seconds spent under each name so far.
  [[nodiscard]] const WallTimes& wall_time() const {
    return wall_time_;
  }

private:
  // Below this many elements starting the threads costs more than they save.
  static constexpr std::int32_t smallest_parallel = 4096;

  template <class Lane, class Kernel>
  void run(std::int32_t n, const Kernel& kernel) const {
#pragma omp parallel for schedule(static) num_threads(threads_) if (n > smallest_parallel)
    for (std::int32_t i = 0; i < n; i += Lane::width) {
      kernel(Lane{i});
    }
  }

  template <class Lane, class Kernel>
  void run_chunks(std::int32_t n, std::int32_t length, const Kernel& kernel) const {
#pragma omp parallel for schedule(static) num_threads(threads_) if (n > smallest_parallel)
    for (std::int32_t first = 0; first < n; first += length) {
      kernel(Lane{first}, std::min(n, first + length));
    }
  }

  template <std::size_t Count, class Lane, class Kernel>
  LaneTotals<Count> run_sums(std::int32_t n, const Kernel& kernel) {
    constexpr std::int32_t length = 512;
    const std::int32_t chunks = (n + length - 1) / length;
    partial_.resize(static_cast<std::size_t>(chunks) * (Count + 1));
#pragma omp parallel for schedule(static) num_threads(threads_) if (n > smallest_parallel)
    for (std::int32_t chunk = 0; chunk < chunks; ++chunk) {
      LaneSums<Count> sums;
      const std::int32_t end = std::min(n, (chunk + 1) * length);
      for (std::int32_t i = chunk * length; i < end; i += Lane::width) {
        kernel(Lane{i}, sums);
      }
      double* out = partial_.data() + static_cast<std::size_t>(chunk) * (Count + 1);
      for (std::size_t k = 0; k < Count; ++k) {
        out[k] = std::accumulate(sums.sum[k].begin(), sums.sum[k].end(), 0.0);
      }
      out[Count] = *std::max_element(sums.peak.begin(), sums.peak.end());
    }
    LaneTotals<Count> totals;
    for (const double* out = partial_.data(); out != partial_.data() + partial_.size();
         out += Count + 1) {
      for (std::size_t k = 0; k < Count; ++k) {
        totals.sum[k] += out[k];
      }
      totals.peak = std::max(totals.peak, out[Count]);
    }
    return totals;
  }

  Backend backend_;
  int threads_;
  std::vector<double> partial_;
  WallTimes wall_time_;
};

}  // namespace percolith
