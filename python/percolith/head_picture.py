# SPDX-License-Identifier: BSD-3-Clause
"""Draws over a map of the hydraulic head: lines of equal head, and the rock that is not full of
water, where the head is but the elevation, apart from it, with the water table between both."""

from __future__ import annotations

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation

from percolith.colour_range import ColourRange
from percolith.colours import BLUE
from percolith.flow_fields import is_dry, point_values
from percolith.run_directory import Frame
from percolith.vtu import Grid

_DRY = "#D9D4CC"  # rock without a head: not a colour of the map
_LINE = "#FFFFFF"
_LINES = 10  # of equal head, at most
_ABOVE_ROCK, _STEP = 1.1, 0.1  # zorder; cracks lie higher


def _wetness(grid: Grid) -> np.ndarray:
    """Per point, m: in full rock how high water would rise above it, beside which the unfilled share
    of the others counts as a depth below the water table. The zero between two points is about where
    the water table is."""
    dry = is_dry(grid)
    rise = point_values(grid, "head") - grid.points[:, 1]
    ends = grid.points[grid.cells]
    edge = np.hypot(*(ends - np.roll(ends, 1, axis=1)).reshape(-1, 2).T).mean()
    unfilled = 1.0 - grid.point_data["saturation"]
    above = np.maximum(rise - rise[dry].min(initial=np.inf), 0.0) + 1e-9 * edge
    return np.where(dry, -edge * np.maximum(unfilled, 1e-9), above)


def _split(corners: np.ndarray, wetness: np.ndarray) -> tuple[list[np.ndarray], np.ndarray]:
    """The part of each triangle (n, 3, 2) in which the wetness (n, 3) is below zero, and the line
    (m, 2, 2) along which it is zero in those that it cuts."""
    whole = corners[(wetness < 0.0).all(axis=1)]
    cut = (wetness < 0.0).any(axis=1) & (wetness >= 0.0).any(axis=1)
    parts, lines = list(whole), []
    for places, values in zip(corners[cut], wetness[cut]):
        below = values < 0.0
        alone = int(np.flatnonzero(below == (below.sum() == 1))[0])  # the corner on its own side
        others = [(alone + 1) % 3, (alone + 2) % 3]
        share = values[alone] / (values[alone] - values[others])
        line = places[alone] + share[:, None] * (places[others] - places[alone])
        lines.append(line)
        parts.append(np.array([places[alone], *line]) if below[alone]
                     else np.array([line[0], places[others[0]], places[others[1]], line[1]]))
    return parts, np.array(lines).reshape(-1, 2, 2)


def _levels(shown: ColourRange) -> np.ndarray:
    """Heads of the lines in the unit that is shown."""
    norm = shown.norm
    levels = MaxNLocator(_LINES).tick_values(norm.vmin, norm.vmax)
    return levels[(levels > norm.vmin) & (levels < norm.vmax)]


def draw_head(axes, frame: Frame, points: np.ndarray, shown: ColourRange) -> list:
    """Draws the lines and the dry rock and returns entries of the legend. `shown` gives the range
    and the unit of the head."""
    matrix, handles = frame.matrix, []
    if not len(matrix.cells):
        return handles
    levels = _levels(shown)
    dry = is_dry(matrix)
    # Lines end in the dry rock, which is painted over them.
    wet = ~dry[matrix.cells].all(axis=1)
    if len(levels) > 1 and wet.any():
        axes.tricontour(Triangulation(*points.T, matrix.cells[wet]),
                        point_values(matrix, "head") / shown.scale.factor, levels, colors=_LINE,
                        linewidths=0.8, alpha=0.8, zorder=_ABOVE_ROCK)
        step = f"{levels[1] - levels[0]:.3g}"
        handles.append(Line2D([], [], color="#909090", linewidth=0.8,
                              label=f"equal head, every {step} {shown.scale.unit}"))
    if not dry.any():
        return handles
    parts, table = _split(points[matrix.cells], _wetness(matrix)[matrix.cells])
    axes.add_collection(PolyCollection(parts, facecolors=_DRY, edgecolors=_DRY, linewidths=0.8,
                                       antialiased=False, rasterized=True,
                                       zorder=_ABOVE_ROCK + _STEP), autolim=False)
    axes.add_collection(LineCollection(table, colors=BLUE, linewidths=1.6, capstyle="round",
                                       zorder=_ABOVE_ROCK + 2.0 * _STEP), autolim=False)
    return [*handles, Patch(color=_DRY, label="not full of water"),
            Line2D([], [], color=BLUE, linewidth=1.6, label="water table")]
