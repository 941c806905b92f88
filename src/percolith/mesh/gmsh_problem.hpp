// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/error.hpp"
#include "percolith/core/vec2.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace percolith::mesh {

/// Throws InputError about the mesh file, with key `mesh.file`.
[[noreturn]] void fail_mesh(const FileLocation& location, const std::string& reason,
                            const std::string& allowed = {});

/// A point as messages show it: `(x, y)`, m.
[[nodiscard]] std::string place_text(const Point& place);

/// Text from a file, made fit for a message: short and printable, whatever the file holds.
[[nodiscard]] std::string printable_text(std::string_view text);

/// Throws InputError when `count` items cannot be numbered: indices have 32 bits, and a triangle
/// has three corners of its own.
void require_countable(std::uint64_t count, std::string_view what, const FileLocation& location);

}  // namespace percolith::mesh
