// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/mechanics/solid_forces.hpp"

namespace percolith::mechanics {
namespace {

const double* view(const std::vector<double>& values) {
  return values.empty() ? nullptr : values.data();
}

}  // namespace

SolidForces::SolidForces(const Model& model)
    : ax_(model.triangles.ax.data()), ay_(model.triangles.ay.data()),
      bx_(model.triangles.bx.data()), by_(model.triangles.by.data()),
      initial_xx_(view(model.triangles.initial_xx)), initial_yy_(view(model.triangles.initial_yy)),
      initial_xy_(view(model.triangles.initial_xy)), viscosity_(view(model.triangles.viscosity)),
      pore_pressure_(model.pores.pressure.empty() ? nullptr : model.pores.pressure.data()),
      biot_(view(model.pores.biot)), material_of_(model.triangles.material.data()),
      uniform_(model.triangles.uniform.data()), material_(model.material.data()),
      edge_joint_(model.triangles.edge_joint.data()), force_(model.joints.force.data()) {}

}  // namespace percolith::mechanics
