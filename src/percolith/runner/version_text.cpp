// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/version_text.hpp"

#include "percolith/version.hpp"

#include <fmt/format.h>

namespace percolith::runner {

std::string version_and_revision() {
  return fmt::format("{} ({})", build::version, build::revision);
}

std::string version_text() {
  return fmt::format("percolith {}\ncompiled by {}, flags {}", version_and_revision(),
                     build::compiler, build::flags);
}

}  // namespace percolith::runner
