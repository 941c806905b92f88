// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/console.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace percolith::cli {
namespace {

// Returns 0 or the error number.
int write_all(int number, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(number, text.data(), text.size());
    if (count < 0 && errno != EINTR) {
      return errno;
    }
    if (count > 0) {
      text.remove_prefix(static_cast<std::size_t>(count));
    }
  }
  return 0;
}

// Columns of the terminal, 80 where unknown.
int terminal_width() {
  winsize size{};
  const bool known = ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

void print(std::string_view text) {
  const int error_number = write_all(STDOUT_FILENO, text);
  if (error_number != 0 && error_number != EPIPE) {
    throw FileError("cannot write to the standard output: " +
                    std::generic_category().message(error_number));
  }
}

void print_line_to_stderr(std::string_view text) {
  // Nothing is left to tell it to where this fails.
  [[maybe_unused]] const int error_number = write_all(STDERR_FILENO, std::string(text) + '\n');
}

void print_error(const Error& error) {
  if (error.exit_code() == ExitCode::input) {
    print_line_to_stderr(error.what());
  } else {
    print_error(std::string_view(error.what()));
  }
}

void print_error(std::string_view message) {
  print_line_to_stderr("error: " + std::string(message));
}

runner::Console program_console() {
  return {print, print_line_to_stderr, ::isatty(STDOUT_FILENO) == 1, terminal_width()};
}

}  // namespace percolith::cli
