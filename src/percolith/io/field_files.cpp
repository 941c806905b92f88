// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/field_files.hpp"

#include "percolith/io/field_names.hpp"
#include "percolith/io/vtu.hpp"

namespace percolith::io {
namespace {

template <std::size_t N>
std::vector<std::int32_t> flat(const std::vector<std::array<std::int32_t, N>>& cells) {
  std::vector<std::int32_t> indices;
  indices.reserve(N * cells.size());
  for (const auto& cell : cells) {
    indices.insert(indices.end(), cell.begin(), cell.end());
  }
  return indices;
}

DataArray real(const char* name, const std::vector<double>& values) {
  return {name, std::span<const double>(values)};
}

DataArray whole(const char* name, const std::vector<std::int32_t>& values) {
  return {name, std::span<const std::int32_t>(values)};
}

std::vector<DataArray> point_quantities(const std::vector<double>& pressure,
                                        const std::vector<double>& head,
                                        const std::vector<double>& saturation) {
  std::vector<DataArray> arrays = {real(names::pressure, pressure)};
  if (!head.empty()) {
    arrays.push_back(real(names::head, head));
  }
  arrays.push_back(real(names::saturation, saturation));
  return arrays;
}

}  // namespace

void write_matrix(const std::filesystem::path& path, double time,
                  const simulation::MatrixFrame& matrix) {
  const std::vector<std::int32_t> connectivity = flat(matrix.triangles);
  UnstructuredGrid grid;
  grid.time = time;
  grid.shape = CellShape::triangle;
  grid.points = matrix.points;
  grid.connectivity = connectivity;
  grid.point_data = point_quantities(matrix.pressure, matrix.head, matrix.saturation);
  grid.cell_data = {{names::darcy_flux, std::span<const Point>(matrix.flux)},
                    whole(names::region, matrix.region)};
  write_vtu(path, grid);
}

void write_cracks(const std::filesystem::path& path, double time,
                  const simulation::CrackFrame& cracks) {
  const std::vector<std::int32_t> connectivity = flat(cracks.segments);
  UnstructuredGrid grid;
  grid.time = time;
  grid.shape = CellShape::line;
  grid.points = cracks.points;
  grid.connectivity = connectivity;
  grid.point_data = point_quantities(cracks.pressure, cracks.head, cracks.saturation);
  grid.cell_data = {real(names::aperture, cracks.aperture), real(names::crack_flux, cracks.flux),
                    whole(names::fracture, cracks.group)};
  write_vtu(path, grid);
}

}  // namespace percolith::io
