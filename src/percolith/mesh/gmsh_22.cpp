// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_problem.hpp"
#include "percolith/mesh/gmsh_sections.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace percolith::mesh {
namespace {

/// A count line, text also in a binary file, after which the data begin.
std::uint64_t read_count(GmshCursor& cursor) {
  const auto count = cursor.text_number<std::uint64_t>();
  cursor.line();
  return count;
}

std::int32_t read_node(GmshCursor& cursor, const GmshNodes& nodes) {
  const auto tag = cursor.number<std::int32_t>();
  if (tag < 0) {
    cursor.fail(fmt::format("an element uses node {}, which $Nodes does not list", tag));
  }
  return nodes.index(static_cast<std::uint64_t>(tag), cursor);
}

/// The tags of an element that matter here: its physical group (0: none) and geometric entity.
struct ElementTags {
  int group = 0;
  int entity = 0;
};

ElementTags read_tags(GmshCursor& cursor, int count) {
  ElementTags tags;
  for (int i = 0; i < count; ++i) {
    const auto tag = cursor.number<std::int32_t>();
    if (i == 0) {
      // A minus sign tells the direction in which the group uses the entity.
      tags.group = tag == INT32_MIN ? 0 : std::abs(tag);
    } else if (i == 1) {
      tags.entity = tag;
    }
  }
  return tags;
}

void read_element(GmshCursor& cursor, GmshContent& content, int dimension, int tag_count) {
  const ElementTags tags = read_tags(cursor, tag_count);
  std::array<std::int32_t, 3> nodes{};
  for (int i = 0; i <= dimension; ++i) {
    nodes[static_cast<std::size_t>(i)] = read_node(cursor, content.nodes);
  }
  if (dimension == 2) {
    if (tags.group == 0) {
      fail_no_region(tags.entity, cursor);
    }
    content.triangles.push_back(nodes);
    content.triangle_group.push_back(tags.group);
  } else if (tags.group != 0 && dimension == 1) {
    content.edges[tags.group].push_back({nodes[0], nodes[1]});
  } else if (tags.group != 0) {
    content.points[tags.group].push_back(nodes[0]);
  }
}

int read_tag_count(GmshCursor& cursor) {
  const auto count = cursor.number<std::int32_t>();
  if (count < 0) {
    cursor.fail(fmt::format("an element announces {} tags", count));
  }
  return count;
}

void read_text_elements(GmshCursor& cursor, GmshContent& content, std::uint64_t count) {
  for (std::uint64_t i = 0; i < count; ++i) {
    cursor.number<std::int32_t>();
    const int dimension = element_dimension(cursor.number<std::int32_t>(), cursor);
    read_element(cursor, content, dimension, read_tag_count(cursor));
  }
}

void read_binary_elements(GmshCursor& cursor, GmshContent& content, std::uint64_t count) {
  for (std::uint64_t done = 0; done < count;) {
    const int dimension = element_dimension(cursor.number<std::int32_t>(), cursor);
    const auto in_block = cursor.number<std::int32_t>();
    if (in_block <= 0 || static_cast<std::uint64_t>(in_block) > count - done) {
      cursor.fail(fmt::format("a block of {} elements does not fit the {} of the section", in_block,
                              count));
    }
    const int tag_count = read_tag_count(cursor);
    for (int i = 0; i < in_block; ++i) {
      cursor.number<std::int32_t>();
      read_element(cursor, content, dimension, tag_count);
    }
    done += static_cast<std::uint64_t>(in_block);
  }
}

}  // namespace

void read_nodes_22(GmshCursor& cursor, GmshContent& content) {
  const std::uint64_t count = read_count(cursor);
  cursor.require(count, sizeof(std::int32_t) + 3 * sizeof(double), 4, "nodes");
  require_countable(count, "nodes", {cursor.file()});
  content.nodes.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto tag = cursor.number<std::int32_t>();
    if (tag < 0) {
      cursor.fail(fmt::format("node {} has a negative number", tag));
    }
    const auto x = cursor.number<double>();
    const auto y = cursor.number<double>();
    const auto z = cursor.number<double>();
    content.nodes.add(static_cast<std::uint64_t>(tag), {x, y, z}, cursor);
  }
  content.nodes.finish(cursor);
}

void read_elements_22(GmshCursor& cursor, GmshContent& content) {
  const std::uint64_t count = read_count(cursor);
  // The shortest element is a point: number, no tags, one node.
  cursor.require(count, 2 * sizeof(std::int32_t), 4, "elements");
  require_countable(count, "elements", {cursor.file()});
  if (cursor.binary()) {
    read_binary_elements(cursor, content, count);
  } else {
    read_text_elements(cursor, content, count);
  }
}

}  // namespace percolith::mesh
