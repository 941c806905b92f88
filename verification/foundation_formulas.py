# SPDX-License-Identifier: BSD-3-Clause
"""Seepage below a dam with a flat base on rock without end, by conformal maps; SI units, heads
above that of the tail water."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(60)


@dataclass(frozen=True)
class FlatDam:
    """A dam on y = 0 from -half (heel) to half (toe), impervious. Below its base may be a vertical
    line down to y = -depth: sqrt(z^2 + depth^2), z from the foot of the line, opens the line. Its
    faces come to lie between -depth and depth, and the rock is a half plane again."""

    head: float = 30.0  # of the reservoir, m
    half: float = 20.0  # m

    def bare(self, x):
        """Head (m) along the base of a dam on whole rock (Pavlovsky)."""
        return self._between(np.asarray(x), -self.half, self.half)

    def with_fracture(self, x, depth: float):
        """The same with an open fracture below the heel, which has the head of the reservoir."""
        toe = np.hypot(2 * self.half, depth)
        return self._between(_opened(x, -self.half, depth), depth, toe)

    def with_wall(self, x, place: float, depth: float):
        """The same as of the bare base with a wall below `place` that lets nothing through."""
        heel, toe = _opened([-self.half, self.half], place, depth)
        return self._between(_opened(x, place, depth), heel, toe)

    def with_drain(self, x, place: float, depth: float, level: float):
        """The same with a line of the head `level` below `place`."""
        m = _opened(np.atleast_1d(x), place, depth)
        heel, toe = _opened([-self.half, self.half], place, depth)

        # The slope of the head along the edge is (a m + b)/sqrt(|(m - heel)(m + depth)(m - depth)
        # (m - toe)|) on the left of the line and minus that on the right: the root changes its sign
        # at each of the four places, where a given head and no flow meet.
        def left(to):
            return _integrals(heel, -depth, lambda m: (depth - m) * (toe - m), to)

        def right(to):
            return _integrals(depth, toe, lambda m: (m - heel) * (m + depth), to)

        slope = np.linalg.solve([left(-depth), right(toe)], [level - self.head, level])
        return np.array([self.head + slope @ left(to) if to < 0 else level - slope @ right(to)
                         for to in m])

    def discharge(self, conductivity: float, width: float) -> float:
        """Flow (m2/s) below a dam on whole rock that ends at the line of flow that is a half
        ellipse with the foci heel and toe and the half axis `width`."""
        return conductivity * self.head / np.pi * np.arccosh(width / self.half)

    def _between(self, m, first: float, last: float):
        """Head between two places on the edge of a half plane: beyond them it is given, and nothing
        flows through the edge between them."""
        place = (2 * m - first - last) / (last - first)
        return self.head / np.pi * np.arccos(np.clip(place, -1.0, 1.0))


def _opened(x, place: float, depth: float):
    away = np.asarray(x, dtype=float) - place
    return np.copysign(np.hypot(away, depth), away)


def _integrals(low: float, high: float, rest, to: float) -> np.ndarray:
    """Of m and of 1 over sqrt((m - low)(high - m) rest(m)), from low to `to`; with
    m = middle - radius cos(angle) the first two roots go into the angle."""
    middle, radius = (low + high) / 2, (high - low) / 2
    end = np.arccos(np.clip((middle - to) / radius, -1.0, 1.0))
    m = middle - radius * np.cos(end / 2 * (POINTS + 1))
    factor = end / 2 * WEIGHTS / np.sqrt(rest(m))
    return np.array([(factor * m).sum(), factor.sum()])
