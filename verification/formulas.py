# SPDX-License-Identifier: BSD-3-Clause
"""Analytic solutions of the examples, for their data; positions in m, times in s, results in Pa."""

from __future__ import annotations

import numpy as np
from scipy.optimize import brentq
from scipy.special import erfc, erfcx


def strip(x, time: float, left: float = 1e5, kappa: float = 4.4, terms: int = 2000):
    """Pressure in a strip of 1 m that starts at 0, `left` at x = 0 and 0 at x = 1, (41).
    kappa = (k/mu) M, m2/s; here k = 2e-13, mu = 1e-3, M = 2.2e9/0.1."""
    i = np.arange(1, terms + 1)
    decay = np.exp(-kappa * (i * np.pi) ** 2 * time) / i
    series = np.sin(np.outer(np.atleast_1d(x), i * np.pi)) @ decay
    return left * (1 - np.atleast_1d(x)) - 2 / np.pi * left * series


def radial(radius, well: float = 1e7, outer: float = 1e6, r_well: float = 0.1,
           r_outer: float = 1.0):
    """Steady pressure between two circles, (43)."""
    return well + (outer - well) * np.log(np.asarray(radius) / r_well) / np.log(r_outer / r_well)


def radial_gradient(radius, well: float = 1e7, outer: float = 1e6, r_well: float = 0.1,
                    r_outer: float = 1.0):
    """Its slope dp/dr, Pa/m, (44)."""
    return (outer - well) / np.log(r_outer / r_well) / np.asarray(radius)


def semi_infinite(x, time: float, crack: float = 8e6, kappa: float = 2200.0, film: float = 0.2):
    """Pressure at distance x from a crack at constant pressure that feeds rock without end
    through a film, (45) corrected; `film` is H = h_c mu/k, 1/m."""
    x = np.asarray(x, dtype=float)
    root = np.sqrt(kappa * time)
    u = x / (2 * root)
    # exp(H x + H^2 kappa t) erfc(u + H root) without overflow.
    return crack * (erfc(u) - np.exp(-(u**2)) * erfcx(u + film * root))


def slab(x, time: float, crack: float = 8e6, kappa: float = 2200.0, film: float = 0.2,
         thickness: float = 20.0, terms: int = 400):
    """The same for rock that is sealed at distance `thickness` from the crack."""
    load = film * thickness
    roots = np.array([brentq(lambda b: b * np.sin(b) - load * np.cos(b), n * np.pi,
                             n * np.pi + np.pi / 2) for n in range(terms)])
    factor = 2 * np.sin(roots) / (roots + np.sin(roots) * np.cos(roots))
    factor = factor * np.exp(-(roots**2) * kappa * time / thickness**2)
    series = np.cos(np.outer(1 - np.atleast_1d(x) / thickness, roots)) @ factor
    return crack * (1 - series)


def filling_front(time, pressure: float, aperture: float, viscosity: float):
    """How far fluid at constant inlet pressure has filled an empty crack with sealed faces, m."""
    return aperture * np.sqrt(pressure * np.asarray(time) / (6 * viscosity))
