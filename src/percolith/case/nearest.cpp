// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/nearest.hpp"

#include <algorithm>
#include <numeric>

namespace percolith::case_file {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::string_view nearest_name(std::string_view word, const std::vector<std::string_view>& names) {
  constexpr std::size_t longest_word = 64;
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 2);
  for (const std::string_view name : names) {
    if (word.size() > longest_word) {
      break;
    }
    const std::size_t distance = edit_distance(word, name);
    const bool shares_something = distance < std::max(word.size(), name.size());
    if (shares_something &&
        (distance < best_distance || (best.empty() && distance == best_distance))) {
      best = name;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace percolith::case_file
