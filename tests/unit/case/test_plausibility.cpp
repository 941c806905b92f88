// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/plausibility.hpp"

#include <gtest/gtest.h>

#include "unit/case/mechanics_case.hpp"

namespace percolith::case_file {
namespace {

using Warnings = std::vector<std::string>;

/// The coupled case with lines replaced by others.
Warnings warnings_with(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text = coupled_case;
  for (const auto& [from, to] : changes) {
    text.replace(text.find(from), from.size(), to);
  }
  return read(text).warnings;
}

TEST(Plausibility, ValuesWithoutTheirUnitsAreDoubted) {
  EXPECT_EQ(warnings_with({{"\"50 GPa\"", "50"}}),
            Warnings{"case.toml:15:17: warning: material.rock.young_modulus = 50 is 50 Pa, less "
                     "than the 1 MPa of a soft soil. Is that meant? A number without a unit is in "
                     "Pa; 50 GPa is written \"50 GPa\""});
  EXPECT_EQ(warnings_with({{"\"50 GPa\"", "50000"}}),
            Warnings{"case.toml:15:17: warning: material.rock.young_modulus = 50000 is 50000 Pa, "
                     "less than the 1 MPa of a soft soil. Is that meant? A number without a unit "
                     "is in Pa; 50000 MPa is written \"50000 MPa\""});
  EXPECT_EQ(warnings_with({{"2700", "2.7"}, {"1e-15", "10"}}),
            (Warnings{"case.toml:12:11: warning: material.rock.density = 2.7 is 2.7 kg/m3, outside "
                      "of the 500 to 10000 kg/m3 of rocks. Is that meant? A number without a unit "
                      "is in kg/m3; 2.7 g/cm3 is written \"2.7 g/cm3\"",
                      "case.toml:13:16: warning: material.rock.permeability = 10 is 10 m2, more "
                      "than the 1e-6 m2 of coarse gravel. Is that meant? A number without a unit "
                      "is in m2; 10 mdarcy is written \"10 mdarcy\""}));
  EXPECT_EQ(warnings_with({{"\"10 MPa\"", "10"}, {"\"20 MPa\"", "20"}}),
            (Warnings{"case.toml:17:20: warning: material.rock.tensile_strength = 10 is 10 Pa, "
                      "less than the 100 Pa of loose sand. Is that meant? A number without a unit "
                      "is in Pa; 10 MPa is written \"10 MPa\"",
                      "case.toml:18:12: warning: material.rock.cohesion = 20 is 20 Pa, less than "
                      "the 100 Pa of loose sand. Is that meant? A number without a unit is in Pa; "
                      "20 MPa is written \"20 MPa\""}));
}

TEST(Plausibility, ValuesWithAUnitAreDoubtedWithoutAdvice) {
  EXPECT_EQ(warnings_with({{"\"50 GPa\"", "\"50 kPa\""}}),
            Warnings{"case.toml:15:17: warning: material.rock.young_modulus = \"50 kPa\" is 50000 "
                     "Pa, less than the 1 MPa of a soft soil. Is that meant?"});
}

TEST(Plausibility, RocksAreNotDoubted) {
  EXPECT_TRUE(warnings_with({}).empty());
  EXPECT_TRUE(
      warnings_with({{"\"50 GPa\"", "\"1 MPa\""}, {"2700", "500"}, {"1e-15", "1e-6"}}).empty());
  EXPECT_TRUE(warnings_with({{"\"10 MPa\"", "0"}, {"mode_1_energy = 10\n", "mode_1_energy = 0\n"}})
                  .empty());
  // A problem without units.
  EXPECT_TRUE(
      warnings_with({{"1e-15", "1"}, {"[new_cracks]", "[fluid]\nviscosity = 1\n\n[new_cracks]"}})
          .empty());
}

TEST(Plausibility, LayersAreNotTurnedByMoreThanAFullTurn) {
  EXPECT_EQ(warnings_with({{"poisson_ratio = 0.25", "poisson_ratio = 0.25\nbedding_angle = 30\n"
                                                    "normal_young_modulus = \"40 GPa\""}}),
            Warnings{"case.toml:17:17: warning: material.rock.bedding_angle = 30 is 30 rad, more "
                     "than a full turn. Is that meant? A number without a unit is in rad; 30 deg "
                     "is written \"30 deg\""});
}

}  // namespace
}  // namespace percolith::case_file
