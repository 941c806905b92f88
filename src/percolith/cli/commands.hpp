// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/cli/command_line.hpp"

// The commands. Each returns the exit code of the program and throws the errors of core/error.hpp.
namespace percolith::cli {

/// Runs a case and writes its results. Earlier results are replaced only after the new case has
/// been read and its model built.
[[nodiscard]] int run(const RunOptions& options);

/// Goes on with the run in the folder `options.resume` from its last checkpoint, and comes to the
/// results of a run that was never interrupted. Nothing is changed before the checkpoint was read
/// and found to belong to the case, the mesh and this program.
[[nodiscard]] int resume(const RunOptions& options);

/// Builds the model of a case and prints what was found.
[[nodiscard]] int check(const CheckOptions& options);

/// Prints the JSON Schema or the reference page of case files.
[[nodiscard]] int schema(const SchemaOptions& options);

/// Copies an example, or lists the examples.
[[nodiscard]] int copy_example(const NewOptions& options);

}  // namespace percolith::cli
