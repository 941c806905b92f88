// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/seepage/model.hpp"

namespace percolith::seepage {

/// Sets all pores: `state_at(place)` gives the pressure (Pa) and saturation of the node at `place`
/// (m); contents follow. Below full saturation the pressure is the reference pressure.
template <class StateAt>
void set_pores(Model& model, const StateAt& state_at) {
  for (const Index node : model.pore_nodes.nodes(model.mesh)) {
    const auto i = static_cast<std::size_t>(node);
    set_pore_content(
        model, node,
        {excess_of(state_at(model.mesh.place_of(node)), model.state.growth[i],
                   model.state.storage[i], model.state.void_volume[i], model.reference_pressure()),
         0.0});
  }
}

/// Sets all open crack nodes likewise.
template <class StateAt>
void set_cracks(Model& model, const StateAt& state_at) {
  for (const Index v : model.cracks.open_nodes()) {
    const auto i = static_cast<std::size_t>(v);
    set_crack_content(model, v,
                      {excess_of(state_at(model.mesh.vertex[i]), 0.0, model.crack_storage(v),
                                 model.crack.void_volume[i], model.reference_pressure()),
                       0.0});
  }
}

}  // namespace percolith::seepage
