// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names of the quantities in every file a run writes; a unit other than 1 is part of the name.
namespace percolith::io::names {

inline constexpr const char* time = "time_s";
inline constexpr const char* pressure = "pressure_Pa";
inline constexpr const char* head = "head_m";
inline constexpr const char* saturation = "saturation";
inline constexpr const char* darcy_flux = "darcy_flux_m_per_s";
inline constexpr const char* aperture = "aperture_m";
inline constexpr const char* crack_flux = "flux_m2_per_s";
inline constexpr const char* region = "region";
inline constexpr const char* fracture = "fracture";

}  // namespace percolith::io::names
