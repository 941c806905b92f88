# SPDX-License-Identifier: BSD-3-Clause
"""A figure with the axes of a model, its colour bars, and its title."""

from __future__ import annotations

import re
import textwrap

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import MaxNLocator

from percolith.run_directory import Frame, RunDirectory
from percolith.units import format_time, time_scale
from percolith.view import View

_LEGEND_ROW = 0.3  # inches below the picture
_LETTER, _HANDLE = 0.078, 0.55  # inches of a small letter, and of what stands before a label
_BAR = 1.2  # inches for a colour bar
_GAP = 0.1  # inches between tall axes and a bar
_TITLE = 3.6  # inches that lines of a title have at least
_LETTERS = 10  # of a title on an inch
_LINES, _LINE = 2, 0.19  # of a title that any figure has room for, inches for each further one
_TICK = 0.55  # inches between two ticks


class ModelFigure:
    """A figure that suits the shape of the model, with its axes; wide models get the bars below,
    and tall ones stand in the middle of a figure that has room for a title. With `axes` the picture
    is a part of a figure that is there already."""

    def __init__(self, view: View, second_bar: bool = False, axes=None):
        window = view.window
        width, height = window[1] - window[0]
        self.is_wide = width > 2.2 * height
        self._is_part = axes is not None
        self._is_narrow, self._slenderness = False, height / width
        self._beside = 0.0 if self.is_wide or self._is_part else _BAR * (1 + second_bar)
        if axes is None:
            axes = self._own_axes(width, height, second_bar)
        self.axes = axes
        self.axes.set_aspect("equal")
        margin = 0.0 if view.is_part else 0.01 * max(width, height)
        self.axes.set_xlim(window[0, 0] - margin, window[1, 0] + margin)
        self.axes.set_ylim(window[0, 1] - margin, window[1, 1] + margin)
        self.axes.set_xlabel("x (m)")
        self.axes.set_ylabel("y (m)")

    def _own_axes(self, width: float, height: float, second_bar: bool):
        size = (8.0, 8.0 * height / width + 1.75) if self.is_wide else (
            6.4 * min(1.0, 1.25 * width / height) + 1.4, 6.4 * min(height / width, 1.25) + 0.8)
        size = np.array(size) + np.array([0.0, _BAR] if self.is_wide else [_BAR, 0.0]) * second_bar
        least = _TITLE + self._beside
        self._is_narrow = bool(size[0] < least)
        _, axes = plt.subplots(figsize=(max(size[0], least), size[1]),
                               layout="compressed" if self._is_narrow else "constrained")
        if not self.is_wide:
            _thin_out(axes.xaxis, 8.0 * width / height)
        else:
            _thin_out(axes.yaxis, 8.0 * height / width)
        return axes

    @property
    def figure(self):
        return self.axes.figure

    def title(self, name: str, parts: list[str]) -> None:
        """Writes the name of the run, and what the picture shows in parts that stay whole, in lines
        that fit above the axes: beside these are the bars, and the title is in the middle of the
        axes."""
        letters = int(_LETTERS * (self.figure.get_figwidth() - self._beside))
        lines = textwrap.wrap(name, letters)
        for i, part in enumerate(parts):
            if i and len(lines[-1]) + 2 + len(part) <= letters:
                lines[-1] += f", {part}"
            else:
                lines.append(part)
        if not self._is_part:
            more = max(0, len(lines) - _LINES) * _LINE
            self.figure.set_figheight(self.figure.get_figheight() + more)
        self.axes.set_title("\n".join(lines), fontsize=11)

    def colour_bar(self, picture, label: str, extend: str = "neither") -> None:
        shape = {"shrink": 0.85}
        if self.is_wide:
            shape = {"orientation": "horizontal", "aspect": 40, "shrink": 0.7}
        elif self._is_narrow:
            # As long as beside other models, though the axes are narrow.
            width = self.figure.get_figheight() / self._slenderness  # of the axes, inches
            shape |= {"aspect": 36, "fraction": 0.5, "pad": max(0.05, _GAP / width)}
        self.figure.colorbar(picture, ax=self.axes, extend=extend, label=label, **shape)

    def legend(self, handles: list) -> None:
        """A legend below the picture, in as many rows as the figure needs, which grows by them."""
        if not handles:
            return
        place = self.axes.get_subplotspec() if self._is_part else None
        width = self.figure.get_figwidth() / (place.get_gridspec().ncols if place else 1)
        columns = fitting_columns([handle.get_label() for handle in handles], width)
        rows = -(-len(handles) // columns)
        if self._is_part:
            self.axes.legend(handles=handles, loc="upper center", bbox_to_anchor=(0.5, -0.16),
                             ncols=columns, frameon=False, fontsize="small")
            return
        self.figure.set_figheight(self.figure.get_figheight() + rows * _LEGEND_ROW)
        self.figure.legend(handles=handles, loc="outside lower center", ncols=columns,
                           frameon=False, fontsize="small")


def fitting_columns(labels: list[str], width: float) -> int:
    """Into how many columns entries of a legend go on a width (inches)."""
    lengths = [_LETTER * len(re.sub(r"[$^{}]", "", label)) + _HANDLE for label in labels]
    for rows in range(1, len(labels)):
        if sum(max(lengths[i:i + rows]) for i in range(0, len(lengths), rows)) <= width:
            return -(-len(labels) // rows)
    return 1


def moment(run: RunDirectory, frame: Frame) -> str:
    """The time of a frame in the unit that suits the run."""
    if run.is_steady:
        return "steady state"
    return f"t = {format_time(frame.time, time_scale(run.times))}"


def shape(view: View) -> str:
    """How the deformation is shown."""
    return "true to scale" if view.scale == 1.0 else f"displacements × {view.scale:g}"


def _thin_out(axis, length: float) -> None:
    """Few ticks on an axis that is short (inches)."""
    count = int(length / _TICK)
    if count < 6:
        axis.set_major_locator(MaxNLocator(max(count, 1), steps=[1, 2, 5, 10]))
    if count < 2 and axis.axis_name == "x":
        axis.set_tick_params(rotation=90)
