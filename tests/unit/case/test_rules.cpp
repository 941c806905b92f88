// SPDX-License-Identifier: BSD-3-Clause
#include "unit/case/minimal_case.hpp"

namespace percolith::case_file {
namespace {

std::vector<std::string> with_fault(std::vector<std::string> more) {
  more.insert(more.begin(),
              "fracture.fault={groups=[\"f\"], initial_aperture=1e-4, exchange=1e-6}");
  return more;
}

TEST(Rules, MeshIsAMeshOrAGeometry) {
  EXPECT_EQ(
      error_set({"mesh.file=rock.stl"}),
      "--set: error: mesh.file = \"rock.stl\": neither a mesh nor a geometry of Gmsh; allowed: "
      "a file that ends in .msh or .geo");
  EXPECT_EQ(error_set({"mesh.element_size=0.1"}),
            "--set: error: mesh.element_size = 0.1: has no effect here: it needs a .geo file as "
            "mesh.file");
  EXPECT_EQ(error_set({"mesh.element_size=0.1", "mesh.file=rock.geo"}), "");
}

TEST(Rules, Materials) {
  EXPECT_EQ(error_set({"material="}),
            "case.toml: error: material: no rock is given; allowed: one or more tables "
            "[material.NAME]");
  EXPECT_EQ(error_set({"material.rock.regions=[]"}),
            "--set: error: material.rock.regions = []: names no physical group of the mesh; "
            "allowed: at least one name");
  EXPECT_EQ(error_set({"material.rock.regions=[\"\"]"}),
            "--set: error: material.rock.regions = [\"\"]: a name is empty; allowed: names of "
            "physical groups of the mesh");
  EXPECT_EQ(error_set({"material.rock.regions=[\"a\", \"a\"]"}),
            "--set: error: material.rock.regions = [\"a\", \"a\"]: \"a\" is named twice; allowed: "
            "each name once");
  EXPECT_EQ(
      error_with("[material.sand]\nregions = [\"rock\"]\npermeability = 1e-12\n"
                 "porosity = 0.3\n"),
      "case.toml:21:11: error: material.sand.regions = [\"rock\"]: \"rock\" already belongs to "
      "material.rock.regions; allowed: each name once");
}

TEST(Rules, PermeabilityIsPositiveDefinite) {
  EXPECT_EQ(error_set({"material.rock.permeability=-1e-15"}),
            "--set: error: material.rock.permeability = -1e-15: out of range; allowed: a finite "
            "number > 0 "
            "m2");
  EXPECT_EQ(error_set({"material.rock.permeability=[1e-15, 1e-15, 2e-15]"}),
            "--set: error: material.rock.permeability = [1e-15, 1e-15, 2e-15]: the tensor is not "
            "positive definite; allowed: kxx > 0, kyy > 0 and kxx kyy > kxy^2");
}

TEST(Rules, Apertures) {
  EXPECT_EQ(error_set(with_fault(
                {"fracture.fault.minimum_aperture=2 mm", "fracture.fault.maximum_aperture=1 mm"})),
            "--set: error: fracture.fault.minimum_aperture = \"2 mm\": greater than "
            "maximum_aperture; allowed: at most 0.001 m");
}

TEST(Rules, ExplicitNeedsAFiniteExchange) {
  EXPECT_EQ(error_set(with_fault({"fracture.fault.exchange=inf", "time.scheme=explicit"})),
            "--set: error: fracture.fault.exchange = inf: the explicit scheme cannot give fracture "
            "and rock one pressure; allowed: a finite exchange, or time.scheme = \"implicit\"");
  EXPECT_EQ(error_set(with_fault({"time.scheme=explicit"})), "");
}

TEST(Rules, BoundaryHasExactlyOneCondition) {
  EXPECT_EQ(error_set({"boundary.left.pressure="}),
            "case.toml:14:11: error: boundary.left: one option is missing; allowed: one of "
            "\"pressure\", \"head\", \"flux\", \"seepage_face\"");
  EXPECT_EQ(error_set({"boundary.left.flux=0"}),
            "--set: error: boundary.left.flux = 0: contradicts \"pressure\", which is given too; "
            "allowed: only one of \"pressure\", \"head\", \"flux\", \"seepage_face\"");
  EXPECT_EQ(
      error_set({"boundary.left.pressure=", "boundary.left.flux=0", "boundary.left.on=both"}),
      "--set: error: boundary.left.on = \"both\": has no effect here: it needs pressure, head "
      "or seepage_face");
  EXPECT_EQ(
      error_set({"boundary.left.on=crack"}),
      "--set: error: boundary.left.on = \"crack\": the case has no fracture; allowed: a table "
      "[fracture.NAME]");
  EXPECT_EQ(error_set({"boundary.left.groups=[\"a\", \"a\"]"}),
            "--set: error: boundary.left.groups = [\"a\", \"a\"]: \"a\" is named twice; allowed: "
            "each name once");
}

TEST(Rules, HeadNeedsGravity) {
  const std::string reason = ": needs gravity, which is 0; allowed: model.gravity > 0";
  EXPECT_EQ(error_set({"boundary.left.pressure=", "boundary.left.head=2"}),
            "--set: error: boundary.left.head = 2" + reason);
  EXPECT_EQ(error_set({"initial.head=2"}), "--set: error: initial.head = 2" + reason);
  EXPECT_EQ(error_set({"initial.water_table=2"}), "--set: error: initial.water_table = 2" + reason);
  EXPECT_EQ(error_set({"model.head_datum=2"}),
            "--set: error: model.head_datum = 2: has no effect here: it needs model.gravity > 0");
  EXPECT_EQ(error_set({"model.gravity=9.81", "initial.head=2", "model.head_datum=2"}), "");
}

TEST(Rules, SourceHasOnePlaceAndOneDrive) {
  EXPECT_EQ(error_with("[source.well]\nrate = 1\n"),
            "case.toml:20:9: error: source.well: one option is missing; allowed: one of \"point\", "
            "\"fractures\"");
  EXPECT_EQ(error_with("[source.well]\npoint = [0, 0]\n"),
            "case.toml:20:9: error: source.well: one option is missing; allowed: one of \"rate\", "
            "\"pressure\"");
  EXPECT_EQ(
      error_with("[source.well]\npoint = [0, 0]\nrate = 1\npressure = 1\ninto = \"crack\"\n",
                 with_fault({})),
      "case.toml:23:12: error: source.well.pressure = 1: contradicts \"rate\", which is given "
      "too; allowed: only one of \"rate\", \"pressure\"");
  EXPECT_EQ(
      error_with("[source.well]\npoint = [0, 0]\npressure = 1\n"),
      "case.toml:22:12: error: source.well.pressure = 1: a pressure cannot be held at a point "
      "of the matrix; allowed: rate, or into = \"crack\"");
  EXPECT_EQ(error_with("[source.well]\npoint = [0, 0]\nrate = 1\ninto = \"crack\"\n"),
            "case.toml:23:8: error: source.well.into = \"crack\": the case has no fracture; "
            "allowed: a table [fracture.NAME]");
  EXPECT_EQ(error_with("[source.well]\nfractures = [\"fault\"]\nrate = 1\ninto = \"crack\"\n",
                       with_fault({})),
            "case.toml:23:8: error: source.well.into = \"crack\": has no effect here: it needs a "
            "point");
}

TEST(Rules, SourceNamesKnownFractures) {
  EXPECT_EQ(error_with("[source.well]\nfractures = [\"falt\"]\nrate = 1\n", with_fault({})),
            "case.toml:21:13: error: source.well.fractures = [\"falt\"]: there is no table "
            "[fracture.falt]; the nearest valid name is \"fault\"; allowed: \"fault\"");
  EXPECT_EQ(error_with("[source.well]\nfractures = [\"x\"]\nrate = 1\n"),
            "case.toml:21:13: error: source.well.fractures = [\"x\"]: there is no table "
            "[fracture.x]; allowed: a table [fracture.NAME] of that name");
  EXPECT_EQ(error_with("[source.well]\nfractures = []\nrate = 1\n"),
            "case.toml:21:13: error: source.well.fractures = []: names no fracture; allowed: at "
            "least one name");
}

TEST(Rules, InitialStateIsGivenOnce) {
  EXPECT_EQ(
      error_set({"model.gravity=9.81", "initial.head=2", "initial.pressure=0"}),
      "--set: error: initial.head = 2: contradicts \"pressure\", which is given too; allowed: "
      "only one of \"pressure\", \"head\", \"water_table\"");
  EXPECT_EQ(error_set({"initial.crack_pressure=2"}),
            "--set: error: initial.crack_pressure = 2: the case has no fracture; allowed: a table "
            "[fracture.NAME]");
}

TEST(Rules, NoPressureBelowCavitation) {
  const std::string allowed =
      " is below the cavitation pressure; allowed: >= 0 Pa, or a lower fluid.cavitation_pressure";
  EXPECT_EQ(error_set({"boundary.left.pressure=-1 kPa"}),
            "--set: error: boundary.left.pressure = \"-1 kPa\": -1000 Pa" + allowed);
  EXPECT_EQ(error_set({"boundary.left.pressure=", "boundary.left.seepage_face=-1"}),
            "--set: error: boundary.left.seepage_face = -1: -1 Pa" + allowed);
  EXPECT_EQ(error_set({"initial.pressure=-1"}),
            "--set: error: initial.pressure = -1: -1 Pa" + allowed);
  EXPECT_EQ(error_set(with_fault({"initial.crack_pressure=-1"})),
            "--set: error: initial.crack_pressure = -1: -1 Pa" + allowed);
  EXPECT_EQ(error_set(with_fault({"source.a={fractures=[\"fault\"], pressure=-1}"})),
            "--set: error: source.a.pressure = -1: -1 Pa" + allowed);
  EXPECT_EQ(
      error_set({"fluid.cavitation_pressure=1 kPa"}),
      "case.toml: error: initial.pressure: 0 Pa is below the cavitation pressure; allowed: >= "
      "1000 Pa, or a lower fluid.cavitation_pressure");
  EXPECT_EQ(error_set({"boundary.left.pressure=-1 kPa", "fluid.cavitation_pressure=-inf"}), "");
  // A steady run has no initial pressure that could be too low.
  EXPECT_EQ(error_set({"fluid.cavitation_pressure=1 kPa", "boundary.left.pressure=2 kPa",
                       "time.scheme=steady", "time.end="}),
            "");
}

TEST(Rules, PartlyFilledVoidsHaveTheCavitationPressure) {
  EXPECT_EQ(
      error_set({"initial.saturation=0.5", "fluid.cavitation_pressure=-inf"}),
      "--set: error: initial.saturation = 0.5: the fluid never empties a void; allowed: 1, or "
      "a finite fluid.cavitation_pressure");
  EXPECT_EQ(error_set({"initial.saturation=0.5", "initial.pressure=2"}),
            "--set: error: initial.saturation = 0.5: a void that is not full has the cavitation "
            "pressure, 0 Pa, not 2 Pa; allowed: 1, or initial.pressure at the cavitation pressure");
  EXPECT_EQ(error_set({"initial.saturation=0.5"}), "");
  EXPECT_EQ(
      error_set(with_fault({"initial.crack_saturation=0", "initial.crack_pressure=1"})),
      "--set: error: initial.crack_saturation = 0: a void that is not full has the cavitation "
      "pressure, 0 Pa, not 1 Pa; allowed: 1, or initial.crack_pressure at the cavitation "
      "pressure");
}

TEST(Rules, EndIsRequiredUnlessSteady) {
  EXPECT_EQ(
      error_set({"time.end="}),
      "case.toml:18:2: error: time.end: required but missing: the time at which the run ends; "
      "allowed: a finite number > 0 s, or time.scheme = \"steady\"");
  for (const std::string end : {"0", "-2", "inf", "-inf"}) {
    EXPECT_EQ(error_set({"time.end=" + end}),
              "--set: error: time.end = " + end + ": out of range; allowed: a finite number > 0 s");
  }
  EXPECT_EQ(error_set({"time.end=", "time.scheme=steady"}), "");
  EXPECT_EQ(error_set({"time.scheme=steady"}),
            "case.toml:19:7: error: time.end = \"1 hour\": has no effect here: it needs a "
            "time.scheme other than \"steady\"");
}

TEST(Rules, OptionsOfAnotherScheme) {
  EXPECT_EQ(error_set({"time.safety=0.5"}),
            "--set: error: time.safety = 0.5: has no effect here: it needs time.scheme = "
            "\"explicit\"");
  const std::string free_step =
      ": has no effect here: it needs time.scheme = \"implicit\" or \"quasi_static\" without "
      "time.step";
  EXPECT_EQ(error_set({"time.scheme=explicit", "time.tolerance=0.5"}),
            "--set: error: time.tolerance = 0.5" + free_step);
  EXPECT_EQ(error_set({"time.step=1", "time.initial_step=0.5"}),
            "--set: error: time.initial_step = 0.5" + free_step);
  EXPECT_EQ(error_set({"time.step=1", "time.maximum_step=0.5"}),
            "--set: error: time.maximum_step = 0.5" + free_step);
  EXPECT_EQ(error_set({"time.initial_step=2", "time.maximum_step=1"}),
            "--set: error: time.initial_step = 2: greater than maximum_step; allowed: at most 1 s");
  EXPECT_EQ(error_set({"time.stop_ratio=1e-3"}), "");
  EXPECT_EQ(error_set({"time.end=", "time.scheme=steady", "time.stop_ratio=1e-3"}),
            "--set: error: time.stop_ratio = 0.001: has no effect here: it needs a time.scheme "
            "other than \"steady\"");
  EXPECT_EQ(error_set({"time.end=", "time.scheme=steady", "output.interval=3"}),
            "--set: error: output.interval = 3: has no effect here: it needs a time.scheme "
            "other than \"steady\"");
  EXPECT_EQ(
      error_set({"model.joint_factor=3"}),
      "--set: error: model.joint_factor = 3: has no effect here: it needs model.pore_joints = "
      "\"finite\"");
}

TEST(Rules, ASteadyRunHasNoInitialState) {
  for (const std::string option :
       {"pressure", "head", "water_table", "saturation", "crack_pressure", "crack_saturation"}) {
    std::vector<std::string> settings =
        with_fault({"model.gravity=9.81", "initial." + option + "=1"});
    EXPECT_EQ(error_set(settings), "") << option;
    settings.insert(settings.end(), {"time.end=", "time.scheme=steady"});
    EXPECT_EQ(error_set(settings), "--set: error: initial." + option +
                                       " = 1: has no effect here: it needs a time.scheme "
                                       "other than \"steady\", without initial.steady");
  }
  EXPECT_EQ(error_set({"initial.steady=true", "time.end=", "time.scheme=steady"}),
            "--set: error: initial.steady = true: has no effect here: it needs a time.scheme "
            "other than \"steady\"");
}

TEST(Rules, ASteadyStartTakesNoOtherInitialState) {
  EXPECT_EQ(error_set({"initial.steady=true"}), "");
  EXPECT_EQ(error_set({"initial.steady=true", "initial.pressure=1"}),
            "--set: error: initial.pressure = 1: has no effect here: it needs a time.scheme "
            "other than \"steady\", without initial.steady");
}

TEST(Rules, ARuleIsSilentAboutAnOptionThatIsWrongItself) {
  EXPECT_EQ(error_set({"time.scheme=explict", "time.safety=0.5"}),
            "--set: error: time.scheme = \"explict\": no such choice; allowed: \"implicit\", "
            "\"explicit\", \"steady\", \"quasi_static\"");
}

TEST(Rules, SteadyNeedsConstants) {
  EXPECT_EQ(error_set({"time.end=", "time.scheme=steady",
                       "boundary.left.pressure={times=[0, 1], values=[0, 1]}"}),
            "--set: error: boundary.left.pressure = { times = [0, 1], values = [0, 1] }: changes "
            "over time, which a steady run has not; allowed: a constant, or time.scheme = "
            "\"implicit\"");
}

TEST(Rules, OutputTimes) {
  EXPECT_EQ(error_set({"output.times=[2, 1]"}),
            "--set: error: output.times = [2, 1]: times do not increase; allowed: times that "
            "strictly increase");
  EXPECT_EQ(error_set({"output.times=[1, 3601]"}),
            "--set: error: output.times = [1, 3601]: 3601 s is after the end of the run; allowed: "
            "at most 3600 s");
}

TEST(Rules, ProbeHasOnePlace) {
  EXPECT_EQ(error_set({"probe.a={}"}),
            "--set: error: probe.a: the place is missing; allowed: point, or from and to");
  EXPECT_EQ(
      error_set({"probe.a={from=[0, 0]}"}),
      "--set: error: probe.a: one end of the line is missing; allowed: point, or from and to");
  EXPECT_EQ(
      error_set({"probe.a={point=[0, 0], to=[1, 1]}"}),
      "--set: error: probe.a.to = [1, 1]: contradicts \"point\", which is given too; allowed: "
      "point, or from and to");
  EXPECT_EQ(error_set({"probe.a={from=[1, 1], to=[1, 1]}"}),
            "--set: error: probe.a.to = [1, 1]: both ends of the line are the same point; allowed: "
            "two points that differ");
  EXPECT_EQ(error_set({"probe.a={point=[1, 1], points=5}"}),
            "--set: error: probe.a.points = 5: has no effect here: it needs from and to");
  EXPECT_EQ(error_set({"probe.a={point=[1, 1], in=\"crack\"}"}),
            "--set: error: probe.a.in = \"crack\": the case has no fracture; allowed: a table "
            "[fracture.NAME]");
}

}  // namespace
}  // namespace percolith::case_file
