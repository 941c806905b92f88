// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/core/error.hpp"
#include "percolith/coupling/build.hpp"
#include "percolith/coupling/coupled_step.hpp"
#include "percolith/coupling/drainage.hpp"
#include "percolith/coupling/quasi_static.hpp"
#include "percolith/coupling/step_limit.hpp"
#include "percolith/seepage/flow_graph.hpp"
#include "percolith/seepage/state.hpp"
#include "percolith/seepage/steady_flow.hpp"
#include "percolith/simulation/balance.hpp"
#include "percolith/simulation/build_model.hpp"
#include "percolith/simulation/check_report.hpp"
#include "percolith/simulation/coupled_run.hpp"
#include "percolith/simulation/event_clock.hpp"
#include "percolith/simulation/groups.hpp"
#include "percolith/simulation/run.hpp"
#include "percolith/simulation/solid_task.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace percolith::simulation {
namespace {

using mesh::Index;

/// What helps where a steady start would need suction: motion has no implicit scheme, and the voids
/// of cracks can always empty.
constexpr std::string_view way_out_of_suction =
    "Start from initial.pressure or initial.water_table in place of initial.steady, or take out "
    "less at time 0: a schedule may begin with 0 and rise later";

// Steps of a quasi-static run, unless told: the longest and the first one fit so often into it.
constexpr double least_steps_of_a_run = 20.0;
constexpr double first_steps_of_a_run = 100.0;
// Steps that take many iterations are too long, those that take few too short.
constexpr int few_iterations = 8;
constexpr int many_iterations = 25;
constexpr double step_growth = 1.5;
constexpr double step_shrinkage = 0.5;

/// Biot coefficient of each region of the mesh.
std::vector<double> biot_of_regions(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<double> biot;
  for (const std::string& name : material_of_regions(setup, mesh)) {
    biot.push_back(setup.material.at(name).biot_coefficient);
  }
  return biot;
}

/// Fracture group of the flow that each joint belongs to once fluid enters: its own fracture table,
/// or else that of new cracks.
std::vector<Index> groups_of_joints(const Setup& setup, const mesh::Mesh& mesh) {
  std::vector<Index> group(mesh.joint.size(), static_cast<Index>(setup.fracture.size()));
  Index number = 0;
  for (const auto& [name, fracture] : setup.fracture) {
    for (const Index j : fracture_joints(mesh, fracture.groups, "fracture." + name + ".groups")) {
      group[at(j)] = number;
    }
    ++number;
  }
  return group;
}

seepage::Model make_water(const Setup& setup, const mesh::GmshMesh& mesh) {
  seepage::Model model = build_model(setup, mesh);
  require_datum(setup, model);
  if (setup.initial.steady) {
    Execution serial(Backend::serial);
    seepage::solve_steady(model, serial, way_out_of_suction);
  }
  return model;
}

std::map<std::string, Index> add_drainage(const Setup& setup, seepage::Model& water) {
  std::map<std::string, Index> drainage;
  for (const auto& [name, excavation] : setup.excavation) {
    drainage[name] = coupling::add_drainage(water, "excavation." + name, excavation.pressure);
  }
  return drainage;
}

/// Joints that fluid is in or may enter.
std::vector<Index> joints_for_fluid(const mechanics::Model& rock) {
  std::vector<Index> joints;
  for (Index j = 0; j < rock.mesh.joints(); ++j) {
    const mechanics::JointState state = rock.joints.state[at(j)];
    if (state != mechanics::JointState::tied && state != mechanics::JointState::rigid) {
      joints.push_back(j);
    }
  }
  return joints;
}

/// What the motion takes of a setup. In a quasi-static run it only finds the balance of forces: its
/// step is its own.
Setup setup_of_motion(const Setup& setup) {
  Setup motion = setup;
  if (setup.time.scheme == Scheme::quasi_static) {
    motion.time.step.reset();
  }
  return motion;
}

class CoupledTask : public SolidTask {
public:
  CoupledTask(const Setup& setup, SolidRun rock, WaterRun water)
      : SolidTask(setup, std::move(rock)),
        water_(std::move(water)), model_{run_.dynamics,
                                         water_.model,
                                         {setup.model.fluid_enters,
                                          groups_of_joints(setup, water_.model.mesh)}},
        limit_(model_), is_slow_(setup.time.scheme == Scheme::quasi_static) {
    water_.in_place_at_start = seepage::fluid_in_place(water_.model, run_.execution);
    warn(model_warnings(setup, water_.model));
    warn(water_.probes.warnings());
    if (is_slow_) {
      choose_flow_step(setup.time);
      scheme_ = std::make_unique<coupling::QuasiStatic>(
          model_,
          coupling::QuasiStaticOptions{setup.time.tolerance, balance_tolerance(setup.time)});
    } else {
      scheme_ = std::make_unique<coupling::CoupledStep>(model_, setup.time.pore_flow,
                                                        longest_pore_step());
      warn_of_pore_steps();
    }
  }

  [[nodiscard]] CheckReport check() const override;
  [[nodiscard]] Summary summary() const override;

  [[nodiscard]] Frame frame() const override {
    return {time(), run_.summary.steps, coupled_matrix_frame(run_, water_),
            coupled_crack_frame(run_, water_)};
  }
  [[nodiscard]] std::vector<ProbeSample> probes() const override {
    return read_coupled_probes(run_, water_);
  }
  /// The scheme of a quasi-static run starts each step from what it found in the one before.
  [[nodiscard]] FluidAccess fluid() override {
    return is_slow_ && run_.summary.steps > 0
               ? FluidAccess{}
               : FluidAccess{&water_.model, &water_.in_place_at_start};
  }
  [[nodiscard]] ConditionAccess conditions() override;
  [[nodiscard]] const seepage::Model* flow() const override { return &water_.model; }

protected:
  mechanics::Changes move(double dt) override {
    mechanics::Changes changes = scheme_->advance(dt, run_.execution);
    if (gave_up()) {
      return changes;
    }
    run_.summary.iterations += scheme_->iterations();
    if (is_slow_) {
      judge_flow_step(dt);
    } else {
      limit_now_ = limit_.motion(model_);
    }
    return changes;
  }
  void listen(const std::function<bool()>& stop) override { scheme_->listen(stop); }
  [[nodiscard]] coupling::Doing doing() const override { return scheme_->doing(); }
  [[nodiscard]] bool gave_up() const override { return scheme_->gave_up(); }
  /// A quasi-static step goes far.
  [[nodiscard]] std::int64_t steps_between_checks() const override {
    return is_slow_ ? 1 : SolidTask::steps_between_checks();
  }
  [[nodiscard]] double longest_step() const override {
    return is_slow_ ? flow_step_ : std::min(step_, run_.setup.time.safety * limit_now_);
  }
  [[nodiscard]] const char* limited_by() const override {
    if (is_slow_) {
      return is_fixed_ ? "given step" : "iterations";
    }
    return run_.setup.time.safety * limit_now_ < step_ ? "fluid in cracks"
                                                       : SolidTask::limited_by();
  }
  [[nodiscard]] double next_break(double t) const override {
    return std::min(SolidTask::next_break(t), water_.model.conditions.next_break(t));
  }
  void set_time(double t) override {
    SolidTask::set_time(t);
    water_.model.state.time = t;
  }
  HistoryRow history_row(double step_size) override {
    run_.summary.throughput = water_.model.rate_in;
    return coupled_history_row(run_, water_, scheme_->leaked(), step_size);
  }
  void take_out(const Digging& digging) override;
  bool has_settled() override;
  void describe_state(StateArchive& archive) override;
  void require_valid() const override;
  [[nodiscard]] std::int64_t iterations() const override { return scheme_->iterations(); }

private:
  /// Probes in the rock have told what is wrong with them once already.
  void warn(const std::vector<std::string>& warnings) {
    std::vector<std::string>& known = run_.summary.warnings;
    std::copy_if(warnings.begin(), warnings.end(), std::back_inserter(known),
                 [&](const std::string& warning) {
                   return std::find(known.begin(), known.end(), warning) == known.end();
                 });
  }
  [[nodiscard]] double longest_pore_step() const { return run_.setup.time.safety * limit_.pores(); }
  void choose_flow_step(const Stepping& time);
  void judge_flow_step(double dt);
  void warn_of_pore_steps();
  /// Explicit steps of the pores in each of the motion.
  [[nodiscard]] double pore_steps() const {
    return std::ceil(longest_step() / longest_pore_step());
  }

  WaterRun water_;
  coupling::CoupledModel model_;
  coupling::StepLimit limit_;
  bool is_slow_;                              // quasi-static
  double limit_now_ = limit_.motion(model_);  // s
  std::unique_ptr<coupling::Scheme> scheme_;
  double flow_step_ = 0.0;          // s: of a quasi-static run
  double longest_flow_step_ = 0.0;  // s
  bool is_fixed_ = false;           // whether all its steps are equal
  // Per vertex: pressure in the cracks when rest was looked for last, Pa.
  std::vector<double> checked_pressure_ = std::vector<double>(water_.model.mesh.vertex.size(), 0.0);
};

/// The pressures in the cracks change by less than the share of the largest that counts as rest.
bool CoupledTask::has_settled() {
  const std::vector<double>& now = water_.model.state.crack_pressure;
  double most = 0.0;
  double change = 0.0;
  for (const Index v : water_.model.cracks.open_nodes()) {
    most = std::max(most, std::abs(now[at(v)]));
    change = std::max(change, std::abs(now[at(v)] - checked_pressure_[at(v)]));
  }
  checked_pressure_ = now;
  return change <= run_.setup.time.stop_ratio.value_or(0.0) * most;
}

ConditionAccess CoupledTask::conditions() {
  ConditionAccess access{&water_.model, {}};
  for (const auto& [name, boundary] : run_.setup.boundary) {
    if (boundary.pressurised) {
      access.pressing.push_back("boundary." + name);
    }
  }
  for (const auto& [name, number] : water_.drainage) {
    access.pressing.push_back("excavation." + name);
  }
  return access;
}

void CoupledTask::warn_of_pore_steps() {
  // An implicit step costs about as much as so many explicit ones (docs/choosing.md).
  constexpr double many = 100.0;
  if (run_.setup.time.pore_flow == PoreFlow::explicit_ && pore_steps() > many) {
    run_.summary.warnings.push_back(
        fmt::format("the pores take {:g} explicit steps in each step of the motion; time.pore_flow "
                    "= \"implicit\" takes one",
                    pore_steps()));
  }
}

void CoupledTask::choose_flow_step(const Stepping& time) {
  is_fixed_ = time.step.has_value();
  longest_flow_step_ =
      time.step.value_or(time.maximum_step.value_or(time.end / least_steps_of_a_run));
  flow_step_ = is_fixed_ ? longest_flow_step_
                         : std::min(time.initial_step.value_or(time.end / first_steps_of_a_run),
                                    longest_flow_step_);
}

void CoupledTask::judge_flow_step(double dt) {
  run_.summary.rejected_steps += scheme_->parts() - 1;
  if (is_fixed_) {
    return;
  }
  if (scheme_->parts() > 1 || scheme_->iterations() > many_iterations) {
    flow_step_ = std::min(flow_step_, step_shrinkage * dt);
  } else if (scheme_->iterations() < few_iterations) {
    flow_step_ = std::min(step_growth * flow_step_, longest_flow_step_);
  }
}

void CoupledTask::take_out(const Digging& digging) {
  SolidTask::take_out(digging);
  coupling::drain(model_, digging.triangles, water_.drainage.at(digging.name));
  scheme_->network_changed();
}

/// Excavations that are done have changed the conditions of the flow.
void CoupledTask::describe_state(StateArchive& archive) {
  const std::vector<Digging> known = diggings_;
  SolidTask::describe_state(archive);
  archive("water", water_.model);
  archive("in_place_at_start", water_.in_place_at_start);
  if (archive.reads()) {
    for (std::size_t i = 0; i + diggings_.size() < known.size(); ++i) {
      coupling::drain(model_, known[i].triangles, water_.drainage.at(known[i].name));
    }
    run_.dynamics.model().pores.pressure = water_.model.state.pressure;
    water_.model.swelling = run_.dynamics.model().pores.growth;
  }
  archive("scheme", *scheme_);
  archive("flow_step", flow_step_);
  archive("checked_pressure", checked_pressure_);
  limit_now_ = limit_.motion(model_);
}

CheckReport CoupledTask::check() const {
  CheckReport report = SolidTask::check();
  const CheckReport flow = make_check_report(run_.setup, water_.model, {});
  report.pore_nodes = flow.pore_nodes;
  report.crack_nodes = flow.crack_nodes;
  if (run_.setup.time.scheme == Scheme::explicit_ &&
      run_.setup.time.pore_flow == PoreFlow::explicit_) {
    report.unknowns = flow.crack_nodes;
    report.mechanics.emplace_back("explicit steps of the pores per step of the motion",
                                  static_cast<std::int64_t>(pore_steps()));
  } else {
    report.unknowns = flow.unknowns;
  }
  if (limit_now_ < limit_.rock() && !report.limits.empty()) {
    // The stiffness of the fluid adds to all others.
    report.limits.back().step = limit_now_;
  }
  if (!is_slow_) {
    const double later = run_.setup.time.safety * limit_.in_new_cracks(model_);
    if (later < longest_step()) {
      report.mechanics.emplace_back("step once new cracks are there, before they widen (s)", later);
    }
  }
  return report;
}

Summary CoupledTask::summary() const {
  Summary summary = SolidTask::summary();
  StateHash hash;
  run_.dynamics.add_to(hash);
  summary.state_hash = hash.text() + hash_of(water_.model.state);
  for (const char* const name : {"crack_length_m", "filled_crack_length_m", "mean_aperture_m",
                                 "crack_volume_m2", "crack_fluid_m2", "leaked_m2"}) {
    const auto& values = summary.last.mechanics;
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const NamedValue& value) { return value.first == name; });
    if (found != values.end()) {
      summary.mechanics.emplace_back(found->first, found->second);
    }
  }
  return summary;
}

void CoupledTask::require_valid() const {
  SolidTask::require_valid();
  simulation::require_valid(water_.model, run_.summary.steps, ", or lower time.safety");
}

}  // namespace

std::unique_ptr<Task> make_coupled_task(const Setup& setup, const mesh::GmshMesh& mesh) {
  require_sensible_intervals(setup);
  seepage::Model water = make_water(setup, mesh);
  std::map<std::string, Index> drainage = add_drainage(setup, water);
  const std::vector<double> biot = biot_of_regions(setup, water.mesh);
  const Setup motion = setup_of_motion(setup);
  SolidStart start = build_solid(motion, mesh, [&](mechanics::Model& rock) {
    coupling::moisten(rock, water, biot, setup.model.joint_stress);
  });
  ProbeReader probes(setup.probe, water, joints_for_fluid(start.dynamics.model()),
                     setup.model.head_datum);
  return std::make_unique<CoupledTask>(
      setup, make_solid_run(motion, std::move(start)),
      WaterRun{std::move(water), std::move(probes), 0.0, std::move(drainage)});
}

}  // namespace percolith::simulation
