# SPDX-License-Identifier: BSD-3-Clause
"""Analytic solutions of cracks that a fluid opens, in plane strain; SI units, pressures positive in
compression, stresses tension positive. `modulus` is E' = E/(1 - nu^2)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class PressedCrack:
    """A straight crack of half-length `half` (m) in rock without end (Sneddon)."""

    half: float
    modulus: float

    def opening(self, x, pressure: float):
        """At x from the middle (m) under a pressure above the stress across the crack."""
        return 4 * pressure / self.modulus * np.sqrt(self.half**2 - np.asarray(x) ** 2)

    @property
    def compliance(self) -> float:
        """Volume per pressure, both wings, m2/Pa."""
        return 2 * np.pi * self.half**2 / self.modulus

    def normal_stress(self, along, across, pressure: float):
        """Stress (Pa, tension positive) across the plane of the crack that a pressure above the far
        stress adds, at `along` from its middle in that plane and `across` from the plane (m)."""
        place = np.asarray(along, dtype=float) + 1j * np.abs(across)
        root = np.sqrt(place - self.half) * np.sqrt(place + self.half)
        slope = -self.half**2 / root**3
        return pressure * ((place / root - 1).real + np.abs(across) * slope.imag)

    def sealed_pressure(self, injected: float, room: float, fluid_modulus: float) -> float:
        """After `injected` m2 of fluid came into a sealed crack that had held `room` m2 of it at
        rest; for injected << room the fluid is linear, as is the rock."""
        return injected / (self.compliance + room / fluid_modulus)


def growth_pressure(toughness: float, half: float) -> float:
    """Pressure at which a crack of this half-length grows (Griffith)."""
    return toughness / np.sqrt(np.pi * half)


def crossing_ratio(friction):
    """Compression of an interface over tensile strength and compression across a crack that meets
    it at a right angle, from which on the crack crosses it (Renshaw and Pollard 1995); `friction`
    is the coefficient of the interface."""
    return (0.35 + 0.35 / np.asarray(friction)) / 1.06


def crossing_friction(ratio):
    """The coefficient of friction from which on a crack crosses an interface at that ratio: the
    inverse of `crossing_ratio`, infinite where none is enough."""
    excess = 1.06 * np.asarray(ratio, dtype=float) - 0.35
    return np.where(excess > 0, 0.35 / np.where(excess > 0, excess, 1), np.inf)


@dataclass(frozen=True)
class ToughnessCrack:
    """A crack that a fluid without viscosity drives at the rate `rate` (m2/s into both wings), from
    a point in the middle, against the toughness K (Pa m^1/2) (KGD, toughness and storage)."""

    rate: float
    toughness: float
    modulus: float

    def half_length(self, time):
        volume = self.rate * np.asarray(time)
        return (self.modulus * volume / (2 * np.sqrt(np.pi) * self.toughness)) ** (2 / 3)

    def width(self, time):
        """In the middle, m."""
        return (4 * self.toughness * np.sqrt(self.half_length(time))
                / (np.sqrt(np.pi) * self.modulus))

    def pressure(self, time):
        """Above the stress across the crack, Pa."""
        return growth_pressure(self.toughness, self.half_length(time))


def breakdown_sealed_wall(smaller: float, larger: float, strength: float, pores: float) -> float:
    """Pressure in a borehole at which its wall breaks when no fluid gets into the rock: compressive
    far stresses S_h and S_H and the pore pressure, all positive (Hubbert and Willis)."""
    return 3 * smaller - larger + strength - pores


def breakdown_open_wall(smaller: float, larger: float, strength: float, pores: float,
                        eta: float) -> float:
    """The same when the fluid of the hole gets into the rock (Haimson and Fairhurst)."""
    return (3 * smaller - larger + strength - 2 * eta * pores) / (2 * (1 - eta))


def breakdown_open_wall_by_total_stress(smaller: float, larger: float, strength: float,
                                        pores: float, eta: float) -> float:
    """The same if the rock broke where its total stress reaches the strength, as the paper has it;
    above that of the effective stress by a factor of about (2 - 2 eta)/(1 - 2 eta)."""
    return (3 * smaller - larger + strength - 2 * eta * pores) / (1 - 2 * eta)
