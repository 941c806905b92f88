# SPDX-License-Identifier: BSD-3-Clause
"""Fractures, and random networks of them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from numbers import Integral

import numpy as np

from percolith.errors import MeshError
from percolith.mesh.outline import Outline, as_places, require_number


@dataclass
class Fracture:
    """The trace of a fracture, a line through `points` (n, 2), m. `group` is the name of its curve
    in the mesh; several may share one. is_random: whether a network has it by chance; meshes do not
    warn of those that they leave out or run together with others."""

    points: np.ndarray
    group: str = "fractures"
    is_random: bool = False

    def __post_init__(self) -> None:
        self.points = as_places(self.points, "points of a fracture")
        if self.points.ndim != 2 or self.points.shape[1:] != (2,) or len(self.points) < 2:
            raise MeshError("a fracture runs through two points (x, y) or more")
        if not np.isfinite(self.points).all():
            raise MeshError("the points of a fracture are finite")
        if not self.group:
            raise MeshError("the group of a fracture has a name")

    @property
    def length(self) -> float:
        """m"""
        return float(np.sum(np.hypot(*np.diff(self.points, axis=0).T)))


@dataclass(frozen=True)
class FractureSet:
    """A set of straight fractures of similar orientation.

    angle_deg: of the traces, from the x axis, degrees. spread_deg: standard deviation of the angles,
    normally distributed; infinite: any angle alike. shortest, longest: bounds of the lengths, m.
    exponent: a of the power law n(l) ~ l^-a of their lengths. density: length of traces over area
    (P21), 1/m. group: name of the curves in the mesh.
    """

    angle_deg: float = 0.0
    spread_deg: float = math.inf
    shortest: float = 0.2
    longest: float = 2.0
    exponent: float = 2.5
    density: float = 1.0
    group: str = "fractures"

    def __post_init__(self) -> None:
        require_number("m", shortest=self.shortest, longest=self.longest)
        require_number("1/m", density=self.density)
        require_number("degrees", angle_deg=self.angle_deg, spread_deg=self.spread_deg)
        require_number(exponent=self.exponent)
        if not 0.0 < self.shortest <= self.longest < math.inf:
            raise MeshError(f"lengths from {self.shortest} to {self.longest} m: allowed: "
                            "0 < shortest <= longest")
        if not 0.0 <= self.density < math.inf:
            raise MeshError(f"density = {self.density}: not a length over an area, 1/m")
        if not self.spread_deg >= 0.0 or not math.isfinite(self.angle_deg):
            raise MeshError("angle_deg is finite, spread_deg not negative")
        if not math.isfinite(self.exponent):
            raise MeshError(f"exponent = {self.exponent}: not a finite number")

    def lengths(self, chance: np.ndarray) -> np.ndarray:
        """Lengths (m) at the quantiles `chance` between 0 and 1."""
        power = 1.0 - self.exponent
        ratio = self.longest / self.shortest
        if abs(power) < 1e-9:
            return self.shortest * ratio**chance
        return self.shortest * (1.0 + chance * (ratio**power - 1.0)) ** (1.0 / power)


def clip(start: np.ndarray, end: np.ndarray, region: Outline) -> list[tuple[np.ndarray, np.ndarray]]:
    """The parts of a straight line within a region, by their ends."""
    a, b = region.edges().transpose(1, 0, 2)
    d, e = end - start, b - a
    across = d[0] * e[:, 1] - d[1] * e[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        along = ((a - start)[:, 0] * e[:, 1] - (a - start)[:, 1] * e[:, 0]) / across
        aside = ((a - start)[:, 0] * d[1] - (a - start)[:, 1] * d[0]) / across
    hits = along[(across != 0.0) & (along > 0.0) & (along < 1.0) & (aside >= 0.0) & (aside <= 1.0)]
    cuts = np.concatenate([[0.0], np.unique(hits), [1.0]])
    middles = start + 0.5 * (cuts[:-1] + cuts[1:])[:, None] * d
    parts = []
    for low, high, inside in zip(cuts[:-1], cuts[1:], region.contains(middles)):
        if inside and parts and parts[-1][1] == low:
            parts[-1] = (parts[-1][0], high)
        elif inside:
            parts.append((low, high))
    return [(start + low * d, start + high * d) for low, high in parts]


def fracture_network(region: Outline, sets: FractureSet | Iterable[FractureSet],
                     seed: int) -> list[Fracture]:
    """A random network in a region: of each set as many fractures as give its density of length in
    the rock. Centres are spread evenly, beyond the edges too, so that long fractures reach in from
    outside as they do elsewhere; what lies outside is cut off. The same seed gives the same network.
    Raises MeshError."""
    if isinstance(seed, bool) or not isinstance(seed, Integral) or seed < 0:
        raise MeshError(f"seed = {seed!r}: allowed: a whole number that is not negative")
    generator = np.random.default_rng(seed)
    chosen: Sequence[FractureSet] = [sets] if isinstance(sets, FractureSet) else list(sets)
    return [fracture for one in chosen for fracture in _draw(region, one, generator)]


def _draw(region: Outline, one: FractureSet, generator: np.random.Generator) -> list[Fracture]:
    low, high = region.corners.min(axis=0), region.corners.max(axis=0)
    low, high = low - 0.5 * one.longest, high + 0.5 * one.longest
    wanted = one.density * region.area
    fractures: list[Fracture] = []
    total = 0.0
    while total < wanted:
        centre = generator.uniform(low, high)
        length = float(one.lengths(generator.random(1))[0])
        angle = math.radians(one.angle_deg)
        if math.isfinite(one.spread_deg):
            angle += math.radians(one.spread_deg) * generator.standard_normal()
        else:
            angle += math.pi * generator.random()
        half = 0.5 * length * np.array([math.cos(angle), math.sin(angle)])
        for start, end in clip(centre - half, centre + half, region):
            fractures.append(Fracture(np.array([start, end]), one.group, is_random=True))
            total += fractures[-1].length
    return fractures
