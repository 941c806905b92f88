// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_problem.hpp"
#include "percolith/mesh/gmsh_sections.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace percolith::mesh {
namespace {

using Size = std::uint64_t;

void skip_numbers(GmshCursor& cursor, Size count, std::string_view what) {
  cursor.require(count, sizeof(std::int32_t), 1, what);
  for (Size i = 0; i < count; ++i) {
    cursor.number<std::int32_t>();
  }
}

/// One geometric entity: tag, bounding box, physical groups and, but for points, its boundary.
void read_entity(GmshCursor& cursor, GmshContent& content, int dimension) {
  const auto tag = cursor.number<std::int32_t>();
  const int box_numbers = dimension == 0 ? 3 : 6;
  for (int i = 0; i < box_numbers; ++i) {
    cursor.number<double>();
  }
  const auto group_count = cursor.number<Size>();
  cursor.require(group_count, sizeof(std::int32_t), 1, "physical groups");
  if (group_count > 0) {
    std::vector<int>& groups = content.entity_groups[{dimension, tag}];
    groups.clear();
    for (Size i = 0; i < group_count; ++i) {
      // A minus sign tells the direction in which the group uses the entity.
      const auto number = cursor.number<std::int32_t>();
      groups.push_back(number == INT32_MIN ? 0 : std::abs(number));
    }
  }
  if (dimension > 0) {
    skip_numbers(cursor, cursor.number<Size>(), "bounding entities");
  }
}

/// First line of `$Nodes` and `$Elements`: number of blocks and of items; range of tags unused.
struct SectionSize {
  Size blocks = 0;
  Size items = 0;
};

SectionSize read_section_size(GmshCursor& cursor) {
  SectionSize size;
  size.blocks = cursor.number<Size>();
  size.items = cursor.number<Size>();
  cursor.number<Size>();
  cursor.number<Size>();
  return size;
}

/// A block must not hold more than what the section announces and earlier blocks left over.
void require_left(Size count, Size left, std::string_view what, const GmshCursor& cursor) {
  if (count > left) {
    cursor.fail(fmt::format("a block of {} {} holds {}, but only {} of those announced are left",
                            cursor.section(), what, count, left));
  }
}

void require_all(Size found, Size announced, std::string_view what, const GmshCursor& cursor) {
  if (found != announced) {
    cursor.fail(fmt::format("{} announces {} {}, but its blocks hold {}", cursor.section(),
                            announced, what, found));
  }
}

Size read_node_block(GmshCursor& cursor, GmshContent& content, Size left, std::vector<Size>& tags) {
  const auto dimension = cursor.number<std::int32_t>();
  cursor.number<std::int32_t>();
  const bool parametric = cursor.number<std::int32_t>() != 0;
  const auto count = cursor.number<Size>();
  if (dimension < 0 || dimension > 3) {
    cursor.fail(fmt::format("a block of nodes has dimension {}", dimension), "0 to 3");
  }
  require_left(count, left, "nodes", cursor);
  cursor.require(count, sizeof(Size) + 3 * sizeof(double), 4, "nodes in a block");
  tags.clear();
  tags.reserve(count);
  for (Size i = 0; i < count; ++i) {
    tags.push_back(cursor.number<Size>());
  }
  const int parameters = parametric ? dimension : 0;
  for (const Size tag : tags) {
    const auto x = cursor.number<double>();
    const auto y = cursor.number<double>();
    const auto z = cursor.number<double>();
    for (int i = 0; i < parameters; ++i) {
      cursor.number<double>();
    }
    content.nodes.add(tag, {x, y, z}, cursor);
  }
  return count;
}

/// Number of the physical surface of a surface's triangles. Throws InputError unless there is
/// exactly one.
int region_of(int surface, const std::vector<int>& groups, const GmshContent& content,
              const GmshCursor& cursor) {
  if (groups.empty()) {
    fail_no_region(surface, cursor);
  }
  const std::string name = content.group_name(2, groups.front());
  for (const int other : groups) {
    const std::string other_name = content.group_name(2, other);
    if (other_name != name) {
      cursor.fail(fmt::format("region assigned twice: surface {} is in the physical surfaces '{}' "
                              "and '{}'; keep one",
                              surface, name, other_name));
    }
  }
  return groups.front();
}

void read_triangles(GmshCursor& cursor, GmshContent& content, Size count, int group) {
  const GmshNodes& nodes = content.nodes;
  for (Size i = 0; i < count; ++i) {
    cursor.number<Size>();
    const std::int32_t a = nodes.index(cursor.number<Size>(), cursor);
    const std::int32_t b = nodes.index(cursor.number<Size>(), cursor);
    const std::int32_t c = nodes.index(cursor.number<Size>(), cursor);
    content.triangles.push_back({a, b, c});
  }
  content.triangle_group.insert(content.triangle_group.end(), count, group);
}

void read_edges(GmshCursor& cursor, GmshContent& content, Size count,
                const std::vector<int>& groups) {
  for (Size i = 0; i < count; ++i) {
    cursor.number<Size>();
    const std::int32_t a = content.nodes.index(cursor.number<Size>(), cursor);
    const std::int32_t b = content.nodes.index(cursor.number<Size>(), cursor);
    for (const int group : groups) {
      content.edges[group].push_back({a, b});
    }
  }
}

void read_points(GmshCursor& cursor, GmshContent& content, Size count,
                 const std::vector<int>& groups) {
  for (Size i = 0; i < count; ++i) {
    cursor.number<Size>();
    const std::int32_t node = content.nodes.index(cursor.number<Size>(), cursor);
    for (const int group : groups) {
      content.points[group].push_back(node);
    }
  }
}

Size read_element_block(GmshCursor& cursor, GmshContent& content, Size left) {
  const auto entity_dimension = cursor.number<std::int32_t>();
  const auto entity = cursor.number<std::int32_t>();
  const auto type = cursor.number<std::int32_t>();
  const int dimension = element_dimension(type, cursor);
  const auto count = cursor.number<Size>();
  if (entity_dimension != dimension) {
    cursor.fail(fmt::format("elements of dimension {} stand under an entity of dimension {}",
                            dimension, entity_dimension));
  }
  require_left(count, left, "elements", cursor);
  const auto numbers = static_cast<Size>(dimension) + 2;
  cursor.require(count, numbers * sizeof(Size), numbers, "elements in a block");
  const auto found = content.entity_groups.find({dimension, entity});
  const std::vector<int> groups =
      found != content.entity_groups.end() ? found->second : std::vector<int>{};
  if (dimension == 2) {
    read_triangles(cursor, content, count, region_of(entity, groups, content, cursor));
  } else if (dimension == 1) {
    read_edges(cursor, content, count, groups);
  } else {
    read_points(cursor, content, count, groups);
  }
  return count;
}

}  // namespace

void read_entities_41(GmshCursor& cursor, GmshContent& content) {
  std::array<Size, 4> counts{};
  for (Size& count : counts) {
    count = cursor.number<Size>();
  }
  for (int dimension = 0; dimension < 4; ++dimension) {
    const Size count = counts[static_cast<std::size_t>(dimension)];
    cursor.require(count, sizeof(std::int32_t) + 3 * sizeof(double) + sizeof(Size), 5,
                   "geometric entities");
    for (Size i = 0; i < count; ++i) {
      read_entity(cursor, content, dimension);
    }
  }
}

void read_nodes_41(GmshCursor& cursor, GmshContent& content) {
  const SectionSize size = read_section_size(cursor);
  cursor.require(size.items, sizeof(Size) + 3 * sizeof(double), 4, "nodes");
  require_countable(size.items, "nodes", {cursor.file()});
  content.nodes.reserve(size.items);
  std::vector<Size> tags;
  Size found = 0;
  for (Size block = 0; block < size.blocks; ++block) {
    found += read_node_block(cursor, content, size.items - found, tags);
  }
  require_all(found, size.items, "nodes", cursor);
  content.nodes.finish(cursor);
}

void read_elements_41(GmshCursor& cursor, GmshContent& content) {
  const SectionSize size = read_section_size(cursor);
  cursor.require(size.items, 2 * sizeof(Size), 2, "elements");
  require_countable(size.items, "elements", {cursor.file()});
  content.triangles.reserve(size.items);
  content.triangle_group.reserve(size.items);
  Size found = 0;
  for (Size block = 0; block < size.blocks; ++block) {
    found += read_element_block(cursor, content, size.items - found);
  }
  require_all(found, size.items, "elements", cursor);
}

}  // namespace percolith::mesh
