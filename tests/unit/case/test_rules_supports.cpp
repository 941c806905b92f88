// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <set>
#include <utility>

#include "unit/case/mechanics_case.hpp"

namespace percolith::case_file {
namespace {

using Pair = std::pair<std::string, std::string>;

/// Everything a boundary may have in mechanics, with a value that acts.
const std::vector<Pair> supports{
    {"fixed", "true"},        {"roller", "true"},  {"displacement_x", "1"}, {"displacement_y", "1"},
    {"velocity_x", "1"},      {"velocity_y", "1"}, {"traction_x", "1"},     {"traction_y", "1"},
    {"normal_pressure", "1"}, {"in_situ", "true"}, {"absorbing", "true"},
};

/// The pairs that cannot stand together, the one that is blamed last.
const std::set<Pair> contradictions{
    {"fixed", "roller"},
    {"fixed", "displacement_x"},
    {"fixed", "displacement_y"},
    {"fixed", "velocity_x"},
    {"fixed", "velocity_y"},
    {"fixed", "traction_x"},
    {"fixed", "traction_y"},
    {"fixed", "normal_pressure"},
    {"fixed", "in_situ"},
    {"fixed", "absorbing"},
    {"roller", "displacement_x"},
    {"roller", "displacement_y"},
    {"roller", "velocity_x"},
    {"roller", "velocity_y"},
    {"roller", "normal_pressure"},
    {"roller", "absorbing"},
    {"displacement_x", "velocity_x"},
    {"displacement_x", "traction_x"},
    {"displacement_x", "absorbing"},
    {"displacement_y", "velocity_y"},
    {"displacement_y", "traction_y"},
    {"displacement_y", "absorbing"},
    {"velocity_x", "traction_x"},
    {"velocity_x", "absorbing"},
    {"velocity_y", "traction_y"},
    {"velocity_y", "absorbing"},
    {"normal_pressure", "traction_x"},
    {"normal_pressure", "traction_y"},
    {"normal_pressure", "in_situ"},
};

std::string setting(const Pair& support) {
  return "boundary.side." + support.first + " = " + support.second;
}

/// What is wrong with a boundary that has both.
std::string error_of_both(const Pair& one, const Pair& other) {
  return mechanics_error(
      {"boundary.side.groups=[\"side\"]", "in_situ.stress_xx=1", setting(one), setting(other)});
}

std::string contradiction(const Pair& blamed, const Pair& other) {
  return "--set: error: " + setting(blamed) + ": contradicts \"" + other.first +
         "\", which is given too; allowed: only one of \"" + other.first + "\", \"" + blamed.first +
         "\"";
}

TEST(Supports, EachMayStandAlone) {
  for (const Pair& support : supports) {
    EXPECT_EQ(error_of_both(support, support), "") << support.first;
  }
}

TEST(Supports, OnlySomeContradictEachOther) {
  for (std::size_t i = 0; i < supports.size(); ++i) {
    for (std::size_t k = i + 1; k < supports.size(); ++k) {
      const Pair& a = supports[i];
      const Pair& b = supports[k];
      std::string expected;
      if (contradictions.count({a.first, b.first}) > 0) {
        expected = contradiction(b, a);
      } else if (contradictions.count({b.first, a.first}) > 0) {
        expected = contradiction(a, b);
      }
      EXPECT_EQ(error_of_both(a, b), expected) << a.first << " and " << b.first;
    }
  }
}

/// The fluid that presses on a boundary is its load, as normal_pressure is.
TEST(Supports, FluidThatPressesStandsForTheTraction) {
  const std::vector<std::string> wall{"in_situ.stress_xx=1", "boundary.wall.pressurised=true"};
  for (const Pair& support : supports) {
    std::vector<std::string> overrides = wall;
    overrides.push_back("boundary.wall." + support.first + " = " + support.second);
    const bool moves =
        support.first.find("velocity") == 0 || support.first.find("displacement") == 0;
    if (moves || support.first == "absorbing") {
      EXPECT_EQ(coupled_error(overrides), "") << support.first;
    } else {
      EXPECT_THAT(coupled_error(overrides), testing::HasSubstr("contradicts \"")) << support.first;
    }
  }
}

TEST(Supports, ABoundaryHasOneAtLeast) {
  const std::string missing =
      "a support or a load is missing; allowed: one or more of \"fixed\", \"roller\", "
      "\"displacement_x\", \"displacement_y\", \"velocity_x\", \"velocity_y\", \"traction_x\", "
      "\"traction_y\", \"normal_pressure\", \"in_situ\", \"absorbing\"";
  EXPECT_EQ(mechanics_error({"boundary.base.fixed="}),
            "case.toml:21:11: error: boundary.base: " + missing);
  EXPECT_EQ(mechanics_error({"boundary.base.fixed=false"}),
            "case.toml:21:11: error: boundary.base: " + missing);
}

TEST(Supports, InSituTractionNeedsTheStress) {
  EXPECT_EQ(mechanics_error({"boundary.base.fixed=", "boundary.base.in_situ=true"}),
            "--set: error: boundary.base.in_situ = true: the case has no in-situ stress; allowed: "
            "a table [in_situ]");
}

TEST(Supports, ValuesAreFiniteAndHaveUnits) {
  for (const Pair& option : std::vector<Pair>{{"displacement_x", "m"},
                                              {"displacement_y", "m"},
                                              {"velocity_x", "m/s"},
                                              {"velocity_y", "m/s"},
                                              {"traction_x", "Pa"},
                                              {"traction_y", "Pa"},
                                              {"normal_pressure", "Pa"}}) {
    const std::string key = "boundary.side." + option.first;
    EXPECT_EQ(mechanics_error({"boundary.side.groups=[\"side\"]", key + " = inf"}),
              "--set: error: " + key + " = inf: out of range; allowed: a finite number of " +
                  option.second);
  }
  EXPECT_THAT(mechanics_error({"boundary.side.groups=[\"side\"]", "boundary.side.velocity_x=1 m"}),
              testing::HasSubstr("the unit \"m\" is not one of velocity; allowed: a number in m/s, "
                                 "or a text with a unit of velocity such as \"5 cm/s\""));
  EXPECT_EQ(mechanics_error({"boundary.base.fixed=1"}),
            "--set: error: boundary.base.fixed = 1: expects true or false, found a number; "
            "allowed: true, false");
}

}  // namespace
}  // namespace percolith::case_file
