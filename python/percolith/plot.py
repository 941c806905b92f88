# SPDX-License-Identifier: BSD-3-Clause
"""`percolith plot DIR`: pictures of the results of a run."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

from percolith.deformation import automatic_scale
from percolith.event_picture import draw_events
from percolith.field_picture import FIELDS, ColourRange, draw_field
from percolith.history_picture import draw_history
from percolith.mechanics_fields import MECHANICS_FIELDS, fragment_count, range_of_frames
from percolith.mechanics_history import draw_loading, draw_mechanics_history
from percolith.mechanics_picture import draw_mechanics
from percolith.probe_picture import draw_probes
from percolith.run_directory import Frame, RunDirectory, RunDirectoryError
from percolith.vtu import VtuError


def _arguments(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percolith plot",
        description="Draws a run: the fields (pressure.png, ...), the probes (probes.png) and, "
        "unless it is steady, the history (history.png), written into the run directory. Of "
        "mechanics it draws every field on the deformed shape, the reaction of loaded boundaries "
        "over their displacement (loading.png) and the joints that broke (events.png) as well.",
    )
    parser.add_argument("directory", metavar="DIR", help="the run directory")
    parser.add_argument("--field", choices=FIELDS + MECHANICS_FIELDS,
                        help=f"what to draw: of flow {', '.join(FIELDS)} (default pressure); of "
                        f"mechanics {', '.join(MECHANICS_FIELDS)} (default all but velocity)",
                        metavar="FIELD")
    parser.add_argument(
        "--time", default="last", help="time in s (the nearest frame), last (default) or all"
    )
    parser.add_argument(
        "--arrows", action="store_true", help="draw arrows of the Darcy flux over the field"
    )
    parser.add_argument(
        "--scale", default="auto",
        help="of mechanics: factor of the displacements, or auto (default): 1 where they are as "
        "large as the triangles, otherwise so that they can just be seen"
    )
    parser.add_argument(
        "--output", type=Path, metavar="FILE.png", help="write only the field, to this file"
    )
    arguments = parser.parse_args(words)
    if arguments.time not in ("last", "all"):
        try:
            arguments.time = float(arguments.time)
        except ValueError:
            parser.error(f"--time = {arguments.time}: not a number; allowed: seconds, last, all")
    if arguments.scale != "auto":
        try:
            arguments.scale = float(arguments.scale)
        except ValueError:
            arguments.scale = -1.0
        if not 0.0 <= arguments.scale < float("inf"):
            parser.error("--scale: allowed: auto, or a number that is not negative")
    if arguments.time == "all" and arguments.output:
        parser.error("--output holds one picture; leave it out with --time all")
    return arguments


def _require(allowed: bool, message: str) -> None:
    if not allowed:
        raise RunDirectoryError(message)


def _frame(run: RunDirectory, time: float | str) -> Frame:
    return run.frame(None if time == "last" else time)


def _series(run: RunDirectory, field: str) -> list[tuple[Path, float]]:
    """Path and time of a picture a frame: `FIELD_NNNN.png` in the run directory."""
    return [(run.path / f"{field}_{i:04d}.png", time) for i, time in enumerate(run.times)]


def _draw_flow(run: RunDirectory, field: str, time: float | str, arrows: bool,
               output: Path | None) -> list[Path]:
    if time == "all":
        shown = ColourRange.of_frames(run, field)  # one scale of colours for all
        return [draw_field(run, run.frame(moment), field, path, arrows, shown)
                for path, moment in _series(run, field)]
    return [draw_field(run, _frame(run, time), field, output or run.path / f"{field}.png", arrows)]


def _draw_deformed(run: RunDirectory, field: str | None, time: float | str, output: Path | None,
                   scale: float | None) -> list[Path]:
    if time == "all":
        field = field or "displacement"
        shown = None if field in ("damage", "fragments") else range_of_frames(run, field)
        scale = automatic_scale(run.frame().matrix) if scale is None else scale
        return [draw_mechanics(run, run.frame(moment), field, path, scale, shown)
                for path, moment in _series(run, field)]
    frame = _frame(run, time)
    if field or output:
        field = field or "displacement"
        return [draw_mechanics(run, frame, field, output or run.path / f"{field}.png", scale)]
    fields = [name for name in MECHANICS_FIELDS if name != "velocity"]
    if fragment_count(frame) == 1:
        fields.remove("fragments")
    return [draw_mechanics(run, frame, name, run.path / f"{name}.png", scale) for name in fields]


def _draw_mechanics_tables(run: RunDirectory) -> list[Path]:
    paths = [draw_mechanics_history(run, run.path / "history.png"),
             draw_loading(run, run.path / "loading.png"),
             draw_events(run, run.path / "events.png")]
    return [path for path in paths if path]


def draw(run: RunDirectory, field: str | None = None, time: float | str = "last",
         arrows: bool = False, output: Path | None = None,
         scale: float | None = None) -> list[Path]:
    """Draws what `percolith plot` draws and returns the paths of the pictures. Without `field` it
    is the pressure, in mechanics every field. `scale` multiplies the displacements of mechanics;
    None chooses it."""
    known = MECHANICS_FIELDS if run.is_mechanics else FIELDS
    _require(field is None or field in known,
             f"{run.path}: no {field} in this run; there are: {', '.join(known)}")
    if run.is_mechanics:
        _require(not arrows, "--arrows shows the Darcy flux, and this is a run of mechanics")
        paths = _draw_deformed(run, field, time, output, scale)
    else:
        _require(scale is None, "--scale is for runs of mechanics, and this is one of flow")
        field = field or "pressure"
        paths = _draw_flow(run, field, time, arrows, output)
    if output is not None:
        return paths
    if run.probe_names:
        paths.append(draw_probes(run, field or "displacement", run.path / "probes.png"))
    if run.is_mechanics:
        paths += _draw_mechanics_tables(run)
    elif not run.is_steady:
        paths.append(draw_history(run, run.path / "history.png"))
    return paths


def main(words: list[str] | None = None) -> int:
    """Runs the command; returns 0, 2 for an unusable directory or 4 for an unusable file."""
    arguments = _arguments(words)
    try:
        run = RunDirectory(arguments.directory)
        scale = None if arguments.scale == "auto" else arguments.scale
        paths = draw(run, arguments.field, arguments.time, arguments.arrows, arguments.output,
                     scale)
    except RunDirectoryError as error:
        print(f"percolith-plot: error: {error}", file=sys.stderr)
        return 2
    except (OSError, VtuError) as error:
        print(f"percolith-plot: error: {error}", file=sys.stderr)
        return 4
    for path in paths:
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
