# SPDX-License-Identifier: BSD-3-Clause
"""The fields of rock and cracks that the interactive view can show."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from percolith.colour_range import ColourRange
from percolith.crack_fields import (
    CRACK_FIELDS,
    chosen_segments,
    end_values,
    has_crack_field,
    range_of_cracks,
    shown_values,
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
from percolith.view import View, view_of
from percolith.vtu import Grid


@dataclass(frozen=True)
class ViewField:
    """What a colour of the view means. `names` stands for the numbers 0, 1, ... where values are
    no quantities; colours are then one a number, and else span `ends`."""

    name: str
    label: str
    at_points: bool  # whether there is a value a point, or else one a triangle or segment
    colours: str  # as of colour_table
    ends: tuple[float, float] = (0.0, 1.0)  # SI
    scale: Scale = Scale(1.0, "")
    beyond: str = "neither"  # as of ColourRange
    names: list[str] = field(default_factory=list)

    @property
    def unit(self) -> str:
        return unit_text(self.scale.unit)


def _spanning(name: str, label: str, at_points: bool, shown: ColourRange,
              colours: str) -> ViewField:
    return ViewField(name, label, at_points, colours, (shown.low, shown.high), shown.scale,
                     shown.beyond)


def _fragments(frames: Sequence[Frame]) -> ViewField:
    """Fragments by their size, the largest first, as in the pictures."""
    counts = [fragment_count(frame) for frame in frames]
    most = max(counts)
    of_all = f" of {most}" if min(counts) == most else ""
    return ViewField("fragments", "Fragments", False, colour_table.distinct(most),
                     names=[f"fragment {i + 1} by size{of_all}" for i in range(most)])


def _regions(run: RunDirectory, frames: Sequence[Frame]) -> ViewField:
    """Regions by their names, which stand in the summary; before it is there by their numbers."""
    highest = max(int(frame.matrix.cell_data["region"].max(initial=-1)) for frame in frames)
    names = run.summary.get("regions", []) if run.has_summary else []
    names = names or [f"region {i}" for i in range(highest + 1)]
    return ViewField("region", "Regions", False, colour_table.distinct(len(names)), names=names)


def _offers(run: RunDirectory, frames: Sequence[Frame]) -> Iterator[str]:
    """Fields that these frames have and that say something in one of them."""
    points = [frame.matrix.point_data for frame in frames]
    if run.has_flow:
        yield "pressure"
        if "head_m" in points[-1]:
            yield "head"
        if any(np.ptp(one["saturation"]) > 0 for one in points):
            yield "saturation"
        yield "flux"
    if run.has_mechanics:
        moves = any(np.any(one["velocity_m_per_s"]) for one in points)
        yield from (name for name in MECHANICS_FIELDS if name != "velocity" or moves)


def _view(run: RunDirectory, frames: Sequence[Frame], name: str, scale: float) -> View:
    return view_of(run, [lambda frame=frame: frame for frame in frames], name, scale)


def rock_field(run: RunDirectory, frames: Sequence[Frame], name: str, scale: float) -> ViewField:
    """A field of the rock with colours that suit all frames; `scale` is the factor of the
    displacements, which decides what a picture shows."""
    if name == "region":
        return _regions(run, frames)
    if name == "fragments":
        return _fragments(frames)
    shown = _view(run, frames, name, scale).rock
    colours = colour_table.of_map(GREYS if name == "damage" else "viridis")
    label = LABEL[name] if name in FIELDS else label_of(frames[-1], name)
    return _spanning(name, label, drawn_values(frames[-1], name)[1], shown, colours)


def rock_fields(run: RunDirectory, frames: Sequence[Frame], scale: float) -> list[ViewField]:
    """All fields of the rock that these frames have."""
    return [rock_field(run, frames, name, scale) for name in (*_offers(run, frames), "region")]


def rock_values(frame: Frame, name: str) -> np.ndarray:
    """Values of a field of the rock: SI, or numbers with names."""
    if name == "region":
        return frame.matrix.cell_data["region"]
    values = drawn_values(frame, name)[0]
    return ranks_by_size(values) if name == "fragments" else values


def _modes() -> ViewField:
    return ViewField("mode", "Mode of breakage", False,
                     colour_table.of_names([colour for _, colour in MODES.values()]),
                     names=[name for name, _ in MODES.values()])


def has_cracks(frame: Frame) -> bool:
    return frame.cracks is not None and len(frame.cracks.cells) > 0


def crack_values(cracks: Grid, name: str) -> np.ndarray:
    """Values of a field of the cracks: (segments, 2) of both ends, or (segments,); NaN where a
    segment has none, as where it holds no fluid."""
    if name == "mode":
        order = list(MODES)
        return np.array([order.index(mode) for mode in cracks.cell_data["mode"].tolist()])
    has_value = chosen_segments(cracks, name)
    ends = np.where(has_value[:, None], end_values(cracks, name), np.nan)
    return ends if CRACK_FIELDS[name].array in cracks.point_data else ends[:, 0]


def crack_field(run: RunDirectory, frames: Sequence[Frame], name: str, scale: float) -> ViewField:
    """A field of the cracks with colours that suit all frames, one of which has cracks: those of
    the rock where a picture of the same quantity shows both in one."""
    if name == "mode":
        return _modes()
    known = CRACK_FIELDS[name]
    if name in FIELDS and name != "flux":
        view = _view(run, frames, name, scale)
        shown, colours = (view.cracks, "inferno") if view.cracks else (view.rock, "viridis")
    else:
        values = [shown_values(frame, name) for frame in frames]
        shown, colours = range_of_cracks(name, np.concatenate(values)), "inferno"
    cracks = next(frame.cracks for frame in frames if has_cracks(frame))
    at_points = known.array in cracks.point_data
    return _spanning(name, known.label, at_points, shown, colour_table.of_map(colours))


def crack_fields(run: RunDirectory, frames: Sequence[Frame], scale: float) -> list[ViewField]:
    """All fields of the cracks that these frames have. None where there is no crack."""
    cracked = [frame for frame in frames if has_cracks(frame)]
    names = [name for name in ("mode", *CRACK_FIELDS)
             if cracked and has_crack_field(cracked[-1].cracks, name)]
    return [crack_field(run, frames, name, scale) for name in names]
