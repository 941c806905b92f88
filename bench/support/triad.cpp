// SPDX-License-Identifier: BSD-3-Clause
#include "bench/support/triad.hpp"

#include <cstdint>
#include <vector>

#include "bench/support/measure.hpp"

namespace percolith::bench {

double triad_bandwidth(std::size_t bytes, int threads) {
  constexpr int passes = 40;
  const auto n = static_cast<std::int64_t>(bytes / (3 * sizeof(double)));
  std::vector<double> a(static_cast<std::size_t>(n), 0.0);
  std::vector<double> b(static_cast<std::size_t>(n), 1.0);
  std::vector<double> c(static_cast<std::size_t>(n), 2.0);
  double* const to = a.data();
  const double* const first = b.data();
  const double* const second = c.data();
  Best best;
  for (int pass = 0; pass < passes; ++pass) {
    const double factor = 1.0 + 1e-3 * pass;
    const Stopwatch watch;
#pragma omp parallel for simd schedule(static) num_threads(threads)
    for (std::int64_t i = 0; i < n; ++i) {
      to[i] = first[i] + factor * second[i];
    }
    best.add(watch.seconds());
  }
  return 4.0 * sizeof(double) * static_cast<double>(n) / best.value();
}

}  // namespace percolith::bench
