// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_checks.hpp"
#include "percolith/mesh/gmsh_geo.hpp"
#include "percolith/mesh/gmsh_reader.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "unit/mesh/test_gmsh_samples.hpp"

namespace percolith::mesh {
namespace {

using samples::BinaryText;
using samples::data;
using samples::Places;
using samples::places_of;
using samples::TextMesh;
using samples::TextMesh41;

double area_of_region(const GmshMesh& mesh, const std::string& name) {
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const auto point = [&](std::int32_t index) {
      return mesh.points[static_cast<std::size_t>(index)];
    };
    if (mesh.regions[static_cast<std::size_t>(mesh.triangle_region[i])] == name) {
      area += 0.5 * std::abs(cross(point(b) - point(a), point(c) - point(a)));
    }
  }
  return area;
}

TEST(GmshFormats, ReadsRegionsCurvesAndPointsOfARealFile) {
  const GmshMesh mesh = read_gmsh(data + "two_regions_41_binary.msh");
  EXPECT_EQ(mesh.file, data + "two_regions_41_binary.msh");
  EXPECT_EQ(mesh.regions, (std::vector<std::string>{"sand stone", "clay"}));
  EXPECT_NEAR(area_of_region(mesh, "sand stone"), 1.0, 1e-12);
  EXPECT_NEAR(area_of_region(mesh, "clay"), 1.0, 1e-12);
  ASSERT_EQ(mesh.point_groups.at("crossing").size(), 1U);
  const std::int32_t crossing = mesh.point_groups.at("crossing").front();
  EXPECT_EQ(mesh.points[static_cast<std::size_t>(crossing)], (Point{0.5, 0.5}));
}

TEST(GmshFormats, PutsAnEdgeInEveryGroupOfItsCurve) {
  const GmshMesh mesh = read_gmsh(data + "two_regions_41_binary.msh");
  EXPECT_EQ(mesh.curves.at("across").size(), 2U);
  EXPECT_EQ(mesh.curves.at("up").size(), 2U);
  EXPECT_EQ(mesh.curves.at("fractures").size(), 4U);
  EXPECT_EQ(mesh.curves.at("left").size(), 2U);
  EXPECT_EQ(mesh.curves.at("outline").size(), 8U);
}

TEST(GmshFormats, NamesAGroupWithoutNameByItsNumber) {
  const GmshMesh mesh = read_gmsh(data + "two_regions_41_text.msh");
  EXPECT_EQ(mesh.curves.at("77").size(), 2U);
}

TEST(GmshFormats, AllFourFormatsGiveTheSameMesh) {
  const Places expected = places_of(read_gmsh(data + "two_regions_41_binary.msh"));
  EXPECT_EQ(places_of(read_gmsh(data + "two_regions_41_text.msh")), expected);
  EXPECT_EQ(places_of(read_gmsh(data + "two_regions_22_binary.msh")), expected);
  EXPECT_EQ(places_of(read_gmsh(data + "two_regions_22_text.msh")), expected);
}

TEST(GmshFormats, DropsPointsOfNoTriangle) {
  TextMesh sample;
  sample.nodes.insert(sample.nodes.begin(), "9 5 5 0");
  const GmshMesh mesh = read_gmsh(sample.text(), "square.msh");
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::int32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.curves.at("left"), (std::vector<std::array<std::int32_t, 2>>{{0, 3}}));
}

TEST(GmshFormats, BothVersionsOfTheSquareAgree) {
  const GmshMesh square = read_gmsh(TextMesh{}.text(), "square.msh");
  EXPECT_EQ(places_of(read_gmsh(TextMesh41{}.text(), "square.msh")), places_of(square));
}

TEST(GmshFormats, DropsEdgesThatStickOutOfTheTriangles) {
  TextMesh sample;
  sample.nodes.push_back("5 -1 0 0");
  sample.nodes.push_back("6 -2 0 0");
  sample.elements.push_back("4 1 2 5 1 5 1");
  sample.elements.push_back("5 1 2 8 1 6 5");
  const GmshMesh mesh = read_gmsh(sample.text(), "square.msh");
  EXPECT_EQ(mesh.curves.at("left").size(), 1U);
  EXPECT_TRUE(mesh.curves.at("8").empty());
}

TEST(GmshFormats, KeepsNamedGroupsWithoutElementsAsEmpty) {
  TextMesh sample;
  sample.names = "$PhysicalNames\n2\n0 1 \"well\"\n1 6 \"fault\"\n$EndPhysicalNames\n";
  const GmshMesh mesh = read_gmsh(sample.text(), "square.msh");
  EXPECT_TRUE(mesh.curves.at("fault").empty());
  EXPECT_TRUE(mesh.point_groups.at("well").empty());
  EXPECT_EQ(mesh.regions, std::vector<std::string>{"7"});
}

TEST(GmshFormats, JoinsGroupsOfOneName) {
  TextMesh sample;
  sample.names = "$PhysicalNames\n2\n2 7 \"rock\"\n2 9 \"rock\"\n$EndPhysicalNames\n";
  sample.elements[2] = "3 2 2 9 1 1 3 4";
  const GmshMesh mesh = read_gmsh(sample.text(), "square.msh");
  EXPECT_EQ(mesh.regions, std::vector<std::string>{"rock"});
  EXPECT_EQ(mesh.triangle_region, (std::vector<std::int32_t>{0, 0}));
}

TEST(GmshFormats, ReadsSparseAndHugeNodeTags) {
  TextMesh41 sample;
  sample.nodes = "$Nodes\n1 4 3 18446744073709551615\n2 1 0 4\n18446744073709551615\n3\n"
                 "9000000000\n70\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n";
  sample.elements = "$Elements\n1 2 1 2\n2 1 2 2\n2 18446744073709551615 3 9000000000\n"
                    "3 18446744073709551615 9000000000 70\n$EndElements\n";
  const GmshMesh mesh = read_gmsh(sample.text(), "square.msh");
  EXPECT_EQ(mesh.points, (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<std::int32_t, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(GmshFormats, ReadsWindowsLineEndsAndSkipsUnknownSections) {
  const TextMesh sample;
  std::string text = sample.format + "$Comments\nmade by hand, $Nodes follow\n$EndComments\n" +
                     sample.text().substr(sample.format.size()) +
                     "$NodeData\n1\n\"p\"\n$EndNodeData\n";
  std::string windows;
  for (const char c : text) {
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  EXPECT_EQ(places_of(read_gmsh(windows, "square.msh")),
            places_of(read_gmsh(sample.text(), "square.msh")));
}

TEST(GmshFormats, TakesAPlaneOfAnotherHeightAndClockwiseTriangles) {
  TextMesh sample;
  sample.nodes = {"1 0 0 7", "2 1 0 7", "3 1 1 7", "4 0 1 7"};
  sample.elements[1] = "2 2 2 7 1 1 3 2";
  EXPECT_EQ(read_gmsh(sample.text(), "square.msh").triangles.size(), 2U);
}

TEST(GmshFormats, SkipsParametersOfNodes) {
  TextMesh41 sample;
  sample.nodes = "$Nodes\n1 4 1 4\n2 1 1 4\n1\n2\n3\n4\n0 0 0 8 8\n1 0 0 8 8\n1 1 0 8 8\n"
                 "0 1 0 8 8\n$EndNodes\n";
  EXPECT_EQ(read_gmsh(sample.text(), "square.msh").points,
            (std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

std::string binary_41(bool reversed) {
  BinaryText file(reversed);
  file.text("$MeshFormat\n4.1 1 8\n").ints({1}).text("\n$EndMeshFormat\n$Entities\n");
  file.sizes({0, 0, 1, 0}).ints({1}).reals({0, 0, 0, 1, 1, 0}).sizes({1}).ints({7}).sizes({0});
  file.text("\n$EndEntities\n$Nodes\n").sizes({1, 4, 1, 4}).ints({2, 1, 0}).sizes({4, 1, 2, 3, 4});
  file.reals({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}).text("\n$EndNodes\n$Elements\n");
  file.sizes({1, 2, 1, 2}).ints({2, 1, 2}).sizes({2, 1, 1, 2, 3, 2, 1, 3, 4});
  return file.text("\n$EndElements\n").bytes();
}

std::string binary_22(bool reversed) {
  BinaryText file(reversed);
  file.text("$MeshFormat\n2.2 1 8\n").ints({1}).text("\n$EndMeshFormat\n$Nodes\n4\n");
  file.ints({1}).reals({0, 0, 0}).ints({2}).reals({1, 0, 0});
  file.ints({3}).reals({1, 1, 0}).ints({4}).reals({0, 1, 0});
  file.text("\n$EndNodes\n$Elements\n2\n").ints({2, 2, 2, 1, 7, 1, 1, 2, 3, 2, 7, 1, 1, 3, 4});
  return file.text("\n$EndElements\n").bytes();
}

TEST(GmshFormats, ReadsBinaryFilesOfBothByteOrders) {
  TextMesh sample;
  sample.names.clear();
  sample.elements.erase(sample.elements.begin());
  const Places expected = places_of(read_gmsh(sample.text(), "square.msh"));
  for (const bool reversed : {false, true}) {
    EXPECT_EQ(places_of(read_gmsh(binary_41(reversed), "square.msh")), expected);
    EXPECT_EQ(places_of(read_gmsh(binary_22(reversed), "square.msh")), expected);
  }
}

}  // namespace
}  // namespace percolith::mesh
