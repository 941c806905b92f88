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
                      "than the 1e-7 m2 of coarse gravel. Is that meant? A number without a unit "
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

TEST(Plausibility, AToughnessIsNoEnergy) {
  EXPECT_EQ(
      warnings_with({{"mode_1_energy = 10\n", "mode_1_energy = 1e6\n"}}),
      Warnings{"case.toml:20:17: warning: material.rock.mode_1_energy = 1000000 is 1e+06 J/m2, "
               "more than the 1e5 J/m2 of the toughest rock. Is that meant? It is an energy: "
               "of a toughness K it is K^2 (1 - nu^2)/E in plane strain, for K = 1e+06 Pa "
               "m^(1/2) here 18.8 J/m2"});
}

TEST(Plausibility, AperturesWithoutTheirUnitAreDoubted) {
  EXPECT_EQ(warnings_with({{"\"0.1 mm\"", "0.1"}}),
            Warnings{"case.toml:24:20: warning: new_cracks.initial_aperture = 0.1 is 0.1 m, more "
                     "than the 20 mm of a wide fissure. Is that meant? A number without a unit is "
                     "in m; 0.1 mm is written \"0.1 mm\""});
}

TEST(Plausibility, RatesOfPumpsAreDoubted) {
  const auto pumped = [](const std::string& rate) {
    return warnings_with(
        {{"[time]", "[source.pump]\npoint = [0, 0]\nrate = " + rate + "\n\n[time]"}});
  };
  EXPECT_EQ(pumped("60"),
            Warnings{"case.toml:38:8: warning: source.pump.rate = 60 is 60 m2/s, more than the 1 "
                     "m2/s of the largest pumps. Is that meant? A number without a unit is in "
                     "m2/s; 60 l/s/m is written \"60 l/s/m\""});
  EXPECT_EQ(pumped("{ times = [0, 1, 2], values = [0, -2, 1] }").size(), 1u);
  EXPECT_TRUE(pumped("0.06").empty());
}

TEST(Plausibility, IntervalsBeyondTheEndAreToldOf) {
  EXPECT_EQ(warnings_with({{"end = \"10 ms\"\n", "end = \"10 ms\"\n\n[output]\ninterval = 1\n"}}),
            Warnings{"case.toml:40:12: warning: output.interval = 1 is longer than the run, which "
                     "ends at time.end = 0.01 s: only its first and its last state are written"});
}

TEST(Plausibility, LoadsWithoutTheirUnitAreDoubted) {
  EXPECT_EQ(warnings_with({{"\"1 MPa\"", "1"}}),
            Warnings{"case.toml:33:12: warning: boundary.wall.pressure = 1 is 1 Pa, less than the "
                     "100 Pa of 1 cm of water. Is that meant? A number without a unit is in Pa; 1 "
                     "MPa is written \"1 MPa\""});
  EXPECT_TRUE(warnings_with({{"\"1 MPa\"", "0"}}).empty());
}

/// The coupled case under in-situ stress that its base bears.
Warnings warnings_under(const std::string& stresses, const std::string& model = "") {
  return warnings_with({{"gravity = 0\n", "gravity = 0\n" + model + "[in_situ]\n" + stresses}});
}

TEST(Plausibility, SignsAndUnitsOfInSituStressAreDoubted) {
  EXPECT_EQ(warnings_under("stress_yy = \"3 MPa\"\n"),
            Warnings{"case.toml:10:13: warning: in_situ.stress_yy = \"3 MPa\" is tension of 3e+06 "
                     "Pa. Is that meant? Stresses are positive in tension; compression has a minus "
                     "sign"});
  EXPECT_EQ(warnings_under("stress_yy = -3\n"),
            Warnings{"case.toml:10:13: warning: in_situ.stress_yy = -3 is -3 Pa, less than the 100 "
                     "Pa of 1 cm of water. Is that meant? A number without a unit is in Pa; -3 MPa "
                     "is written \"-3 MPa\""});
  EXPECT_EQ(warnings_under("gradient_yy = -2e4\n"),
            Warnings{"case.toml:10:15: warning: in_situ.gradient_yy = -20000 says that compression "
                     "falls with depth. Is that meant? Elevation counts upwards and stresses are "
                     "positive in tension: compression that grows with depth has a positive "
                     "gradient"});
  EXPECT_TRUE(warnings_under("stress_yy = \"-3 MPa\"\ngradient_yy = 2e4\n").empty());
}

TEST(Plausibility, InSituStressIsHeldAtSomeEdge) {
  const auto loose = [](const std::string& wall) {
    return warnings_with({{"gravity = 0\n", "gravity = 0\n[in_situ]\nstress_yy = -5e6\n"},
                          {"[boundary.base]\ngroups = [\"bottom\"]\nfixed = true\n", ""},
                          {"pressurised = true\n", wall}});
  };
  EXPECT_EQ(loose("pressurised = true\n"),
            Warnings{"case.toml:9:2: warning: in_situ is held by no boundary: the rock springs "
                     "apart when the run starts. A boundary with in_situ = true carries these "
                     "stresses on"});
  EXPECT_TRUE(loose("in_situ = true\n").empty());
  const Warnings borne =
      warnings_with({{"gravity = 0\n", "gravity = 0\n[in_situ]\nstress_yy = \"-1.05 MPa\"\n"},
                     {"[boundary.base]\ngroups = [\"bottom\"]\nfixed = true\n", ""}});
  EXPECT_TRUE(borne.empty()) << "by the fluid of 1 MPa at the wall";
  const auto free = [](const std::string& stresses, const std::string& pressure) {
    return warnings_with({{"gravity = 0\n", "gravity = 0\n[in_situ]\n" + stresses},
                          {"[boundary.base]\ngroups = [\"bottom\"]\nfixed = true\n", ""},
                          {"\"1 MPa\"", pressure}})
        .size();
  };
  EXPECT_EQ(free("stress_zz = -5e6\n", "1e6"), 0u) << "has no effect on the motion";
  EXPECT_EQ(free("stress_yy = -5e6\n", "0"), 1u) << "a wall without pressure bears nothing";
  EXPECT_EQ(free("gradient_yy = 2e4\n", "1e6"), 0u) << "borne at some depth";
  EXPECT_EQ(free("gradient_yy = 2e4\n", "0"), 1u);
  EXPECT_EQ(free("stress_yy = -5e6\n[body.platen]\nregions = [\"rock\"]\nrigid = true\n", "1e6"),
            0u);
}

TEST(Plausibility, FluidThatIsKeptOutOfPressedJointsIsToldOf) {
  const std::string pressed = "stress_xx = \"-8 MPa\"\nstress_yy = \"-6 MPa\"\n";
  EXPECT_EQ(warnings_under(pressed),
            Warnings{"case.toml:6:2: warning: model.fluid_enters is not written, so fluid enters "
                     "broken joints alone. Under an in-situ compression of 6e+06 Pa, against "
                     "a tensile strength of 1e+07 Pa, the softening joints ahead of a "
                     "crack then stay dry and are pressed together: the rock resists more than its "
                     "fracture energy says. \"softening\" lets fluid into them; \"broken\" keeps "
                     "them dry"});
  EXPECT_TRUE(warnings_under(pressed + "gradient_yy = 2e4\n").empty()) << "not known at the cracks";
  EXPECT_TRUE(warnings_under(pressed, "fluid_enters = \"broken\"\n").empty());
  EXPECT_TRUE(warnings_under("stress_xx = \"-8 MPa\"\nstress_yy = \"-5 MPa\"\n").empty());
  EXPECT_FALSE(warnings_under(pressed + "stress_xy = \"0.9 MPa\"\n").empty());
  EXPECT_TRUE(warnings_under(pressed + "stress_xy = \"3 MPa\"\n").empty());
}

TEST(Plausibility, RocksAreNotDoubted) {
  EXPECT_TRUE(warnings_with({}).empty());
  EXPECT_TRUE(
      warnings_with({{"\"50 GPa\"", "\"1 MPa\""}, {"2700", "500"}, {"1e-15", "1e-7"}}).empty());
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
