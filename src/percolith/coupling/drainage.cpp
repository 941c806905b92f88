// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/drainage.hpp"

#include <algorithm>
#include <vector>

namespace percolith::coupling {

Index add_drainage(seepage::Model& water, const std::string& name, double pressure) {
  water.conditions.name.push_back(name);
  water.conditions.option.emplace_back("pressure");
  water.conditions.schedule.push_back(Schedule::constant(pressure));
  water.let_in.emplace_back();
  water.rate.push_back(0.0);
  return static_cast<Index>(water.conditions.name.size()) - 1;
}

void drain(CoupledModel& model, std::span<const Index> triangles, Index number) {
  seepage::Model& water = model.water;
  std::vector<std::uint8_t> drained(water.mesh.vertex.size(), 0);
  for (const Index t : triangles) {
    for (const Index v : water.mesh.triangle_vertex[at(t)]) {
      drained[at(v)] = 1;
    }
  }
  seepage::Conditions& conditions = water.conditions;
  const auto give_way = [&](std::vector<seepage::NodeCondition>& list, const auto& vertex_of) {
    std::erase_if(list, [&](const seepage::NodeCondition& c) {
      return drained[at(vertex_of(c.place))] != 0;
    });
  };
  const auto of_corner = [&](Index corner) { return water.mesh.vertex_of(corner); };
  const auto of_vertex = [](Index vertex) { return vertex; };
  for (auto* list : {&conditions.pore.pressure, &conditions.pore.seepage_face}) {
    give_way(*list, of_corner);
  }
  for (auto* list : {&conditions.crack.pressure, &conditions.crack.seepage_face}) {
    give_way(*list, of_vertex);
  }
  for (Index v = 0; v < water.mesh.vertices(); ++v) {
    if (drained[at(v)] == 0) {
      continue;
    }
    for (const Index corner : water.mesh.vertex_corners.row(v)) {
      conditions.pore.pressure.push_back({corner, number, number, 1.0, 0.0});
    }
    conditions.crack.pressure.push_back({v, number, number, 1.0, 0.0});
  }
}

}  // namespace percolith::coupling
