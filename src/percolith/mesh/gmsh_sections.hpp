// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mesh/gmsh_content.hpp"
#include "percolith/mesh/gmsh_cursor.hpp"

// Readers of the sections of a `.msh` file (Gmsh reference manual, "MSH file format" and "Legacy
// formats"). Each starts behind the section's first line and stops before its `$End` line; each
// throws InputError at the cursor.
namespace percolith::mesh {

/// `$PhysicalNames`, text in every version.
void read_physical_names(GmshCursor& cursor, GmshContent& content);

/// Version 2.2. Elements carry the number of their physical group; an element in several groups
/// stands once for each.
void read_nodes_22(GmshCursor& cursor, GmshContent& content);
void read_elements_22(GmshCursor& cursor, GmshContent& content);

/// Version 4.1. Elements carry the tag of their geometric entity, entities their physical groups.
void read_entities_41(GmshCursor& cursor, GmshContent& content);
void read_nodes_41(GmshCursor& cursor, GmshContent& content);
void read_elements_41(GmshCursor& cursor, GmshContent& content);

}  // namespace percolith::mesh
