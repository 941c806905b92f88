// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace percolith::seepage {

/// How pore pressure crosses an unbroken joint (theory 3.2).
enum class PoreJoints { tied, finite };
/// Which saturation weights the flow between two corners (theory 3.1).
enum class SaturationWeight { upstream, mean };

}  // namespace percolith::seepage
