// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "unit/support/setup.hpp"

namespace percolith::simulation {
namespace {

using test::expect_refused;
using test::plain_setup;

TEST(GroupErrors, UnknownCurvesAreListedWithThoseThatExist) {
  simulation::Setup setup = plain_setup();
  setup.boundary["inlet"].groups = {"left", "lefd"};
  expect_refused(setup, "boundary.inlet.groups[1]",
                 "error: boundary.inlet.groups[1] = \"lefd\": the mesh has no physical curve of "
                 "this name; allowed: \"bottom\", \"left\", \"level\", \"right\", \"top\", "
                 "\"upright\"");
}

TEST(GroupErrors, SurfacesAndPointsAreNoCurves) {
  simulation::Setup setup = plain_setup();
  setup.boundary["inlet"].groups = {"rock"};
  expect_refused(setup, "boundary.inlet.groups[0]",
                 "\"rock\": this is a physical surface (triangles), where a physical curve (edges) "
                 "is needed");
  setup.boundary["inlet"].groups = {"well"};
  expect_refused(setup, "boundary.inlet.groups[0]",
                 "\"well\": this is a physical point, where a physical curve (edges) is needed");
}

TEST(GroupErrors, ABoundaryDoesNotRunInside) {
  simulation::Setup setup = plain_setup();
  setup.boundary["inlet"].groups = {"level"};
  expect_refused(setup, "boundary.inlet.groups[0]",
                 "\"level\": 6 of its edges at (0.4375, 0.5) are not on the boundary of the rock; "
                 "allowed: curves on the outer boundary or round a hole; for a curve inside use a "
                 "fracture or a source");
}

TEST(GroupErrors, AFractureDoesNotLieOnTheBoundary) {
  simulation::Setup setup = plain_setup();
  setup.fracture["fault"] = test::fracture_group("top", 1e-4);
  expect_refused(setup, "fracture.fault.groups[0]", "\"top\": its edge at (");
  expect_refused(setup, "fracture.fault.groups[0]",
                 ", 1) lies on the boundary of the rock, and a fracture needs rock on both sides; "
                 "allowed: curves inside the rock; they may end at the boundary");
}

TEST(GroupErrors, AFractureConsistsOfEdgesOfTriangles) {
  simulation::Setup setup = plain_setup();
  setup.fracture["fault"] = test::fracture_group("loose", 1e-4);
  auto mesh = test::plain_mesh();
  mesh.curves["loose"] = {{0, 17}, {test::plain_grid.point(1, 1), test::plain_grid.point(1, 2)}};
  test::expect_input_error([&] { Simulation(setup, mesh); }, "fracture.fault.groups[0]",
                           "\"loose\": 1 of its edges are not edges of triangles: the curve leaves "
                           "the rock or is not embedded in its surface; allowed: curves embedded "
                           "in the geometry with `Curve{...} In Surface{...};` or fragmented with "
                           "the surface");
}

TEST(GroupErrors, AMeshWithoutCurvesSaysSo) {
  simulation::Setup setup = plain_setup();
  auto mesh = test::plain_mesh();
  mesh.curves.clear();
  test::expect_input_error([&] { Simulation(setup, mesh); }, "boundary.inlet.groups[0]",
                           "the mesh has no physical curve of this name; allowed: none");
}

TEST(MaterialErrors, EveryRegionHasExactlyOneMaterial) {
  simulation::Setup setup = plain_setup();
  setup.material["sandstone"].regions = {"rock", "stone"};
  expect_refused(setup, "material.sandstone.regions[1]",
                 "\"stone\": the mesh has no physical surface of this name; allowed: \"rock\"");
  setup = plain_setup();
  setup.material["shale"] = setup.material["sandstone"];
  expect_refused(setup, "material.shale.regions[0]",
                 "\"rock\": this region already has material.sandstone; allowed: one material per "
                 "region");
  setup = plain_setup();
  setup.material["sandstone"].regions.clear();
  expect_refused(setup, "material",
                 "region \"rock\" of the mesh has no material; allowed: every physical surface "
                 "named in the regions of one material");
}

TEST(FractureErrors, AnEdgeBelongsToOneTable) {
  simulation::Setup setup = plain_setup();
  setup.fracture["first"] = test::fracture_group("level", 1e-4);
  setup.fracture["second"] = test::fracture_group("upright", 1e-4);
  setup.fracture["second"].groups.push_back("level");
  expect_refused(setup, "fracture.second.groups", "its edge at (");
  expect_refused(setup, "fracture.second.groups",
                 ", 0.5) already belongs to fracture.first; allowed: each edge in one fracture "
                 "table");
}

TEST(MeshErrors, AnEdgeOfThreeTrianglesIsRefused) {
  auto mesh = test::plain_mesh();
  mesh.triangles.push_back({mesh.triangles[0][0], mesh.triangles[0][2], 80});
  mesh.triangle_region.push_back(0);
  test::expect_input_error([&] { Simulation(plain_setup(), mesh); }, "mesh.file",
                           "belongs to more than two triangles; allowed: a conforming "
                           "triangulation of the plane");
}

}  // namespace
}  // namespace percolith::simulation
