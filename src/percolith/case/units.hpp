// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace percolith::case_file {

/// What a quantity measured in an SI unit is called, and a unit as users write it.
struct Dimension {
  std::string_view name;     ///< "pressure"
  std::string_view example;  ///< "2 MPa"
};

/// The dimension of a unit that options use, and that of the given name where several have the
/// unit; a unit unknown here is its own name.
[[nodiscard]] Dimension dimension_of(std::string_view si_unit, std::string_view name = {});

/// Converts values to SI units with UDUNITS-2 and a few units of the field that it lacks (cP, mD,
/// D, deg).
class Units {
public:
  Units();
  ~Units();
  Units(const Units&) = delete;
  Units& operator=(const Units&) = delete;

  /// The outcome of a conversion: a value, or the reason why there is none.
  struct Converted {
    std::optional<double> value;
    std::string reason;
  };
  /// `value` in `unit` as a value in `si_unit`, whose dimension has that name. The first conversion
  /// reads the unit database, and throws FileError where it cannot.
  [[nodiscard]] Converted convert(double value, std::string_view unit, std::string_view si_unit,
                                  std::string_view dimension = {});

private:
  struct Database;
  std::unique_ptr<Database> database_;
};

/// A number and the unit written after it, "" when there is none.
struct NumberWithUnit {
  double number = 0.0;
  std::string_view unit;
};

/// Splits a text such as "55 GPa"; nothing where it does not begin with a number. "inf", "+inf" and
/// "-inf" are numbers when they stand alone.
[[nodiscard]] std::optional<NumberWithUnit> split_number(std::string_view text);

/// Why UDUNITS would misread this unit, "" where it would not: it ignores the dot of a fractional
/// exponent (m^0.5 is 5 to it) and multiplies by any number that stands in a unit.
[[nodiscard]] std::string misread_unit(std::string_view unit);

}  // namespace percolith::case_file
