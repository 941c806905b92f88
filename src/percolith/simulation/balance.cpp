// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/simulation/balance.hpp"

#include "percolith/core/hash.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace percolith::simulation {
MassBalance mass_balance(const seepage::Model& model, double in_place_at_start,
                         const Execution& execution) {
  MassBalance balance;
  balance.in_place = seepage::fluid_in_place(model, execution);
  balance.stored = balance.in_place - in_place_at_start;
  for (std::size_t i = 0; i < model.let_in.size(); ++i) {
    balance.by_condition[model.conditions.name[i]] = model.let_in[i].total();
  }
  balance.in = model.passed_in.total();
  balance.out = model.passed_out.total();
  balance.error = balance.in - balance.out - balance.stored;
  const double scale = balance.in_place + balance.in + balance.out;
  balance.relative_error = scale > 0.0 ? std::abs(balance.error) / scale : 0.0;
  return balance;
}

MassBalance steady_balance(const seepage::Model& model, double round_off,
                           const Execution& execution) {
  MassBalance balance;
  balance.in_place = seepage::fluid_in_place(model, execution);
  for (std::size_t i = 0; i < model.rate.size(); ++i) {
    balance.by_condition[model.conditions.name[i]] = model.rate[i];
  }
  balance.in = model.rate_in;
  balance.out = model.rate_out;
  balance.error = balance.in - balance.out;
  const double throughput = std::max(balance.in, balance.out);
  balance.relative_error = throughput > round_off ? std::abs(balance.error) / throughput : 0.0;
  return balance;
}

HistoryRow history_row(const seepage::Model& model, const MassBalance& balance) {
  HistoryRow row;
  row.time = model.state.time;
  row.balance = balance;
  const seepage::State& s = model.state;
  bool first = true;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const auto c = at(mesh::corner_of(t, k));
      row.minimum_pressure = first ? s.pressure[c] : std::min(row.minimum_pressure, s.pressure[c]);
      row.maximum_pressure = first ? s.pressure[c] : std::max(row.maximum_pressure, s.pressure[c]);
      row.minimum_saturation = std::min(row.minimum_saturation, s.saturation[c]);
      first = false;
    }
  }
  for (const Index v : model.cracks.open_nodes()) {
    const double p = s.crack_pressure[at(v)];
    row.minimum_crack_pressure = std::min(row.minimum_crack_pressure.value_or(p), p);
    row.maximum_crack_pressure = std::max(row.maximum_crack_pressure.value_or(p), p);
    row.minimum_saturation = std::min(row.minimum_saturation, s.crack_saturation[at(v)]);
  }
  for (std::size_t i = 0; i < model.rate.size(); ++i) {
    row.rate[model.conditions.name[i]] = model.rate[i];
  }
  return row;
}

std::optional<std::string> find_invalid(const seepage::Model& model) {
  const seepage::State& s = model.state;
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Index c = mesh::corner_of(t, k);
      if (!std::isfinite(s.pressure[at(c)]) || !std::isfinite(s.saturation[at(c)])) {
        const Point p = model.mesh.place_of(c);
        return fmt::format("pore pressure at ({:.6g}, {:.6g})", p.x, p.y);
      }
    }
  }
  for (const Index v : model.cracks.open_nodes()) {
    if (!std::isfinite(s.crack_pressure[at(v)]) || !std::isfinite(s.crack_saturation[at(v)])) {
      const Point p = model.mesh.vertex[at(v)];
      return fmt::format("crack pressure at ({:.6g}, {:.6g})", p.x, p.y);
    }
  }
  return std::nullopt;
}

std::optional<std::string> find_overdrawn(const seepage::Model& model) {
  // Donors weighted by the mean saturation drain nodes below zero by themselves (theory.md section
  // 2).
  if (model.weight == seepage::SaturationWeight::mean) {
    return std::nullopt;
  }
  constexpr double tolerance = 1e-3;
  const seepage::State& s = model.state;
  const auto text = [](const char* kind, const Point& p) {
    return fmt::format("{} at ({:.6g}, {:.6g})", kind, p.x, p.y);
  };
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    for (Index k = 0; k < 3; ++k) {
      const Index c = mesh::corner_of(t, k);
      if (s.saturation[at(c)] < -tolerance) {
        return text("pore node", model.mesh.place_of(c));
      }
    }
  }
  for (const Index v : model.cracks.open_nodes()) {
    if (s.crack_saturation[at(v)] < -tolerance) {
      return text("crack node", model.mesh.vertex[at(v)]);
    }
  }
  return std::nullopt;
}

std::string hash_of(const seepage::State& state) {
  StateHash hash;
  for (const auto* field : {&state.pressure, &state.saturation, &state.content,
                            &state.content_carry, &state.crack_pressure, &state.crack_saturation,
                            &state.crack_content, &state.crack_content_carry}) {
    hash.add(*field);
  }
  hash.add(state.time);
  return hash.text();
}

}  // namespace percolith::simulation
