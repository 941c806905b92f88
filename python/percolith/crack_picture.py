# SPDX-License-Identifier: BSD-3-Clause
"""Draws cracks over the rock: thin and dark, in the colours of one of their quantities, or in the
colour of the mode in which they broke."""

from __future__ import annotations

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patheffects import Normal, Stroke

from percolith.colours import BLACK, BLUE, GREEN, ORANGE, RED
from percolith.crack_fields import chosen_segments, end_values
from percolith.deformation import FROM_THE_START, can_deform, crack_faces, crack_gaps
from percolith.mechanics_fields import array_of
from percolith.run_directory import Frame

SOFTENING = -1  # of the field `mode`
# Number in the field `mode`, name and colour of the joints that a picture of damage shows.
MODES = {
    SOFTENING: ("past its peak", ORANGE),
    FROM_THE_START: ("broken from the start", BLACK),
    1: ("tensile", BLUE),
    2: ("shear", RED),
    3: ("mixed", GREEN),
}
OUTLINE = "#202020"
_ABOVE = 2.0  # the rock; what comes later lies on top


def draw_thin(axes, frame: Frame, points: np.ndarray) -> None:
    """Both faces of every broken joint, thin and dark; of rock at rest the fractures."""
    if not can_deform(frame.matrix):
        ends = frame.cracks.points[frame.cracks.cells] if frame.cracks is not None else []
        axes.add_collection(LineCollection(ends, colors=OUTLINE, linewidths=1.2,
                                           capstyle="round"), autolim=False)
        return
    faces, segment, _ = crack_faces(frame)
    if len(faces):
        broken = array_of(frame.cracks.cell_data, "mode")[segment] >= 0
        axes.add_collection(LineCollection(points[faces[broken]], colors=OUTLINE,
                                           linewidths=0.7, capstyle="round"), autolim=False)


def mode_handles(frame: Frame, modes: tuple[int, ...]) -> list[Line2D]:
    """Entries of a legend with the number of joints of each of these modes."""
    has_cracks = frame.cracks is not None and len(frame.cracks.cells)
    mode = array_of(frame.cracks.cell_data, "mode") if has_cracks else np.empty(0, int)
    return [Line2D([], [], color=colour, linewidth=2.2, label=f"{name} ({(mode == number).sum()})")
            for number, (name, colour) in MODES.items() if number in modes]


def draw_modes(axes, frame: Frame, points: np.ndarray, is_edged: bool) -> None:
    """Both faces of every joint past its peak in the colour of its mode; those that broke with a
    white edge where the rock below is coloured."""
    faces, segment, _ = crack_faces(frame)
    if not len(faces):
        return
    mode = array_of(frame.cracks.cell_data, "mode")[segment]
    for number, (_, colour) in MODES.items():
        width = 1.0 if number == SOFTENING else 1.8
        edge = [Stroke(linewidth=width + 1.2, foreground="white"), Normal()]
        if (mode == number).any():
            axes.add_collection(LineCollection(points[faces[mode == number]], colors=colour,
                                               linewidths=width, capstyle="round",
                                               path_effects=edge if is_edged and number != SOFTENING
                                               else None), autolim=False)


def _shapes(frame: Frame, points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Corners of the gaps (n, 4, 2), middle lines (n, 2, 2) and crack segments (n,) of what a
    picture shows: of rock at rest the segments as they are."""
    cracks = frame.cracks
    if not can_deform(frame.matrix):
        lines = cracks.points[cracks.cells]
        return np.empty((0, 4, 2)), lines, np.arange(len(lines))
    gaps = crack_gaps(frame)
    corners = points[gaps.corners]
    lines = 0.5 * (corners[:, [0, 1]] + corners[:, [3, 2]])
    return corners, lines, gaps.segment


def _halves(corners: np.ndarray, lines: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Both halves of each gap and line, first those at the first end."""
    middle = lines.mean(axis=1)
    cut = np.concatenate([np.stack([lines[:, 0], middle], 1), np.stack([middle, lines[:, 1]], 1)])
    if not len(corners):
        return corners, cut
    one, other = corners[:, [0, 1]].mean(axis=1), corners[:, [2, 3]].mean(axis=1)
    return np.concatenate([np.stack([corners[:, 0], one, other, corners[:, 3]], 1),
                           np.stack([one, corners[:, 1], corners[:, 2], other], 1)]), cut


def draw_filled(axes, frame: Frame, points: np.ndarray, quantity: str, factor: float,
                colours: dict) -> None:
    """Every crack that has a value of the quantity in the colour of that over `factor`: its gap as
    far as it can be seen, and a line."""
    cracks = frame.cracks
    gaps, lines, segment = _shapes(frame, points)
    has_value = chosen_segments(cracks, quantity)[segment]
    gaps, lines, segment = gaps[has_value[:len(gaps)]], lines[has_value], segment[has_value]
    axes.add_collection(LineCollection(lines, colors=OUTLINE, linewidths=3.4, capstyle="round",
                                       zorder=_ABOVE), autolim=False)
    if len(gaps):
        axes.add_collection(PolyCollection(gaps, facecolors="none", edgecolors=OUTLINE,
                                           linewidths=1.4, zorder=_ABOVE), autolim=False)
    values = end_values(cracks, quantity)[segment]
    mean = values.mean(axis=1)
    # Two halves a segment, each in the colour a quarter of the way from its end.
    values = np.concatenate([(values[:, 0] + mean) / 2, (values[:, 1] + mean) / 2]) / factor
    gaps, lines = _halves(gaps, lines)
    if len(gaps):
        axes.add_collection(PolyCollection(gaps, array=values, antialiased=False, linewidths=0.0,
                                           zorder=_ABOVE, **colours), autolim=False)
    axes.add_collection(LineCollection(lines, array=values, linewidths=2.0, capstyle="round",
                                       zorder=_ABOVE, **colours), autolim=False)
