// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/core/archive.hpp"
#include "percolith/core/vec2.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// What a simulation tells the outside: plain values in SI units, copied out of its state.
namespace percolith::simulation {

/// A further quantity of a frame, one value a point or a cell; the unit is part of the name
/// (`displacement_m`). A `Point` is a vector.
struct FrameField {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<Point>> values;
};

/// The matrix as a picture sees it: one point per pore node, so that a pressure that jumps across
/// a crack is two points at one place.
struct MatrixFrame {
  std::vector<Point> points;                           ///< m
  std::vector<std::array<std::int32_t, 3>> triangles;  ///< indices into points
  std::vector<std::int32_t> region;      ///< per triangle, index into the region names
  std::vector<double> pressure;          ///< Pa, per point; empty without flow
  std::vector<double> head;              ///< m, per point; empty without gravity or flow
  std::vector<double> saturation;        ///< 1, per point; empty without flow
  std::vector<Point> flux;               ///< Darcy flux, m/s, per triangle; empty without flow
  std::vector<FrameField> point_fields;  ///< displacement, velocity
  std::vector<FrameField> cell_fields;   ///< stress, strain, damage, ...
};

/// The open cracks as a line mesh: one point per open crack node, one segment per broken joint.
struct CrackFrame {
  std::vector<Point> points;                          ///< m
  std::vector<std::array<std::int32_t, 2>> segments;  ///< indices into points
  std::vector<std::int32_t> group;                    ///< per segment, index into fracture names
  std::vector<double> pressure;                       ///< Pa, per point
  std::vector<double> head;                           ///< m, per point; empty without gravity
  std::vector<double> saturation;                     ///< 1, per point
  std::vector<double> aperture;                       ///< m, per segment
  std::vector<double> flux;  ///< m2/s per segment, positive from its first to its second point
  std::vector<FrameField> cell_fields;  ///< opening, slip, mode, time of breakage, ...
};

/// One moment of the field series.
struct Frame {
  double time = 0.0;  ///< s
  std::int64_t step = 0;
  MatrixFrame matrix;
  CrackFrame cracks;
};

/// One row of a probe: quantities that do not exist there (head without gravity, aperture in the
/// matrix) are absent from `values`. Keys carry units: `pressure_Pa`, `head_m`, `saturation`,
/// `flux_x_m_per_s`, `flux_y_m_per_s`; in cracks `aperture_m`, `flux_x_m2_per_s`,
/// `flux_y_m2_per_s`; in mechanics `displacement_x_m` and so on. A value is not a number where the
/// rock was taken out.
struct ProbeRow {
  Point place;  ///< m
  std::vector<double> values;
};

/// All rows of one probe at one time.
struct ProbeSample {
  std::string name;
  std::vector<std::string> columns;  ///< of ProbeRow::values
  std::vector<ProbeRow> rows;
};

/// Fluid volumes (m2: m3 per metre of thickness, at reference density) since time zero.
struct MassBalance {
  double in = 0.0;              ///< through boundaries and sources
  double out = 0.0;             ///< through boundaries and sources, positive
  double stored = 0.0;          ///< growth of the content
  double in_place = 0.0;        ///< fluid in pores and cracks now
  double error = 0.0;           ///< in - out - stored
  double relative_error = 0.0;  ///< |error| over (fluid in place + throughput)
  /// Net volume let in by each condition, by its option path (`boundary.left`, `source.well`).
  std::map<std::string, double> by_condition;
};

/// How a joint broke.
enum class BreakMode { tensile = 1, shear = 2, mixed = 3 };

/// A joint that broke: what users call an acoustic emission.
struct BreakEvent {
  double time = 0.0;  ///< s
  std::int64_t step = 0;
  Point place;  ///< m, middle of the joint, undeformed
  BreakMode mode = BreakMode::tensile;
  double length = 0.0;           ///< m
  double released_energy = 0.0;  ///< J/m: spent in the joint since its peak
  double magnitude = 0.0;  ///< 2/3 (log10 of the released energy in J, of 1 m thickness - 4.8)
  std::string material;    ///< material or fracture table whose strengths the joint had
};

/// A part of the rock that hangs together through bonded joints.
struct FragmentRow {
  std::int32_t number = 0;  ///< as in the field `fragment`
  std::int64_t triangles = 0;
  double area = 0.0;  ///< m2, undeformed
  Point centre;       ///< m, of its area, where it is now
  Point velocity;     ///< m/s, mean over its mass
};

/// A named number of a history row; the unit is part of the name.
using NamedValue = std::pair<std::string, double>;

/// A named result, the unit part of its name; what counts is a whole number.
using NamedResult = std::pair<std::string, std::variant<double, std::int64_t>>;

/// The largest reaction of a boundary or a body along each axis, by magnitude and with its sign,
/// over all rows of the history; the first row that has it gives the time.
struct PeakReaction {
  std::string name;                   ///< option path: `boundary.top`, `body.platen`
  double x = 0.0, y = 0.0;            ///< N/m, force on the rock
  double x_time = 0.0, y_time = 0.0;  ///< s
};

/// The highest pressure at a source in a crack over all rows of the history; the first row that has
/// it gives the time.
struct PeakPressure {
  std::string name;       ///< option path: `source.pump`
  double pressure = 0.0;  ///< Pa
  double time = 0.0;      ///< s
};

/// One row of the history.
struct HistoryRow {
  double time = 0.0;
  std::int64_t step = 0;
  double step_size = 0.0;                                 ///< s
  double minimum_pressure = 0.0, maximum_pressure = 0.0;  ///< Pa, pores
  /// Pa; absent while no crack is open to fluid.
  std::optional<double> minimum_crack_pressure{}, maximum_crack_pressure{};
  double minimum_saturation = 1.0;
  MassBalance balance;
  /// Current rate into the model of each condition, m2/s, by its option path.
  std::map<std::string, double> rate;
  bool has_flow = true;  ///< whether the members above mean anything
  /// What motion has to tell, in the order of the columns; empty in a run of flow alone: energies,
  /// work, reactions, numbers of broken joints and fragments; of coupled runs cracks and sources.
  std::vector<NamedValue> mechanics;
};

/// Where the run stands after a step; cheap, sent every step.
struct Progress {
  double time = 0.0, end = 0.0, step_size = 0.0;  ///< s
  std::int64_t step = 0;
  std::int64_t iterations = 0;  ///< of the last implicit step
  const char* limited_by =
      "";  ///< what rules the step: "tolerance", "pore flow", "crack flow", ...
  std::optional<std::int64_t> broken_joints = std::nullopt;  ///< in mechanics
};

/// How far a flow with `time.stop_ratio` has settled: what changes in its pores and cracks between
/// the last two looks at it, over what flows through.
struct Settlement {
  double change = 0.0;   ///< 1; infinite where fluid only moves within the rock
  bool is_rest = false;  ///< ended because hardly anything flows or changes any more
};

/// What remains to be said at the end of a run.
struct Summary {
  double end_time = 0.0;  ///< s
  std::int64_t steps = 0;
  std::int64_t rejected_steps = 0;          ///< of flow
  std::int64_t iterations = 0;              ///< of flow
  std::map<std::string, double> wall_time;  ///< s per phase
  HistoryRow last;
  double throughput = 0.0;    ///< m2/s that enter, in the last step or in steady state
  std::string state_hash;     ///< of all that the state of the run consists of
  bool reached_rest = false;  ///< ended by `time.stop_ratio`
  std::optional<Settlement> settlement = std::nullopt;  ///< of flow with a `time.stop_ratio`
  /// Named results of mechanics: energy balance, broken joints by mode, fragments, b-value, added
  /// mass.
  std::vector<NamedResult> mechanics;
  std::vector<PeakReaction> peak_reactions;  ///< of mechanics
  std::vector<PeakPressure> peak_pressures;  ///< of coupled physics
  std::vector<std::string> warnings;
};

/// A moment from which a run can go on.
struct Checkpoint {
  double time = 0.0;  ///< s
  std::int64_t step = 0;
  /// Walks through the state of the run; valid during the call only.
  std::function<void(StateArchive&)> state;
};

/// Receives what a simulation has to tell, on the thread that runs it. Frames and probes come at
/// time zero, at the output times and at the end.
class Observer {
public:
  virtual ~Observer() = default;
  virtual void on_progress(const Progress&) {}
  virtual void on_history(const HistoryRow&) {}
  virtual void on_frame(const Frame&) {}
  virtual void on_probes(double /*time*/, const std::vector<ProbeSample>&) {}
  /// Joints that broke since the last call, in the order of time.
  virtual void on_events(const std::vector<BreakEvent>&) {}
  /// All fragments of a rock that may break, at the times of the frames.
  virtual void on_fragments(double /*time*/, const std::vector<FragmentRow>&) {}
  virtual void on_warning(const std::string&) {}
  /// Everything up to the step of the checkpoint has been reported, and nothing beyond.
  virtual void on_checkpoint(const Checkpoint&) {}
  /// The run goes on from a checkpoint at `time` (s): what was reported after it is void. Comes
  /// before all else.
  virtual void on_resume(double /*time*/, std::int64_t /*step*/) {}
};

/// A limit of the explicit time step: that of one mechanism, or of all of them together.
struct StepLimit {
  /// "pore flow", "finite joints", "crack flow", "exchange"; in mechanics "triangles", "joints",
  /// "contact", "viscosity"; "all together"
  std::string mechanism;
  double step = 0.0;  ///< s
  Point place;        ///< m: where it is smallest
};

/// What `percolith check` prints.
struct CheckReport {
  std::int64_t triangles = 0, vertices = 0, joints = 0, broken_joints = 0, boundary_edges = 0;
  std::int64_t pore_nodes = 0, crack_nodes = 0, unknowns = 0;
  double area = 0.0;                                       ///< m2
  Point lower_corner, upper_corner;                        ///< m, of the box round the rock
  double smallest_edge = 0.0, largest_edge = 0.0;          ///< m
  double smallest_angle = 0.0, largest_angle = 0.0;        ///< degree
  Point smallest_angle_place;                              ///< m
  double fracture_length = 0.0;                            ///< m
  std::map<std::string, double> region_area;               ///< m2
  std::map<std::string, double> fracture_length_by_group;  ///< m, by fracture table
  /// One per mechanism of the model, smallest first; the last, "all together", counts every
  /// mechanism at once and is the one that rules.
  std::vector<StepLimit> limits;
  /// Mechanics: numbers worth knowing before a run by names with their unit (cohesive length over
  /// element size, apparent modulus, bodies, added mass); empty in a run of flow alone.
  std::vector<NamedResult> mechanics;
  std::vector<std::string> warnings;
};

}  // namespace percolith::simulation
