# SPDX-License-Identifier: BSD-3-Clause
"""Draws the rock of a map: triangles in the colours of a field, or of what they belong to, and rigid
bodies in grey."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap, ListedColormap
from matplotlib.patches import Patch

from percolith.colours import distinct_colour
from percolith.deformation import deformed_points
from percolith.fine_triangles import refine
from percolith.flow_fields import FIELDS, flux_size, point_values
from percolith.mechanics_fields import is_at_points, values_of
from percolith.run_directory import Frame, RunDirectory
from percolith.view import View
from percolith.vtu import Grid

ROCK = "viridis"
GREYS = LinearSegmentedColormap.from_list("damage", ["#F4F4F4", "#7A7A7A"])
_BODY = "#B4B4B4"  # rigid bodies, which no field of the rock describes
_FLAT = {"antialiased": False, "linewidths": 0.0, "rasterized": True}


def draw_bodies(axes, bodies: Grid | None, scale: float) -> None:
    """Rigid bodies in plain grey."""
    if bodies is not None:
        axes.add_collection(PolyCollection(deformed_points(bodies, scale)[bodies.cells],
                                           facecolors=_BODY, **_FLAT), autolim=False)


def drawn_values(frame: Frame, field: str) -> tuple[np.ndarray, bool]:
    """Values of the field, and whether there is one a point."""
    if field == "flux":
        return flux_size(frame), False
    if field in FIELDS:
        return point_values(frame.matrix, field), True
    return values_of(frame, field), is_at_points(frame, field)


def draw_values(axes, frame: Frame, points: np.ndarray, field: str, view: View) -> PolyCollection:
    """Flat triangles, fine enough that no step between two of them can be seen."""
    corners, shown = points[frame.matrix.cells], view.rock
    values, at_points = drawn_values(frame, field)
    if at_points:
        fine = refine(corners, values[frame.matrix.cells], view.step, smallest=view.pixel)
        corners, values = fine.corners, fine.values
    colours = (GREYS if field == "damage" else plt.get_cmap(ROCK)).resampled(view.colours)
    picture = PolyCollection(corners, array=values / shown.scale.factor, cmap=colours,
                             norm=shown.norm, **_FLAT)
    axes.add_collection(picture, autolim=False)
    return picture


def draw_categories(axes, frame: Frame, points: np.ndarray, ranks: np.ndarray) -> None:
    """Triangles in the colours of the numbers (n,) they have, from 0 on."""
    count = int(ranks.max(initial=0)) + 1
    colours = ListedColormap([distinct_colour(i) for i in range(count)])
    axes.add_collection(PolyCollection(points[frame.matrix.cells], array=ranks, cmap=colours,
                                       norm=plt.Normalize(-0.5, count - 0.5), **_FLAT),
                        autolim=False)


def ranks_by_size(numbers: np.ndarray) -> np.ndarray:
    """The largest fragment comes first in the order of colours, so that it keeps its colour while
    pieces come off."""
    _, number, count = np.unique(numbers, return_inverse=True, return_counts=True)
    rank = np.empty(len(count), int)
    rank[np.argsort(-count, kind="stable")] = np.arange(len(count))
    return rank[number.ravel()]


def category_handles(run: RunDirectory, field: str, numbers: np.ndarray) -> list[Patch]:
    """Entries of a legend for numbers of things; regions by their names, as far as the run has
    said them."""
    names = run.summary.get("regions", []) if field == "region" and run.has_summary else []
    return [Patch(color=distinct_colour(i), label=names[i] if i < len(names) else f"{field} {i}")
            for i in np.unique(numbers).tolist()]
