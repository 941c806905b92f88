// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace percolith::runner {

/// Version and revision, as results carry them: `0.1.0 (4ff44d5)`.
[[nodiscard]] std::string version_and_revision();

/// What `percolith --version` prints: version, revision, compiler and its flags.
[[nodiscard]] std::string version_text();

}  // namespace percolith::runner
