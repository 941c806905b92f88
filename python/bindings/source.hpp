// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/runner/load_model.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

namespace percolith::python {

/// A case as the package hands it over: name of the file, its text where it is not to be read from
/// there, and options set on top as `path.to.key=value`.
inline runner::CaseSource make_source(const std::string& file,
                                      const std::optional<std::string>& text,
                                      const std::vector<std::string>& overrides) {
  return {file, text, overrides};
}

}  // namespace percolith::python
