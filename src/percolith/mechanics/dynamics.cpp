// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/dynamics.hpp"

#include "percolith/mechanics/excavation.hpp"
#include "percolith/mechanics/pressed_faces.hpp"
#include "percolith/mechanics/wet_joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace percolith::mechanics {
namespace {

CornerMotion motion_of(const Model& model) {
  const Motion& m = model.motion;
  return {m.ux, m.uy, m.vx, m.vy};
}

EnergyStart start_of(const Model& model, const JointTable& table) {
  Execution serial(Backend::serial);
  EnergyStart start{0.0, elastic_energy(model, displacements_before(model, 0.0), serial),
                    stored_in_joints(model, table, serial)};
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    const double w = model.triangles.inverse_mass[at(t)];
    for (Index k = 0; w > 0.0 && k < 3; ++k) {
      const auto c = at(mesh::corner_of(t, k));
      start.kinetic +=
          0.5 / w *
          (model.motion.vx[c] * model.motion.vx[c] + model.motion.vy[c] * model.motion.vy[c]);
    }
  }
  return start;
}

/// How far the pores have grown, in the present places.
struct MeasureGrowth {
  explicit MeasureGrowth(Model& model) : solid(model), motion(&model.motion), pores(&model.pores) {}

  void operator()(ScalarLane lane) const {
    const Index t = lane.first;
    const auto u =
        load_corners<ScalarLane>(motion->ux.data(), motion->uy.data(), mesh::corner_of(t, 0));
    pores->growth[at(t)] = solid.pore_growth<ScalarLane>(t, u);
  }

  SolidForces solid;
  const Motion* motion;
  PoreFluid* pores;
};

}  // namespace

std::vector<std::uint8_t> contact_candidates(const Model& model) {
  std::vector<std::uint8_t> at_vertex(model.mesh.vertex.size(), 0);
  const auto mark = [&](const std::array<Index, 2>& ends) {
    at_vertex[at(ends[0])] = 1;
    at_vertex[at(ends[1])] = 1;
  };
  for (const mesh::BoundaryEdge& edge : model.mesh.boundary) {
    mark(edge.vertex);
  }
  for (Index j = 0; j < model.mesh.joints(); ++j) {
    if (model.bonded[at(j)] == 0) {
      mark(model.mesh.joint[at(j)].vertex);
    }
  }
  std::vector<std::uint8_t> candidate(at(model.mesh.triangles()), 0);
  for (Index t = 0; t < model.mesh.triangles(); ++t) {
    for (const Index v : model.mesh.triangle_vertex[at(t)]) {
      if (at_vertex[at(v)] != 0 && model.triangles.inverse_mass[at(t)] > 0.0) {
        candidate[at(t)] = 1;
      }
    }
  }
  return candidate;
}

Dynamics::Dynamics(Model model, LoadList loads, SupportSet supports, ContactProperties contact)
    : model_(std::move(model)), table_(joint_table(model_)), loads_(model_.mesh, std::move(loads)),
      supports_(std::move(supports)), contact_penalty_(contact.penalty),
      contact_(model_.mesh, std::move(contact)), start_(start_of(model_, table_)) {
  if (model_.any_tied) {
    buffers_.resize(model_.mesh.corners());
  }
  model_.loads.resistance = loads_.resistances(model_.mesh);
  model_.energy.kinetic = start_.kinetic;
  start_contact();
}

Changes Dynamics::advance(double dt, Execution& execution) {
  return step(motion_law(model_, dt), execution);
}

Changes Dynamics::creep(double dt, Execution& execution) {
  return step(creeping_law(dt, true), execution);
}

Changes Dynamics::pull(double dt, Execution& execution) {
  return step(creeping_law(dt, false), execution);
}

void Dynamics::shift(std::span<const double> way, double dt, Execution& execution) {
  Motion& m = model_.motion;
  const std::size_t corners = m.ux.size();
  // The step before has booked half of the way that its velocities would have led.
  for (std::size_t c = 0; c < corners; ++c) {
    m.vx[c] = 0.5 * (way[2 * c] / dt - m.vx[c]);
    m.vy[c] = 0.5 * (way[2 * c + 1] / dt - m.vy[c]);
  }
  const ContactForces contact{contact_.force_x(), contact_.force_y(), contact_.acts()};
  book_works(execution.sum_each<terms>("works", model_.mesh.triangles(),
                                       WorkOfPath{Move(model_, contact, creeping_law(dt, false))}));
  double furthest = 0.0;
  for (std::size_t c = 0; c < corners; ++c) {
    const Point w{way[2 * c], way[2 * c + 1]};
    m.ux[c] += w.x;
    m.uy[c] += w.y;
    m.vx[c] = w.x / dt;
    m.vy[c] = w.y / dt;
    furthest = std::max(furthest, dot(w, w));
  }
  travelled_ = std::sqrt(furthest);
}

void Dynamics::halt(Execution& execution) {
  Motion& m = model_.motion;
  const double back = 0.5 * m.last_step;
  for (std::size_t c = 0; c < m.ux.size(); ++c) {
    m.ux[c] -= back * m.vx[c];
    m.uy[c] -= back * m.vy[c];
  }
  // Faces that slide have come along.
  contact_.advance(model_.mesh, motion_of(model_), travelled_, back, execution);
  std::fill(m.vx.begin(), m.vx.end(), 0.0);
  std::fill(m.vy.begin(), m.vy.end(), 0.0);
  model_.energy.damping += model_.energy.kinetic;
  model_.energy.kinetic = 0.0;
  if (SolidForces(model_).is_wet()) {
    execution.for_each("pore growth", model_.mesh.triangles(), MeasureGrowth(model_));
  }
  measure_faces(model_, execution);
  book_faces(model_);
  book_pores(model_);
}

Changes Dynamics::step(const MotionLaw& law, Execution& execution) {
  set_joint_forces(execution);
  add_closed_joints(model_, execution);
  press_faces(model_, execution);
  contact_.advance(model_.mesh, motion_of(model_), travelled_, model_.motion.last_step, execution);
  add_turns(model_, contact_);
  loads_.apply(model_);
  const double dt = law.creeps ? law.dt_velocity : law.dt;
  supports_.apply(model_, dt);
  book(move(law, execution), law.dt);
  loads_.book_absorbed(model_, law.dt);
  if (law.creeps) {
    // Velocities are ways over a time of no meaning.
    model_.energy.kinetic = 0.0;
  } else {
    model_.motion.time += dt;
  }
  model_.motion.last_step = dt;
  const auto start = std::chrono::steady_clock::now();
  Changes changes = break_failed_joints(model_, table_);
  if (changes.any()) {
    renew_contact(changes);
  }
  execution.book("breakage", start);
  return changes;
}

void Dynamics::set_joint_forces(Execution& execution) {
  if (model_.pores.joint_share.empty()) {
    execution.for_each("joints", model_.mesh.joints(), JointForces(model_, table_));
    return;
  }
  const auto totals =
      execution.sum_each<1>("joints", model_.mesh.joints(), WetJointForces(model_, table_));
  model_.energy.fluid_work += totals.sum[0];
}

LaneTotals<terms> Dynamics::move(const MotionLaw& law, Execution& execution) {
  const ContactForces contact{contact_.force_x(), contact_.force_y(), contact_.acts()};
  const Move motion(model_, contact, law);
  const Index n = model_.mesh.triangles();
  if (!model_.any_tied) {
    return execution.sum_each<terms>("triangles and motion", n, motion);
  }
  execution.for_each("triangles", n, StoreForces{motion, &buffers_});
  LaneTotals<terms> totals = execution.sum_each<terms>(
      "motion", model_.mesh.vertices(), MoveNodes{motion, &buffers_, &model_.mesh, &model_.nodes});
  const auto finished = execution.sum_each<terms>("motion", n, FinishMotion{motion, &buffers_});
  for (std::size_t k = 0; k < terms; ++k) {
    totals.sum[k] += finished.sum[k];
  }
  totals.peak = std::max(totals.peak, finished.peak);
  return totals;
}

void Dynamics::book(const LaneTotals<terms>& totals, double dt) {
  const auto value = [&](Term term) { return totals.sum[static_cast<std::size_t>(term)]; };
  Energies& e = model_.energy;
  e.kinetic = value(Term::kinetic);
  e.unbalanced = value(Term::unbalanced);
  e.internal = value(Term::stressing);
  book_works(totals);
  travelled_ = std::sqrt(totals.peak) * dt;
}

void Dynamics::book_works(const LaneTotals<terms>& totals) {
  const auto value = [&](Term term) { return totals.sum[static_cast<std::size_t>(term)]; };
  Energies& e = model_.energy;
  e.viscous += -value(Term::viscous);
  e.load_work += value(Term::load);
  e.gravity_work += value(Term::gravity);
  e.support_work += value(Term::support);
  e.fluid_work += value(Term::fluid);
  e.damping += -value(Term::damping);
}

void Dynamics::start_contact() {
  candidate_ = contact_candidates(model_);
  faces_touch_.resize(model_.mesh.joint.size());
  for (std::size_t j = 0; j < faces_touch_.size(); ++j) {
    faces_touch_[j] = model_.joints.state[j] == JointState::broken ? 1 : 0;
  }
  contact_.topology_changed(model_.mesh, {candidate_, &model_.fans, faces_touch_});
}

void Dynamics::renew_contact(const Changes& changes) {
  std::vector<Index> changed;
  for (const Breakage& b : changes.broke) {
    changed.push_back(b.joint);
  }
  for (const ClosedJointEnd& end : changes.parted) {
    changed.push_back(end.joint);
  }
  for (const Index j : changed) {
    faces_touch_[at(j)] = model_.joints.state[at(j)] == JointState::broken ? 1 : 0;
    for (const Index v : model_.mesh.joint[at(j)].vertex) {
      for (const Index corner : model_.mesh.vertex_corners.row(v)) {
        const Index t = mesh::triangle_of(corner);
        candidate_[at(t)] = model_.triangles.inverse_mass[at(t)] > 0.0 ? 1 : 0;
      }
    }
  }
  contact_.topology_changed(model_.mesh, {candidate_, &model_.fans, faces_touch_}, changed);
  for (const ClosedJointEnd& end : changes.parted) {
    if (end.normal_force > 0.0) {
      contact_.hand_over(model_.mesh,
                         {end.joint, end.normal_force, end.shear_on_first, end.stiffness});
    }
  }
}

void Dynamics::take_out(std::span<const Index> triangles, double duration, double pressure) {
  std::vector<std::uint8_t> removed(at(model_.mesh.triangles()), 0);
  for (const Index t : triangles) {
    removed[at(t)] = 1;
  }
  if (model_.motion.last_step == 0.0) {
    loads_.apply(model_);
  }
  const ContactRelease contact = contact_.release(model_.mesh, motion_of(model_), removed);
  model_.energy.taken_out += contact.energy;
  FadingSupport support = remove_triangles(model_, table_, triangles, removed, duration);
  support.pressure = pressure;
  support.force.insert(support.force.end(), contact.force.begin(), contact.force.end());
  loads_.add_fading(model_.mesh, std::move(support));
  start_contact();
}

double Dynamics::unbalanced_ratio() const {
  const Energies& e = model_.energy;
  if (e.internal > 0.0) {
    return e.unbalanced / e.internal;
  }
  return e.unbalanced > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

EnergyBalance Dynamics::energy(const Execution& execution) const {
  // What looks at the state leaves the account of the run alone.
  Execution loops(execution.backend(), execution.threads());
  const Motion& m = model_.motion;
  const Displacements u = displacements_before(model_, 0.5 * m.last_step);
  const double pressed = contact_.potential_energy(model_.mesh, {u.ux, u.uy, m.vx, m.vy});
  return energy_balance(model_, table_, start_,
                        {pressed + contact_.stored_tangential(), contact_.friction_dissipation()},
                        u, loops);
}

std::vector<std::array<Index, 2>> Dynamics::overlapping() const {
  return contact_.overlapping(model_.mesh, motion_of(model_));
}

void Dynamics::add_to(StateHash& hash) const {
  const Motion& m = model_.motion;
  for (const auto* field : {&m.ux, &m.uy, &m.vx, &m.vy}) {
    hash.add(*field);
  }
  for (std::size_t g = 0; g < 2; ++g) {
    hash.add(model_.joints.damage[g]);
    hash.add(model_.joints.opening_peak[g]);
    hash.add(model_.joints.slip_peak[g]);
    hash.add(model_.joints.past.slope[g]);
    hash.add(model_.joints.past.friction[g]);
  }
  for (const ClosedJoint& closed : model_.closed) {
    hash.add(closed.shear);
    hash.add(closed.slip);
    hash.add(closed.slip_at_start);
  }
  for (const JointState state : model_.joints.state) {
    hash.add(static_cast<double>(state));
  }
  hash.add(model_.triangles.inverse_mass);
  contact_.add_to(hash);
  hash.add(m.last_step);
  hash.add(m.time);
}

}  // namespace percolith::mechanics
