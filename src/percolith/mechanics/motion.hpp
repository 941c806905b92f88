// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/solid_forces.hpp"

namespace percolith::mechanics {

/// What the motion of a step adds up, in the order of `LaneSums`.
enum class Term : std::size_t {
  kinetic,     ///< 1/2 m v^2 in the middle of the step, J/m
  viscous,     ///< works over the step, J/m: of the viscous part of the stress
  load,        ///< of loads
  gravity,     ///< of gravity
  fluid,       ///< of the fluid in the pores of triangles
  damping,     ///< of nodal viscosity and local damping
  support,     ///< of supports
  unbalanced,  ///< sum of |F| of corners that are free to move, N/m
  stressing,   ///< sum of |F| of the stress alone, N/m
  count
};
inline constexpr auto terms = static_cast<std::size_t>(Term::count);

/// Forces on the corners of a triangle by their origin, N/m.
template <class Real>
struct ForcesByOrigin {
  CornerVectors<Real> stress, viscous, joint, contact, load, fluid;
  Real gravity;  ///< along y, negative, the same at each corner
};

/// What corners are moved by: views, and the lengths of the steps before and after.
struct MotionLaw {
  double damping_nodal = 0.0;  ///< mu of (2), kg/(m s)
  double damping_local = 0.0;
  double dt = 0.0;           ///< s
  double dt_velocity = 0.0;  ///< s: from the middle of the last step to the middle of this
  /// Whether rock is dragged through a medium that lets no velocity live on: it goes where forces
  /// pull it, and spends on the medium what they work.
  bool creeps = false;

  /// Force of the damping on a corner: local, against its velocity, a share of the unbalanced
  /// force; and nodal viscosity, (1), (2), taken at the new velocity so that it is stable at any
  /// step.
  template <class Real>
  PERCOLITH_DEVICE Real local_damping(Real force, Real velocity) const {
    const Real share = Real(damping_local) * magnitude(force);
    return select(velocity > Real(0.0), -share, select(velocity < Real(0.0), share, Real(0.0)));
  }

  /// New velocity, (3), of a corner of inverse mass `w` under `force`.
  template <class Real>
  PERCOLITH_DEVICE Vec2<Real> new_velocity(Vec2<Real> v, Vec2<Real> force, Real w) const {
    const Real kick = Real(dt_velocity) * w;
    if (creeps) {
      return kick * force;
    }
    const Vec2<Real> free = v + kick * force;
    if (damping_nodal == 0.0) {
      return free;
    }
    return (Real(1.0) / (Real(1.0) + Real(damping_nodal) * kick)) * free;
  }

  /// Path (m) over which the force of this moment works, from the middle of the last step to the
  /// middle of the next. Works by this path change 1/2 m v^2 exactly.
  template <class Real>
  PERCOLITH_DEVICE Vec2<Real> path(Vec2<Real> before, Vec2<Real> after) const {
    return Real(0.5 * dt_velocity) * (before + after);
  }
};

/// The law for a step of `dt` (s) after the last one.
[[nodiscard]] MotionLaw motion_law(const Model& model, double dt);

/// The law of rock that creeps: velocities are those of forces that act on masses at rest for
/// `dt` (s), at which it moves as long, or not at all.
[[nodiscard]] MotionLaw creeping_law(double dt, bool moves);

/// Forces of contact: per corner, and the blocks where there are any; all empty without contact.
struct ContactForces {
  std::span<const double> x, y;
  std::span<const std::uint8_t> acts;
};

/// Moves the triangles whose corners are all nodes of their own: forces, velocities, displacements
/// and what they add up to, in one pass.
struct Move {
  static constexpr bool vectorised = true;

  Move(Model& model, const ContactForces& contact, const MotionLaw& motion);

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane, LaneSums<terms>& sums) const {
    using Real = typename Lane::Real;
    const Index t = lane.first;
    const Index first = mesh::corner_of(t, 0);
    const CornerVectors<Real> u = load_corners<Lane>(ux, uy, first);
    const CornerVectors<Real> v = load_corners<Lane>(vx, vy, first);
    const ForcesByOrigin<Real> f = forces<Lane>(t, first, u, v);
    const Real w = Lane::load(inverse_mass + t);
    const CornerVectors<Real> fast{
        faster(lane, 0, f, v[0], w, sums),
        faster(lane, 1, f, v[1], w, sums),
        faster(lane, 2, f, v[2], w, sums),
    };
    const CornerVectors<Real> moved{u[0] + Real(law.dt) * fast[0], u[1] + Real(law.dt) * fast[1],
                                    u[2] + Real(law.dt) * fast[2]};
    store_corners<Lane>(fast, vx, vy, first);
    store_corners<Lane>(moved, ux, uy, first);
    keep_growth<Lane>(t, moved);
    book(lane, f, v, fast, w, sums);
  }

  template <class Lane>
  PERCOLITH_DEVICE ForcesByOrigin<typename Lane::Real>
  forces(Index t, Index first, const CornerVectors<typename Lane::Real>& u,
         const CornerVectors<typename Lane::Real>& v) const {
    CornerVectors<typename Lane::Real> viscous{};
    const auto stress = solid.of_stress<Lane>(t, u, v, viscous);
    return {stress,
            viscous,
            solid.of_joints<Lane>(first),
            of_contact<Lane>(t, first),
            of_loads<Lane>(t, first),
            of_pores<Lane>(t, u),
            of_gravity<Lane>(t)};
  }

  /// Keeps by how much the pores have grown at the displacements `moved`.
  template <class Lane>
  PERCOLITH_DEVICE void keep_growth(Index t,
                                    const CornerVectors<typename Lane::Real>& moved) const {
    if (solid.is_wet()) {
      Lane::store(growth + t, solid.pore_growth<Lane>(t, moved));
    }
  }

  template <class Lane>
  PERCOLITH_DEVICE CornerVectors<typename Lane::Real> of_contact(Index t, Index first) const {
    if (contact_acts != nullptr && contact_acts[t / block_width] != 0) {
      return load_corners<Lane>(contact_x, contact_y, first);
    }
    return {};
  }

  template <class Lane>
  PERCOLITH_DEVICE CornerVectors<typename Lane::Real> of_loads(Index t, Index first) const {
    if (load_acts[t / block_width] != 0) {
      return load_corners<Lane>(load_x, load_y, first);
    }
    return {};
  }

  template <class Lane>
  PERCOLITH_DEVICE CornerVectors<typename Lane::Real>
  of_pores(Index t, const CornerVectors<typename Lane::Real>& u) const {
    if (solid.is_wet()) {
      return solid.of_pores<Lane>(t, u);
    }
    return {};
  }

  template <class Lane>
  PERCOLITH_DEVICE typename Lane::Real of_gravity(Index t) const {
    return weight != nullptr ? -Lane::load(weight + t) : typename Lane::Real(0.0);
  }

  /// Adds energies and works of a triangle that went from velocities `v` to `fast`.
  template <class Lane>
  PERCOLITH_DEVICE void book(Lane lane, const ForcesByOrigin<typename Lane::Real>& f,
                             const CornerVectors<typename Lane::Real>& v,
                             const CornerVectors<typename Lane::Real>& fast, typename Lane::Real w,
                             LaneSums<terms>& sums) const {
    using Real = typename Lane::Real;
    const CornerVectors<Real> path{law.path(v[0], fast[0]), law.path(v[1], fast[1]),
                                   law.path(v[2], fast[2])};
    const auto work = [&](const CornerVectors<Real>& force) {
      return (dot(force[0], path[0]) + dot(force[1], path[1])) + dot(force[2], path[2]);
    };
    const auto add = [&](Term term, Real value) {
      sums.add(static_cast<std::size_t>(term), lane, value);
    };
    const Real mass = select(w > Real(0.0), Real(1.0) / w, Real(0.0));
    add(Term::kinetic,
        Real(0.5) * mass *
            ((dot(fast[0], fast[0]) + dot(fast[1], fast[1])) + dot(fast[2], fast[2])));
    if (solid.is_viscous()) {
      add(Term::viscous, work(f.viscous));
    }
    if (load_acts[lane.first / block_width] != 0) {
      add(Term::load, work(f.load));
    }
    if (solid.is_wet()) {
      add(Term::fluid, work(f.fluid));
    }
    if (weight != nullptr) {
      add(Term::gravity, f.gravity * ((path[0].y + path[1].y) + path[2].y));
    }
    const auto size = [](const Vec2<Real>& a) { return magnitude(a.x) + magnitude(a.y); };
    add(Term::stressing,
        select(w > Real(0.0), (size(f.stress[0]) + size(f.stress[1])) + size(f.stress[2]),
               Real(0.0)));
    const Real fastest =
        larger(larger(dot(fast[0], fast[0]), dot(fast[1], fast[1])), dot(fast[2], fast[2]));
    sums.raise(lane, fastest);
  }

  /// All forces on corner `k` together.
  template <class Real>
  PERCOLITH_DEVICE Vec2<Real> all_of(const ForcesByOrigin<Real>& f, std::size_t k) const {
    Vec2<Real> total = (f.stress[k] + f.joint[k]) + (f.contact[k] + f.load[k]);
    if (solid.is_wet()) {
      total = total + f.fluid[k];
    }
    total.y += f.gravity;
    return total;
  }

  /// New velocity of corner `k`, a node of its own, under all forces.
  template <class Lane>
  PERCOLITH_DEVICE Vec2<typename Lane::Real>
  faster(Lane lane, std::size_t k, const ForcesByOrigin<typename Lane::Real>& f,
         const Vec2<typename Lane::Real>& v, typename Lane::Real w, LaneSums<terms>& sums) const {
    const Vec2<typename Lane::Real> total = all_of(f, k);
    const Index slot = mesh::corner_of(lane.first, static_cast<Index>(k));
    return move_corner(lane, slot, total, v, w, sums);
  }

  /// New velocity of the corners in `slot` of inverse mass `w` under the forces `total`; books
  /// damping, supports and the unbalanced force.
  template <class Lane>
  PERCOLITH_DEVICE Vec2<typename Lane::Real>
  move_corner(Lane lane, Index slot, Vec2<typename Lane::Real> total, Vec2<typename Lane::Real> v,
              typename Lane::Real w, LaneSums<terms>& sums) const {
    using Real = typename Lane::Real;
    const Index record = constrained[slot / mesh::corners_per_block];
    const bool held = record != mesh::none;
    // What a support takes is balanced: it neither moves nor damps the corner.
    const Vec2<Real> unbalanced = held ? left_free<Lane>(record, slot, total) : total;
    Vec2<Real> drag{Real(0.0), Real(0.0)};
    if (law.damping_local != 0.0) {
      drag = {law.local_damping(unbalanced.x, v.x), law.local_damping(unbalanced.y, v.y)};
    }
    const Vec2<Real> free = law.new_velocity(v, total + drag, w);
    const Vec2<Real> result = held ? hold<Lane>(record, slot, free, v, w, lane, sums) : free;
    // What was taken out has no mass and counts no more, though its stress still stands there.
    sums.add(static_cast<std::size_t>(Term::unbalanced), lane,
             select(w > Real(0.0), magnitude(unbalanced.x) + magnitude(unbalanced.y), Real(0.0)));
    if (law.creeps) {
      sums.add(static_cast<std::size_t>(Term::damping), lane,
               -dot(unbalanced, law.path(v, result)));
    } else if (law.damping_local != 0.0 || law.damping_nodal != 0.0) {
      if (law.damping_nodal != 0.0) {
        drag = drag - Real(law.damping_nodal) * result;
      }
      sums.add(static_cast<std::size_t>(Term::damping), lane, dot(drag, law.path(v, result)));
    }
    return result;
  }

  /// The part P f of a force that the supports of a record leave to motion.
  template <class Lane>
  PERCOLITH_DEVICE Vec2<typename Lane::Real> left_free(Index record, Index slot,
                                                       Vec2<typename Lane::Real> force) const {
    using Real = typename Lane::Real;
    const Index place = record * mesh::corners_per_block + slot % mesh::corners_per_block;
    const Real xx = Lane::load(pxx + place);
    const Real xy = Lane::load(pxy + place);
    const Real yy = Lane::load(pyy + place);
    return {xx * force.x + xy * force.y, xy * force.x + yy * force.y};
  }

  /// Projects a velocity as the supports of a record say, and keeps their forces.
  template <class Lane>
  PERCOLITH_DEVICE Vec2<typename Lane::Real>
  hold(Index record, Index slot, Vec2<typename Lane::Real> free, Vec2<typename Lane::Real> v,
       typename Lane::Real w, Lane lane, LaneSums<terms>& sums) const {
    using Real = typename Lane::Real;
    const Index place = record * mesh::corners_per_block + slot % mesh::corners_per_block;
    const Real xx = Lane::load(pxx + place);
    const Real xy = Lane::load(pxy + place);
    const Real yy = Lane::load(pyy + place);
    const Vec2<Real> result{xx * free.x + xy * free.y + Lane::load(wx + place),
                            xy * free.x + yy * free.y + Lane::load(wy + place)};
    // Where nothing is moved nothing is needed, and a removed triangle has no mass.
    const Real kick = Real(law.dt_velocity) * w;
    const Real mass = select(kick > Real(0.0), Real(1.0) / kick, Real(0.0));
    const Real thick = Real(1.0) + Real(law.damping_nodal) * kick;
    const Vec2<Real> support = mass * thick * (result - free);
    Lane::store(rx + place, support.x);
    Lane::store(ry + place, support.y);
    sums.add(static_cast<std::size_t>(Term::support), lane, dot(support, law.path(v, result)));
    return result;
  }

  /// Takes back the reaction noted at a corner, where the block of the corner has supports.
  PERCOLITH_DEVICE void clear_reaction(Index corner) const {
    const Index record = constrained[corner / mesh::corners_per_block];
    if (record != mesh::none) {
      const Index place = record * mesh::corners_per_block + corner % mesh::corners_per_block;
      rx[place] = 0.0;
      ry[place] = 0.0;
    }
  }

  SolidForces solid;
  MotionLaw law;
  double* ux;
  double* uy;
  double* vx;
  double* vy;
  double* growth;
  const double* inverse_mass;
  const double* weight;
  const double* contact_x;
  const double* contact_y;
  const std::uint8_t* contact_acts;
  const double* load_x;
  const double* load_y;
  const std::uint8_t* load_acts;
  const Index* constrained;
  const double* pxx;
  const double* pxy;
  const double* pyy;
  const double* wx;
  const double* wy;
  double* rx;
  double* ry;
};

/// Works of the forces of the present places over the way that the velocities lead in the time of
/// the law, on which the medium that rock creeps through takes all that is unbalanced.
struct WorkOfPath {
  static constexpr bool vectorised = true;
  Move move;

  template <class Lane>
  PERCOLITH_DEVICE void operator()(Lane lane, LaneSums<terms>& sums) const {
    using Real = typename Lane::Real;
    const Index t = lane.first;
    const Index first = mesh::corner_of(t, 0);
    const CornerVectors<Real> v = load_corners<Lane>(move.vx, move.vy, first);
    const auto f = move.forces<Lane>(t, first, load_corners<Lane>(move.ux, move.uy, first), v);
    const Real w = Lane::load(move.inverse_mass + t);
    Real spent(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      spent += dot(move.all_of(f, k), move.law.path(v[k], v[k]));
    }
    sums.add(static_cast<std::size_t>(Term::damping), lane,
             -select(w > Real(0.0), spent, Real(0.0)));
    move.book(lane, f, v, v, w, sums);
  }
};

}  // namespace percolith::mechanics
