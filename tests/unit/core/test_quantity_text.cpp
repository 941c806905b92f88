// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/quantity_text.hpp"

#include <gtest/gtest.h>

namespace percolith {
namespace {

TEST(PressureText, HasThreeDigitsAndAUnitThatKeepsThemShort) {
  EXPECT_EQ(pressure_text(3.184e6), "3.18 MPa");
  EXPECT_EQ(pressure_text(-20e6), "-20 MPa");
  EXPECT_EQ(pressure_text(1.5e9), "1.5 GPa");
  EXPECT_EQ(pressure_text(999.96e3), "1 MPa");
  EXPECT_EQ(pressure_text(1500.0), "1.5 kPa");
  EXPECT_EQ(pressure_text(20.0), "20 Pa");
  EXPECT_EQ(pressure_text(0.0), "0 Pa");
}

}  // namespace
}  // namespace percolith
