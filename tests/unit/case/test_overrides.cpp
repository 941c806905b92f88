// SPDX-License-Identifier: BSD-3-Clause
#include "unit/case/minimal_case.hpp"

namespace percolith::case_file {
namespace {

TEST(Overrides, ReplaceAddAndTakeOut) {
  const simulation::Setup setup =
      read(minimal_case, {"time.end=2 hour", "model.gravity = 9.81", "title = \"A = B\"",
                          "fluid.density=900", "probe.axis={from=[0, 0], to=[1, 0]}",
                          "probe.axis.points=7", "boundary.left.pressure=", "boundary.left.head=3",
                          "time.end=3 hour", "mesh.file=other.msh"})
          .setup;
  EXPECT_EQ(setup.time.end, 10800.0);
  EXPECT_EQ(setup.model.gravity, 9.81);
  EXPECT_EQ(setup.title, "A = B");
  EXPECT_EQ(setup.fluid.density, 900.0);
  EXPECT_EQ(setup.probe.at("axis").points, 7);
  EXPECT_FALSE(setup.boundary.at("left").pressure.has_value());
  EXPECT_EQ(setup.boundary.at("left").head, Schedule::constant(3.0));
  EXPECT_EQ(setup.mesh.file, "other.msh");
}

TEST(Overrides, ABareTextMayHoldAnything) {
  EXPECT_EQ(read(minimal_case, {"title=one\nfluid = 3"}).setup.title, "one\nfluid = 3");
  EXPECT_EQ(read(minimal_case, {"title=3\nfluid = 3"}).setup.title, "3\nfluid = 3");
}

TEST(Overrides, TakingOutWhatIsNotThereIsNoError) {
  EXPECT_EQ(error_set({"probe.a.points=", "fluid.density="}), "");
}

TEST(Overrides, Errors) {
  EXPECT_EQ(error_set({"time.end"}),
            "--set: error: cannot read \"time.end\"; allowed: path.to.key=value");
  EXPECT_EQ(error_set({"=3"}), "--set: error: cannot read \"=3\"; allowed: path.to.key=value");
  EXPECT_EQ(error_set({"time..end=3"}),
            "--set: error: cannot read \"time..end=3\"; allowed: path.to.key=value");
  EXPECT_EQ(error_set({"time.end.more=3"}),
            "--set: error: time.end.more = 3: \"time.end\" is not a table");
  EXPECT_EQ(error_set({"model.gravity=[1"}),
            "--set: error: model.gravity = [1: not valid TOML: encountered end-of-file; allowed: a "
            "TOML value, or a bare text");
  EXPECT_EQ(error_set({"time.nd=3"}).substr(0, 74),
            "--set: error: time.nd: unknown option; the nearest valid name is \"end\"; al");
}

TEST(Overrides, StandBesideErrorsOfTheFile) {
  EXPECT_EQ(error_with("safety = 0.5\n", {"model.gravity=-1"}),
            "--set: error: model.gravity = -1: out of range; allowed: a finite number >= 0 m/s2\n"
            "case.toml:20:10: error: time.safety = 0.5: has no effect here: it needs time.scheme = "
            "\"explicit\"");
}

TEST(Overrides, AMisspeltTableIsToldByTheNameThatIsNear) {
  EXPECT_EQ(
      error_set({"material.rok.porosity=0.2"}),
      "--set: error: material.rok: the file has no such table; the nearest name is \"rock\"; a "
      "new one lacks \"regions\", \"permeability\"");
  EXPECT_EQ(
      error_set({"boundary.lfet.pressure=1e5"}),
      "--set: error: boundary.lfet: the file has no such table; the nearest name is \"left\"; "
      "a new one lacks \"groups\"");
}

TEST(Overrides, AMisspeltSourceIsToldThoughItLacksOneOfSeveral) {
  EXPECT_EQ(
      error_of(minimal_case + "[source.upper]\npoint = [0, 0]\nrate = 1\n", {"source.uper.rate=2"}),
      "--set: error: source.uper: the file has no such table; the nearest name is \"upper\"; "
      "a new one lacks one of \"point\", \"fractures\"");
}

TEST(Overrides, ANewTableThatIsWholeOrOfAnotherNameIsJudgedAsInAFile) {
  EXPECT_EQ(error_set({"boundary.left2.groups=[\"right\"]", "boundary.left2.pressure=1e5"}), "");
  EXPECT_EQ(error_set({"boundary.far_away_side.pressure=1e5"}).substr(0, 68),
            "--set: error: boundary.far_away_side.groups: required but missing: P");
  EXPECT_EQ(error_set({"material.rock.porosity="}).substr(0, 72),
            "case.toml:9:11: error: material.rock.porosity: required but missing: Vol");
}

}  // namespace
}  // namespace percolith::case_file
