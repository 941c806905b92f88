// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/solid_forces.hpp"

namespace percolith::mechanics {
namespace {

const double* view(const std::vector<double>& values) {
  return values.empty() ? nullptr : values.data();
}

}  // namespace

SolidForces::SolidForces(const Model& model)
    : ax(model.triangles.ax.data()), ay(model.triangles.ay.data()), bx(model.triangles.bx.data()),
      by(model.triangles.by.data()), initial_xx(view(model.triangles.initial_xx)),
      initial_yy(view(model.triangles.initial_yy)), initial_xy(view(model.triangles.initial_xy)),
      viscosity(view(model.triangles.viscosity)), material_of(model.triangles.material.data()),
      uniform(model.triangles.uniform.data()), material(model.material.data()),
      edge_joint(model.triangles.edge_joint.data()), force(model.joints.force.data()) {}

}  // namespace percolith::mechanics
