// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mesh/gmsh_geo.hpp"

#include "percolith/mesh/gmsh_file.hpp"
#include "percolith/mesh/gmsh_geo_errors.hpp"
#include "percolith/mesh/gmsh_problem.hpp"
#include "percolith/mesh/gmsh_program.hpp"
#include "percolith/mesh/gmsh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace percolith::mesh {
namespace {

/// A directory of its own for the files of one meshing, deleted on the way out.
class TemporaryDirectory {
public:
  TemporaryDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "percolith-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw FileError(fmt::format("error: no temporary directory can be made in {}: {}; set TMPDIR "
                                  "to a directory with space",
                                  pattern, std::strerror(errno)));
    }
    path_ = pattern;
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

/// A script that gmsh reads after the geometry: the command line's -clmax would yield to a larger
/// bound set in the geometry.
std::filesystem::path write_size_bound(const std::filesystem::path& directory, double size) {
  std::filesystem::path path = directory / "bound.geo";
  std::ofstream file(path);
  file << fmt::format("If (Mesh.CharacteristicLengthMax > {0})\n"
                      "  Mesh.CharacteristicLengthMax = {0};\nEndIf\n"
                      "If (Mesh.CharacteristicLengthMin > {0})\n"
                      "  Mesh.CharacteristicLengthMin = {0};\nEndIf\n",
                      size);
  file.close();
  if (!file) {
    throw FileError(fmt::format("{}: error: the file cannot be written", path.string()));
  }
  return path;
}

void require_program(const ProgramResult& result, const std::filesystem::path& geometry,
                     const std::string& program) {
  if (!result.found) {
    throw FileError(fmt::format(
        "{}: error: mesh.file: a geometry is meshed by the program '{}', which is not installed; "
        "install it ('apt install gmsh'), or give a ready mesh (.msh) made elsewhere",
        geometry.string(), program));
  }
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

}  // namespace

GmshMesh mesh_geo(const std::filesystem::path& path, const GeoOptions& options) {
  require_plain_file(path);
  const TemporaryDirectory directory;
  const std::filesystem::path mesh_path = directory.path() / "mesh.msh";
  // An absolute path cannot be taken for an option.
  std::vector<std::string> command{
      options.program, "-2", "-format",          "msh41",
      "-bin",          "-o", mesh_path.string(), std::filesystem::absolute(path).string()};
  if (options.element_size > 0.0) {
    command.push_back(write_size_bound(directory.path(), options.element_size).string());
  }
  const ProgramResult result = run_program(command);
  require_program(result, path, options.program);
  throw_geo_errors(result, path);
  if (!std::filesystem::exists(mesh_path)) {
    fail_mesh({path.string()}, "gmsh wrote no mesh; run 'gmsh -2' on it to see why");
  }
  const FileContent content = read_whole_file(mesh_path);
  return read_gmsh(content.view(), path.string());
}

GmshMesh read_mesh(const std::filesystem::path& path, double element_size) {
  const std::string extension = lower_case(path.extension().string());
  const FileContent content = read_whole_file(path);
  const bool ready = looks_like_gmsh(content.view());
  if (extension == ".geo" && !ready) {
    return mesh_geo(path, {.element_size = element_size});
  }
  if (extension != ".msh" && !ready) {
    fail_mesh({path.string()},
              fmt::format("a mesh file with the extension '{}' cannot be read; where Gmsh can open "
                          "it, convert it with 'gmsh FILE -2 -o mesh.msh'",
                          extension),
              ".msh (Gmsh 2.2 or 4.1), .geo (meshed by gmsh)");
  }
  if (element_size > 0.0) {
    throw InputError({{path.string()},
                      "mesh.element_size",
                      fmt::format("{}", element_size),
                      "a ready mesh has its own element size; leave this option out, or give the "
                      "geometry (.geo) as mesh.file",
                      ""});
  }
  return read_gmsh(content.view(), path.string());
}

}  // namespace percolith::mesh
