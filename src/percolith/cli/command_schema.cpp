// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/case/documents.hpp"
#include "percolith/cli/commands.hpp"
#include "percolith/cli/console.hpp"
#include "percolith/core/error.hpp"

namespace percolith::cli {

int schema(const SchemaOptions& options) {
  std::string text = options.reference ? case_file::reference_markdown() : case_file::schema_json();
  if (!text.ends_with('\n')) {
    text += '\n';
  }
  print(text);
  return static_cast<int>(ExitCode::success);
}

}  // namespace percolith::cli
