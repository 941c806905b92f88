# SPDX-License-Identifier: BSD-3-Clause
"""Draws crosses of the principal stresses and arrows of the Darcy flux over a map."""

from __future__ import annotations

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patheffects import Normal, Stroke

from percolith.flow_fields import flux
from percolith.mechanics_fields import STRESSES, array_of
from percolith.run_directory import Frame
from percolith.units import format_value, power_scale, pressure_scale

_TENSION, _COMPRESSION = "#D7191C", "#2C4FBB"
_ARROW, _ARROW_EDGE = "white", "#202020"
_CROSSES, _ARROWS = 20, 25  # across the model
_SMALLEST = 0.05  # of the longest: a shorter line is left out
_SMALLEST_ARROW = 0.02  # of the longest: a shorter arrow is but a dot


def one_a_square(places: np.ndarray, spacing: float) -> np.ndarray:
    """Indices of the places nearest to the middle of each square of the given size."""
    square = np.floor(places / spacing).astype(np.int64)
    nearest = np.argsort(np.hypot(*(places - (square + 0.5) * spacing).T), kind="stable")
    _, first = np.unique(square[nearest], axis=0, return_index=True)
    return nearest[first]


def cross_handles(longest: float, is_cut: bool = False) -> list[Line2D]:
    """Entries of the legend, with the stress (Pa) of the longest line, and whether lines of larger
    ones are cut."""
    size = format_value(longest, pressure_scale([longest])) + " (larger ones cut)" * is_cut
    return [Line2D([], [], color=_TENSION, linewidth=2.2, label="tension"),
            Line2D([], [], color=_COMPRESSION, linewidth=2.2, label="compression"),
            Line2D([], [], linestyle="none", label=f"longest cross: {size}")]


def draw_crosses(axes, frame: Frame, points: np.ndarray, longest: float) -> None:
    """Principal stresses at about 20 places across the model: direction, size and sign. A stress
    above `longest` (Pa) is cut, as its line would be longer than a place."""
    if not len(points) or longest <= 0.0:
        return
    data = frame.matrix.cell_data
    stress = np.stack([array_of(data, name) for name in STRESSES.values()], axis=1)
    direction = array_of(data, "principal_direction")
    centre = points[frame.matrix.cells].mean(axis=1)
    extent = np.ptp(points, axis=0)
    spacing = max(extent) / _CROSSES
    counts = np.maximum(np.round(extent / spacing), 1)  # whole squares, so that none is a sliver
    chosen = one_a_square((centre - points.min(axis=0)) / extent * counts, 1.0)
    across = np.stack([-direction[:, 1], direction[:, 0]], axis=1)
    for sign, colour in ((-1, _COMPRESSION), (1, _TENSION)):
        lines = []
        for i, along in enumerate((direction, across)):
            size = np.clip(sign * stress[chosen, i] / longest, 0.0, 1.0)
            kept = size > _SMALLEST
            half = 0.45 * spacing * size[kept, None] * along[chosen][kept]
            middle = centre[chosen][kept]
            lines.append(np.stack([middle - half, middle + half], axis=1))
        axes.add_collection(LineCollection(
            np.concatenate(lines), colors=colour, linewidths=1.3, zorder=3.0,
            path_effects=[Stroke(linewidth=2.6, foreground="white"), Normal()]), autolim=False)


def arrow_handles(longest: float) -> list[Line2D]:
    """Entry of the legend, with the flux (m/s) of the longest arrow."""
    size = format_value(longest, power_scale([longest], "m/s"))
    return [Line2D([], [], linestyle="none", marker=r"$\rightarrow$", markersize=13,
                   color=_ARROW_EDGE, label=f"longest arrow: {size}")]


def draw_arrows(axes, frame: Frame, points: np.ndarray, longest: float) -> None:
    """Direction and size of the Darcy flux at about 25 places across the model. A flux above
    `longest` (m/s) is cut, and one that is next to nothing beside it has no arrow."""
    if not len(frame.matrix.cells) or longest <= 0.0:
        return
    centre = points[frame.matrix.cells].mean(axis=1)
    flow = flux(frame)
    spacing = max(np.ptp(centre, axis=0)) / _ARROWS or 1.0
    size = np.hypot(*flow.T)
    chosen = one_a_square(centre, spacing)
    chosen = chosen[size[chosen] >= _SMALLEST_ARROW * longest]
    length = (np.minimum(size, longest) / np.where(size > 0, size, 1.0) * 0.9 * spacing / longest)
    # Shafts and heads are measured in the longer side of the axes.
    slender = np.ptp(axes.get_ylim()) / np.ptp(axes.get_xlim())
    axes.quiver(*centre[chosen].T, *(flow[chosen] * length[chosen, None]).T, angles="xy",
                scale_units="xy", scale=1.0, width=0.0025 * max(1.0, slender),
                color=_ARROW, edgecolor=_ARROW_EDGE, linewidth=0.4, pivot="mid", zorder=1.9)
