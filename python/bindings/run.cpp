// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/io/history.hpp"
#include "percolith/io/probes.hpp"
#include "percolith/io/summary.hpp"
#include "percolith/simulation/report.hpp"

#include <nanobind/stl/map.h>
#include <nanobind/stl/unique_ptr.h>

#include "driven_run.hpp"
#include "frames.hpp"
#include "modules.hpp"
#include "source.hpp"
#include "states.hpp"
#include "views.hpp"

namespace percolith::python {
namespace {

using nb::literals::operator""_a;
using Simulation = simulation::Simulation;

std::unique_ptr<DrivenRun> start(const std::string& file, const std::optional<std::string>& text,
                                 const std::vector<std::string>& overrides,
                                 const std::optional<std::string>& output, bool force,
                                 std::optional<int> threads, bool quiet, const nb::object& print,
                                 const nb::object& alert) {
  runner::RunRequest request;
  request.source = make_source(file, text, overrides);
  request.output = output;
  request.existing = force ? io::Existing::replace : io::Existing::refuse;
  request.threads = threads;
  request.quiet = quiet;
  return DrivenRun::start(request, {print, alert});
}

/// The present state as `history.csv` and the probes would tell it, by the name of the table.
std::map<std::string, std::string> present_tables(DrivenRun& run) {
  return run.with([](Simulation& simulation) {
    std::map<std::string, std::string> tables;
    const simulation::HistoryRow row = simulation.look();
    tables["history"] = io::history_header(row) + io::history_line(row);
    for (const simulation::ProbeSample& sample : simulation.probes()) {
      tables["probes/" + sample.name] =
          io::probe_header(sample) + io::probe_lines(simulation.time(), sample);
    }
    return tables;
  });
}

/// What `summary.json` would tell of the present state.
std::string summary(DrivenRun& run) {
  return run.with([&](Simulation& simulation) {
    io::RunRecord record;
    record.title = run.run()->read_case().setup.title;
    record.regions = simulation.region_names();
    record.fractures = simulation.fracture_names();
    record.warnings = run.run()->read_case().warnings;
    simulation::Summary present = simulation.summary();
    present.last = simulation.look();
    return io::summary_json(record, present, {});
  });
}

std::optional<MeshView> mesh_of(DrivenRun& run) {
  const Simulation& simulation = run.run()->simulation();
  const mesh::Mesh& mesh =
      simulation.flow() != nullptr ? simulation.flow()->mesh : simulation.motion()->mesh;
  return MeshView{run.run(), &mesh};
}

std::optional<FlowView> flow_of(DrivenRun& run) {
  const seepage::Model* model = run.run()->simulation().flow();
  return model != nullptr ? std::optional(FlowView{run.run(), model}) : std::nullopt;
}

std::optional<MotionView> motion_of(DrivenRun& run) {
  const mechanics::Model* model = run.run()->simulation().motion();
  return model != nullptr ? std::optional(MotionView{run.run(), model}) : std::nullopt;
}

using Values = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

std::span<const double> span_of(const Values& values) {
  return {values.data(), values.shape(0)};
}

nb::object writable(std::span<double> values, nb::handle owner) {
  return nb::cast(
      nb::ndarray<nb::numpy, double, nb::ndim<1>>(values.data(), {values.size()}, owner));
}

std::vector<Point> points_of(const Values& values) {
  std::vector<Point> points;
  for (std::size_t i = 0; i + 1 < values.shape(0); i += 2) {
    points.push_back({values.data()[i], values.data()[i + 1]});
  }
  return points;
}

void bind_driving(nb::class_<DrivenRun>& run) {
  run.def_static("start", &start, "file"_a, "text"_a = nb::none(),
                 "overrides"_a = std::vector<std::string>(), "output"_a = nb::none(),
                 "force"_a = false, "threads"_a = nb::none(), "quiet"_a = true, "print"_a,
                 "alert"_a, "Builds the model of a case. Raises CaseError and FileError.");
  run.def_static(
      "reopen",
      [](const std::string& folder, std::optional<int> threads, bool quiet, const nb::object& print,
         const nb::object& alert) {
        return DrivenRun::reopen(folder, threads, quiet, {print, alert});
      },
      "folder"_a, "threads"_a = nb::none(), "quiet"_a = true, "print"_a, "alert"_a,
      "Goes on with a run from its last checkpoint; None where it has finished.");
  run.def("begin", &DrivenRun::begin, "Reports time zero, unless that was done.");
  run.def("advance", &DrivenRun::advance, "until"_a, "steps"_a, "at_output"_a,
          "Makes steps to the first that reaches `until` (s), `steps` in number, or an output; "
          "true where there is more to do. Raises SolverError.");
  run.def("close", &DrivenRun::close, "by"_a,
          "Ends a run before its end; a checkpoint, a last frame and a summary are left.");
}

void bind_looks(nb::class_<DrivenRun>& run) {
  run.def_prop_ro("has_begun", &DrivenRun::has_begun, "Whether time zero has been reported.");
  run.def_prop_ro("is_over", &DrivenRun::is_over, "Whether nothing is left to do.");
  run.def_prop_ro(
      "time", [](DrivenRun& r) { return r.run()->simulation().time(); }, "Present time, s.");
  run.def_prop_ro(
      "steps", [](DrivenRun& r) { return r.run()->simulation().steps(); },
      "Steps made since time zero.");
  run.def_prop_ro(
      "end", [](DrivenRun& r) { return r.run()->read_case().setup.time.end; },
      "Time at which the run ends, s.");
  run.def_prop_ro(
      "case_warnings", [](DrivenRun& r) { return r.run()->read_case().warnings; },
      "Warnings of the case file, with their places.");
  run.def_prop_ro("outputs", &DrivenRun::outputs, "Outputs so far, that of time zero included.");
  run.def_prop_ro(
      "tables", [](const DrivenRun& r) { return r.tables(); },
      "What the tables of the results hold so far, as text by name.");
  run.def("present_tables", &present_tables, "The present state as rows of the same tables.");
  run.def("summary", &summary, "The present state as `summary.json` would tell it.");
  run.def(
      "check",
      [](DrivenRun& r) {
        simulation::CheckReport report = r.with([](Simulation& s) { return s.check(); });
        const std::vector<std::string>& of_file = r.run()->read_case().warnings;
        report.warnings.insert(report.warnings.begin(), of_file.begin(), of_file.end());
        return report;
      },
      "Counts, mesh quality, limits of the time step and warnings.");
  run.def(
      "frame",
      [](DrivenRun& r) { return frame_arrays(r.with([](Simulation& s) { return s.frame(); })); },
      "The present fields of matrix and cracks.");
  run.def_prop_ro("mesh", &mesh_of, "The mesh.");
  run.def_prop_ro("flow", &flow_of, "What flows; None in mechanics of dry rock.");
  run.def_prop_ro("motion", &motion_of, "What moves; None in a run of flow alone.");
}

}  // namespace

void bind_run(nb::module_& module) {
  nb::class_<DrivenRun> run(module, "Run", "A case on its way to its results.");
  bind_driving(run);
  bind_looks(run);
  run.def(
      "start_from",
      [](DrivenRun& r, const Values& displacement, const Values& velocity) {
        r.with([&](Simulation&) {
          r.run()->start_from({points_of(displacement), points_of(velocity)});
        });
      },
      "displacement"_a, "velocity"_a,
      "Displacements (m) and velocities (m/s) at time zero, x and y of each vertex in turn; empty "
      "for none. Raises CaseError.");
  run.def(
      "set_condition",
      [](DrivenRun& r, const std::string& path, double value) {
        r.with([&](Simulation&) { r.run()->set_condition(path, value); });
      },
      "path"_a, "value"_a,
      "The value (SI) that a condition of the flow has from now on. Raises CaseError.");
  run.def(
      "set_pore_pressure",
      [](DrivenRun& r, const Values& pressure) {
        r.with([&](Simulation& s) { s.set_pore_pressure(span_of(pressure)); });
      },
      "pressure"_a, "Pressures of the pores per corner slot, Pa. Raises CaseError.");
  run.def(
      "set_crack_pressure",
      [](DrivenRun& r, const Values& pressure) {
        r.with([&](Simulation& s) { s.set_crack_pressure(span_of(pressure)); });
      },
      "pressure"_a, "Pressures of the open crack nodes per vertex, Pa. Raises CaseError.");
  run.def(
      "change_pressures",
      [](DrivenRun& r, const Values& pores, const Values& former_pores, const Values& cracks,
         const Values& former_cracks) {
        r.with([&](Simulation& s) {
          s.change_pressures({span_of(pores), span_of(former_pores)},
                             {span_of(cracks), span_of(former_cracks)});
        });
      },
      "pores"_a, "former_pores"_a, "cracks"_a, "former_cracks"_a,
      "The same for those nodes of both that have another pressure than the former, or for none. "
      "Raises CaseError.");
  run.def(
      "pressure_memory",
      [](nb::handle self) {
        const auto memory =
            nb::cast<DrivenRun&>(self).with([](Simulation& s) { return s.pressure_memory(); });
        return nb::make_tuple(writable(memory.pores, self), writable(memory.cracks, self));
      },
      "Pressures of pores (corner slots,) and cracks (vertices,) in place, Pa, to be written to. "
      "Raises CaseError.");
}

}  // namespace percolith::python
