// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>

#include "unit/case/mechanics_case.hpp"
#include "unit/case/minimal_case.hpp"

namespace percolith::case_file {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(ReadingErrors, UnknownOptionNamesTheNearest) {
  EXPECT_EQ(error_with("ende = 3\n"),
            "case.toml:20:1: error: time.ende: unknown option; the nearest valid name is \"end\"; "
            "allowed: \"scheme\", \"end\", \"step\", \"initial_step\", \"maximum_step\", "
            "\"tolerance\", \"safety\", \"stop_ratio\"");
  EXPECT_THAT(error_with("[boundry.right]\ngroups = [\"r\"]\n"),
              StartsWith("case.toml:20:2: error: boundry: unknown option; the nearest valid name "
                         "is \"boundary\"; allowed: \"format\", "));
}

TEST(ReadingErrors, UnknownOptionFarFromAnyNameListsThemAll) {
  EXPECT_EQ(error_with("[mesh.xyzzyxyzzy]\n"),
            "case.toml:20:7: error: mesh.xyzzyxyzzy: unknown option; allowed: \"file\", "
            "\"element_size\"");
}

TEST(ReadingErrors, OptionInTheWrongTableNamesTheRightOnes) {
  EXPECT_THAT(
      error_with("viscosity = 1\n"),
      StartsWith("case.toml:20:1: error: time.viscosity: unknown option here; \"viscosity\" "
                 "belongs in [fluid]; allowed: "));
  EXPECT_THAT(error_with("pressure = 1\n"),
              HasSubstr("\"pressure\" belongs in [boundary.NAME], [source.NAME], [initial]"));
}

TEST(ReadingErrors, WhatConductsInAFractureIsNamed) {
  const std::string hint = "unknown option here; a fracture conducts by its aperture a, as a^3/12 "
                           "(cubic law): initial_aperture; transmissivity replaces that law; "
                           "allowed: \"groups\", \"initial_aperture\"";
  const std::string fault = "[fracture.fault]\ngroups = [\"f\"]\ninitial_aperture = 1e-4\n"
                            "exchange = 1e-9\n";
  EXPECT_THAT(error_with(fault + "permeability = 1e-12\n"),
              StartsWith("case.toml:24:1: error: fracture.fault.permeability: " + hint));
  EXPECT_THAT(error_with(fault + "hydraulic_conductivity = 1e-5\n"), HasSubstr(hint));
  EXPECT_THAT(error_with(fault + "viscosity = 1\n"), Not(HasSubstr("cubic")));
}

TEST(ReadingErrors, ToughnessIsToldFromTheEnergy) {
  const std::string hint = "unknown option here; the toughness K_Ic follows from mode_1_energy G: "
                           "K_Ic^2 = G E/(1 - nu^2) in plane strain; allowed: ";
  for (const char* const name : {"fracture_toughness", "K_Ic", "toughness"}) {
    const std::string key = fmt::format("material.rock.{}", name);
    EXPECT_THAT(coupled_error({key + "=1e6"}),
                StartsWith(fmt::format("--set: error: {}: {}", key, hint)));
  }
}

TEST(ReadingErrors, WrongKindOfValue) {
  EXPECT_EQ(error_set({"title=[1]"}),
            "--set: error: title = [1]: expects a text, found a list; allowed: a text in quotes");
  EXPECT_EQ(error_set({"fluid.density=true"}),
            "--set: error: fluid.density = true: expects a number, found true or false; allowed: a "
            "number in kg/m3, or a text with a unit of density such as \"1 g/cm3\"");
  EXPECT_EQ(error_set({"fluid.density=2020-01-01"}),
            "--set: error: fluid.density = a date: expects a number, found a date; allowed: a "
            "number in kg/m3, or a text with a unit of density such as \"1 g/cm3\"");
  EXPECT_EQ(
      error_set({"output.fields=1"}),
      "--set: error: output.fields = 1: expects true or false, found a number; allowed: true, "
      "false");
  EXPECT_EQ(error_set({"boundary.left.groups=\"left\""}),
            "--set: error: boundary.left.groups = \"left\": expects a list of texts, found a text; "
            "allowed: [\"...\", ...]");
  EXPECT_EQ(error_set({"output.times=3"}),
            "--set: error: output.times = 3: expects a list of numbers, found a number; allowed: "
            "[...], each a number in s, or a text with a unit of time such as \"3 hour\"");
  EXPECT_EQ(error_set({"time=3"}),
            "--set: error: time = 3: expects a table, found a number; allowed: [time] with its "
            "options below");
  EXPECT_EQ(error_set({"material.rock=3"}),
            "--set: error: material.rock = 3: expects a table, found a number; allowed: "
            "[material.rock] with its options below");
  EXPECT_EQ(error_set({"time.scheme=3"}),
            "--set: error: time.scheme = 3: expects a text, found a number; allowed: \"implicit\", "
            "\"explicit\", \"steady\", \"quasi_static\"");
}

TEST(ReadingErrors, NoSuchChoice) {
  EXPECT_EQ(error_set({"time.scheme=implict"}),
            "--set: error: time.scheme = \"implict\": no such choice; allowed: \"implicit\", "
            "\"explicit\", \"steady\", \"quasi_static\"");
}

TEST(ReadingErrors, AnOptionOfCouplingIsUnknown) {
  EXPECT_EQ(
      error_set({"material.rock.skempton_coefficient=0.8"}),
      "--set: error: material.rock.skempton_coefficient: unknown option; allowed: \"regions\", "
      "\"permeability\", \"porosity\", \"biot_modulus\"");
}

TEST(ReadingErrors, UnknownOptionsNameWhatThePhysicsHasOnly) {
  EXPECT_EQ(mechanics_error({"material.rock.porosty=0.1"}),
            "--set: error: material.rock.porosty: unknown option; allowed: \"regions\", "
            "\"density\", \"young_modulus\", \"poisson_ratio\", \"normal_young_modulus\", "
            "\"normal_poisson_ratio\", \"normal_shear_modulus\", \"bedding_angle\", \"joints\", "
            "\"tensile_strength\", \"cohesion\", \"friction_angle\", "
            "\"residual_friction_angle\", \"mode_1_energy\", \"mode_2_energy\", "
            "\"joint_penalty\", \"weibull_modulus\", \"weibull_seed\"");
  EXPECT_EQ(mechanics_error({"time.saftey=0.1"}),
            "--set: error: time.saftey: unknown option; the nearest valid name is \"safety\"; "
            "allowed: \"scheme\", \"end\", \"step\", \"safety\", \"stop_ratio\", "
            "\"mass_scaling_step\"");
  EXPECT_EQ(mechanics_error({"suorce.well.rate=1"}),
            "--set: error: suorce: unknown option; allowed: \"format\", \"title\", \"mesh\", "
            "\"model\", \"material\", \"fracture\", \"boundary\", \"body\", "
            "\"point_force\", \"in_situ\", \"excavation\", \"damping\", \"contact\", "
            "\"time\", \"output\", \"probe\"");
  EXPECT_THAT(mechanics_error({"time.rate=1"}), Not(HasSubstr("belongs in")));
  EXPECT_THAT(mechanics_error({"time.density=1"}),
              HasSubstr("\"density\" belongs in [material.NAME];"));
  EXPECT_THAT(error_set({"time.density=1"}), HasSubstr("\"density\" belongs in [fluid];"));
}

TEST(ReadingErrors, WhereThePhysicsIsUnknownTooEveryOptionIsNamed) {
  const std::string text = mechanics_error({"model.physics=mechanic", "time.x=1"});
  EXPECT_THAT(text, HasSubstr("\"tolerance\""));
  EXPECT_THAT(text, HasSubstr("\"stop_ratio\""));
}

TEST(ReadingErrors, ChoicesAreThoseOfThePhysics) {
  EXPECT_EQ(mechanics_error({"time.scheme=implict"}),
            "--set: error: time.scheme = \"implict\": no such choice; allowed: \"explicit\"");
  EXPECT_EQ(mechanics_error({"probe.a.point=[0, 0]", "probe.a.in=crack"}),
            "--set: error: probe.a.in = \"crack\": has no effect here: it needs model.physics = "
            "\"seepage\" or \"coupled\"");
}

TEST(ReadingErrors, WholeNumbers) {
  const std::string probe = "[probe.line]\nfrom = [0, 0]\nto = [1, 0]\npoints = ";
  EXPECT_EQ(error_with(probe + "1.5\n"),
            "case.toml:23:10: error: probe.line.points = 1.5: expects a whole number, found a "
            "number; allowed: a whole number from 2 to 1000000");
  EXPECT_EQ(error_with(probe + "1\n"),
            "case.toml:23:10: error: probe.line.points = 1: out of range; allowed: a whole number "
            "from 2 to 1000000");
}

TEST(ReadingErrors, Points) {
  const std::string probe = "[probe.here]\npoint = ";
  EXPECT_EQ(
      error_with(probe + "[1, 2, 3]\n"),
      "case.toml:21:9: error: probe.here.point = [1, 2, 3]: expects a point; allowed: [x, y], "
      "each a number in m, or a text with a unit of length such as \"5 cm\"");
  EXPECT_EQ(error_with(probe + "[1, \"2 s\"]\n"),
            "case.toml:21:13: error: probe.here.point = \"2 s\": the unit \"s\" is not one of "
            "length; allowed: a number in m, or a text with a unit of length such as \"5 cm\"");
}

TEST(ReadingErrors, MissingUnit) {
  EXPECT_EQ(error_set({"fluid.bulk_modulus=\"2e9\""}),
            "--set: error: fluid.bulk_modulus = \"2e9\": missing unit; allowed: a number in Pa, or "
            "a text with a unit of pressure such as \"2 MPa\"");
  EXPECT_EQ(error_set({"fluid.bulk_modulus=GPa"}),
            "--set: error: fluid.bulk_modulus = \"GPa\": not a number with a unit; allowed: a "
            "number in Pa, or a text with a unit of pressure such as \"2 MPa\"");
}

TEST(ReadingErrors, WrongDimensionNamesTheRightOne) {
  EXPECT_EQ(error_set({"material.rock.permeability=3 m"}),
            "--set: error: material.rock.permeability = \"3 m\": the unit \"m\" is not one of "
            "permeability; allowed: a number in m2, or a text with a unit of permeability such as "
            "\"10 mdarcy\"");
  EXPECT_EQ(error_set({"material.rock.porosity=3 m"}),
            "--set: error: material.rock.porosity = \"3 m\": the unit \"m\" has a dimension, which "
            "the option has not; allowed: a number, or a text such as \"10 %\"");
}

TEST(ReadingErrors, OutOfRange) {
  EXPECT_EQ(error_set({"material.rock.porosity=1.5"}),
            "--set: error: material.rock.porosity = 1.5: out of range; allowed: 0 < value <= 1");
  EXPECT_EQ(error_set({"material.rock.porosity=15"}),
            "--set: error: material.rock.porosity = 15: out of range: it is a share of one; "
            "did you mean \"15 %\"; allowed: 0 < value <= 1");
  EXPECT_EQ(
      error_set({"fluid.viscosity=-1 cP"}),
      "--set: error: fluid.viscosity = \"-1 cP\": out of range; allowed: a finite number > 0 Pa s");
  EXPECT_EQ(error_set({"fluid.viscosity=inf"}),
            "--set: error: fluid.viscosity = inf: out of range; allowed: a finite number > 0 Pa s");
  EXPECT_EQ(error_set({"fluid.viscosity=nan"}),
            "--set: error: fluid.viscosity = nan: not a number; allowed: a finite number > 0 Pa s");
  EXPECT_EQ(error_set({"fluid.cavitation_pressure=inf"}),
            "--set: error: fluid.cavitation_pressure = inf: out of range; allowed: a finite number "
            "of Pa or -inf");
  EXPECT_EQ(
      error_set({"model.gravity=-9.81"}),
      "--set: error: model.gravity = -9.81: out of range; allowed: a finite number >= 0 m/s2");
}

TEST(ReadingErrors, MissingOptionsSayWhatTheyAre) {
  EXPECT_EQ(error_set({"model.gravity="}),
            "case.toml:6:2: error: model.gravity: required but missing: Acceleration of gravity "
            "along -y: 9.81 for a vertical section, 0 for a horizontal plan.");
  EXPECT_THAT(error_set({"mesh="}), StartsWith("case.toml: error: mesh.file: required but missing: "
                                               "Gmsh mesh"));
}

TEST(ReadingErrors, Tensor) {
  EXPECT_EQ(
      error_set({"material.rock.permeability=[[2e-15, 1e-16], [3e-16, 1e-15]]"}),
      "--set: error: material.rock.permeability = [[2e-15, 1e-16], [3e-16, 1e-15]]: the tensor "
      "is not symmetric: kxy = 1e-16, kyx = 3e-16; allowed: [[kxx, kxy], [kxy, kyy]]");
  EXPECT_EQ(
      error_set({"material.rock.permeability=[1, 2]"}),
      "--set: error: material.rock.permeability = [1, 2]: expects a symmetric tensor; allowed: "
      "one value, [kxx, kyy, kxy] or [[kxx, kxy], [kxy, kyy]]");
}

TEST(ReadingErrors, NamesOfTables) {
  EXPECT_EQ(error_with("[probe.\"a/b\"]\npoint = [0, 0]\n"),
            "case.toml:20:8: error: probe.a/b: not a usable name; allowed: letters A to Z and a to "
            "z, digits, _ and -");
}

TEST(ReadingErrors, Format) {
  EXPECT_EQ(error_set({"format="}), "case.toml: error: format: required but missing: Format of the "
                                    "case file; this version reads 1.");
  EXPECT_EQ(error_set({"format=2", "time.nonsense=3"}),
            "--set: error: format = 2: this file needs a newer version of Percolith, which reads "
            "format 2; allowed: 1");
  EXPECT_EQ(error_set({"format=0"}),
            "--set: error: format = 0: there is no such format; allowed: 1");
  EXPECT_EQ(error_set({"format=1.0"}),
            "--set: error: format = 1: expects a whole number, found a number; allowed: 1");
}

TEST(ReadingErrors, TomlSyntax) {
  EXPECT_EQ(error_of("format = 1\nformat = 2\n"),
            "case.toml:2:10: error: not valid TOML: cannot redefine existing integer 'format'");
  EXPECT_THAT(error_of("format = 1\n[mesh\n"),
              StartsWith("case.toml:2:6: error: not valid TOML: "));
  EXPECT_THAT(error_of("title = \"\xff\"\n"), StartsWith("case.toml:1:9: error: not valid TOML: "));
}

TEST(ReadingErrors, AUnitWithoutQuotesIsToldHowToBeWritten) {
  EXPECT_THAT(error_of("format = 1\n[boundary.a]\nhead = 6 m  # of the canal\n"),
              AllOf(StartsWith("case.toml:3:"),
                    EndsWith("; allowed: a value with a unit in quotes: \"6 m\"")));
  EXPECT_THAT(error_of("head = -1.5e-3 MPa\n"), EndsWith("in quotes: \"-1.5e-3 MPa\""));
  EXPECT_THAT(error_of("head = [1 2]\n"), Not(HasSubstr("in quotes")));
}

TEST(ReadingErrors, AllAreReportedInTheOrderOfTheFile) {
  const std::string text = "format = 1\ntitel = \"x\"\n[model]\ngravity = \"1\"\n[fluid]\n"
                           "density = -1\n[mesh]\nfile = \"a.msh\"\n[time]\nscheme = \"steady\"\n";
  EXPECT_THAT(error_of(text),
              testing::ContainsRegex("^case.toml: error: material: no rock is given[^\n]*\n"
                                     "case.toml:2:1: error: titel: [^\n]*\n"
                                     "case.toml:4:11: error: model.gravity = [^\n]*\n"
                                     "case.toml:6:11: error: fluid.density = [^\n]*$"));
}

TEST(ReadingErrors, ExitCodes) {
  try {
    (void)read("x = 1\n");
    FAIL() << "an unknown option was read";
  } catch (const InputErrors& errors) {
    EXPECT_EQ(errors.exit_code(), ExitCode::input);
    EXPECT_FALSE(errors.problems().empty());
  }
  try {
    (void)read_case("no/such/case.toml");
    FAIL() << "a missing file was read";
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "cannot read the case file no/such/case.toml: no such file");
    EXPECT_EQ(error.exit_code(), ExitCode::file);
  }
  try {
    (void)read_case("tests");
    FAIL() << "a directory was read";
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "cannot read the case file tests: it is a directory");
  }
}

TEST(ReadingErrors, LongValuesAreShortened) {
  const std::string message = error_set({"fluid.density=" + std::string(100, 'x')});
  EXPECT_THAT(message, StartsWith("--set: error: fluid.density = \"" + std::string(59, 'x') +
                                  "...: not a number"));
}

}  // namespace
}  // namespace percolith::case_file
