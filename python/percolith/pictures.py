# SPDX-License-Identifier: BSD-3-Clause
"""Which pictures of a run there are, from what it has left: of flow, of mechanics, or of both."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from numbers import Real
from pathlib import Path

import numpy as np

from percolith.crack_growth_picture import crack_growth_figure
from percolith.errors import did_you_mean
from percolith.event_picture import events_figure
from percolith.flow_fields import FIELDS
from percolith.history_picture import history_figure
from percolith.loading_picture import loading_figure
from percolith.map_picture import map_axes
from percolith.mechanics_fields import MECHANICS_FIELDS, fragment_count, other_fields
from percolith.mechanics_history import mechanics_history_figure
from percolith.overlays import Overlays, check_overlays
from percolith.probe_picture import probes_figure
from percolith.reference_curves import read_references
from percolith.run_directory import ArgumentError, Frame, RunDirectory, RunDirectoryError
from percolith.saving import save
from percolith.units import without_unit
from percolith.view import STILL, View, view_of_frame, view_of_times


def fields_of(run: RunDirectory) -> tuple[str, ...]:
    """The fields that pictures of this run can show; without gravity there is no head."""
    fields = FIELDS * run.has_flow + MECHANICS_FIELDS * run.has_mechanics
    if not run.times:
        return fields
    matrix = run.frame(run.times[0]).matrix
    fields = tuple(name for name in fields if name != "head" or "head_m" in matrix.point_data)
    return (*fields, *other_fields(matrix))


def check_field(run: RunDirectory, field: str | None) -> str | None:
    """The field by its name in pictures: without the unit, if it was given as an array is called.
    Raises RunDirectoryError where pictures of this run cannot show it."""
    if field is None:
        return None
    known = fields_of(run)
    for name in (field, without_unit(str(field))):
        if name in known:
            return name
    needs = "; head needs model.gravity > 0" if without_unit(str(field)) == "head" else ""
    raise RunDirectoryError(f"{run.path}: no {field} in this run; there are: {', '.join(known)}"
                            + did_you_mean(without_unit(str(field)), known, most=1) + needs)


def check_scale(run: RunDirectory, scale: float | None) -> None:
    """Raises RunDirectoryError where a factor of displacements has no meaning."""
    if scale is None:
        return
    if not run.has_mechanics:
        raise ArgumentError("scale is for runs of mechanics, and this is one of flow")
    if not isinstance(scale, Real) or not 0.0 <= scale < float("inf"):
        raise ArgumentError(f"scale = {scale!r}: allowed: a number that is not negative")


def default_field(run: RunDirectory) -> str:
    """What one map of a run shows where nobody says it."""
    return "pressure" if run.has_flow else "displacement"


def shows_modes(run: RunDirectory) -> bool:
    """Whether cracks are told apart by their mode in every picture of mechanics."""
    return run.has_flow and run.has_mechanics


@dataclass(frozen=True)
class MapOptions:
    """How maps of a run are drawn."""

    scale: float | None = None  # of the displacements; None chooses it
    window: np.ndarray | None = None  # lower left and upper right end (2, 2), m; None shows all
    overlays: Overlays = Overlays()

    def check(self, run: RunDirectory) -> None:
        """Raises RunDirectoryError where the run has nothing to draw this from."""
        check_scale(run, self.scale)
        check_overlays(run, self.overlays)

    def view(self, run: RunDirectory, frame: Frame, field: str) -> View:
        return view_of_frame(run, frame, field, self.scale, shows_modes(run), self.window,
                             self.overlays)

    def view_of_all(self, run: RunDirectory, times: Sequence[float], field: str,
                    modes: bool | None = None, colours: int = STILL) -> View:
        """The view that suits the frames at these times (s)."""
        modes = shows_modes(run) if modes is None else modes
        return view_of_times(run, times, field, self.scale, modes, colours, self.window,
                             self.overlays)


def draw_map(run: RunDirectory, frame: Frame, field: str, options: MapOptions, axes=None):
    """Draws one field of one frame and returns its axes."""
    return map_axes(run, frame, field, options.view(run, frame, field), axes)


def _draw_series(run: RunDirectory, field: str, options: MapOptions) -> list[Path]:
    """A picture a frame, `FIELD_NNNN.png` in the run directory, all with one view."""
    view = options.view_of_all(run, run.times, field)
    return [save(map_axes(run, run.frame(time), field, view).figure,
                 run.path / f"{field}_{i:04d}.png") for i, time in enumerate(run.times)]


def default_fields(run: RunDirectory, frame: Frame) -> list[str]:
    """Which maps there are where no field is asked for."""
    fields = ["pressure"] if run.has_flow else []
    if run.has_mechanics:
        fields += [name for name in MECHANICS_FIELDS if name != "velocity"]
        if fragment_count(frame) == 1:
            fields.remove("fragments")
    return fields


def _draw_fields(run: RunDirectory, field: str | None, time: float | str, output: Path | None,
                 options: MapOptions) -> list[Path]:
    first = field or default_field(run)
    if time == "all":
        return _draw_series(run, first, options)
    frame = run.frame(None if time == "last" else time)
    if field or output:
        return [save(draw_map(run, frame, first, options).figure,
                     output or run.path / f"{first}.png")]
    # Where no field is asked for, arrows of the flux lie over those of flow.
    still = replace(options, overlays=replace(options.overlays, arrows=False))
    return [save(draw_map(run, frame, name, options if name in FIELDS else still).figure,
                 run.path / f"{name}.png") for name in default_fields(run, frame)]


def history_of(run: RunDirectory, of: str | None = None):
    """The figure of the history of the `rock` or the `fluid`; None stands for the one there is, of
    a coupled run that of the rock. Raises RunDirectoryError where there is none."""
    known = ["rock"] * run.has_mechanics + ["fluid"] * (run.has_flow and not run.is_steady)
    if not known:
        raise RunDirectoryError(f"{run.path}: a steady run has no history")
    of = known[0] if of is None else of
    if of not in known:
        raise RunDirectoryError(f"history of {of}: this run has none; allowed: {', '.join(known)}")
    return mechanics_history_figure(run) if of == "rock" else history_figure(run)


def loading_of(run: RunDirectory):
    """The figure of reactions over displacements; None where nothing is loaded."""
    return loading_figure(run) if run.has_mechanics else None


def table_figures(run: RunDirectory, window: np.ndarray | None = None) -> dict:
    """The figures of history and events by the names of their files; those of flow have a name of
    their own beside those of mechanics."""
    if run.is_steady:
        return {}
    figures = {"history": history_of(run)}
    if run.has_mechanics:
        if run.has_flow:
            figures["fluid"] = history_of(run, "fluid")
        figures |= {"crack_growth": crack_growth_figure(run), "loading": loading_of(run),
                    "events": events_figure(run, window)}
    return {name: figure for name, figure in figures.items() if figure}


def draw(run: RunDirectory, field: str | None = None, time: float | str = "last",
         arrows: bool = False, output: Path | None = None,
         scale: float | None = None, window: np.ndarray | None = None, cracks: str = "auto",
         crosses: bool | None = None,
         references: Sequence[str | os.PathLike] = ()) -> list[Path]:
    """Draws what `percolith plot` draws and returns the paths of the pictures. Without `field` it
    is the pressure of a run with flow, and every field of mechanics. `scale` multiplies the
    displacements; None chooses it. `window` gives lower left and upper right end (2, 2) of what
    maps show, in m; None stands for all. `cracks` is one of overlays.CRACKS; `crosses` of the
    principal stresses and `arrows` of the flux lie over every map, without being asked for crosses
    over principal stresses alone. `references` are files to compare probes with."""
    options = MapOptions(scale, window, Overlays(cracks, crosses, arrows))
    field = check_field(run, field)
    options.check(run)
    curves = read_references(references, run)
    paths = _draw_fields(run, field, time, output, options)
    if output is not None:
        return paths
    if run.probe_names:
        paths.append(save(probes_figure(run, field or "pressure", curves), run.path / "probes.png"))
    return paths + [save(figure, run.path / f"{name}.png")
                    for name, figure in table_figures(run, window).items()]
