// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace percolith::coupling {

/// What the law of a bonded joint sees.
enum class JointStress {
  effective,  ///< the effective traction: the pore pressure acts between the faces besides
  total       ///< the whole traction, as in the paper
};

/// When fluid of the cracks gets between the faces of a joint.
enum class FluidEnters {
  broken,    ///< once the joint has broken, as in the paper
  softening  ///< once it is past its peak
};

/// How the flow in the pores is advanced in each step of the motion.
enum class PoreFlow {
  explicit_,  ///< in as many steps as their limit asks for
  implicit    ///< together with the cracks, in one
};

}  // namespace percolith::coupling
