// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/time_series.hpp"

#include "percolith/io/file_output.hpp"
#include "percolith/io/xml_text.hpp"

#include <fmt/format.h>

#include <string_view>

namespace percolith::io {

void TimeSeries::add(double time, const std::string& file) {
  entries_ +=
      fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time, escape_xml(file));
  write();
}

std::vector<std::string> TimeSeries::files() const {
  constexpr std::string_view before = "file=\"";
  std::vector<std::string> names;
  std::size_t found = entries_.find(before);
  while (found != std::string::npos) {
    const std::size_t first = found + before.size();
    const std::size_t last = entries_.find('"', first);
    names.push_back(entries_.substr(first, last - first));
    found = entries_.find(before, last);
  }
  return names;
}

void TimeSeries::write() const {
  if (entries_.empty()) {
    remove_file(path_);
    return;
  }
  write_file(path_,
             "<?xml version=\"1.0\"?>\n"
             "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
             "<Collection>\n" +
                 entries_ + "</Collection>\n</VTKFile>\n",
             Durability::buffered);
}

}  // namespace percolith::io
