// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/vtu.hpp"

#include "percolith/io/compressed_blocks.hpp"
#include "percolith/io/file_output.hpp"
#include "percolith/io/xml_text.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <stdexcept>
#include <type_traits>

namespace percolith::io {
namespace {

// The XML part of a file and the compressed arrays it points to, in the order of their offsets.
class Appended {
public:
  template <class T>
  void add(const std::string& name, const char* type, int components, std::span<const T> values,
           const char* more = "") {
    xml_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{} "
                        "format=\"appended\" offset=\"{}\"/>\n",
                        type, escape_xml(name), components, more, size_);
    constexpr Content content = std::is_same_v<T, double> ? Content::reals : Content::integers;
    blocks_.push_back(compress_blocks(std::as_bytes(values), content));
    size_ += blocks_.back().size();
  }
  void line(const std::string& text) { xml_ += text + '\n'; }
  [[nodiscard]] const std::string& xml() const { return xml_; }
  [[nodiscard]] const std::vector<std::string>& blocks() const { return blocks_; }

private:
  std::string xml_;
  std::vector<std::string> blocks_;
  std::size_t size_ = 0;
};

std::vector<double> in_space(std::span<const Point> vectors) {
  std::vector<double> values;
  values.reserve(3 * vectors.size());
  for (const Point& vector : vectors) {
    values.insert(values.end(), {vector.x, vector.y, 0.0});
  }
  return values;
}

void add(Appended& file, const std::string& name, std::span<const double> values) {
  file.add(name, "Float64", 1, values);
}

void add(Appended& file, const std::string& name, std::span<const std::int32_t> values) {
  file.add(name, "Int32", 1, values);
}

void add(Appended& file, const std::string& name, std::span<const Point> values) {
  const std::vector<double> vectors = in_space(values);
  file.add(name, "Float64", 3, std::span<const double>(vectors));
}

void add_all(Appended& file, const char* element, const std::vector<DataArray>& arrays,
             std::size_t count) {
  file.line(fmt::format("<{}>", element));
  for (const DataArray& array : arrays) {
    const std::size_t size =
        std::visit([](const auto& values) { return values.size(); }, array.values);
    if (size != count) {
      throw std::invalid_argument(
          fmt::format("array {} holds {} values where {} belong", array.name, size, count));
    }
    std::visit([&](const auto& values) { add(file, array.name, values); }, array.values);
  }
  file.line(fmt::format("</{}>", element));
}

void add_cells(Appended& file, const UnstructuredGrid& grid, std::size_t cells,
               std::int32_t corners) {
  std::vector<std::int32_t> offsets(cells);
  std::int32_t end = 0;
  for (std::int32_t& offset : offsets) {
    offset = end += corners;
  }
  const std::vector<std::uint8_t> types(cells, static_cast<std::uint8_t>(grid.shape));
  file.line("<Cells>");
  add(file, "connectivity", grid.connectivity);
  add(file, "offsets", std::span<const std::int32_t>(offsets));
  file.add("types", "UInt8", 1, std::span<const std::uint8_t>(types));
  file.line("</Cells>");
}

}  // namespace

void write_vtu(const std::filesystem::path& path, const UnstructuredGrid& grid) {
  static_assert(std::endian::native == std::endian::little, "the header below says LittleEndian");
  const std::int32_t corners = grid.shape == CellShape::line ? 2 : 3;
  const std::size_t cells = grid.connectivity.size() / static_cast<std::size_t>(corners);

  Appended file;
  file.line("<?xml version=\"1.0\"?>");
  file.line("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">");
  file.line("<UnstructuredGrid>\n<FieldData>");
  const std::array<double, 1> time = {grid.time};
  file.add("TimeValue", "Float64", 1, std::span<const double>(time), " NumberOfTuples=\"1\"");
  file.line("</FieldData>");
  file.line(
      fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">", grid.points.size(), cells));
  add_all(file, "PointData", grid.point_data, grid.points.size());
  add_all(file, "CellData", grid.cell_data, cells);
  file.line("<Points>");
  add(file, "Points", grid.points);
  file.line("</Points>");
  add_cells(file, grid, cells, corners);
  file.line("</Piece>\n</UnstructuredGrid>");

  AtomicFile output(path);
  output.write(file.xml() + "<AppendedData encoding=\"raw\">\n_");
  for (const std::string& block : file.blocks()) {
    output.write(block);
  }
  output.write("\n</AppendedData>\n</VTKFile>\n");
  output.commit(Durability::buffered);
}

}  // namespace percolith::io
