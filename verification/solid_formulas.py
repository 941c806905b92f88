# SPDX-License-Identifier: BSD-3-Clause
"""Analytic solutions of solid mechanics in plane strain; SI units, tension positive."""

from __future__ import annotations

import numpy as np

SOFTENING = 0.36309  # integral of the softening curve


def lame(young: float, poisson: float) -> tuple[float, float]:
    """lambda and the shear modulus G."""
    shear = young / (2 * (1 + poisson))
    return 2 * shear * poisson / (1 - 2 * poisson), shear


def plane_modulus(young: float, poisson: float) -> float:
    """E' = E/(1 - nu^2)."""
    return young / (1 - poisson**2)


def wave_speeds(young: float, poisson: float, density: float) -> tuple[float, float]:
    """Of compression and of shear waves."""
    lame_first, shear = lame(young, poisson)
    return np.sqrt((lame_first + 2 * shear) / density), np.sqrt(shear / density)


def ring_displacement(radius, pressure: float, inner: float, outer: float, young: float,
                      poisson: float):
    """Radial displacement of a thick ring with `pressure` inside and none outside (Lame)."""
    factor = (1 + poisson) / young * pressure * inner**2 / (outer**2 - inner**2)
    return factor * ((1 - 2 * poisson) * radius + outer**2 / radius)


def tunnel_wall_displacement(angle, stress_xx: float, stress_yy: float, radius: float,
                             young: float, poisson: float):
    """Radial displacement of the wall by the excavation of a circle (Kirsch): that of the hole
    under the far stress less that of the rock without the hole."""
    modulus, ratio = plane_modulus(young, poisson), poisson / (1 - poisson)
    mean, difference = stress_xx + stress_yy, stress_xx - stress_yy
    return radius / (2 * modulus) * ((1 + ratio) * mean
                                     + (3 - ratio) * difference * np.cos(2 * np.asarray(angle)))


def tunnel_stress(x, stress_xx: float, stress_yy: float, radius: float):
    """(radial, hoop) stress along the x axis from the wall of a circular hole on (Kirsch)."""
    r = (radius / np.asarray(x)) ** 2
    mean, half = (stress_xx + stress_yy) / 2, (stress_xx - stress_yy) / 2
    radial = mean * (1 - r) + half * (1 - 4 * r + 3 * r**2)
    hoop = mean * (1 + r) - half * (1 + 3 * r**2)
    return radial, hoop


class DoubleCantilever:
    """Two arms of height `height` pulled apart at their ends, with the root rotation of the arms
    counted as 0.66 of the height."""

    def __init__(self, young: float, poisson: float, energy: float, height: float):
        self.stiffness = plane_modulus(young, poisson) * height**3
        self.toughness = np.sqrt(energy * self.stiffness / 12)
        self.root = 0.66 * height

    def load(self, length):
        """That propagates a crack of this length, N/m."""
        return self.toughness / (np.asarray(length) + self.root)

    def length(self, opening):
        """Of a crack that propagates at this opening of the ends, m."""
        return np.sqrt(np.asarray(opening) * self.stiffness / (8 * self.toughness)) - self.root

    def elastic_load(self, opening, length: float):
        """Before a crack of this length propagates, N/m."""
        return np.asarray(opening) * self.stiffness / (8 * (length + self.root) ** 3)


def mohr_coulomb(confinement, cohesion: float, friction_angle: float):
    """Largest compressive stress that rock bears under a confining pressure, both positive."""
    sine, confinement = np.sin(friction_angle), np.asarray(confinement)
    return (2 * cohesion * np.cos(friction_angle) + (1 + sine) * confinement) / (1 - sine)


def slide_distance(time: float, slope: float, friction_angle: float, gravity: float = 9.81):
    """How far a block slides from rest down a slope steeper than the friction angle."""
    pull = np.sin(slope) - np.cos(slope) * np.tan(friction_angle)
    return 0.5 * gravity * max(0.0, pull) * time**2


def mixed_energy(direction: float, strength: float, cohesion: float, mode_1: float,
                 mode_2: float) -> float:
    """Energy per area after the peak of a joint whose sides part along a straight path at
    `direction` (0: opening, pi/2: sliding), softening by the ellipse (10) of openings."""
    opening, slip = mode_1 / (SOFTENING * strength), mode_2 / (SOFTENING * cohesion)
    end = 1 / np.hypot(np.cos(direction) / opening, np.sin(direction) / slip)
    return SOFTENING * end * (strength * np.cos(direction) + cohesion * np.sin(direction))


def plane_failure(weight: float, dip: float, friction_angle: float, uplift: float = 0.0,
                  push: float = 0.0) -> float:
    """Factor of safety of a block on a plane that dips out of a slope, without cohesion (Hoek and
    Bray): `weight`, `uplift` of the water on the plane and horizontal `push` of that in a crack
    behind the block are forces per metre, N/m."""
    normal = weight * np.cos(dip) - uplift - push * np.sin(dip)
    return float(normal * np.tan(friction_angle) / (weight * np.sin(dip) + push * np.cos(dip)))


def overstressed_depth(smaller: float, larger: float, strength: float,
                       pressure: float = 0.0) -> float:
    """Distance from the axis, over the radius of a circular hole under `pressure`, within which
    principal stresses differ by more than `strength` in the direction of the smaller far stress
    (Kirsch; far stresses as positive compression). The estimate of the broken zone of Martin,
    Kaiser and McCreath (1999): brittle rock loses its cohesion before friction holds it. 1 where
    even the wall bears it, infinite where the far stress does not."""
    # Hoop less radial stress at r: (s + l - 2 p) q + (l - s)/2 (2 - 4 q + 6 q^2) with q = 1/r^2.
    total, half = smaller + larger - 2 * pressure, (larger - smaller) / 2
    roots = np.roots([6 * half, total - 4 * half, 2 * half - strength])
    return float(max(1.0, roots.real.max() ** -0.5)) if strength > 2 * half else float("inf")


def breakout_half_width(smaller: float, larger: float, pressure: float, cohesion: float,
                        friction_angle: float) -> float:
    """Angle (rad) from the direction of the smaller far stress within which the stress round a hole
    under `pressure` is more than the wall bears (Kirsch, Mohr and Coulomb); 0 where it holds."""
    strength = mohr_coulomb(pressure, cohesion, friction_angle)
    # Stress round the hole: s + l + 2 (l - s) cos(2 angle) - p.
    cosine = (strength + pressure - smaller - larger) / (2 * (larger - smaller))
    return float(0.5 * np.arccos(np.clip(cosine, -1.0, 1.0)))
