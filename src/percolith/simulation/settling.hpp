// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/seepage/model.hpp"
#include "percolith/simulation/report.hpp"
#include "percolith/simulation/setup.hpp"

#include <cstdint>
#include <vector>

namespace percolith::simulation {

/// Watches a flow with `time.stop_ratio` until it is steady or at rest (theory.md section 6). Each
/// look compares the fluid in every node with that of the look before.
class Settling {
public:
  /// `model` is as the run starts.
  Settling(const Stepping& time, const seepage::Model& model);

  /// Whether anything is looked for.
  [[nodiscard]] bool is_wanted() const { return time_.stop_ratio.has_value(); }
  /// Looks at the model, some steps after the last look; true once it has settled and no condition
  /// is to change until the end of the run. Must be wanted.
  [[nodiscard]] bool look(const seepage::Model& model);
  /// What the last look saw.
  [[nodiscard]] const Settlement& seen() const { return seen_; }

  void describe_state(StateArchive& archive);

private:
  /// Fluid that moved into or out of the nodes since the last look, m2; keeps what they hold now.
  double take_change(const seepage::Model& model);
  /// Judges the rates of change and of throughput, m2/s.
  [[nodiscard]] bool is_calm(const seepage::Model& model, double change, double through);
  /// Flow that the last digit of the largest pressure drives, m2/s.
  [[nodiscard]] double round_off(const seepage::Model& model) const;

  Stepping time_;
  double conductance_ = 0.0;   // sum of all, m2/(Pa s)
  double largest_lift_ = 0.0;  // Pa
  // At the last look: excess of the pore nodes, by corner, and of the crack nodes, m2.
  std::vector<double> content_, crack_content_;
  double passed_in_ = 0.0, passed_out_ = 0.0;  // then, m2
  double looked_at_ = 0.0;                     // s
  double moved_ = 0.0;                         // m2: the changes of all looks
  std::int64_t calm_looks_ = 0;                // in a row
  Settlement seen_;
};

}  // namespace percolith::simulation
