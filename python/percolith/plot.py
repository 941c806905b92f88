# SPDX-License-Identifier: BSD-3-Clause
"""`percolith plot DIR`: pictures of the results of a run."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

from percolith.field_picture import FIELDS, ColourRange, draw_field
from percolith.history_picture import draw_history
from percolith.probe_picture import draw_probes
from percolith.run_directory import RunDirectory, RunDirectoryError
from percolith.vtu import VtuError


def _arguments(words: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percolith plot",
        description="Draws a run: the fields (pressure.png, ...), the probes (probes.png) and, "
        "unless it is steady, the history (history.png), written into the run directory.",
    )
    parser.add_argument("directory", metavar="DIR", help="the run directory")
    parser.add_argument("--field", choices=FIELDS, default="pressure", help="what to draw")
    parser.add_argument(
        "--time", default="last", help="time in s (the nearest frame), last (default) or all"
    )
    parser.add_argument(
        "--arrows", action="store_true", help="draw arrows of the Darcy flux over the field"
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
    if arguments.time == "all" and arguments.output:
        parser.error("--output holds one picture; leave it out with --time all")
    return arguments


def draw_all_frames(run: RunDirectory, field: str, arrows: bool) -> list[Path]:
    """A picture a frame, all on one scale of colours, as `FIELD_NNNN.png` in the run directory."""
    ranges = ColourRange.of_frames(run, field)
    paths = []
    for number, time in enumerate(run.times):
        path = run.path / f"{field}_{number:04d}.png"
        paths.append(draw_field(run, run.frame(time), field, path, arrows, ranges))
    return paths


def draw(run: RunDirectory, field: str = "pressure", time: float | str = "last",
         arrows: bool = False, output: Path | None = None) -> list[Path]:
    """Draws what `percolith plot` draws and returns the paths of the pictures."""
    if time == "all":
        paths = draw_all_frames(run, field, arrows)
    else:
        frame = run.frame(None if time == "last" else time)
        paths = [draw_field(run, frame, field, output or run.path / f"{field}.png", arrows)]
    if output is None:
        if run.probe_names:
            paths.append(draw_probes(run, field, run.path / "probes.png"))
        if not run.is_steady:
            paths.append(draw_history(run, run.path / "history.png"))
    return paths


def main(words: list[str] | None = None) -> int:
    """Runs the command; returns 0, 2 for an unusable directory or 4 for an unusable file."""
    arguments = _arguments(words)
    try:
        run = RunDirectory(arguments.directory)
        paths = draw(run, arguments.field, arguments.time, arguments.arrows, arguments.output)
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
