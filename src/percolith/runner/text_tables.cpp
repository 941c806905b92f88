// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/runner/text_tables.hpp"

#include "percolith/io/events.hpp"
#include "percolith/io/fragments.hpp"
#include "percolith/io/history.hpp"
#include "percolith/io/probes.hpp"

namespace percolith::runner {
namespace {

template <class Header>
std::string& table(std::map<std::string, std::string>& tables, const std::string& name,
                   const Header& header) {
  std::string& text = tables[name];
  if (text.empty()) {
    text = header();
  }
  return text;
}

}  // namespace

void TextTables::on_history(const simulation::HistoryRow& row) {
  table(tables_, "history", [&] { return io::history_header(row); }) += io::history_line(row);
}

void TextTables::on_probes(double time, const std::vector<simulation::ProbeSample>& samples) {
  // Probes come with every output, even where none are asked for.
  ++outputs_;
  for (const simulation::ProbeSample& sample : samples) {
    table(tables_, "probes/" + sample.name, [&] { return io::probe_header(sample); }) +=
        io::probe_lines(time, sample);
  }
}

void TextTables::on_events(const std::vector<simulation::BreakEvent>& events) {
  table(tables_, "events", io::events_header) += io::event_lines(events);
}

void TextTables::on_fragments(double time, const std::vector<simulation::FragmentRow>& rows) {
  table(tables_, "fragments", io::fragments_header) += io::fragment_lines(time, rows);
}

}  // namespace percolith::runner
