// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/pressed_faces.hpp"

#include "percolith/mechanics/joint_points.hpp"

#include <algorithm>

namespace percolith::mechanics {
namespace {

std::array<double, 2> openings_of(const JointPlace<double>& place) {
  return {dot(place.apart[0], place.across), dot(place.apart[1], place.across)};
}

/// Stress with which the faces press on each other, Pa; none of a bonded joint.
double compression_of(const Model& model, const PressedFaces& faces) {
  const auto j = at(faces.joint);
  const Joints& joints = model.joints;
  if (joints.state[j] == JointState::bonded) {
    return 0.0;
  }
  double opening = 0.5 * (faces.opening[0] + faces.opening[1]);
  if (joints.state[j] == JointState::closed && !joints.opening_start[0].empty()) {
    opening += 0.5 * (joints.opening_start[0][j] + joints.opening_start[1][j]);
  }
  return joints.full_stiffness[j] * std::max(0.0, -opening);
}

struct MeasureFaces {
  Model* model;

  void operator()(ScalarLane lane) const {
    PressedFaces& faces = model->pressed[at(lane.first)];
    const JointPlace<double> place = joint_openings(*model, faces.joint).place;
    faces.across = place.across;
    faces.opening = openings_of(place);
    faces.compression = compression_of(*model, faces);
  }
};

struct PressFaces {
  Model* model;

  void operator()(ScalarLane lane, LaneSums<1>& sums) const {
    PressedFaces& faces = model->pressed[at(lane.first)];
    const double half = 0.5 * model->mesh.joint_length(faces.joint);
    // Where nothing else sets the force of a joint the one of the last step still stands there.
    const bool alone = model->joints.state[at(faces.joint)] == JointState::broken;
    double* out = model->joints.force.data() + force_slot(faces.joint);
    double work = 0.0;
    for (std::size_t end = 0; end < 2; ++end) {
      const Point push = -half * faces.pressure[end] * faces.across;
      out[0] = (alone ? 0.0 : out[0]) + push.x;
      out[block_width] = (alone ? 0.0 : out[block_width]) + push.y;
      out += 2 * block_width;
      work += (faces.last_pressure[end] + faces.pressure[end]) *
              (faces.opening[end] - faces.last_opening[end]);
    }
    faces.last_pressure = faces.pressure;
    faces.last_opening = faces.opening;
    sums.add(0, lane, 0.5 * half * work);
  }
};

}  // namespace

void add_pressed(Model& model, std::span<const Index> joints) {
  for (const Index j : joints) {
    PressedFaces faces{.joint = j};
    // The first pressure acts from half a step ago on.
    faces.last_opening = openings_of(joint_openings(model, j, model.motion.last_step).place);
    model.pressed.push_back(faces);
  }
  std::sort(model.pressed.begin(), model.pressed.end(),
            [](const PressedFaces& a, const PressedFaces& b) { return a.joint < b.joint; });
}

void measure_faces(Model& model, Execution& execution) {
  execution.for_each("crack openings", static_cast<Index>(model.pressed.size()),
                     MeasureFaces{&model});
}

void press_faces(Model& model, Execution& execution) {
  if (model.pressed.empty()) {
    return;
  }
  const auto totals = execution.sum_each<1>(
      "crack pressure", static_cast<Index>(model.pressed.size()), PressFaces{&model});
  model.energy.fluid_work += totals.sum[0];
}

void book_faces(Model& model) {
  model.energy.fluid_work += work_on_faces_since(model, 0.0);
  for (PressedFaces& faces : model.pressed) {
    faces.last_opening = faces.opening;
  }
}

std::array<Point, 2> force_of_fluid(const Model& model, Index joint) {
  const auto faces = std::lower_bound(
      model.pressed.begin(), model.pressed.end(), joint,
      [](const PressedFaces& entry, Index wanted) { return entry.joint < wanted; });
  if (faces == model.pressed.end() || faces->joint != joint) {
    return {};
  }
  const double half = 0.5 * model.mesh.joint_length(joint);
  return {-half * faces->pressure[0] * faces->across, -half * faces->pressure[1] * faces->across};
}

void forget_pressed(Model& model, const std::function<bool(Index)>& gone) {
  std::erase_if(model.pressed, [&](const PressedFaces& faces) { return gone(faces.joint); });
}

double work_on_faces_since(const Model& model, double back) {
  double work = 0.0;
  for (const PressedFaces& faces : model.pressed) {
    const auto opening = openings_of(joint_openings(model, faces.joint, back).place);
    for (std::size_t end = 0; end < 2; ++end) {
      work += 0.5 * model.mesh.joint_length(faces.joint) * faces.last_pressure[end] *
              (opening[end] - faces.last_opening[end]);
    }
  }
  return work;
}

}  // namespace percolith::mechanics
