# SPDX-License-Identifier: BSD-3-Clause
"""By which factor pictures multiply displacements where nobody gives one: so that they can be seen,
and so that the deformed shape still is one."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from percolith.deformation import displacement
from percolith.outline import Openings, openings_of
from percolith.vtu import Grid
from percolith.window import meets

_VISIBLE = 0.03  # of what is shown: the largest displacement of a picture made to be seen
_AREA_LEFT = 0.2  # of a triangle, that it must keep
_WIDTH_LEFT = 0.5  # of an opening, that it must keep


def factor_of_areas(matrix: Grid, chosen: np.ndarray) -> float:
    """The largest factor with which every chosen triangle keeps a fifth of its area. Displacements
    u(x) are linear in a triangle with gradient G, and its area grows by det(I + s G) = 1 + s tr G +
    s² det G."""
    corners = matrix.points[matrix.cells[chosen]]
    moved = displacement(matrix)[matrix.cells[chosen]]
    (a, b), (u, v) = ((side[:, 1] - side[:, 0], side[:, 2] - side[:, 0])
                      for side in (corners, moved))

    def cross(one: np.ndarray, other: np.ndarray) -> np.ndarray:
        return one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]

    area = cross(a, b)
    trace, determinant = (cross(a, v) + cross(u, b)) / area, cross(u, v) / area
    lost = 1.0 - _AREA_LEFT
    # Smallest positive root in the form without cancellation; there is none where the discriminant
    # is negative or the divisor not positive.
    root = np.sqrt(np.maximum(trace**2 - 4.0 * lost * determinant, 0.0))
    reached = trace**2 >= 4.0 * lost * determinant
    divisor = np.where(reached, root - trace, 0.0)
    return float(2.0 * lost / divisor.max(initial=0.0)) if (divisor > 0.0).any() else np.inf


def factor_of_openings(matrix: Grid, openings: Openings, chosen: np.ndarray) -> float:
    """The largest factor with which holes and notches keep half of their width before every edge of
    a chosen triangle. The area of a hole would not do: it says nothing of a piece that has come
    loose and crosses it, nor of a notch, which has none."""
    counted = chosen[openings.triangle]
    moved = displacement(matrix)
    near = moved[openings.near].mean(axis=1)
    first, last = moved[openings.far].transpose(1, 0, 2)
    far = first + openings.share[:, None] * (last - first)
    closure = ((near - far) * openings.direction).sum(axis=1)
    relative = np.nanmax((closure / openings.width)[counted], initial=0.0)
    return float((1.0 - _WIDTH_LEFT) / relative) if relative > 0.0 else np.inf


def _edge(corners: np.ndarray) -> float:
    """The median edge of triangles, m."""
    return float(np.median(np.hypot(*(corners - np.roll(corners, 1, axis=1)).reshape(-1, 2).T)))


def _rounded(factor: float) -> float:
    """1, 2 or 5 times a power of ten, at most `factor` and at least 1."""
    if factor <= 1.0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(factor))
    return float(power * max(step for step in (1, 2, 5) if step * power <= factor * (1 + 1e-9)))


def _shown(matrix: Grid, window: np.ndarray | None) -> np.ndarray:
    """True (n,) for the triangles that a window shows when undeformed; all where it shows none, or
    where there is no window."""
    if window is None:
        return np.ones(len(matrix.cells), bool)
    inside = meets(matrix.points[matrix.cells], window)
    return inside | ~inside.any()


def _limit(rocks: Iterable[Grid], window: np.ndarray | None) -> float:
    """The largest factor with which no triangle turns inside out and no opening closes."""
    limit, before, openings = np.inf, None, None
    for rock in rocks:
        # Only an excavation changes the outline.
        if before is None or not (np.array_equal(rock.cells, before.cells)
                                  and np.array_equal(rock.points, before.points)):
            openings = openings_of(rock)
        before, chosen = rock, _shown(rock, window)
        limit = min(limit, factor_of_areas(rock, chosen),
                    factor_of_openings(rock, openings, chosen))
    return limit


def automatic_scale(matrix: Grid, rocks: Iterable[Grid] | None = None,
                    window: np.ndarray | None = None) -> float:
    """Factor of the displacements that lets the deformation of a matrix just be seen: 1, 2 or 5
    times a power of ten, so that the largest displacement is at most 3 % of what is shown. It must
    turn no triangle inside out and close no opening of `rocks`: the rock, without rigid bodies, at
    all times of a series; None stands for the matrix alone. It is 1 where the displacements are as
    large as the triangles, as in a collapse, or can be seen as they are."""
    cells = matrix.cells[_shown(matrix, window)]
    largest = float(np.nanmax(np.hypot(*displacement(matrix)[cells.ravel()].T), initial=0.0))
    if largest == 0.0 or largest >= _edge(matrix.points[cells]):
        return 1.0
    extent = np.ptp(matrix.points, axis=0) if window is None else window[1] - window[0]
    wanted = _VISIBLE * float(extent.max()) / largest
    return _rounded(min(wanted, _limit(rocks or [matrix], window))) if wanted > 1.0 else 1.0
