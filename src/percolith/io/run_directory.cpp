// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/run_directory.hpp"

#include "percolith/core/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace percolith::io {
namespace {

namespace fs = std::filesystem;

// The log is never removed by a new run, so a lock on it cannot be lost to one that replaces it.
constexpr const char* log_name = "run.log";
constexpr std::array<std::string_view, 8> table_names = {
    "resolved.toml", "summary.json", "history.csv", "events.csv",
    "fragments.csv", "matrix.pvd",   "cracks.pvd",  checkpoint_name};

[[noreturn]] void refuse(const fs::path& path, const char* reason, std::string allowed) {
  throw InputError({{}, "--output", path.string(), reason, std::move(allowed)});
}

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
  throw FileError(
      fmt::format("{}: cannot use the folder for output: {}", path.string(), error.message()));
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    entries.push_back(entry->path());
  }
  if (error) {
    fail(folder, error);
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_run_file(const fs::path& file, std::string_view start, std::string_view extension) {
  std::string name = file.filename().string();
  if (name.ends_with(".part")) {
    name.resize(name.size() - 5);
  }
  return name.starts_with(start) && name.ends_with(extension);
}

// Returns the number of the lock, -1 where another process holds it.
int try_lock(const fs::path& log, int flags) {
  const int number = ::open(log.c_str(), flags | O_CLOEXEC, 0666);
  if (number < 0) {
    fail(log.parent_path(), std::error_code(errno, std::generic_category()));
  }
  if (::flock(number, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(number);
    return -1;
  }
  return number;
}

// Throws unless the folder may be written to; the caller has seen that no other run holds it.
void require_replaceable(const fs::path& path, Existing existing) {
  std::vector<fs::path> entries = entries_of(path);
  // A run that was killed at once leaves these and nothing else.
  std::erase_if(entries, [](const fs::path& entry) {
    return entry.filename() == log_name || entry.filename() == "resolved.toml.part";
  });
  if (entries.empty()) {
    return;
  }
  const bool is_run_directory =
      fs::exists(path / "resolved.toml") || fs::exists(path / "summary.json");
  if (!is_run_directory) {
    refuse(path, "the folder is not empty and holds no results of a run", "a new or empty folder");
  }
  if (existing == Existing::refuse) {
    const bool can_go_on = fs::exists(path / checkpoint_name);
    refuse(path, "the folder holds results of an earlier run",
           std::string(can_go_on ? "--resume to go on with an unfinished run, " : "") +
               "--force to replace them, or another --output");
  }
}

void remove_results(const fs::path& path) {
  std::vector<fs::path> old;
  for (const fs::path& entry : entries_of(path)) {
    // The new input takes the place of the old one: until then it tells whose folder this is.
    const bool known =
        entry.filename() != "resolved.toml" &&
        std::any_of(table_names.begin(), table_names.end(),
                    [&](std::string_view name) { return is_run_file(entry, name, name); });
    if (known) {
      old.push_back(entry);
    }
  }
  const auto add_files = [&](const char* folder, std::string_view start,
                             std::string_view extension) {
    if (fs::is_directory(path / folder)) {
      for (const fs::path& entry : entries_of(path / folder)) {
        if (is_run_file(entry, start, extension)) {
          old.push_back(entry);
        }
      }
    }
  };
  add_files("fields", "matrix_", ".vtu");
  add_files("fields", "cracks_", ".vtu");
  add_files("probes", "", ".csv");
  for (const fs::path& file : old) {
    std::error_code error;
    if (!fs::remove(file, error) && error) {
      fail(file, error);
    }
  }
}

}  // namespace

fs::path RunDirectory::default_path(const fs::path& case_file) {
  return case_file.stem().string() + ".results";
}

void RunDirectory::require_usable(const fs::path& path, Existing existing) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    return;
  }
  if (!fs::is_directory(status)) {
    refuse(path, "is not a folder", "the name of a folder");
  }
  if (fs::exists(path / log_name)) {
    const FileDescriptor lock(try_lock(path / log_name, O_RDONLY));
    if (!lock.is_open()) {
      refuse(path, "another run is writing to this folder",
             "another --output, or wait for that run to end");
    }
  }
  require_replaceable(path, existing);
}

RunDirectory RunDirectory::open(const fs::path& path, Existing existing) {
  require_usable(path, existing);
  make_folder(path);
  FileDescriptor lock(try_lock(path / log_name, O_RDWR | O_CREAT));
  if (!lock.is_open()) {
    refuse(path, "another run is writing to this folder",
           "another --output, or wait for that run to end");
  }
  require_replaceable(path, existing);
  remove_results(path);
  if (::ftruncate(lock.number(), 0) != 0) {
    fail(path, std::error_code(errno, std::generic_category()));
  }
  return {path, std::move(lock)};
}

RunDirectory RunDirectory::reopen(const fs::path& path) {
  const auto refuse_to_go_on = [&](const char* reason, const char* allowed) {
    throw InputError({{}, "--resume", path.string(), reason, allowed});
  };
  if (!fs::is_directory(path)) {
    refuse_to_go_on("there is no such folder", "the folder of a run");
  }
  if (!fs::exists(path / log_name) || !fs::exists(path / "resolved.toml")) {
    refuse_to_go_on("the folder holds no run", "the folder of a run");
  }
  FileDescriptor lock(try_lock(path / log_name, O_RDWR));
  if (!lock.is_open()) {
    refuse_to_go_on("another run is writing to this folder", "wait for that run to end");
  }
  return {path, std::move(lock)};
}

void RunDirectory::remove_checkpoint() const {
  remove_file(file(checkpoint_name));
  remove_file(file(checkpoint_name) += ".part");  // of one that was cut short
}

}  // namespace percolith::io
