// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace percolith::cli {

/// A worked example: a folder with a `case.toml`.
struct Example {
  std::string name;
  std::filesystem::path folder;
};

/// The folder with the examples: `examples` of the source tree the program was built in or
/// `share/percolith/examples` beside it, else where the sources were at build time. Throws
/// FileError where none of them exists.
[[nodiscard]] std::filesystem::path examples_folder();

/// The examples in `folder`, by name. Throws FileError.
[[nodiscard]] std::vector<Example> list_examples(const std::filesystem::path& folder);

/// Copies an example into `target`, which is made where it does not exist. Results of runs, hidden
/// files and caches are left behind. Throws InputError where `target` is not an empty folder, and
/// FileError.
void copy_folder(const std::filesystem::path& example, const std::filesystem::path& target);

}  // namespace percolith::cli
