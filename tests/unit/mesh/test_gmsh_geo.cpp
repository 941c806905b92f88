// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_geo.hpp"
#include "percolith/mesh/gmsh_geo_errors.hpp"
#include "percolith/mesh/gmsh_program.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "unit/mesh/test_gmsh_samples.hpp"

namespace percolith::mesh {
namespace {

using samples::data;
using samples::message_of;
using samples::TextMesh;

/// A directory for the files of one test; also the place of temporary files during it.
class GmshGeo : public testing::Test {
public:
  GmshGeo() {
    directory_ =
        std::filesystem::temp_directory_path() / ("test-gmsh-geo-" + std::to_string(getpid()));
    std::filesystem::create_directories(directory_ / "temporary");
    if (const char* old = std::getenv("TMPDIR")) {
      old_temporary_ = old;
    }
    setenv("TMPDIR", (directory_ / "temporary").c_str(), 1);
  }
  ~GmshGeo() override {
    EXPECT_TRUE(std::filesystem::is_empty(directory_ / "temporary"));
    std::filesystem::remove_all(directory_);
    old_temporary_.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", old_temporary_.c_str(), 1);
  }
  GmshGeo(const GmshGeo&) = delete;
  GmshGeo& operator=(const GmshGeo&) = delete;

protected:
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_ / name, std::ios::binary) << text;
    return (directory_ / name).string();
  }

private:
  std::filesystem::path directory_;
  std::string old_temporary_;
};

double longest_edge(const GmshMesh& mesh) {
  double longest = 0.0;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point edge = mesh.points[static_cast<std::size_t>(triangle[i])] -
                         mesh.points[static_cast<std::size_t>(triangle[(i + 1) % 3])];
      longest = std::max(longest, std::sqrt(dot(edge, edge)));
    }
  }
  return longest;
}

const std::string square = "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\nPoint(3) = {1, 1, 0};\n"
                           "Point(4) = {0, 1, 0};\nLine(1) = {1, 2};\nLine(2) = {2, 3};\n"
                           "Line(3) = {3, 4};\nLine(4) = {4, 1};\nCurve Loop(1) = {1, 2, 3, 4};\n"
                           "Plane Surface(1) = {1};\n";

TEST_F(GmshGeo, MeshesAGeometry) {
  const GmshMesh mesh = read_mesh(data + "two_regions.geo");
  EXPECT_EQ(mesh.file, data + "two_regions.geo");
  EXPECT_EQ(mesh.regions, (std::vector<std::string>{"sand stone", "clay"}));
  EXPECT_FALSE(mesh.curves.at("fractures").empty());
}

TEST_F(GmshGeo, BoundsTheElementSizeEvenAgainstTheGeometry) {
  const std::string rock = square + "Physical Surface(\"rock\") = {1};\n";
  for (const char* option :
       {"", "Mesh.CharacteristicLengthMax = 0.5;\n", "Mesh.CharacteristicLengthMin = 0.5;\n"}) {
    const std::string file = write("square.geo", rock + option);
    EXPECT_LT(longest_edge(read_mesh(file, 0.1)), 0.15) << option;
  }
  const std::string fine = write("fine.geo", rock + "Mesh.CharacteristicLengthMax = 0.05;\n");
  EXPECT_LT(longest_edge(read_mesh(fine, 0.1)), 0.08);
}

TEST_F(GmshGeo, TakesAFileNameThatAShellWouldSplit) {
  const std::string file = write("a b;$(c) 'd'.geo", square + "Physical Surface(\"r\") = {1};\n");
  EXPECT_EQ(read_mesh(file, 0.5).regions, std::vector<std::string>{"r"});
}

TEST_F(GmshGeo, PicksByExtensionAndContent) {
  const std::string mesh = TextMesh{}.text();
  EXPECT_EQ(read_mesh(write("a.MSH", mesh)).triangles.size(), 2U);
  EXPECT_EQ(read_mesh(write("a.mesh2d", mesh)).triangles.size(), 2U);
  EXPECT_EQ(read_mesh(write("a.geo", mesh)).triangles.size(), 2U);
  const std::string other = write("a.vtu", "<?xml");
  EXPECT_EQ(message_of([&] { (void)read_mesh(other); }),
            other + ": error: mesh.file: a mesh file with the extension '.vtu' cannot be read; "
                    "where Gmsh can open it, convert it with 'gmsh FILE -2 -o mesh.msh'; allowed: "
                    ".msh (Gmsh 2.2 or 4.1), .geo (meshed by gmsh)");
}

TEST_F(GmshGeo, RefusesASizeBoundForAReadyMesh) {
  const std::string file = data + "two_regions_22_text.msh";
  EXPECT_EQ(message_of([&] { (void)read_mesh(file, 0.1); }),
            file + ": error: mesh.element_size = 0.1: a ready mesh has its own element size; leave "
                   "this option out, or give the geometry (.geo) as mesh.file");
}

TEST_F(GmshGeo, SaysWhatToInstall) {
  const std::string file = data + "two_regions.geo";
  EXPECT_EQ(message_of([&] { (void)mesh_geo(file, {.program = "no-such-gmsh"}); }),
            file + ": error: mesh.file: a geometry is meshed by the program 'no-such-gmsh', which "
                   "is not installed; install it ('apt install gmsh'), or give a ready mesh (.msh) "
                   "made elsewhere");
}

TEST_F(GmshGeo, SaysThatTheGeometryIsMissing) {
  EXPECT_EQ(message_of([] { (void)read_mesh("tests/none.geo"); }),
            "tests/none.geo: error: mesh.file: there is no such file");
  EXPECT_EQ(message_of([] { (void)mesh_geo("tests/none.geo"); }),
            "tests/none.geo: error: mesh.file: there is no such file");
}

TEST_F(GmshGeo, QuotesGmshWithFileAndLine) {
  const std::string file = write("bad.geo", square + "Physical Surface(\"rock\") = {one};\n");
  EXPECT_EQ(message_of([&] { (void)read_mesh(file); }),
            file + ":11: error: mesh.file: gmsh cannot mesh the geometry: Unknown variable 'one'");
}

TEST_F(GmshGeo, SaysThatThereIsNoSurface) {
  const std::string file = write("line.geo", "Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\n"
                                             "Line(1) = {1, 2};\nPhysical Curve(1) = {1};\n");
  EXPECT_EQ(message_of([&] { (void)read_mesh(file); }),
            file + ": error: mesh.file: the mesh has no triangles; the geometry needs a plane "
                   "surface in a physical surface, meshed with 'gmsh -2'");
}

TEST_F(GmshGeo, SaysThatASurfaceHasNoRegion) {
  const std::string file = write("bare.geo", square);
  const std::string message = message_of([&] { (void)read_mesh(file, 0.5); });
  EXPECT_TRUE(message.find("triangles of surface 1 are in no physical surface") !=
              std::string::npos)
      << message;
}

TEST_F(GmshGeo, SaysThatDuplicatePointsNeedCoherence) {
  const std::string file = write(
      "apart.geo",
      square + "Point(5) = {1, 0, 0};\nPoint(6) = {2, 0, 0};\nPoint(7) = {2, 1, 0};\n"
               "Point(8) = {1, 1, 0};\nLine(5) = {5, 6};\nLine(6) = {6, 7};\nLine(7) = {7, 8};\n"
               "Line(8) = {8, 5};\nCurve Loop(2) = {5, 6, 7, 8};\nPlane Surface(2) = {2};\n"
               "Physical Surface(\"rock\") = {1, 2};\n");
  const std::string message = message_of([&] { (void)read_mesh(file, 0.5); });
  EXPECT_TRUE(message.find("two points of the mesh lie at (1, ") != std::string::npos) << message;
  const std::string joined = write("joined.geo", "Merge \"apart.geo\";\nCoherence;\n");
  EXPECT_NO_THROW((void)read_mesh(joined, 0.5));
}

TEST(GmshGeoErrors, ReportsAProgramThatFailsWithoutAWord) {
  EXPECT_NO_THROW(throw_geo_errors({true, 0, "Info    : Done\n"}, "m.geo"));
  EXPECT_EQ(message_of([] {
              throw_geo_errors({true, 139, "Info    : Done\n"}, "m.geo");
            }),
            "m.geo: error: mesh.file: gmsh cannot mesh the geometry: exit code 139");
}

TEST(GmshGeoErrors, QuotesEveryErrorOnce) {
  const std::string output = "Info    : Meshing\nError   : Unable to recover the edge 7\n"
                             "Error   : 'sub.geo', line 3: Unknown variable 'a'\n"
                             "Error   : Unable to recover the edge 7\n"
                             "Error   : ------------------------------\nError   : 1 error\n";
  EXPECT_EQ(message_of([&] {
              throw_geo_errors({true, 0, output}, "m.geo");
            }),
            "sub.geo:3: error: mesh.file: gmsh cannot mesh the geometry: Unknown variable 'a'\n"
            "  gmsh: Unable to recover the edge 7");
}

TEST(GmshProgram, CollectsOutputAndExitCode) {
  const ProgramResult result = run_program({"sh", "-c", "echo out; echo err >&2; cat; exit 3"});
  EXPECT_TRUE(result.found);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.output, "out\nerr\n");
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}).exit_code, 137);
  EXPECT_FALSE(run_program({"no-such-program"}).found);
  EXPECT_EQ(message_of([] { (void)run_program({"/etc/passwd"}); }),
            "error: the program '/etc/passwd' cannot be started: Permission denied");
}

}  // namespace
}  // namespace percolith::mesh
