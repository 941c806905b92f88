# SPDX-License-Identifier: BSD-3-Clause
"""Draws one field of mechanics on the deformed shape, with the cracks over it."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap, ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patheffects import Normal, Stroke

from percolith.colours import distinct_colour
from percolith.crack_picture import MODES, draw_modes, draw_thin, mode_columns, mode_handles
from percolith.deformation import deformed_points
from percolith.field_picture import draw_bodies, one_a_square
from percolith.fine_triangles import refine
from percolith.mechanics_fields import (
    LABEL,
    STRESSES,
    VECTORS,
    array_of,
    fragment_count,
    values_of,
)
from percolith.model_figure import ModelFigure, moment, shape, wrapped
from percolith.run_directory import Frame, RunDirectory
from percolith.view import View, shown_parts, view_of_frame

__all__ = ["MODES", "draw_mechanics", "mechanics_figure"]

_TENSION, _COMPRESSION = "#D7191C", "#2C4FBB"
_GREYS = LinearSegmentedColormap.from_list("damage", ["#F4F4F4", "#7A7A7A"])


def _draw_triangles(axes, frame: Frame, points: np.ndarray, values: np.ndarray, field: str,
                    view: View) -> PolyCollection:
    corners, shown = points[frame.matrix.cells], view.rock
    if field in VECTORS:
        fine = refine(corners, values[frame.matrix.cells], view.step, smallest=view.pixel)
        corners, values = fine.corners, fine.values
    colours = (_GREYS if field == "damage" else plt.get_cmap("viridis")).resampled(view.colours)
    picture = PolyCollection(corners, array=values / shown.scale.factor, antialiased=False,
                             linewidths=0.0, rasterized=True, cmap=colours, norm=shown.norm)
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


def _cross_handles() -> list[Line2D]:
    """Entries of the legend."""
    return [Line2D([], [], color=_TENSION, linewidth=2.2, label="tension"),
            Line2D([], [], color=_COMPRESSION, linewidth=2.2, label="compression")]


def _draw_crosses(axes, frame: Frame, points: np.ndarray, field: str) -> None:
    """Principal stresses at about 20 places across the model: direction, size and sign. The stress
    of the picture sets the length; the other is cut where it would be longer than a place."""
    if not len(points):
        return
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


def _title(run: RunDirectory, frame: Frame, field: str, view: View, figure) -> str:
    """What the picture shows, in lines that fit the figure."""
    name = LABEL[field].split(",")[0]
    if field == "fragments":
        name = f"{fragment_count(frame)} fragments" + " in all" * view.is_part
    return "\n".join(wrapped(run.title, figure)
                     + [f"{name}, {moment(run, frame)}, {shape(view)}"])


def _draw_values(model: ModelFigure, frame: Frame, points: np.ndarray, field: str,
                 view: View) -> None:
    if field == "fragments":
        _draw_fragments(model.axes, frame, points)
        return
    values = values_of(frame, field)
    picture = _draw_triangles(model.axes, frame, points, values, field, view)
    is_beyond = field in VECTORS and np.nanmax(values, initial=0.0) > view.rock.high
    beyond = "max" if is_beyond else "neither"
    model.colour_bar(picture, view.rock.scale.label(LABEL[field]),
                     "both" if field in STRESSES else beyond)


def mechanics_figure(run: RunDirectory, frame: Frame, field: str, view: View):
    """A figure of `field` at the time of `frame` on the deformed shape. Rigid bodies are grey.
    Raises RunDirectoryError where the run has no such field."""
    shows_modes = field == "damage" or view.shows_modes
    has_crosses = field in STRESSES and not shows_modes
    rows = 2 if field == "damage" or len(view.modes) > 3 else 1
    model = ModelFigure(view, rows if shows_modes else int(has_crosses))
    title = _title(run, frame, field, view, model.figure)
    frame, bodies = shown_parts(run, frame, view)
    points = deformed_points(frame.matrix, view.scale)
    draw_bodies(model.axes, bodies, view.scale)
    _draw_values(model, frame, points, field, view)
    if shows_modes:
        draw_modes(model.axes, frame, points, is_edged=field != "damage")
        model.legend(mode_handles(frame, view.modes), mode_columns(len(view.modes)))
    else:
        draw_thin(model.axes, frame, points)
    if has_crosses:
        _draw_crosses(model.axes, frame, points, field)
        model.legend(_cross_handles(), 2)
    model.axes.set_title(title, fontsize=11)
    return model.figure


def draw_mechanics(run: RunDirectory, frame: Frame, field: str, path: Path,
                   scale: float | None = None, view: View | None = None) -> Path:
    """Writes the picture of `field` at the time of `frame` to `path` and returns it. `scale`
    multiplies the displacements; None stands for `automatic_scale`. A `view` gives the scale and
    all else that the pictures of a series share. Raises RunDirectoryError where the run has no
    such field."""
    view = view or view_of_frame(run, frame, field, scale)
    figure = mechanics_figure(run, frame, field, view)
    figure.savefig(path, dpi=120, pil_kwargs={"optimize": True})
    plt.close(figure)
    return path
