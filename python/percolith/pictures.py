# SPDX-License-Identifier: BSD-3-Clause
"""Which pictures of a run there are, from what it has left: of flow, of mechanics, or of both."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from percolith.crack_growth_picture import draw_crack_growth
from percolith.event_picture import draw_events
from percolith.field_picture import draw_field
from percolith.flow_fields import FIELDS
from percolith.history_picture import draw_history
from percolith.mechanics_fields import MECHANICS_FIELDS, fragment_count
from percolith.mechanics_history import draw_loading, draw_mechanics_history
from percolith.mechanics_picture import draw_mechanics
from percolith.probe_picture import draw_probes
from percolith.run_directory import Frame, RunDirectory, RunDirectoryError
from percolith.view import View, view_of_frame, view_of_times


def fields_of(run: RunDirectory) -> tuple[str, ...]:
    """The fields that pictures of this run can show."""
    return FIELDS * run.has_flow + MECHANICS_FIELDS * run.has_mechanics


def check_field(run: RunDirectory, field: str | None) -> None:
    """Raises RunDirectoryError where pictures of this run cannot show `field`."""
    if field is not None and field not in fields_of(run):
        raise RunDirectoryError(f"{run.path}: no {field} in this run; there are: "
                                f"{', '.join(fields_of(run))}")


def check_scale(run: RunDirectory, scale: float | None) -> None:
    """Raises RunDirectoryError where a factor of displacements has no meaning."""
    if scale is not None and not run.has_mechanics:
        raise RunDirectoryError("--scale is for runs of mechanics, and this is one of flow")


def _check_arrows(run: RunDirectory, field: str | None, arrows: bool) -> None:
    if arrows and not run.has_flow:
        raise RunDirectoryError("--arrows shows the Darcy flux, and this is a run of mechanics")
    if arrows and field in MECHANICS_FIELDS:
        raise RunDirectoryError(f"--arrows shows the Darcy flux, and {field} is no field of flow")


def shows_modes(run: RunDirectory) -> bool:
    """Whether cracks are told apart by their mode in every picture of mechanics."""
    return run.has_flow and run.has_mechanics


def _draw_one(run: RunDirectory, frame: Frame, field: str, path: Path, arrows: bool,
              view: View) -> Path:
    if field in FIELDS:
        return draw_field(run, frame, field, path, arrows, view)
    return draw_mechanics(run, frame, field, path, view=view)


def _draw_series(run: RunDirectory, field: str, arrows: bool, scale: float | None,
                 window: np.ndarray | None) -> list[Path]:
    """A picture a frame, `FIELD_NNNN.png` in the run directory, all with one view."""
    view = view_of_times(run, run.times, field, scale, shows_modes(run), window=window)
    return [_draw_one(run, run.frame(time), field, run.path / f"{field}_{i:04d}.png", arrows, view)
            for i, time in enumerate(run.times)]


def _default_fields(run: RunDirectory, frame: Frame) -> list[str]:
    """What is drawn where no field is asked for."""
    fields = ["pressure"] if run.has_flow else []
    if run.has_mechanics:
        fields += [name for name in MECHANICS_FIELDS if name != "velocity"]
        if fragment_count(frame) == 1:
            fields.remove("fragments")
    return fields


def _draw_fields(run: RunDirectory, field: str | None, time: float | str, arrows: bool,
                 output: Path | None, scale: float | None,
                 window: np.ndarray | None) -> list[Path]:
    first = field or ("pressure" if run.has_flow else "displacement")
    if time == "all":
        return _draw_series(run, first, arrows, scale, window)
    frame = run.frame(None if time == "last" else time)
    fields = [first] if field or output else _default_fields(run, frame)
    return [_draw_one(run, frame, name, output or run.path / f"{name}.png",
                      arrows and name in FIELDS,
                      view_of_frame(run, frame, name, scale, shows_modes(run), window))
            for name in fields]


def _draw_tables(run: RunDirectory, window: np.ndarray | None) -> list[Path]:
    """The pictures of history and events; those of flow have a name of their own beside those of
    mechanics."""
    paths: list[Path | None] = []
    if run.has_mechanics:
        paths.append(draw_mechanics_history(run, run.path / "history.png"))
    if run.has_flow and not run.is_steady:
        name = "fluid.png" if run.has_mechanics else "history.png"
        paths.append(draw_history(run, run.path / name))
    if run.has_mechanics:
        paths += [draw_crack_growth(run, run.path / "crack_growth.png"),
                  draw_loading(run, run.path / "loading.png"),
                  draw_events(run, run.path / "events.png", window)]
    return [path for path in paths if path]


def draw(run: RunDirectory, field: str | None = None, time: float | str = "last",
         arrows: bool = False, output: Path | None = None,
         scale: float | None = None, window: np.ndarray | None = None) -> list[Path]:
    """Draws what `percolith plot` draws and returns the paths of the pictures. Without `field` it
    is the pressure of a run with flow, and every field of mechanics. `scale` multiplies the
    displacements; None chooses it. `window` gives lower left and upper right end (2, 2) of what
    maps show, in m; None stands for all."""
    check_field(run, field)
    check_scale(run, scale)
    _check_arrows(run, field, arrows)
    paths = _draw_fields(run, field, time, arrows, output, scale, window)
    if output is not None:
        return paths
    if run.probe_names:
        paths.append(draw_probes(run, field or "pressure", run.path / "probes.png"))
    return paths + _draw_tables(run, window)
