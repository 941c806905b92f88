// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_reader.hpp"

#include "percolith/mesh/gmsh_checks.hpp"
#include "percolith/mesh/gmsh_file.hpp"
#include "percolith/mesh/gmsh_header.hpp"
#include "percolith/mesh/gmsh_sections.hpp"

#include <fmt/format.h>

#include <utility>

namespace percolith::mesh {
namespace {

enum class Section { physical_names, entities, nodes, elements, partitions, other };

Section section_kind(std::string_view name, GmshVersion version) {
  if (name == "$PhysicalNames") {
    return Section::physical_names;
  }
  if (name == "$Entities" && version == GmshVersion::v41) {
    return Section::entities;
  }
  if (name == "$Nodes") {
    return Section::nodes;
  }
  if (name == "$Elements") {
    return Section::elements;
  }
  return name == "$PartitionedEntities" ? Section::partitions : Section::other;
}

/// Reads one `.msh` file section by section.
class GmshParser {
public:
  explicit GmshParser(GmshCursor& cursor) : cursor_(cursor) {}

  GmshContent parse() {
    version_ = read_gmsh_header(cursor_);
    while (!cursor_.at_end()) {
      read_section();
    }
    cursor_.set_section("the file");
    if (!has_nodes_ || !has_elements_) {
      cursor_.fail(fmt::format("section {} is missing: the file is truncated or holds no mesh",
                               has_nodes_ ? "$Elements" : "$Nodes"));
    }
    return std::move(content_);
  }

private:
  void read_section() {
    const std::string_view name = cursor_.word();
    if (name.front() != '$' || name.starts_with("$End")) {
      cursor_.fail("expected the beginning of a section ('$Nodes', ...) here: the file is damaged");
    }
    cursor_.set_section(name);
    const std::string end = fmt::format("$End{}", name.substr(1));
    const Section kind = section_kind(name, version_);
    if (kind == Section::other) {
      cursor_.skip_past(end);
      return;
    }
    cursor_.line();
    read_known(kind);
    cursor_.expect(end);
  }

  void read_known(Section kind) {
    const bool old = version_ == GmshVersion::v22;
    switch (kind) {
    case Section::physical_names:
      read_physical_names(cursor_, content_);
      break;
    case Section::entities:
      read_entities_41(cursor_, content_);
      break;
    case Section::nodes:
      require_first(has_nodes_);
      old ? read_nodes_22(cursor_, content_) : read_nodes_41(cursor_, content_);
      break;
    case Section::elements:
      require_first(has_elements_);
      if (!has_nodes_) {
        cursor_.fail("$Elements stands before $Nodes");
      }
      old ? read_elements_22(cursor_, content_) : read_elements_41(cursor_, content_);
      break;
    case Section::partitions:
      cursor_.fail("the mesh is partitioned; save it without partitions");
    case Section::other:
      break;
    }
  }

  void require_first(bool& seen) const {
    if (seen) {
      cursor_.fail(fmt::format("section {} stands twice", cursor_.section()));
    }
    seen = true;
  }

  GmshCursor& cursor_;
  GmshContent content_;
  GmshVersion version_ = GmshVersion::v41;
  bool has_nodes_ = false;
  bool has_elements_ = false;
};

}  // namespace

GmshMesh read_gmsh(const std::filesystem::path& path) {
  const FileContent content = read_whole_file(path);
  return read_gmsh(content.view(), path.string());
}

GmshMesh read_gmsh(std::string_view content, const std::string& file) {
  GmshCursor cursor(content, file);
  GmshMesh mesh = assemble_gmsh(GmshParser(cursor).parse(), file);
  check_gmsh_mesh(mesh);
  return mesh;
}

}  // namespace percolith::mesh
