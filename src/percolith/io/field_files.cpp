// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/field_files.hpp"

#include "percolith/io/field_names.hpp"

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

// A quantity that the physics of the run does not have is an empty array, and is left out.
void add_if_any(std::vector<DataArray>& arrays, const char* name,
                const std::vector<double>& values) {
  if (!values.empty()) {
    arrays.push_back(real(name, values));
  }
}

std::vector<DataArray> point_quantities(const std::vector<double>& pressure,
                                        const std::vector<double>& head,
                                        const std::vector<double>& saturation) {
  std::vector<DataArray> arrays;
  add_if_any(arrays, names::pressure, pressure);
  add_if_any(arrays, names::head, head);
  add_if_any(arrays, names::saturation, saturation);
  return arrays;
}

void add_fields(std::vector<DataArray>& arrays, const std::vector<simulation::FrameField>& fields) {
  for (const simulation::FrameField& field : fields) {
    std::visit(
        [&](const auto& values) {
          arrays.push_back({field.name, std::span(values)});
        },
        field.values);
  }
}

}  // namespace

UnstructuredGrid matrix_grid(double time, const simulation::MatrixFrame& matrix,
                             std::vector<std::int32_t>& connectivity) {
  connectivity = flat(matrix.triangles);
  UnstructuredGrid grid;
  grid.time = time;
  grid.shape = CellShape::triangle;
  grid.points = matrix.points;
  grid.connectivity = connectivity;
  grid.point_data = point_quantities(matrix.pressure, matrix.head, matrix.saturation);
  add_fields(grid.point_data, matrix.point_fields);
  if (!matrix.flux.empty()) {
    grid.cell_data.push_back({names::darcy_flux, std::span<const Point>(matrix.flux)});
  }
  grid.cell_data.push_back(whole(names::region, matrix.region));
  add_fields(grid.cell_data, matrix.cell_fields);
  return grid;
}

UnstructuredGrid crack_grid(double time, const simulation::CrackFrame& cracks,
                            std::vector<std::int32_t>& connectivity) {
  connectivity = flat(cracks.segments);
  UnstructuredGrid grid;
  grid.time = time;
  grid.shape = CellShape::line;
  grid.points = cracks.points;
  grid.connectivity = connectivity;
  grid.point_data = point_quantities(cracks.pressure, cracks.head, cracks.saturation);
  add_if_any(grid.cell_data, names::aperture, cracks.aperture);
  add_if_any(grid.cell_data, names::crack_flux, cracks.flux);
  grid.cell_data.push_back(whole(names::fracture, cracks.group));
  add_fields(grid.cell_data, cracks.cell_fields);
  return grid;
}

void write_matrix(const std::filesystem::path& path, double time,
                  const simulation::MatrixFrame& matrix) {
  std::vector<std::int32_t> connectivity;
  write_vtu(path, matrix_grid(time, matrix, connectivity));
}

void write_cracks(const std::filesystem::path& path, double time,
                  const simulation::CrackFrame& cracks) {
  std::vector<std::int32_t> connectivity;
  write_vtu(path, crack_grid(time, cracks, connectivity));
}

}  // namespace percolith::io
