# SPDX-License-Identifier: BSD-3-Clause
"""Draws one field of flow of one frame: the rock in colours, the cracks over it in the same colours
or, where their pressure is of another size, in colours of their own. Where the rock deforms, on its
deformed shape."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from percolith.crack_picture import OUTLINE, draw_filled, draw_thin
from percolith.deformation import can_deform, deformed_points
from percolith.fine_triangles import refine
from percolith.flow_fields import LABEL, flux, flux_size, point_values
from percolith.model_figure import ModelFigure, moment, shape, wrapped
from percolith.run_directory import Frame, RunDirectory
from percolith.view import View, shown_parts, view_of_frame
from percolith.vtu import Grid

_ROCK, _CRACKS = "viridis", "inferno"
_BODY = "#B4B4B4"  # rigid bodies, which no field of the rock describes


def draw_bodies(axes, bodies: Grid | None, scale: float) -> None:
    """Rigid bodies in plain grey."""
    if bodies is not None:
        axes.add_collection(PolyCollection(deformed_points(bodies, scale)[bodies.cells],
                                           facecolors=_BODY, antialiased=False, linewidths=0.0,
                                           rasterized=True), autolim=False)


def _colours(name: str, view: View) -> dict:
    shown = view.cracks if name == _CRACKS else view.rock
    return {"cmap": plt.get_cmap(name).resampled(view.colours), "norm": shown.norm}


def _draw_rock(axes, frame: Frame, points: np.ndarray, field: str, view: View) -> PolyCollection:
    """Draws flat triangles, fine enough that no step between two of them can be seen."""
    corners = points[frame.matrix.cells]
    if field == "flux":
        values = flux_size(frame)
    else:
        at_corners = point_values(frame.matrix, field)[frame.matrix.cells]
        fine = refine(corners, at_corners, view.step, smallest=view.pixel)
        corners, values = fine.corners, fine.values
    picture = PolyCollection(corners, array=values / view.rock.scale.factor, antialiased=False,
                             linewidths=0.0, rasterized=True, **_colours(_ROCK, view))
    axes.add_collection(picture, autolim=False)
    return picture


def _draw_cracks(model: ModelFigure, frame: Frame, points: np.ndarray, field: str,
                 view: View) -> None:
    cracks = frame.cracks
    if field == "flux":
        axes = model.axes
        if can_deform(frame.matrix):
            draw_thin(axes, frame, points)
        else:
            axes.add_collection(LineCollection(cracks.points[cracks.cells], colors=OUTLINE,
                                               linewidths=1.2, capstyle="round"))
        return
    colours = _colours(_CRACKS if view.cracks else _ROCK, view)
    draw_filled(model.axes, frame, points, field, view, colours)


def _add_bars(model: ModelFigure, rock: PolyCollection, field: str, view: View) -> None:
    name = LABEL[field]
    if view.cracks is None:
        model.colour_bar(rock, view.rock.scale.label(name), view.rock.beyond)
        return
    of_cracks = plt.cm.ScalarMappable(**_colours(_CRACKS, view))
    model.colour_bar(of_cracks, view.cracks.scale.label(f"{name} in cracks"), view.cracks.beyond)
    model.colour_bar(rock, view.rock.scale.label(f"{name} in the rock"), view.rock.beyond)


def one_a_square(places: np.ndarray, spacing: float) -> np.ndarray:
    """Indices of the places nearest to the middle of each square of the given size."""
    square = np.floor(places / spacing).astype(np.int64)
    nearest = np.argsort(np.hypot(*(places - (square + 0.5) * spacing).T), kind="stable")
    _, first = np.unique(square[nearest], axis=0, return_index=True)
    return nearest[first]


def _draw_arrows(axes, frame: Frame, points: np.ndarray) -> None:
    """Direction and size of the Darcy flux at about 25 places across the model."""
    centre = points[frame.matrix.cells].mean(axis=1)
    flow = flux(frame)
    spacing = max(np.ptp(centre, axis=0)) / 25
    chosen = one_a_square(centre, spacing)
    size = np.hypot(*flow.T)
    largest = np.percentile(size, 95) or 1.0
    length = np.minimum(size, largest) / np.where(size > 0, size, 1.0) * 0.9 * spacing / largest
    axes.quiver(*centre[chosen].T, *(flow[chosen] * length[chosen, None]).T, angles="xy",
                scale_units="xy", scale=1.0, width=0.0025, color="white", edgecolor=OUTLINE,
                linewidth=0.4, pivot="mid")


def _title(run: RunDirectory, frame: Frame, field: str, view: View, figure) -> str:
    if not can_deform(frame.matrix):
        return f"{run.title}\n{LABEL[field]}, {moment(run, frame)}"
    return "\n".join(wrapped(run.title, figure)
                     + [f"{LABEL[field]}, {moment(run, frame)}, {shape(view)}"])


def field_figure(run: RunDirectory, frame: Frame, field: str, view: View, arrows: bool = False):
    """A figure of `field` at the time of `frame`. Raises RunDirectoryError where the run has no
    such field."""
    model = ModelFigure(view, second_bar=view.cracks is not None)
    title = _title(run, frame, field, view, model.figure)
    frame, bodies = shown_parts(run, frame, view)
    points = deformed_points(frame.matrix, view.scale)
    draw_bodies(model.axes, bodies, view.scale)
    rock = _draw_rock(model.axes, frame, points, field, view)
    if (arrows or field == "flux") and len(frame.matrix.cells):
        _draw_arrows(model.axes, frame, points)
    if frame.cracks is not None and len(frame.cracks.cells):
        _draw_cracks(model, frame, points, field, view)
    _add_bars(model, rock, field, view)
    model.axes.set_title(title, fontsize=11)
    return model.figure


def draw_field(run: RunDirectory, frame: Frame, field: str, path: Path, arrows: bool = False,
               view: View | None = None) -> Path:
    """Writes the picture of `field` at the time of `frame` to `path` and returns it. A `view` gives
    what the pictures of a series share. Raises RunDirectoryError where the run has no such field.
    """
    figure = field_figure(run, frame, field, view or view_of_frame(run, frame, field), arrows)
    figure.savefig(path, dpi=120, pil_kwargs={"optimize": True})
    plt.close(figure)
    return path
