// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/case.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace percolith::case_file {

/// A small valid case; a test replaces parts of it.
inline const std::string minimal_case = R"(format = 1

[mesh]
file = "strip.msh"

[model]
gravity = 0

[material.rock]
regions = ["rock"]
permeability = "2e-13 m2"
porosity = 0.1

[boundary.left]
groups = ["left"]
pressure = "100 kPa"

[time]
end = "1 hour"
)";

/// Reads a text as `case.toml`.
inline Case read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return read_case_text(text, "case.toml", overrides);
}

/// The minimal case with more text after it.
inline Case read_with(const std::string& more, const std::vector<std::string>& overrides = {}) {
  return read(minimal_case + more, overrides);
}

/// The message of the error that reading gives; "" where there is none.
inline std::string error_of(const std::string& text,
                            const std::vector<std::string>& overrides = {}) {
  try {
    (void)read(text, overrides);
  } catch (const InputErrors& errors) {
    return errors.what();
  }
  return {};
}

/// As error_of, for the minimal case with more text after it. That text begins on line 20.
inline std::string error_with(const std::string& more,
                              const std::vector<std::string>& overrides = {}) {
  return error_of(minimal_case + more, overrides);
}

/// As error_of, for the minimal case with options set.
inline std::string error_set(const std::vector<std::string>& overrides) {
  return error_of(minimal_case, overrides);
}

}  // namespace percolith::case_file
