// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace percolith::seepage {

/// How pore pressure crosses an unbroken joint (theory.md section 4).
enum class PoreJoints { tied, finite };
/// Which saturation weights the flow between two corners (theory.md section 3).
enum class SaturationWeight { upstream, mean };

}  // namespace percolith::seepage
