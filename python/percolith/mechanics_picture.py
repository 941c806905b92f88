# SPDX-License-Identifier: BSD-3-Clause
"""Draws one field of mechanics on the deformed shape, with the cracks over it."""

from __future__ import annotations

import textwrap
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap, ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patheffects import Normal, Stroke

from percolith.colours import BLACK, BLUE, GREEN, ORANGE, RED, distinct_colour
from percolith.deformation import (
    FROM_THE_START,
    automatic_scale,
    crack_faces,
    deformed_points,
)
from percolith.field_picture import ColourRange, model_figure, one_a_square
from percolith.fine_triangles import refine
from percolith.mechanics_fields import (
    LABEL,
    STRESSES,
    VECTORS,
    array_of,
    fragment_count,
    range_of_values,
    rock_and_bodies,
    values_of,
)
from percolith.run_directory import Frame, RunDirectory
from percolith.units import format_time, time_scale
from percolith.vtu import Grid

# Number in the field `mode`, name and colour of the joints that a picture of damage shows.
MODES = {
    -1: ("past its peak", ORANGE),
    FROM_THE_START: ("broken from the start", BLACK),
    1: ("tensile", BLUE),
    2: ("shear", RED),
    3: ("mixed", GREEN),
}
_TENSION, _COMPRESSION = "#D7191C", "#2C4FBB"
_COLOURS = 256  # of the colour map
_LEGEND_ROW = 0.3  # inches below the picture
_BODY = "#B4B4B4"  # rigid bodies, which no field of the rock describes
_GREYS = LinearSegmentedColormap.from_list("damage", ["#F4F4F4", "#7A7A7A"])


def _draw_bodies(axes, bodies: Grid, scale: float) -> None:
    axes.add_collection(PolyCollection(deformed_points(bodies, scale)[bodies.cells],
                                       facecolors=_BODY, antialiased=False, linewidths=0.0,
                                       rasterized=True), autolim=False)


def _draw_triangles(axes, frame: Frame, points: np.ndarray, values: np.ndarray, field: str,
                    shown: ColourRange) -> PolyCollection:
    corners = points[frame.matrix.cells]
    if field in VECTORS:
        fine = refine(corners, values[frame.matrix.cells], (shown.high - shown.low) / _COLOURS)
        corners, values = fine.corners, fine.values
    factor = shown.scale.factor
    colours = _GREYS if field == "damage" else "viridis"
    picture = PolyCollection(corners, array=values / factor, antialiased=False, linewidths=0.0,
                             rasterized=True, cmap=colours,
                             norm=plt.Normalize(shown.low / factor, shown.high / factor))
    axes.add_collection(picture, autolim=False)
    return picture


def _draw_fragments(axes, frame: Frame, points: np.ndarray) -> None:
    """The largest fragment comes first in the order of colours, so that it keeps its colour while
    pieces come off."""
    _, number, count = np.unique(values_of(frame, "fragments"), return_inverse=True,
                                 return_counts=True)
    rank = np.empty(len(count), int)
    rank[np.argsort(-count, kind="stable")] = np.arange(len(count))
    colours = ListedColormap([distinct_colour(i) for i in range(len(count))])
    axes.add_collection(PolyCollection(
        points[frame.matrix.cells], array=rank[number.ravel()], antialiased=False, linewidths=0.0,
        rasterized=True, cmap=colours, norm=plt.Normalize(-0.5, len(count) - 0.5)), autolim=False)


def _draw_cracks(axes, frame: Frame, points: np.ndarray) -> None:
    """Both faces of every broken joint, thin and dark."""
    faces, segment, _ = crack_faces(frame)
    if len(faces):
        broken = array_of(frame.cracks.cell_data, "mode")[segment] >= 0
        axes.add_collection(LineCollection(points[faces[broken]], colors="#202020",
                                           linewidths=0.7, capstyle="round"), autolim=False)


def _draw_modes(figure, axes, frame: Frame, points: np.ndarray) -> None:
    """Both faces of every joint past its peak in the colour of its mode, with a legend."""
    faces, segment, _ = crack_faces(frame)
    if not len(faces):
        return
    mode = array_of(frame.cracks.cell_data, "mode")
    handles = []
    for number, (name, colour) in MODES.items():
        if not (mode == number).any():
            continue
        width = 1.0 if number == -1 else 1.8
        axes.add_collection(LineCollection(points[faces[mode[segment] == number]], colors=colour,
                                           linewidths=width, capstyle="round"), autolim=False)
        handles.append(Line2D([], [], color=colour, linewidth=2.2,
                              label=f"{name} ({(mode == number).sum()})"))
    columns = 2 if len(handles) == 4 else min(3, len(handles))
    figure.legend(handles=handles, loc="outside lower center", ncols=columns, frameon=False,
                  fontsize="small")


def _draw_crosses(figure, axes, frame: Frame, points: np.ndarray, field: str) -> None:
    """Principal stresses at about 20 places across the model: direction, size and sign. The stress
    of the picture sets the length; the other is cut where it would be longer than a place."""
    data = frame.matrix.cell_data
    stress = np.stack([array_of(data, name) for name in STRESSES.values()], axis=1)
    direction = array_of(data, "principal_direction")
    centre = points[frame.matrix.cells].mean(axis=1)
    size = np.ptp(points, axis=0)
    spacing = max(size) / 20
    counts = np.maximum(np.round(size / spacing), 1)  # whole squares, so that none is a sliver
    chosen = one_a_square((centre - points.min(axis=0)) / size * counts, 1.0)
    largest = np.nanpercentile(np.abs(values_of(frame, field)), 95) or 1.0
    across = np.stack([-direction[:, 1], direction[:, 0]], axis=1)
    for sign, colour in ((-1, _COMPRESSION), (1, _TENSION)):
        lines = []
        for i, along in enumerate((direction, across)):
            size = np.clip(sign * stress[chosen, i] / largest, 0.0, 1.0)
            kept = size > 0.05
            half = 0.45 * spacing * size[kept, None] * along[chosen][kept]
            middle = centre[chosen][kept]
            lines.append(np.stack([middle - half, middle + half], axis=1))
        axes.add_collection(LineCollection(
            np.concatenate(lines), colors=colour, linewidths=1.3,
            path_effects=[Stroke(linewidth=2.6, foreground="white"), Normal()]), autolim=False)
    handles = [Line2D([], [], color=_TENSION, linewidth=2.2, label="tension"),
               Line2D([], [], color=_COMPRESSION, linewidth=2.2, label="compression")]
    figure.legend(handles=handles, loc="outside lower center", ncols=2, frameon=False,
                  fontsize="small")


def _title(run: RunDirectory, frame: Frame, field: str, scale: float, width: float) -> str:
    """What the picture shows, in lines that fit a figure of `width` inches."""
    name = LABEL[field].split(",")[0]
    name = f"{fragment_count(frame)} fragments" if field == "fragments" else name
    moment = format_time(frame.time, time_scale(run.times))
    shape = "true to scale" if scale == 1.0 else f"displacements × {scale:g}"
    lines = textwrap.wrap(run.title, int(10 * width)) + [f"{name}, t = {moment}, {shape}"]
    return "\n".join(lines)


def draw_mechanics(run: RunDirectory, frame: Frame, field: str, path: Path,
                   scale: float | None = None, colour_range: ColourRange | None = None) -> Path:
    """Writes the picture of `field` at the time of `frame` to `path` and returns it. `scale`
    multiplies the displacements; None stands for `automatic_scale`. Rigid bodies are grey. Raises
    RunDirectoryError where the run has no such field."""
    scale = automatic_scale(frame.matrix) if scale is None else scale
    figure, axes, is_wide = model_figure(deformed_points(frame.matrix, scale))
    title = _title(run, frame, field, scale, figure.get_figwidth())
    frame, bodies = rock_and_bodies(run, frame)
    points = deformed_points(frame.matrix, scale)
    _draw_bodies(axes, bodies, scale)
    legend_rows = 2 if field == "damage" else 1 if field in STRESSES else 0
    figure.set_figheight(figure.get_figheight() + legend_rows * _LEGEND_ROW)
    if field == "fragments":
        _draw_fragments(axes, frame, points)
    else:
        values = values_of(frame, field)
        shown = colour_range or range_of_values(field, values)
        picture = _draw_triangles(axes, frame, points, values, field, shown)
        beyond = "max" if field in VECTORS and np.nanmax(values) > shown.high else "neither"
        figure.colorbar(picture, ax=axes, extend="both" if field in STRESSES else beyond,
                        label=shown.scale.label(LABEL[field]),
                        **({"orientation": "horizontal", "aspect": 40, "shrink": 0.7} if is_wide
                           else {"shrink": 0.85}))
    if field == "damage":
        _draw_modes(figure, axes, frame, points)
    else:
        _draw_cracks(axes, frame, points)
    if field in STRESSES:
        _draw_crosses(figure, axes, frame, points, field)
    axes.set_title(title, fontsize=11)
    figure.savefig(path, dpi=120, pil_kwargs={"optimize": True})
    plt.close(figure)
    return path
