# SPDX-License-Identifier: BSD-3-Clause
"""Draws one field of mechanics of one frame."""

from __future__ import annotations

from pathlib import Path

from percolith.crack_picture import MODES
from percolith.map_picture import map_axes
from percolith.run_directory import Frame, RunDirectory
from percolith.saving import save
from percolith.view import View, view_of_frame

__all__ = ["MODES", "draw_mechanics", "mechanics_figure"]


def mechanics_figure(run: RunDirectory, frame: Frame, field: str, view: View):
    """A figure of `field` at the time of `frame` on the deformed shape. Rigid bodies are grey.
    Raises RunDirectoryError where the run has no such field."""
    return map_axes(run, frame, field, view).figure


def draw_mechanics(run: RunDirectory, frame: Frame, field: str, path: Path,
                   scale: float | None = None, view: View | None = None) -> Path:
    """Writes the picture of `field` at the time of `frame` to `path` and returns it. `scale`
    multiplies the displacements; None stands for `automatic_scale`. A `view` gives the scale and
    all else that the pictures of a series share. Raises RunDirectoryError where the run has no
    such field."""
    view = view or view_of_frame(run, frame, field, scale)
    return save(mechanics_figure(run, frame, field, view), path)
