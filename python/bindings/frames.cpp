// SPDX-License-Identifier: BSD-3-Clause
#include "frames.hpp"

#include "percolith/io/field_files.hpp"

#include <memory>
#include <utility>
#include <variant>

#include "views.hpp"

namespace percolith::python {
namespace {

/// A frame with the indices of its cells, as the arrays that show it keep it.
struct KeptFrame {
  simulation::Frame frame;
  std::vector<std::int32_t> triangles, segments;
};

nb::object show(std::span<const Point> points, nb::handle owner) {
  const double* first = points.empty() ? nullptr : &points.front().x;
  return nb::cast(View<double>(first, {points.size(), 2}, owner));
}

template <class T>
nb::object show(std::span<const T> values, nb::handle owner) {
  return nb::cast(list_view(values, owner));
}

nb::dict show_all(const std::vector<io::DataArray>& arrays, nb::handle owner) {
  nb::dict shown;
  for (const io::DataArray& array : arrays) {
    shown[array.name.c_str()] =
        std::visit([&](const auto& values) { return show(values, owner); }, array.values);
  }
  return shown;
}

nb::dict grid_arrays(const io::UnstructuredGrid& grid, std::size_t corners, nb::handle owner) {
  nb::dict result;
  result["points"] = show(grid.points, owner);
  result["cells"] = nb::cast(View<std::int32_t>(
      grid.connectivity.data(), {grid.connectivity.size() / corners, corners}, owner));
  result["point_data"] = show_all(grid.point_data, owner);
  result["cell_data"] = show_all(grid.cell_data, owner);
  return result;
}

}  // namespace

nb::tuple frame_arrays(simulation::Frame frame) {
  auto kept = std::make_unique<KeptFrame>(KeptFrame{std::move(frame), {}, {}});
  KeptFrame& all = *kept;
  const nb::capsule owner(kept.release(), [](void* p) noexcept {
    const std::unique_ptr<KeptFrame> ended(static_cast<KeptFrame*>(p));
  });
  const io::UnstructuredGrid matrix =
      io::matrix_grid(all.frame.time, all.frame.matrix, all.triangles);
  const io::UnstructuredGrid cracks =
      io::crack_grid(all.frame.time, all.frame.cracks, all.segments);
  return nb::make_tuple(grid_arrays(matrix, 3, owner), grid_arrays(cracks, 2, owner));
}

}  // namespace percolith::python
