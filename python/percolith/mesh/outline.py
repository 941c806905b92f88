# SPDX-License-Identifier: BSD-3-Clause
"""Outlines of rock: closed polygons whose sides have names, with holes."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from numbers import Real
from typing import Any

import numpy as np

from percolith.errors import MeshError


@dataclass
class Outline:
    """A polygon, counter-clockwise, and holes in it.

    corners: (n, 2), m. sides: names of the n sides, side i from corner i to the next; neighbours
    may share one. holes: outlines without holes, clockwise or not. region: name of the rock.
    filling: name of a region that fills the holes, "" where they are empty.
    """

    corners: np.ndarray
    sides: list[str]
    holes: list[Outline] = field(default_factory=list)
    region: str = "rock"
    filling: str = ""

    def __post_init__(self) -> None:
        self.corners = as_places(self.corners, "corners of an outline")
        if self.corners.ndim != 2 or self.corners.shape[1:] != (2,) or len(self.corners) < 3:
            raise MeshError("an outline has three corners (x, y) or more")
        if len(self.sides) != len(self.corners):
            raise MeshError(f"an outline of {len(self.corners)} corners has as many sides, not "
                            f"{len(self.sides)}")
        if not np.isfinite(self.corners).all() or self.signed_area == 0.0:
            raise MeshError("an outline has finite corners and encloses an area")

    @property
    def signed_area(self) -> float:
        """m2; positive where the corners run counter-clockwise. Holes do not count."""
        x, y = self.corners.T
        return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))

    @property
    def area(self) -> float:
        """Area of the rock, m2."""
        return abs(self.signed_area) - sum(abs(hole.signed_area) for hole in self.holes)

    def edges(self) -> np.ndarray:
        """Ends of all sides, holes included: (n, 2, 2)."""
        own = np.stack([self.corners, np.roll(self.corners, -1, axis=0)], axis=1)
        return np.concatenate([own, *(hole.edges() for hole in self.holes)])

    def contains(self, places: np.ndarray) -> np.ndarray:
        """Whether each of the places (n, 2) lies in the rock: (n,)."""
        start, end = self.edges().transpose(1, 0, 2)[:, None]
        x, y = np.asarray(places, dtype=float).T[:, :, None]
        rise = end[..., 1] - start[..., 1]
        crosses = (start[..., 1] > y) != (end[..., 1] > y)
        with np.errstate(divide="ignore", invalid="ignore"):
            at = start[..., 0] + (y - start[..., 1]) / rise * (end[..., 0] - start[..., 0])
        return np.sum(crosses & (x < at), axis=1) % 2 == 1


def box(width: float, height: float, centre: tuple[float, float] | None = None,
        region: str = "rock") -> Outline:
    """A rectangle with the sides left, right, bottom and top; its lower left corner is the origin
    where no centre is given."""
    require_positive(width=width, height=height)
    x, y = (0.5 * width, 0.5 * height) if centre is None else as_place(centre, "centre")
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * [0.5 * width, 0.5 * height] + [x, y]
    return Outline(corners, ["bottom", "right", "top", "left"], region=region)


def circle(radius: float, size: float, side: str, centre: tuple[float, float] = (0.0, 0.0),
           region: str = "rock") -> Outline:
    """A circle as a polygon with sides of about `size`, sixteen at least, all of one name."""
    require_positive(radius=radius, size=size)
    count = max(16, 4 * math.ceil(math.pi * radius / (2.0 * size)))
    angle = 2.0 * math.pi * np.arange(count) / count
    corners = (radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
               + as_place(centre, "centre"))
    return Outline(corners, [side] * count, region=region)


def as_places(given: Any, what: str) -> np.ndarray:
    """An array of numbers. Raises MeshError where it cannot be one."""
    try:
        return np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise MeshError(f"{what}: not pairs of numbers; allowed: (x, y) in m for each") from None


def as_place(given: Any, name: str) -> tuple[float, float]:
    """One place (x, y), m. Raises MeshError where it is none."""
    try:
        place = np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        place = np.empty(0)
    if place.shape != (2,) or not np.isfinite(place).all():
        raise MeshError(f"{name} = {given!r}: no place; allowed: (x, y) in m")
    return float(place[0]), float(place[1])


def require_positive(what: str = "length in m", /, **values: float) -> None:
    """Raises MeshError for a value that is not a positive number."""
    for name, value in values.items():
        if not isinstance(value, Real) or not 0.0 < value < math.inf:
            raise MeshError(f"{name} = {value!r}: not a positive {what}")


def require_number(unit: str = "", /, **values: float) -> None:
    """Raises MeshError for a value that is no number, as a text with a unit is none."""
    for name, value in values.items():
        if not isinstance(value, Real):
            raise MeshError(f"{name} = {value!r}: not a number{unit and ' in ' + unit}")
