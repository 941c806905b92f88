// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/simulation/report.hpp"

#include <map>
#include <string>

namespace percolith::runner {

/// Keeps what a run writes into its tables (`history.csv`, `events.csv`, `fragments.csv`,
/// `probes/<name>.csv`) in memory, by the name of the file without `.csv`: the same text.
class TextTables : public simulation::Observer {
public:
  void on_history(const simulation::HistoryRow& row) override;
  void on_probes(double time, const std::vector<simulation::ProbeSample>& samples) override;
  void on_events(const std::vector<simulation::BreakEvent>& events) override;
  void on_fragments(double time, const std::vector<simulation::FragmentRow>& rows) override;
  /// Outputs so far, that of time zero among them.
  [[nodiscard]] int outputs() const { return outputs_; }
  [[nodiscard]] const std::map<std::string, std::string>& tables() const { return tables_; }

private:
  int outputs_ = 0;
  std::map<std::string, std::string> tables_;
};

}  // namespace percolith::runner
