# SPDX-License-Identifier: BSD-3-Clause
"""Draws a map: one field of one frame on the deformed shape, with cracks, crosses of the principal
stresses and arrows of the flux over it. Cracks have the colours of the rock where they show the
same quantity, and colours of their own elsewhere."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap

from percolith.crack_fields import CRACK_FIELDS
from percolith.crack_picture import draw_filled, draw_modes, draw_thin, mode_handles
from percolith.cross_picture import arrow_handles, cross_handles, draw_arrows, draw_crosses
from percolith.deformation import can_deform, deformed_points
from percolith.flow_fields import FIELDS
from percolith.flow_fields import LABEL as FLOW_LABEL
from percolith.head_picture import draw_head
from percolith.mechanics_fields import fragment_count, label_of, values_of
from percolith.model_figure import ModelFigure, moment, shape
from percolith.rock_picture import (
    ROCK,
    category_handles,
    draw_bodies,
    draw_categories,
    draw_values,
    ranks_by_size,
)
from percolith.run_directory import Frame, RunDirectory
from percolith.view import View, shown_parts

_CRACKS = "inferno"
# Without the black end: what is hardly damaged could not be told from the outlines of cracks.
_OF_DAMAGE = LinearSegmentedColormap.from_list(
    "damage of joints", plt.get_cmap(_CRACKS)(np.linspace(0.3, 1.0, 256)))


def _shown(run: RunDirectory, frame: Frame, field: str, view: View) -> list[str]:
    """What the picture shows."""
    name = (FLOW_LABEL.get(field) or label_of(frame, field)).split(",")[0]
    if field == "fragments":
        name = f"{fragment_count(frame)} fragments" + " in all" * view.is_part
    parts = [name, moment(run, frame)]
    if can_deform(frame.matrix):
        parts.append(shape(view))
    return parts


def _draw_rock(model: ModelFigure, run: RunDirectory, frame: Frame, points, field: str,
               view: View) -> tuple:
    """Draws the field; returns what a colour bar belongs to, and entries of the legend."""
    if view.rock is not None:
        picture = draw_values(model.axes, frame, points, field, view)
        return picture, (draw_head(model.axes, frame, points, view.rock) if field == "head" else [])
    numbers = values_of(frame, field)
    if field == "fragments":
        draw_categories(model.axes, frame, points, ranks_by_size(numbers))
        return None, []
    draw_categories(model.axes, frame, points, numbers)
    return None, category_handles(run, field, numbers)


def _draw_cracks(model: ModelFigure, frame: Frame, points, field: str, view: View) -> list:
    """Draws the cracks and returns entries of the legend."""
    wanted = view.crack_colours
    if wanted == "mode":
        draw_modes(model.axes, frame, points, is_edged=field != "damage")
        return mode_handles(frame, view.modes)
    if wanted == "none" or frame.cracks is None or not len(frame.cracks.cells):
        return []
    if wanted == "thin" or field not in FIELDS:
        draw_thin(model.axes, frame, points)
    if wanted != "thin":
        shown = view.cracks or view.rock
        draw_filled(model.axes, frame, points, wanted, shown.scale.factor, _colours(view))
    return []


def _colours(view: View) -> dict:
    """Colours of the cracks."""
    shown, name = (view.cracks, _CRACKS) if view.cracks else (view.rock, ROCK)
    if view.crack_colours == "damage":
        name = _OF_DAMAGE
    return {"cmap": plt.get_cmap(name).resampled(view.colours), "norm": shown.norm}


def _add_bars(model: ModelFigure, rock, frame: Frame, field: str, view: View) -> None:
    name = FLOW_LABEL[field] if field in FIELDS else label_of(frame, field)
    if view.cracks is not None:
        of_cracks = plt.cm.ScalarMappable(**_colours(view))
        label = CRACK_FIELDS[view.crack_colours].label
        model.colour_bar(of_cracks, view.cracks.scale.label(label), view.cracks.beyond)
        name += " in the rock" * (view.crack_colours == field)
    if rock is not None:
        model.colour_bar(rock, view.rock.scale.label(name), view.rock.beyond)


def map_axes(run: RunDirectory, frame: Frame, field: str, view: View, axes=None):
    """Draws `field` at the time of `frame` and returns the axes: those given, or of a figure of its
    own. Raises RunDirectoryError where the run has no such field."""
    model = ModelFigure(view, view.cracks is not None, axes)
    parts = _shown(run, frame, field, view)
    frame, bodies = shown_parts(run, frame, view)
    points = deformed_points(frame.matrix, view.scale)
    draw_bodies(model.axes, bodies, view.scale)
    rock, handles = _draw_rock(model, run, frame, points, field, view)
    if view.arrow is not None:
        draw_arrows(model.axes, frame, points, view.arrow)
    handles += _draw_cracks(model, frame, points, field, view)
    if view.cross is not None:
        draw_crosses(model.axes, frame, points, view.cross)
        handles += cross_handles(view.cross, view.cuts_crosses)
    if view.arrow is not None:
        handles += arrow_handles(view.arrow)
    _add_bars(model, rock, frame, field, view)
    model.legend(handles)
    model.title(run.title, parts)
    return model.axes
