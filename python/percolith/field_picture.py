# SPDX-License-Identifier: BSD-3-Clause
"""Draws one field of flow of one frame."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from percolith.map_picture import map_axes
from percolith.overlays import arrow_size
from percolith.run_directory import Frame, RunDirectory
from percolith.saving import save
from percolith.view import View, view_of_frame


def field_figure(run: RunDirectory, frame: Frame, field: str, view: View, arrows: bool = False):
    """A figure of `field` at the time of `frame`. Raises RunDirectoryError where the run has no
    such field."""
    if arrows and view.arrow is None:
        view = replace(view, arrow=arrow_size(frame))
    return map_axes(run, frame, field, view).figure


def draw_field(run: RunDirectory, frame: Frame, field: str, path: Path, arrows: bool = False,
               view: View | None = None) -> Path:
    """Writes the picture of `field` at the time of `frame` to `path` and returns it. A `view` gives
    what the pictures of a series share. Raises RunDirectoryError where the run has no such field.
    """
    view = view or view_of_frame(run, frame, field)
    return save(field_figure(run, frame, field, view, arrows), path)
