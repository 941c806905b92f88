// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/load_model.hpp"

#include "percolith/mesh/gmsh_geo.hpp"

#include <chrono>
#include <utility>

namespace percolith::runner {
namespace {

// Calls `work`, adds its wall time to `account`, and returns what it returns.
template <class Work>
auto timed(double& account, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  auto result = work();
  account += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

mesh::GmshMesh read_mesh(const case_file::Case& read) {
  const simulation::MeshOptions& options = read.setup.mesh;
  const std::filesystem::path path = read.directory / options.file;
  if (!std::filesystem::exists(path)) {
    throw InputError({{},
                      "mesh.file",
                      options.file,
                      "there is no file " + path.string(),
                      "a .msh or .geo file, relative to the case file"});
  }
  return mesh::read_mesh(path, options.element_size);
}

}  // namespace

case_file::Case read_case(const CaseSource& source) {
  return source.text ? case_file::read_case_text(*source.text, source.file, source.overrides)
                     : case_file::read_case(source.file, source.overrides);
}

LoadedModel load_model(const CaseSource& source, const simulation::StartingMotion& start) {
  std::map<std::string, double> wall_time;
  case_file::Case read = timed(wall_time["case file"], [&] { return read_case(source); });
  try {
    const mesh::GmshMesh mesh = timed(wall_time["mesh file"], [&] { return read_mesh(read); });
    simulation::Simulation built =
        timed(wall_time["model"], [&] { return simulation::Simulation(read.setup, mesh, start); });
    return {std::move(read), std::move(built), std::move(wall_time), mesh::hash_of(mesh)};
  } catch (const InputError& error) {
    throw case_file::locate(error, read);
  }
}

}  // namespace percolith::runner
