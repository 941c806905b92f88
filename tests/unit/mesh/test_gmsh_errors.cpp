// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_file.hpp"
#include "percolith/mesh/gmsh_problem.hpp"
#include "percolith/mesh/gmsh_reader.hpp"

#include <gtest/gtest.h>

#include "unit/mesh/test_gmsh_samples.hpp"

namespace percolith::mesh {
namespace {

using samples::data;
using samples::message_of;
using samples::TextMesh;
using samples::TextMesh41;

/// The message for a file of this content, named m.msh, without the part all have in common.
std::string problem(const std::string& content) {
  const std::string message = message_of([&] { (void)read_gmsh(content, "m.msh"); });
  const std::string common = "error: mesh.file: ";
  const std::size_t found = message.find(common);
  EXPECT_TRUE(message.starts_with("m.msh:")) << message;
  EXPECT_NE(found, std::string::npos) << message;
  return found == std::string::npos
             ? message
             : message.substr(0, found) + message.substr(found + common.size());
}

TEST(GmshErrors, SaysWhichFileIsMissing) {
  EXPECT_EQ(message_of([] { (void)read_gmsh("tests/no_such.msh"); }),
            "tests/no_such.msh: error: mesh.file: there is no such file");
  EXPECT_EQ(message_of([] { (void)read_gmsh("tests/unit"); }),
            "tests/unit: error: mesh.file: this is not a plain file");
  EXPECT_THROW((void)read_whole_file("tests/no_such.msh"), FileError);
}

TEST(GmshErrors, TellsForeignFiles) {
  const std::string allowed = "; allowed: a Gmsh mesh, .msh version 2.2 or 4.1";
  const std::string convert = " and not a Gmsh mesh; where Gmsh can open it, convert it with "
                              "'gmsh FILE -0 -o mesh.msh'";
  EXPECT_EQ(problem(""), "m.msh: the file is empty" + allowed);
  EXPECT_EQ(problem("solid cube\nfacet normal 0 0 1\n"),
            "m.msh: this is an STL file" + convert + allowed);
  EXPECT_EQ(problem("# vtk DataFile Version 3.0\n"),
            "m.msh: this is a VTK file" + convert + allowed);
  EXPECT_EQ(problem("PK\x03\x04 something"),
            "m.msh: this is not a Gmsh mesh: it does not begin with $MeshFormat" + allowed);
}

TEST(GmshErrors, RefusesOtherVersionsAndNumberSizes) {
  EXPECT_EQ(problem("$MeshFormat\n4.0 0 8\n$EndMeshFormat\n"),
            "m.msh:2: the mesh has format version 4.0; convert it with 'gmsh FILE -0 -format msh41 "
            "-o mesh.msh'; allowed: 2.2, 4.1");
  EXPECT_EQ(problem("$MeshFormat\n4.1 0 4\n$EndMeshFormat\n"),
            "m.msh:2: file type 0 with numbers of 4 bytes is not supported; allowed: type 0 (text) "
            "or 1 (binary), 8 bytes");
  EXPECT_EQ(problem("$MeshFormat\n4.1 1 8\nabcd\n$EndMeshFormat\n"),
            "m.msh:3: the binary file's mark of byte order is 1684234849 instead of 1: the file is "
            "damaged, for instance by a transfer in text mode");
}

TEST(GmshErrors, EveryTruncationIsFound) {
  for (const char* name : {"22_text", "22_binary", "41_text", "41_binary"}) {
    const FileContent whole = read_whole_file(data + "two_regions_" + name + ".msh");
    const std::string_view content = whole.view();
    EXPECT_NO_THROW((void)read_gmsh(content, "m.msh"));
    // Without its last line end the file is still whole.
    for (std::size_t size = 0; size + 1 < content.size(); ++size) {
      EXPECT_THROW((void)read_gmsh(content.substr(0, size), "m.msh"), InputError)
          << name << " cut to " << size << " bytes";
    }
  }
}

TEST(GmshErrors, SaysWhereAFileIsTruncated) {
  const std::string text = TextMesh{}.text();
  EXPECT_EQ(
      problem(text.substr(0, text.find("3 1 1 0"))),
      "m.msh:10: $Nodes announces 4 nodes, but only 16 bytes follow: the file is truncated or "
      "damaged");
  EXPECT_EQ(problem(text.substr(0, text.find(" 3 4\n$EndElements"))),
            "m.msh:20: the file ends inside $Elements: it is truncated; write or copy it again");
  EXPECT_EQ(problem(text.substr(0, text.find("$Elements"))),
            "m.msh:15: section $Elements is missing: the file is truncated or holds no mesh");
  const FileContent binary = read_whole_file(data + "two_regions_41_binary.msh");
  const std::string_view all = binary.view();
  EXPECT_EQ(problem(std::string(all.substr(0, all.find("$Elements") + 200))),
            "m.msh: $Elements announces 45 elements, but only 158 bytes follow: the file is "
            "truncated or damaged (at byte 3035)");
}

TEST(GmshErrors, ChecksClaimedSizesBeforeAllocating) {
  TextMesh sample;
  const std::string text = sample.format + "$Nodes\n18446744073709551615\n1 0 0 0\n";
  EXPECT_EQ(problem(text), "m.msh:5: $Nodes announces 18446744073709551615 nodes, but only 8 bytes "
                           "follow: the file is truncated or damaged");
  EXPECT_EQ(problem(sample.format + "$Nodes\n99999999999999999999\n"),
            "m.msh:5: the number 99999999999999999999 in $Nodes is out of range");
}

TEST(GmshErrors, RefusesMoreThanIndicesCanNumber) {
  EXPECT_NO_THROW(require_countable(715827882, "triangles", {"m.msh"}));
  EXPECT_EQ(message_of([] { require_countable(715827883, "triangles", {"m.msh"}); }),
            "m.msh: error: mesh.file: the mesh has 715827883 triangles, more than 32-bit indices "
            "can number; mesh coarser; allowed: at most 715827882 triangles");
}

TEST(GmshErrors, SaysWhereCountsAndNumbersAreWrong) {
  TextMesh sample;
  std::string text = sample.text();
  text.replace(text.find("$Nodes\n4"), 8, "$Nodes\n3");
  EXPECT_EQ(problem(text), "m.msh:14: expected $EndNodes, found '4': a count in the file is wrong "
                           "or the file is damaged");
  sample.nodes[1] = "2 one 0 0";
  EXPECT_EQ(problem(sample.text()), "m.msh:12: expected a number in $Nodes, found 'one'");
  sample.nodes[1] = "2.5 1 0 0";
  EXPECT_EQ(problem(sample.text()), "m.msh:12: expected a whole number in $Nodes, found '2.5'");
}

TEST(GmshErrors, RefusesSolidElements) {
  TextMesh sample;
  sample.elements.push_back("4 4 2 7 1 1 2 3 4");
  EXPECT_EQ(problem(sample.text()),
            "m.msh:21: the mesh holds tetrahedra; a two-dimensional mesh is needed: mesh with "
            "'gmsh -2' and leave physical volumes out; allowed: triangles of 3 nodes, lines of 2 "
            "nodes, points");
}

TEST(GmshErrors, RefusesQuadraticElements) {
  TextMesh41 sample;
  sample.elements = "$Elements\n1 1 1 1\n2 1 9 1\n1 1 2 3 4 5 6\n$EndElements\n";
  EXPECT_EQ(problem(sample.text()),
            "m.msh:28: the mesh holds quadratic triangles (6 nodes); set 'Mesh.ElementOrder = 1' "
            "and mesh again; allowed: triangles of 3 nodes, lines of 2 nodes, points");
}

TEST(GmshErrors, RefusesQuadrangles) {
  TextMesh sample;
  sample.elements[1] = "2 3 2 7 1 1 2 3 4";
  EXPECT_EQ(problem(sample.text()),
            "m.msh:19: the mesh holds quadrangles; leave out 'Recombine' and "
            "'Mesh.RecombineAll', and mesh again; allowed: triangles of 3 nodes, lines of 2 nodes, "
            "points");
  sample.elements[1] = "2 93 2 7 1 1 2 3 4";
  EXPECT_EQ(problem(sample.text()), "m.msh:19: the mesh holds elements of Gmsh type 93; allowed: "
                                    "triangles of 3 nodes, lines of 2 nodes, points");
}

TEST(GmshErrors, RefusesMeshesOutOfPlane) {
  TextMesh sample;
  sample.nodes[2] = "3 1 1 0.25";
  EXPECT_EQ(problem(sample.text()), "m.msh: the mesh is not plane: z runs from 0 to 0.25; the "
                                    "model lies in the x-y plane; allowed: points of one and the "
                                    "same z");
}

TEST(GmshErrors, RefusesTrianglesWithoutPhysicalSurface) {
  const std::string reason =
      "triangles of surface 1 are in no physical surface, so they have no material; add 'Physical "
      "Surface(\"rock\") = {1};' to the geometry and mesh again";
  TextMesh sample;
  sample.elements[2] = "3 2 2 0 1 1 3 4";
  EXPECT_EQ(problem(sample.text()), "m.msh:20: " + reason);
  TextMesh41 sample41;
  sample41.entities = "$Entities\n0 0 1 0\n1 0 0 0 1 1 0 0 0\n$EndEntities\n";
  EXPECT_EQ(problem(sample41.text()), "m.msh:29: " + reason);
}

TEST(GmshErrors, RefusesASurfaceInTwoRegions) {
  TextMesh sample;
  sample.elements.push_back("4 2 2 8 1 1 3 4");
  EXPECT_EQ(problem(sample.text()),
            "m.msh: region assigned twice: the triangle at (0.333333333, 0.666666667) is in the "
            "physical surfaces 'rock' and '8'; keep one");
  TextMesh41 sample41;
  sample41.entities = "$Entities\n0 0 1 0\n1 0 0 0 1 1 0 2 7 8 0\n$EndEntities\n";
  EXPECT_EQ(problem(sample41.text()), "m.msh:29: region assigned twice: surface 1 is in the "
                                      "physical surfaces 'rock' and '8'; keep one");
}

TEST(GmshErrors, RefusesUnknownAndRepeatedNodes) {
  TextMesh sample;
  sample.elements[2] = "3 2 2 7 1 1 3 44";
  EXPECT_EQ(problem(sample.text()),
            "m.msh:20: an element uses node 44, which $Nodes does not list");
  sample.elements[2] = "3 2 2 7 1 1 3 -4";
  EXPECT_EQ(problem(sample.text()),
            "m.msh:20: an element uses node -4, which $Nodes does not list");
  sample.nodes[3] = "3 0 1 0";
  EXPECT_EQ(problem(sample.text()), "m.msh:14: node 3 is listed twice");
}

TEST(GmshErrors, RefusesRepeatedSparseNodes) {
  TextMesh sample;
  sample.nodes = {"1 0 0 0", "1000000 1 0 0", "3 1 1 0", "1000000 0 1 0"};
  EXPECT_EQ(problem(sample.text()), "m.msh:14: node 1000000 is listed twice");
}

TEST(GmshErrors, RefusesCoordinatesThatAreNotFinite) {
  TextMesh sample;
  sample.nodes[3] = "4 0 nan 0";
  EXPECT_EQ(problem(sample.text()),
            "m.msh:14: node 4 has a coordinate that is not finite: (0, nan, 0)");
  sample.nodes[3] = "4 0 1e999 0";
  EXPECT_EQ(problem(sample.text()), "m.msh:14: the number 1e999 in $Nodes is out of range");
}

TEST(GmshErrors, RefusesAMeshWithoutTriangles) {
  TextMesh sample;
  sample.elements.resize(1);
  EXPECT_EQ(problem(sample.text()), "m.msh: the mesh has no triangles; the geometry needs a plane "
                                    "surface in a physical surface, meshed with 'gmsh -2'");
  sample.elements.clear();
  sample.nodes.clear();
  EXPECT_EQ(problem(sample.text()), "m.msh: the mesh has no triangles; the geometry needs a plane "
                                    "surface in a physical surface, meshed with 'gmsh -2'");
}

TEST(GmshErrors, RefusesACurveThatIsNotEmbedded) {
  TextMesh sample;
  sample.nodes.push_back("5 0.2 0.5 0");
  sample.nodes.push_back("6 0.4 0.5 0");
  sample.elements.push_back("4 1 2 5 2 5 6");
  EXPECT_EQ(problem(sample.text()),
            "m.msh: physical curve 'left' runs through the mesh at (0.3, 0.5) without being part "
            "of it; embed it with 'Curve{...} In Surface{...};', or by 'BooleanFragments', and "
            "mesh again");
  sample.elements.back() = "4 15 2 3 2 5";
  EXPECT_EQ(problem(sample.text()),
            "m.msh: physical point '3' at (0.2, 0.5) lies in the mesh without being part of it; "
            "embed it with 'Point{...} In Surface{...};' and mesh again");
}

TEST(GmshErrors, RefusesMisplacedAndUnusableSections) {
  const TextMesh sample;
  const std::string nodes = TextMesh::section("Nodes", sample.nodes);
  const std::string elements = TextMesh::section("Elements", sample.elements);
  EXPECT_EQ(problem(sample.format + elements + nodes), "m.msh:4: $Elements stands before $Nodes");
  EXPECT_EQ(problem(sample.format + nodes + nodes), "m.msh:11: section $Nodes stands twice");
  EXPECT_EQ(problem(sample.format + "$PartitionedEntities\n2\n"),
            "m.msh:4: the mesh is partitioned; save it without partitions");
  EXPECT_EQ(problem(sample.text() + "7 8 9\n"),
            "m.msh:22: expected the beginning of a section ('$Nodes', ...) here: the file is "
            "damaged");
  EXPECT_EQ(problem(sample.format + "$PhysicalNames\n1\n2 1 rock\n$EndPhysicalNames\n"),
            "m.msh:6: expected the name of a physical group in double quotes");
}

TEST(GmshErrors, RefusesBlocksThatDoNotAddUp) {
  TextMesh41 sample;
  std::string text = sample.text();
  text.replace(text.find("$Nodes\n1 4"), 10, "$Nodes\n1 5");
  EXPECT_EQ(problem(text), "m.msh:24: $Nodes announces 5 nodes, but its blocks hold 4");
  sample.elements = "$Elements\n1 1 1 2\n2 1 2 2\n2 1 2 3\n3 1 3 4\n$EndElements\n";
  EXPECT_EQ(problem(sample.text()), "m.msh:28: a block of $Elements elements holds 2, but only 1 "
                                    "of those announced are left");
  sample.elements = "$Elements\n1 2 1 2\n1 1 2 2\n2 1 2 3\n3 1 3 4\n$EndElements\n";
  EXPECT_EQ(problem(sample.text()),
            "m.msh:28: elements of dimension 2 stand under an entity of dimension 1");
}

}  // namespace
}  // namespace percolith::mesh
