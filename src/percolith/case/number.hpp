// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/case/key_locations.hpp"
#include "percolith/case/node.hpp"
#include "percolith/case/option.hpp"
#include "percolith/case/problems.hpp"
#include "percolith/case/units.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace percolith::case_file {

/// What reading takes besides the text: units, where files lie, and where findings go.
struct Context {
  Units& units;
  std::filesystem::path directory;  ///< files named in the case are relative to it
  Problems& problems;
  KeyLocations& locations;
  /// Physics of the case as it is written, such as "seepage"; "" where there is none such.
  std::string_view physics = {};
};

/// Adds a problem with the value that stands in `node`.
void report(Context& context, const Node& node, const std::string& key, std::string reason,
            std::string allowed);

/// Reads a number, or a text with a number and a unit, as SI. A plain number is in `unit` where
/// that is not empty, else in the unit of `quantity`. Reports a wrong kind of value, a missing,
/// unknown or wrong unit, and a value out of bounds; nothing is returned then.
[[nodiscard]] std::optional<double> read_number(const Node& node, const std::string& key,
                                                const Quantity& quantity, Context& context,
                                                std::string_view unit = {});

/// What may stand for `quantity`: `a number in Pa, or a text with a unit such as "2 MPa"`.
[[nodiscard]] std::string allowed_number(const Quantity& quantity);

}  // namespace percolith::case_file
