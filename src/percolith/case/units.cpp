// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/units.hpp"

#include "percolith/core/error.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

namespace percolith::case_file {

namespace {

struct UnitDeleter {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using UnitHandle = std::unique_ptr<ut_unit, UnitDeleter>;

struct ConverterDeleter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};

struct OwnSymbol {
  const char* symbol;
  const char* unit;
};
/// A symbol takes SI prefixes: "P" and "D" bring cP and mD.
constexpr std::array<OwnSymbol, 3> own_symbols{{{"P", "poise"}, {"D", "darcy"}, {"deg", "degree"}}};

struct KnownDimension {
  std::string_view unit;
  Dimension dimension;
};
constexpr std::array<KnownDimension, 18> known_dimensions{{
    {"1", {"plain number", "10 %"}},
    {"m", {"length", "5 cm"}},
    {"m2", {"permeability", "10 mdarcy"}},
    {"m3", {"intrinsic transmissivity", "1e-12 m3"}},
    {"s", {"time", "3 hour"}},
    {"m/s", {"flux", "1e-8 m/s"}},
    {"m/s", {"velocity", "5 cm/s"}},
    {"m/s2", {"acceleration", "9.81 m/s2"}},
    {"m2/s", {"rate per metre of thickness", "1e-2 m2/s"}},
    {"Pa", {"pressure", "2 MPa"}},
    {"Pa s", {"viscosity", "1 cP"}},
    {"kg/m3", {"density", "1 g/cm3"}},
    {"rad", {"angle", "30 deg"}},
    {"J/m2", {"fracture energy", "10 J/m2"}},
    {"N/m", {"force per metre of thickness", "5 kN/m"}},
    {"Pa/m", {"stress per length", "25 kPa/m"}},
    {"kg/(m s)", {"nodal viscosity", "1e4 kg/(m s)"}},
    {"m/(Pa s)", {"exchange coefficient", "2e-7 m/(Pa s)"}},
}};

/// What to say of a pressure times the root of a length where an energy is wanted.
std::string toughness_advice(std::string_view unit, std::string_view si_unit) {
  constexpr std::array<std::string_view, 5> roots{"sqrt", "\u221a", "0.5", "1/2", ".5"};
  const bool has_root = std::any_of(roots.begin(), roots.end(), [&](std::string_view root) {
    return unit.find(root) != std::string_view::npos;
  });
  return si_unit == "J/m2" && has_root && unit.find("Pa") != std::string_view::npos
             ? "; of a toughness K the energy is K^2 (1 - nu^2)/E in plane strain"
             : "";
}

/// What the same letters are in other cases: "mD" and "MD" of "md", those with more capitals first.
/// Empty for texts with so many letters that no slip of a single unit is behind them.
std::vector<std::string> other_cases(std::string_view unit) {
  constexpr std::size_t many = 6;
  std::vector<std::size_t> letters;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (std::isalpha(static_cast<unsigned char>(unit[i])) != 0) {
      letters.push_back(i);
    }
  }
  std::vector<std::string> variants;
  const std::size_t choices = letters.size() > many ? 0 : std::size_t{1} << letters.size();
  for (std::size_t choice = choices; choice-- > 0;) {
    std::string variant(unit);
    for (std::size_t i = 0; i < letters.size(); ++i) {
      char& letter = variant[letters[i]];
      const bool is_capital = ((choice >> (letters.size() - 1 - i)) & 1U) != 0;
      letter = static_cast<char>(is_capital ? std::toupper(static_cast<unsigned char>(letter))
                                            : std::tolower(static_cast<unsigned char>(letter)));
    }
    if (variant != unit) {
      variants.push_back(std::move(variant));
    }
  }
  return variants;
}

}  // namespace

Dimension dimension_of(std::string_view si_unit, std::string_view name) {
  for (const KnownDimension& known : known_dimensions) {
    if (known.unit == si_unit && (name.empty() || known.dimension.name == name)) {
      return known.dimension;
    }
  }
  return {si_unit, {}};
}

struct Units::Database {
  struct SystemDeleter {
    void operator()(ut_system* loaded) const { ut_free_system(loaded); }
  };
  std::unique_ptr<ut_system, SystemDeleter> system;

  void load();
  [[nodiscard]] UnitHandle parse(std::string_view unit) const {
    return UnitHandle(ut_parse(system.get(), std::string(unit).c_str(), UT_UTF8));
  }
  [[nodiscard]] std::string suggestion(std::string_view unit, std::string_view si_unit) const;
};

// Units with the letters of `unit` in other cases that can be had in `si_unit`, as a question.
std::string Units::Database::suggestion(std::string_view unit, std::string_view si_unit) const {
  const UnitHandle to = parse(si_unit);
  std::string text;
  for (const std::string& variant : other_cases(unit)) {
    const UnitHandle from = parse(variant);
    if (from && to && ut_are_convertible(from.get(), to.get()) != 0) {
      text += fmt::format("{}\"{}\"", text.empty() ? "; did you mean " : " or ", variant);
    }
  }
  return text;
}

void Units::Database::load() {
  ut_set_error_message_handler(ut_ignore);
  system.reset(ut_read_xml(nullptr));
  if (!system) {
    throw FileError("cannot read the unit database of UDUNITS-2; install the package libudunits2-0 "
                    "or set UDUNITS2_XML_PATH");
  }
  for (const OwnSymbol& own : own_symbols) {
    const UnitHandle unit = parse(own.unit);
    if (!unit || ut_map_symbol_to_unit(own.symbol, UT_UTF8, unit.get()) != UT_SUCCESS) {
      throw FileError(fmt::format("the unit database of UDUNITS-2 has no unit \"{}\"", own.unit));
    }
  }
}

Units::Units() : database_(std::make_unique<Database>()) {}
Units::~Units() = default;

Units::Converted Units::convert(double value, std::string_view unit, std::string_view si_unit,
                                std::string_view dimension) {
  if (unit == si_unit) {
    return {value, {}};
  }
  std::string misread = misread_unit(unit);
  if (!misread.empty()) {
    return {std::nullopt, misread + toughness_advice(unit, si_unit)};
  }
  if (!database_->system) {
    database_->load();
  }
  const UnitHandle from = database_->parse(unit);
  if (!from) {
    return {std::nullopt,
            fmt::format("unknown unit \"{}\"{}{}", unit, database_->suggestion(unit, si_unit),
                        toughness_advice(unit, si_unit))};
  }
  const UnitHandle to = database_->parse(si_unit);
  if (!to || ut_are_convertible(from.get(), to.get()) == 0) {
    return {std::nullopt,
            si_unit == "1"
                ? fmt::format("the unit \"{}\" has a dimension, which the option has not", unit)
                : fmt::format("the unit \"{}\" is not one of {}{}", unit,
                              dimension_of(si_unit, dimension).name,
                              database_->suggestion(unit, si_unit))};
  }
  const std::unique_ptr<cv_converter, ConverterDeleter> converter(
      ut_get_converter(from.get(), to.get()));
  const double converted = converter ? cv_convert_double(converter.get(), value) : std::nan("");
  if (std::isnan(converted) || std::isinf(converted) != std::isinf(value)) {
    return {std::nullopt, fmt::format("the unit \"{}\" gives no number in {}", unit, si_unit)};
  }
  return {converted, {}};
}

}  // namespace percolith::case_file
