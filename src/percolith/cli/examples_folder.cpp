// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/examples_folder.hpp"

#include "percolith/cli/executable.hpp"
#include "percolith/core/error.hpp"

#include <algorithm>
#include <system_error>

namespace percolith::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const char* action, const std::error_code& error) {
  throw FileError(path.string() + ": cannot " + action + ": " + error.message());
}

bool belongs_to_example(const fs::path& entry) {
  const std::string name = entry.filename().string();
  return !name.starts_with('.') && !name.ends_with(".results") && name != "results" &&
         name != "__pycache__";
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    entries.push_back(entry->path());
  }
  if (error) {
    fail(folder, "read the folder", error);
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

void copy_entries(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to, error);
  if (error) {
    fail(to, "make the folder", error);
  }
  for (const fs::path& entry : entries_of(from)) {
    const fs::path copy = to / entry.filename();
    if (!belongs_to_example(entry)) {
      continue;
    }
    if (fs::is_directory(entry)) {
      copy_entries(entry, copy);
    } else if (fs::copy_file(entry, copy, error); error) {
      fail(copy, "write the file", error);
    }
  }
}

}  // namespace

fs::path examples_folder() {
  std::vector<fs::path> places;
  if (const fs::path program = executable_folder(); !program.empty()) {
    places.push_back(program / "../../../examples");
    places.push_back(program / "../share/percolith/examples");
  }
  places.emplace_back(PERCOLITH_EXAMPLES_DIR);
  std::string tried;
  for (const fs::path& place : places) {
    std::error_code error;
    if (fs::is_directory(place, error)) {
      return place;
    }
    tried += (tried.empty() ? "" : ", ") + place.lexically_normal().string();
  }
  throw FileError("no examples found in " + tried);
}

std::vector<Example> list_examples(const fs::path& folder) {
  std::vector<Example> examples;
  for (const fs::path& entry : entries_of(folder)) {
    if (fs::exists(entry / "case.toml")) {
      examples.push_back({entry.filename().string(), entry});
    }
  }
  return examples;
}

void copy_folder(const fs::path& example, const fs::path& target) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (fs::exists(status) && (!fs::is_directory(status) || !entries_of(target).empty())) {
    throw InputError(
        {{}, "DIR", target.string(), "exists and is not an empty folder", "a new or empty folder"});
  }
  copy_entries(example, target);
}

}  // namespace percolith::cli
