// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace percolith::io {

/// `text` as it stands inside an XML attribute in double quotes.
[[nodiscard]] std::string escape_xml(std::string_view text);

}  // namespace percolith::io
