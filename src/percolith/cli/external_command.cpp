// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/external_command.hpp"

#include "percolith/case/nearest.hpp"
#include "percolith/cli/command_line.hpp"
#include "percolith/cli/executable.hpp"
#include "percolith/core/error.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <system_error>
#include <vector>

namespace percolith::cli {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view prefix = "percolith-";

// The program's own folder first, then the PATH in its order.
std::vector<fs::path> search_folders() {
  std::vector<fs::path> folders;
  if (const fs::path own = executable_folder(); !own.empty()) {
    folders.push_back(own);
  }
  const char* path = std::getenv("PATH");
  std::istringstream list(path == nullptr ? "" : path);
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) {
      folders.emplace_back(folder);
    }
  }
  return folders;
}

bool is_program(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

fs::path find_program(const std::string& name) {
  for (const fs::path& folder : search_folders()) {
    if (fs::path program = folder / (std::string(prefix) + name); is_program(program)) {
      return program;
    }
  }
  return {};
}

std::vector<std::string> all_commands() {
  std::set<std::string> names(command_names.begin(), command_names.end());
  for (const fs::path& folder : search_folders()) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
      const std::string file = entry->path().filename().string();
      if (file.starts_with(prefix) && is_program(entry->path())) {
        names.insert(file.substr(prefix.size()));
      }
    }
  }
  return {names.begin(), names.end()};
}

[[noreturn]] void refuse(const std::string& name) {
  const std::vector<std::string> commands = all_commands();
  std::string reason = "unknown command " + name;
  const std::vector<std::string_view> names(commands.begin(), commands.end());
  if (const std::string_view nearest = case_file::nearest_name(name, names); !nearest.empty()) {
    reason += ", did you mean " + std::string(nearest) + "?";
  }
  std::string allowed;
  for (const std::string& command : commands) {
    allowed += (allowed.empty() ? "" : ", ") + command;
  }
  throw InputError({{}, "", "", reason, allowed});
}

}  // namespace

bool is_external_command(std::string_view name) {
  return !name.starts_with('-') &&
         std::find(command_names.begin(), command_names.end(), name) == command_names.end();
}

int run_external_command(std::span<const std::string> arguments) {
  const std::string& name = arguments.front();
  const fs::path program = name.find('/') == std::string::npos ? find_program(name) : fs::path();
  if (program.empty()) {
    refuse(name);
  }
  std::vector<std::string> words(arguments.begin(), arguments.end());
  words.front() = program.string();
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  ::execv(program.c_str(), pointers.data());
  throw FileError(program.string() +
                  ": cannot start the program: " + std::generic_category().message(errno));
}

}  // namespace percolith::cli
