# SPDX-License-Identifier: BSD-3-Clause
"""Analytic solutions of rock whose pores are filled with fluid, in plane strain; SI units, stresses
are total and tension positive, pressures positive in compression."""

from __future__ import annotations

from dataclasses import dataclass
from math import factorial

import numpy as np
from scipy.special import kv
from solid_formulas import lame


@dataclass(frozen=True)
class PorousRock:
    """An isotropic poroelastic rock: Young's modulus (Pa), Poisson's ratio, Biot's coefficient,
    Biot's modulus (Pa) and mobility k/mu (m2/(Pa s)). The defaults are those of the tables."""

    young: float = 16e9
    poisson: float = 0.2
    biot: float = 1.0
    modulus: float = 11e9
    mobility: float = 1e-10

    @property
    def plane_bulk(self) -> float:
        """lambda + G, Pa."""
        return sum(lame(self.young, self.poisson))

    @property
    def oedometer(self) -> float:
        """lambda + 2 G, Pa: stress over strain without strain across."""
        first, shear = lame(self.young, self.poisson)
        return first + 2 * shear

    @property
    def eta(self) -> float:
        """alpha (1 - 2 nu)/(2 (1 - nu)): hoop stress that pore pressure adds, over 2 p."""
        return self.biot * (1 - 2 * self.poisson) / (2 * (1 - self.poisson))

    @property
    def diffusivity(self) -> float:
        """Of consolidation, m2/s."""
        return self.mobility / (1 / self.modulus + self.biot**2 / self.oedometer)

    def undrained_pressure(self, stress_sum: float) -> float:
        """Pressure of sealed rock under the sum of both normal stresses in the plane."""
        gain = self.biot * self.modulus
        return -0.5 * stress_sum * gain / (self.biot * gain + self.plane_bulk)

    def undrained_oedometer_pressure(self, stress: float) -> float:
        """Pressure of sealed rock under a stress along one axis, without strain across it."""
        gain = self.biot * self.modulus
        return -stress * gain / (self.biot * gain + self.oedometer)

    def strain(self, stress_xx: float, stress_yy: float, pressure: float) -> tuple[float, float]:
        """(xx, yy) under total stresses and a pore pressure."""
        _, shear = lame(self.young, self.poisson)
        mean = 0.5 * (stress_xx + stress_yy) + self.biot * pressure
        half = 0.25 * (stress_xx - stress_yy) / shear
        return mean / (2 * self.plane_bulk) + half, mean / (2 * self.plane_bulk) - half


class Consolidation:
    """A column of height `height` (m) under `load` (Pa) on its drained top (Terzaghi)."""

    def __init__(self, rock: PorousRock, height: float, load: float, terms: int = 400):
        self.rock, self.height, self.load = rock, height, load
        storage = 1 / rock.modulus
        self.share = storage / (storage + rock.biot**2 / rock.oedometer)
        self.first_pressure = rock.undrained_oedometer_pressure(-load)
        self.root = (np.arange(1, terms + 1) - 0.5) * np.pi
        self.sign = np.where(np.arange(terms) % 2 == 0, 1.0, -1.0)

    def _decay(self, time: float):
        return np.exp(-(self.root**2) * self.rock.diffusivity * time / self.height**2)

    def pressure(self, z, time: float):
        waves = np.cos(np.outer(np.atleast_1d(z) / self.height, self.root))
        return self.first_pressure * waves @ (2 * self.sign / self.root * self._decay(time))

    def settlement(self, time):
        """Of the top, m; from the undrained to the drained value."""
        last = self.load * self.height / self.rock.oedometer
        done = np.array([1 - np.sum(2 / self.root**2 * self._decay(t))
                         for t in np.atleast_1d(time)])
        return last * (self.share + (1 - self.share) * done)


def stehfest_weights(terms: int) -> np.ndarray:
    half = terms // 2
    weights = []
    for i in range(1, terms + 1):
        total = sum(k**half * factorial(2 * k)
                    / (factorial(half - k) * factorial(k) * factorial(k - 1) * factorial(i - k)
                       * factorial(2 * k - i))
                    for k in range((i + 1) // 2, min(i, half) + 1))
        weights.append((-1) ** (i + half) * total)
    return np.array(weights)


def inverse_laplace(transform, time: float, terms: int = 12) -> np.ndarray:
    """Value at `time` of the function whose Laplace transform is given, by Stehfest's sum."""
    rate = np.log(2) / time
    values = [weight * transform(i * rate)
              for i, weight in enumerate(stehfest_weights(terms), start=1)]
    return rate * np.sum(values, axis=0)


class Borehole:
    """A circular hole of radius `radius` (m) in rock without end, with the pore pressure `pressure`
    (Pa) on its wall from time 0 on and no load there (mode 2 of Detournay and Cheng)."""

    def __init__(self, rock: PorousRock, radius: float, pressure: float):
        self.rock, self.radius, self.wall = rock, radius, pressure

    def pressure(self, r, time: float):
        r = np.asarray(r, dtype=float)

        def transform(s):
            root = np.sqrt(s / self.rock.diffusivity)
            return self.wall / s * kv(0, r * root) / kv(0, self.radius * root)

        return inverse_laplace(transform, time)

    def stress(self, r, time: float):
        """(radial, hoop), total."""
        r = np.asarray(r, dtype=float)

        def transform(s):
            root = np.sqrt(s / self.rock.diffusivity)
            return (self.wall / s / kv(0, self.radius * root) / root
                    * (self.radius * kv(1, self.radius * root) - r * kv(1, r * root)))

        radial = -2 * self.rock.eta / r**2 * inverse_laplace(transform, time)
        return radial, -2 * self.rock.eta * self.pressure(r, time) - radial
