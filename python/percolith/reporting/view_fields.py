# SPDX-License-Identifier: BSD-3-Clause
"""The fields of rock and cracks that the interactive view can show."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from percolith.colour_range import ColourRange, widened
from percolith.crack_picture import MODES
from percolith.flow_fields import FIELDS, LABEL, carries_fluid, point_values, rock_values
from percolith.mechanics_fields import LABEL as MECHANICS_LABEL
from percolith.mechanics_fields import MECHANICS_FIELDS, values_of
from percolith.mechanics_picture import GREYS
from percolith.reporting import colour_table
from percolith.reporting.quantities import unit_text
from percolith.run_directory import Frame, RunDirectory
from percolith.units import Scale, length_scale, power_scale
from percolith.view import view_of_frame


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
    names: list[str] = field(default_factory=list)
    beyond: str = "neither"  # which ends have values beyond, as of ColourRange

    @property
    def unit(self) -> str:
        return unit_text(self.scale.unit)


def _spanning(name: str, label: str, values: np.ndarray, at_points: bool, shown: ColourRange,
              colours: str) -> ViewField:
    low, high = np.nanmin(values, initial=shown.low), np.nanmax(values, initial=shown.high)
    below, above = low < shown.low, high > shown.high
    beyond = ("both" if above else "min") if below else ("max" if above else "neither")
    return ViewField(name, label, values, at_points, colours, (shown.low, shown.high), shown.scale,
                     beyond=beyond)


def _fragments(frame: Frame) -> ViewField:
    """Fragments by their size, the largest first, as in the pictures."""
    _, number, count = np.unique(values_of(frame, "fragments"), return_inverse=True,
                                 return_counts=True)
    rank = np.empty(len(count), int)
    rank[np.argsort(-count, kind="stable")] = np.arange(len(count))
    names = [f"fragment {i + 1} by size of {len(count)}" for i in range(len(count))]
    return ViewField("fragments", "Fragments", rank[number.ravel()], False,
                     colour_table.distinct(len(count)), names=names)


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


def rock_fields(run: RunDirectory, frame: Frame, scale: float) -> list[ViewField]:
    """The fields of the rock at the time of `frame`; `scale` is the factor of the displacements,
    which decides what a picture shows."""
    fields = []
    for name in _offers(run, frame):
        if name == "fragments":
            fields.append(_fragments(frame))
            continue
        shown = view_of_frame(run, frame, name, scale).rock
        of_flow = name in FIELDS
        values = rock_values(frame, name) if of_flow else values_of(frame, name)
        at_points = name in ("pressure", "head", "saturation", "displacement", "velocity")
        label = LABEL[name] if of_flow else MECHANICS_LABEL[name]
        colours = colour_table.of_map(GREYS if name == "damage" else "viridis")
        fields.append(_spanning(name, label, values, at_points, shown, colours))
    return [*fields, _regions(run, frame)]


def _range_of_length(values: np.ndarray) -> ColourRange:
    ends = np.nanpercentile(values, [1, 99]) if np.isfinite(values).any() else (0.0, 1.0)
    low, high = widened(*map(float, ends))
    return ColourRange(low, high, length_scale([low, high]))


def _modes(cracks) -> ViewField:
    order = list(MODES)
    number = np.array([order.index(mode) for mode in cracks.cell_data["mode"].tolist()])
    return ViewField("mode", "Mode of breakage", number, False,
                     colour_table.of_names([colour for _, colour in MODES.values()]),
                     names=[name for name, _ in MODES.values()])


def _fluid(run: RunDirectory, frame: Frame, scale: float) -> Iterator[ViewField]:
    cracks = frame.cracks
    wet = carries_fluid(cracks)
    view = view_of_frame(run, frame, "pressure", scale)
    for name in ("pressure", "saturation"):
        at_ends = np.where(wet[:, None], point_values(cracks, name)[cracks.cells], np.nan)
        shown = view.cracks or view.rock
        colours = "inferno" if view.cracks else "viridis"
        if name == "saturation":
            shown, colours = ColourRange(0.0, 1.0, Scale(1.0, "")), "viridis"
        yield _spanning(name, f"{LABEL[name]} in cracks", at_ends, True, shown,
                        colour_table.of_map(colours))
    if "flux_m2_per_s" in cracks.cell_data:
        flux = np.where(wet, np.abs(cracks.cell_data["flux_m2_per_s"]), np.nan)
        high = float(np.nanpercentile(flux, 99)) if wet.any() else 0.0
        shown = ColourRange(0.0, high or 1.0, power_scale([high], "m²/s"))
        yield _spanning("flux", "Flow along cracks", flux, False, shown,
                        colour_table.of_map("inferno"))


def crack_fields(run: RunDirectory, frame: Frame, scale: float) -> list[ViewField]:
    """The fields of the cracks: (segments, 2) values of both ends, or one a segment. None where
    there is no crack; NaN where a crack holds no fluid."""
    cracks = frame.cracks
    if cracks is None or not len(cracks.cells):
        return []
    data = cracks.cell_data
    fields = [_modes(cracks)] if "mode" in data else []
    if run.has_flow:
        fields += _fluid(run, frame, scale)
    for name, label in (("aperture_m", "Hydraulic aperture"), ("opening_m", "Opening"),
                        ("slip_m", "Slip")):
        if name in data:
            values = np.where(carries_fluid(cracks), data[name], np.nan) \
                if name == "aperture_m" else data[name]
            fields.append(_spanning(name.removesuffix("_m"), label, values, False,
                                    _range_of_length(values), colour_table.of_map("plasma")))
    return fields
