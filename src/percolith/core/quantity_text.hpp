// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace percolith {

/// A pressure or stress (Pa) as a reader takes it in at once: "3.18 MPa", three digits, in GPa,
/// MPa, kPa or Pa.
[[nodiscard]] std::string pressure_text(double pressure);

}  // namespace percolith
