// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

// How an option of the case file is declared. Each `describe` function lists the options of one
// struct by calling its visitor with the member and one of these descriptors; everything that
// knows options (reader, schema, reference page, resolved input) is such a visitor. The default of
// an option is the member's initialiser.
namespace percolith::case_file {

/// Whether a case file must give the option.
enum class Need { optional, required };

/// An interval of numbers; an infinite end that is included allows the value "inf" or "-inf".
struct Bounds {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_included = false;
  bool high_included = false;

  /// True for a number in the interval; never for one that is not a number.
  [[nodiscard]] bool contains(double value) const;
};

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr Bounds finite{-infinite, infinite, false, false};
inline constexpr Bounds finite_or_minus_infinite{-infinite, infinite, true, false};
inline constexpr Bounds positive{0.0, infinite, false, false};
inline constexpr Bounds positive_or_infinite{0.0, infinite, false, true};
inline constexpr Bounds not_negative{0.0, infinite, true, false};
inline constexpr Bounds not_negative_or_infinite{0.0, infinite, true, true};
inline constexpr Bounds fraction{0.0, 1.0, true, true};
inline constexpr Bounds positive_fraction{0.0, 1.0, false, true};
/// An angle from 0 up to, without, a right one.
inline constexpr Bounds slope_angle{0.0, 1.5707963267948966, true, false};

/// The interval in words, with the unit: `a finite number > 0 m2`, `0 <= value <= 1`,
/// `>= 0 m or inf`.
[[nodiscard]] std::string to_text(const Bounds& bounds, std::string_view unit);

/// A number with a unit, or several: the member may be a number, an optional number, a list, a
/// point, a tensor or a schedule. `unit` is the SI unit in the notation of UDUNITS, "1" for none.
/// `absent` says what it means not to give the option, where the
/// member's initialiser does not; `dimension`
/// says what is measured, where the unit alone would name another.
struct Quantity {
  std::string_view name;
  std::string_view unit;
  Bounds bounds;
  Need need = Need::optional;
  std::string_view help;
  std::string_view absent = {};
  std::string_view dimension = {};
};

/// A text, or a list of texts.
struct Text {
  std::string_view name;
  Need need = Need::optional;
  std::string_view help;
};

/// true or false.
struct Flag {
  std::string_view name;
  std::string_view help;
};

/// A whole number from `low` to `high`.
struct Count {
  std::string_view name;
  int low = 0;
  int high = 0;
  Need need = Need::optional;
  std::string_view help;
};

/// One of a few names, each standing for a value of an enumeration. `in_mechanics` is the only one
/// of them that mechanics has, and its default there; "" where it has them all.
template <class Enumeration>
struct Choice {
  struct Name {
    Enumeration value;
    std::string_view name;
  };
  std::string_view name;
  std::vector<Name> names;
  std::string_view help;
  std::string_view in_mechanics = {};
};

/// A table that exists once, `[name]`.
struct Table {
  std::string_view name;
  std::string_view help;
};

/// Tables the user names, `[name.NAME]`.
struct NamedTables {
  std::string_view name;
  std::string_view help;
};

/// `path.name`, or `name` where the path is empty.
[[nodiscard]] std::string join_key(const std::string& path, std::string_view name);

/// A name in double quotes.
[[nodiscard]] std::string quoted(std::string_view name);

/// The names, each in double quotes, parted by commas.
[[nodiscard]] std::string listed(const std::vector<std::string_view>& names);

}  // namespace percolith::case_file
