// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string_view>

namespace percolith::runner {

/// How a run speaks to whoever started it.
struct Console {
  std::function<void(std::string_view)> print;  ///< shows a text, line ends included, at once
  std::function<void(std::string_view)> alert;  ///< shows a line: a warning, or why a run stopped
  bool is_terminal = false;                     ///< whether a line can be drawn again in place
  int width = 80;                               ///< columns
  bool is_python = false;                       ///< whether runs go on by a call of Python
};

}  // namespace percolith::runner
