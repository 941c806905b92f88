// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_header.hpp"

#include "percolith/mesh/gmsh_problem.hpp"
#include "percolith/mesh/gmsh_reader.hpp"
#include "percolith/mesh/gmsh_sections.hpp"

#include <fmt/format.h>

#include <array>

namespace percolith::mesh {
namespace {

constexpr const char* allowed_files = "a Gmsh mesh, .msh version 2.2 or 4.1";

struct Signature {
  std::string_view begin;
  const char* kind;
};

constexpr std::array<Signature, 10> foreign_files{{
    {"# vtk DataFile", "a VTK file"},
    {"<?xml", "an XML file (perhaps VTK)"},
    {"<VTKFile", "a VTK file"},
    {"solid", "an STL file"},
    {"$NOD", "a Gmsh mesh of version 1"},
    {"MeshVersionFormatted", "a Medit mesh"},
    {"\x89HDF", "an HDF5 file (perhaps MED or CGNS)"},
    {"*HEADING", "an Abaqus file"},
    {"*Heading", "an Abaqus file"},
    {"//", "a Gmsh geometry, which should be named .geo,"},
}};

std::string_view without_leading_space(std::string_view content) {
  const std::size_t begin = content.find_first_not_of(" \t\r\n");
  return begin == std::string_view::npos ? std::string_view() : content.substr(begin);
}

[[noreturn]] void fail_foreign(std::string_view content, const GmshCursor& cursor) {
  const std::string_view text = without_leading_space(content);
  if (text.empty()) {
    fail_mesh({cursor.file()}, "the file is empty", allowed_files);
  }
  for (const Signature& signature : foreign_files) {
    if (text.starts_with(signature.begin)) {
      fail_mesh({cursor.file()},
                fmt::format("this is {} and not a Gmsh mesh; where Gmsh can open it, convert it "
                            "with 'gmsh FILE -0 -o mesh.msh'",
                            signature.kind),
                allowed_files);
    }
  }
  fail_mesh({cursor.file()}, "this is not a Gmsh mesh: it does not begin with $MeshFormat",
            allowed_files);
}

GmshVersion read_version(GmshCursor& cursor) {
  const std::string_view text = cursor.word();
  if (text == "2.2") {
    return GmshVersion::v22;
  }
  if (text == "4.1") {
    return GmshVersion::v41;
  }
  cursor.fail(fmt::format("the mesh has format version {}; convert it with 'gmsh FILE -0 "
                          "-format msh41 -o mesh.msh'",
                          printable_text(text)),
              "2.2, 4.1");
}

/// The binary files hold the number one so that a reader can tell the order of bytes.
void read_byte_order(GmshCursor& cursor) {
  constexpr std::int32_t reversed_one = 0x01000000;
  const auto one = cursor.raw<std::int32_t>();
  if (one != 1 && one != reversed_one) {
    cursor.fail(fmt::format("the binary file's mark of byte order is {} instead of 1: the file is "
                            "damaged, for instance by a transfer in text mode",
                            one));
  }
  cursor.switch_to_binary(one == reversed_one);
}

}  // namespace

bool looks_like_gmsh(std::string_view content) {
  return without_leading_space(content).starts_with("$MeshFormat");
}

GmshVersion read_gmsh_header(GmshCursor& cursor) {
  const std::string_view rest = cursor.rest();
  if (!looks_like_gmsh(rest)) {
    fail_foreign(rest, cursor);
  }
  cursor.set_section(cursor.word());
  const GmshVersion version = read_version(cursor);
  const auto type = cursor.text_number<std::int32_t>();
  const auto size = cursor.text_number<std::int32_t>();
  cursor.line();
  if ((type != 0 && type != 1) || size != 8) {
    cursor.fail(fmt::format("file type {} with numbers of {} bytes is not supported", type, size),
                "type 0 (text) or 1 (binary), 8 bytes");
  }
  if (type == 1) {
    read_byte_order(cursor);
  }
  cursor.expect("$EndMeshFormat");
  return version;
}

void read_physical_names(GmshCursor& cursor, GmshContent& content) {
  const auto count = cursor.text_number<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto dimension = cursor.text_number<std::int32_t>();
    const auto number = cursor.text_number<std::int32_t>();
    const std::string_view text = cursor.line();
    const std::size_t begin = text.find('"');
    const std::size_t end = text.rfind('"');
    if (begin == std::string_view::npos || end == begin) {
      cursor.fail("expected the name of a physical group in double quotes");
    }
    content.names[{dimension, number}] = std::string(text.substr(begin + 1, end - begin - 1));
  }
}

}  // namespace percolith::mesh
