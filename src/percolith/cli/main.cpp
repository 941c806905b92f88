// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/cli/program.hpp"

#include <string>
#include <vector>

int main(int argc, char* argv[]) {
  return percolith::cli::run_program(std::vector<std::string>(argv + 1, argv + argc));
}
