// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/case.hpp"
#include "percolith/case/documents.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using percolith::case_file::Case;
using percolith::case_file::Units;

Case read(std::string_view text, const std::vector<std::string>& overrides, Units& units) {
  return percolith::case_file::read_case_text(text, "case.toml", overrides,
                                              percolith::case_file::renamed_options(), units);
}

/// A case that is accepted must survive being written and read again.
void check_round_trip(const Case& accepted, Units& units) {
  const std::string text = percolith::case_file::resolved_toml(accepted.setup);
  try {
    const Case again = read(text, {}, units);
    if (again.setup == accepted.setup) {
      return;
    }
    std::cerr << "read again as another setup:\n" << text;
  } catch (const percolith::Error& error) {
    std::cerr << error.what() << "\nin\n" << text;
  }
  std::abort();
}

}  // namespace

/// Reads any text as a case file. The part after a zero byte is a `--set` of the command line. Only
/// errors that name what is wrong may come out.
// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Units units;
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = input.find('\0');
  std::vector<std::string> overrides;
  if (end != std::string_view::npos) {
    overrides.emplace_back(input.substr(end + 1));
  }
  try {
    check_round_trip(read(input.substr(0, end), overrides, units), units);
  } catch (const percolith::Error& error) {
    if (std::string_view(error.what()).empty()) {
      std::abort();
    }
  }
  return 0;
}
