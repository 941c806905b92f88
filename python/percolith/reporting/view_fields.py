# SPDX-License-Identifier: BSD-3-Clause
"""The fields of rock and cracks that the interactive view can show."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from percolith.colour_range import ColourRange
from percolith.crack_fields import (
    CRACK_FIELDS,
    chosen_segments,
    end_values,
    has_crack_field,
    range_of_cracks,
)
from percolith.crack_picture import MODES
from percolith.flow_fields import FIELDS, LABEL
from percolith.mechanics_fields import (
    MECHANICS_FIELDS,
    fragment_count,
    label_of,
    values_of,
)
from percolith.reporting import colour_table
from percolith.reporting.quantities import unit_text
from percolith.rock_picture import GREYS, drawn_values, ranks_by_size
from percolith.run_directory import Frame, RunDirectory
from percolith.units import Scale
from percolith.view import view_of_frame
from percolith.vtu import Grid


@dataclass(frozen=True)
class ViewField:
    """What a colour of the view means. `names` stands for the numbers 0, 1, ... where values are
    no quantities; colours are then one a number, and else span `ends`."""

    name: str
    label: str
    values: np.ndarray  # one a point, or one a triangle or segment; SI, or numbers with names
    at_points: bool
    colours: str  # as of colour_table
    ends: tuple[float, float] = (0.0, 1.0)  # SI
    scale: Scale = Scale(1.0, "")
    beyond: str = "neither"  # as of ColourRange
    names: list[str] = field(default_factory=list)

    @property
    def unit(self) -> str:
        return unit_text(self.scale.unit)


def _spanning(name: str, label: str, values: np.ndarray, at_points: bool, shown: ColourRange,
              colours: str) -> ViewField:
    return ViewField(name, label, values, at_points, colours, (shown.low, shown.high), shown.scale,
                     shown.beyond)


def _fragments(frame: Frame) -> ViewField:
    """Fragments by their size, the largest first, as in the pictures."""
    count = fragment_count(frame)
    return ViewField("fragments", "Fragments", ranks_by_size(values_of(frame, "fragments")), False,
                     colour_table.distinct(count),
                     names=[f"fragment {i + 1} by size of {count}" for i in range(count)])


def _regions(run: RunDirectory, frame: Frame) -> ViewField:
    """Regions by their names, which stand in the summary; before it is there by their numbers."""
    number = frame.matrix.cell_data["region"]
    names = run.summary.get("regions", []) if run.has_summary else []
    names = names or [f"region {i}" for i in range(int(number.max(initial=-1)) + 1)]
    return ViewField("region", "Regions", number, False, colour_table.distinct(len(names)),
                     names=names)


def _offers(run: RunDirectory, frame: Frame) -> Iterator[str]:
    """Fields that this frame has and that say something."""
    points = frame.matrix.point_data
    if run.has_flow:
        yield "pressure"
        if "head_m" in points:
            yield "head"
        if np.ptp(points["saturation"]) > 0:
            yield "saturation"
        yield "flux"
    if run.has_mechanics:
        yield from (name for name in MECHANICS_FIELDS
                    if name != "velocity" or np.any(points["velocity_m_per_s"]))


def _rock_field(run: RunDirectory, frame: Frame, name: str, scale: float) -> ViewField:
    if name == "fragments":
        return _fragments(frame)
    shown = view_of_frame(run, frame, name, scale).rock
    colours = colour_table.of_map(GREYS if name == "damage" else "viridis")
    values, at_points = drawn_values(frame, name)
    label = LABEL[name] if name in FIELDS else label_of(frame, name)
    return _spanning(name, label, values, at_points, shown, colours)


def rock_fields(run: RunDirectory, frame: Frame, scale: float) -> list[ViewField]:
    """The fields of the rock at the time of `frame`; `scale` is the factor of the displacements,
    which decides what a picture shows."""
    fields = [_rock_field(run, frame, name, scale) for name in _offers(run, frame)]
    return [*fields, _regions(run, frame)]


def _modes(cracks: Grid) -> ViewField:
    order = list(MODES)
    number = np.array([order.index(mode) for mode in cracks.cell_data["mode"].tolist()])
    return ViewField("mode", "Mode of breakage", number, False,
                     colour_table.of_names([colour for _, colour in MODES.values()]),
                     names=[name for name, _ in MODES.values()])


def _crack_range(run: RunDirectory, frame: Frame, name: str, scale: float,
                 values: np.ndarray) -> tuple[ColourRange, str]:
    """The ends of the colours and their map, those of the rock where a picture of the same quantity
    shows both in one."""
    if name in FIELDS and name != "flux":
        view = view_of_frame(run, frame, name, scale)
        return (view.cracks, "inferno") if view.cracks else (view.rock, "viridis")
    return range_of_cracks(name, values), "inferno"


def crack_fields(run: RunDirectory, frame: Frame, scale: float) -> list[ViewField]:
    """The fields of the cracks: (segments, 2) values of both ends, or one a segment; NaN where a
    segment has none, as where it holds no fluid. No field where there is no crack."""
    cracks = frame.cracks
    if cracks is None or not len(cracks.cells):
        return []
    fields = [_modes(cracks)] if has_crack_field(cracks, "mode") else []
    for name, known in CRACK_FIELDS.items():
        if not has_crack_field(cracks, name):
            continue
        has_value = chosen_segments(cracks, name)
        ends = np.where(has_value[:, None], end_values(cracks, name), np.nan)
        shown, colours = _crack_range(run, frame, name, scale, ends[has_value].ravel())
        at_points = known.array in cracks.point_data
        fields.append(_spanning(name, known.label, ends if at_points else ends[:, 0], at_points,
                                shown, colour_table.of_map(colours)))
    return fields
