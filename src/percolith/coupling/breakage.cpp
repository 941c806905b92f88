// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/coupling/breakage.hpp"

#include "percolith/mechanics/pressed_faces.hpp"
#include "percolith/mechanics/wet_joints.hpp"

#include <algorithm>
#include <map>

namespace percolith::coupling {
namespace {

using mechanics::BlockCondition;

void add_softening(const mechanics::Model& rock, const seepage::Model& water,
                   std::vector<Index>& joints) {
  const mechanics::Joints& all = rock.joints;
  for (std::size_t block = 0; block < all.condition.size(); ++block) {
    const auto condition = static_cast<BlockCondition>(all.condition[block]);
    if (condition == BlockCondition::whole || condition == BlockCondition::gone) {
      continue;
    }
    const auto first = static_cast<Index>(block) * block_width;
    const Index last = std::min(first + block_width, rock.mesh.joints());
    for (Index j = first; j < last; ++j) {
      if (std::max(all.damage[0][at(j)], all.damage[1][at(j)]) > 0.0 &&
          !water.cracks.is_broken(j)) {
        joints.push_back(j);
      }
    }
  }
}

}  // namespace

std::vector<Index> open_network(CoupledModel& model, const mechanics::Changes& changes) {
  mechanics::Model& rock = model.rock.model();
  std::vector<Index> joints;
  for (const mechanics::Breakage& b : changes.broke) {
    if (!model.water.cracks.is_broken(b.joint)) {
      joints.push_back(b.joint);
    }
  }
  if (model.options.fluid_enters == FluidEnters::softening) {
    add_softening(rock, model.water, joints);
  }
  if (joints.empty()) {
    return joints;
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  model.water.swelling = rock.pores.growth;
  std::map<Index, std::vector<Index>> by_group;
  for (const Index j : joints) {
    by_group[model.options.group[at(j)]].push_back(j);
    mechanics::leave_pores(rock, j);
  }
  for (const auto& [group, members] : by_group) {
    seepage::break_joints(model.water, members, group);
  }
  mechanics::add_pressed(rock, joints);
  return joints;
}

}  // namespace percolith::coupling
