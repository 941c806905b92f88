// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/units.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <string>

namespace percolith::case_file {
namespace {

double convert(double value, const char* unit, const char* si_unit) {
  Units units;
  const Units::Converted converted = units.convert(value, unit, si_unit);
  EXPECT_TRUE(converted.value.has_value()) << converted.reason;
  return converted.value.value_or(std::nan(""));
}

std::string reason(const char* unit, const char* si_unit) {
  Units units;
  const Units::Converted converted = units.convert(1.0, unit, si_unit);
  EXPECT_FALSE(converted.value.has_value());
  return converted.reason;
}

TEST(Units, ConvertsUnitsOfTheField) {
  EXPECT_EQ(convert(55.0, "GPa", "Pa"), 55e9);
  EXPECT_EQ(convert(3.0, "hour", "s"), 10800.0);
  EXPECT_EQ(convert(3.0, "h", "s"), 10800.0);
  EXPECT_EQ(convert(2.0, "day", "s"), 172800.0);
  EXPECT_DOUBLE_EQ(convert(10.0, "mdarcy", "m2"), 9.869233e-15);
  EXPECT_DOUBLE_EQ(convert(1.0, "g/cm3", "kg/m3"), 1000.0);
  EXPECT_DOUBLE_EQ(convert(1.0, "psi", "Pa"), 6894.75729316836);
  EXPECT_DOUBLE_EQ(convert(1.0, "l/min/m", "m2/s"), 1e-3 / 60.0);
  EXPECT_DOUBLE_EQ(convert(1.0, "mm/(MPa s)", "m/(Pa s)"), 1e-9);
  EXPECT_DOUBLE_EQ(convert(10.0, "%", "1"), 0.1);
  EXPECT_DOUBLE_EQ(convert(1.0, "m**2", "m2"), 1.0);
  EXPECT_DOUBLE_EQ(convert(1.0, "Pa^-1 s^-1 m", "m/(Pa s)"), 1.0);
}

TEST(Units, KnowsSymbolsThatUdunitsLacks) {
  EXPECT_DOUBLE_EQ(convert(1.0, "cP", "Pa s"), 1e-3);
  EXPECT_DOUBLE_EQ(convert(1.0, "D", "m2"), 9.869233e-13);
  EXPECT_DOUBLE_EQ(convert(1.0, "mD", "m2"), 9.869233e-16);
  EXPECT_DOUBLE_EQ(convert(180.0, "deg", "rad"), 3.141592653589793);
}

TEST(Units, RefusesAnotherDimension) {
  EXPECT_EQ(reason("kg", "Pa"), "the unit \"kg\" is not one of pressure");
  EXPECT_EQ(reason("m", "1"), "the unit \"m\" has a dimension, which the option has not");
  EXPECT_EQ(reason("parsnip", "Pa"), "unknown unit \"parsnip\"");
  EXPECT_EQ(reason("s since 2000-01-01", "s"),
            "the unit \"s since 2000-01-01\" holds a number that is not an exponent");
}

TEST(Units, LettersOfTheWrongCaseAreGuessed) {
  EXPECT_EQ(reason("md", "m2"),
            "the unit \"md\" is not one of permeability; did you mean \"MD\" or \"mD\"");
  EXPECT_EQ(reason("cp", "Pa s"), "unknown unit \"cp\"; did you mean \"cP\"");
  EXPECT_EQ(reason("mpa", "Pa"), "unknown unit \"mpa\"; did you mean \"MPa\" or \"mPa\"");
  EXPECT_EQ(reason("S", "s"), "the unit \"S\" is not one of time; did you mean \"s\"");
  EXPECT_EQ(reason("newfathoms", "m"), "unknown unit \"newfathoms\"");
}

TEST(Units, AToughnessInPlaceOfAnEnergyIsNamed) {
  EXPECT_EQ(reason("MPa m^0.5", "J/m2"),
            "the unit \"MPa m^0.5\" has a fractional exponent or factor; of a toughness K the "
            "energy is K^2 (1 - nu^2)/E in plane strain");
  EXPECT_EQ(
      reason("MPa sqrt(m)", "J/m2"),
      "unknown unit \"MPa sqrt(m)\"; of a toughness K the energy is K^2 (1 - nu^2)/E in plane "
      "strain");
}

TEST(Units, RefusesUnitsThatWouldBeMisread) {
  const std::string fractional = "has a fractional exponent or factor";
  EXPECT_EQ(reason("m^0.5", "m"), "the unit \"m^0.5\" " + fractional);
  EXPECT_EQ(reason("m0.5", "m"), "the unit \"m0.5\" " + fractional);
  EXPECT_EQ(reason("m.5", "m"), "the unit \"m.5\" " + fractional);
  EXPECT_EQ(reason("m^1/2", "m"), "the unit \"m^1/2\" " + fractional);
  EXPECT_EQ(reason("100 m", "m"), "the unit \"100 m\" holds a number that is not an exponent");
  EXPECT_EQ(reason("m/3", "m"), "the unit \"m/3\" holds a number that is not an exponent");
}

TEST(Units, GivesNoInfinityFromAFiniteValue) {
  Units units;
  EXPECT_EQ(units.convert(1e308, "km", "m").reason, "the unit \"km\" gives no number in m");
}

TEST(SplitNumber, PartsNumberAndUnit) {
  const auto split = split_number("  -1.5e-8  m/s ");
  ASSERT_TRUE(split.has_value());
  EXPECT_EQ(split->number, -1.5e-8);
  EXPECT_EQ(split->unit, "m/s");
  EXPECT_EQ(split_number("+3h")->unit, "h");
  EXPECT_EQ(split_number(".5")->number, 0.5);
  EXPECT_EQ(split_number("-inf")->number, -INFINITY);
  for (const char* const text :
       {"", " ", "GPa", "nan", "inf m", "infinity", "--1", "+-1", "0x", "e5"}) {
    const auto other = split_number(text);
    EXPECT_TRUE(!other || other->unit == "x") << text;
  }
}

TEST(Units, ConvertsBackAndForth) {
  Units units;
  const bool holds = rc::check("a value survives the way to another unit and back", [&] {
    const double value = *rc::gen::map(rc::gen::inRange(-1000000, 1000000),
                                       [](int i) { return static_cast<double>(i) * 1e-3; });
    const char* const unit = *rc::gen::element("kPa", "MPa", "bar", "psi", "atm");
    const double there = units.convert(value, "Pa", unit).value.value_or(std::nan(""));
    const double back = units.convert(there, unit, "Pa").value.value_or(std::nan(""));
    RC_ASSERT(std::abs(back - value) <= 1e-12 * std::abs(value));
  });
  EXPECT_TRUE(holds);
}

}  // namespace
}  // namespace percolith::case_file
