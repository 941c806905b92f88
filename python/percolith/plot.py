# SPDX-License-Identifier: BSD-3-Clause
"""`percolith plot DIR`: pictures of the results of a run."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

from percolith.animation import draw_animation
from percolith.flow_fields import FIELDS
from percolith.mechanics_fields import MECHANICS_FIELDS
from percolith.pictures import draw
from percolith.run_directory import RunDirectory, RunDirectoryError
from percolith.vtu import VtuError
from percolith.window import ALLOWED, window_from

__all__ = ["draw", "main"]


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="percolith plot",
        description="Draws a run: the fields (pressure.png, ...), the probes (probes.png) and, "
        "unless it is steady, the history (history.png), written into the run directory. Of "
        "mechanics it draws every field on the deformed shape, the reaction of loaded boundaries "
        "over their displacement (loading.png) and the joints that broke (events.png) as well; "
        "of rock that fluid breaks also the fluid (fluid.png) and the cracks (crack_growth.png).",
    )
    parser.add_argument("directory", metavar="DIR", help="the run directory")
    parser.add_argument("--field", choices=FIELDS + MECHANICS_FIELDS,
                        help=f"what to draw: of flow {', '.join(FIELDS)} (default pressure); of "
                        f"mechanics {', '.join(MECHANICS_FIELDS)} (default all but velocity)",
                        metavar="FIELD")
    parser.add_argument(
        "--time", help="time in s (the nearest frame), last (default) or all"
    )
    parser.add_argument(
        "--arrows", action="store_true", help="draw arrows of the Darcy flux over the field"
    )
    parser.add_argument(
        "--scale", default="auto",
        help="of mechanics: factor of the displacements, or auto (default): 1 where they are as "
        "large as the triangles, otherwise so that they can just be seen and close no opening"
    )
    parser.add_argument(
        "--window", nargs=4, metavar=("X0", "X1", "Y0", "Y1"),
        help="show only this part of maps, from X0 to X1 and from Y0 to Y1 in m, in colours that "
        "suit what is seen"
    )
    parser.add_argument(
        "--animate", action="store_true",
        help="draw one field over time instead, as FIELD.gif (default pressure, or "
        "principal_stress_1 of a run without flow)"
    )
    parser.add_argument(
        "--output", type=Path, metavar="FILE",
        help="write only the field, to this file: FILE.png, or FILE.gif with --animate"
    )
    return parser


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _with_numbers(words: list[str]) -> list[str]:
    """The same words, the numbers of a window with a blank before them: -1e-3 would be taken for an
    option."""
    if "--window" not in words:
        return words
    first = words.index("--window") + 1
    return words[:first] + [f" {word}" if _is_number(word) else word
                            for word in words[first:first + 4]] + words[first + 4:]


def _arguments(words: list[str] | None) -> argparse.Namespace:
    parser = _parser()
    arguments = parser.parse_args(_with_numbers(sys.argv[1:] if words is None else words))
    if arguments.animate and (arguments.time or arguments.arrows):
        parser.error("--animate shows all times, and no arrows; leave out --time and --arrows")
    if arguments.animate and arguments.output and arguments.output.suffix.lower() != ".gif":
        parser.error(f"--output = {arguments.output}: an animation is a GIF; allowed: FILE.gif")
    arguments.time = arguments.time or "last"
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
    if arguments.window:
        try:
            arguments.window = window_from(arguments.window)
        except ValueError as error:
            shown = " ".join(word.strip() for word in arguments.window)
            parser.error(f"--window = {shown}: {error}; allowed: {ALLOWED}")
    if arguments.time == "all" and arguments.output:
        parser.error("--output holds one picture; leave it out with --time all")
    return arguments


def main(words: list[str] | None = None) -> int:
    """Runs the command; returns 0, 2 for an unusable directory or 4 for an unusable file."""
    arguments = _arguments(words)
    scale = None if arguments.scale == "auto" else arguments.scale
    try:
        run = RunDirectory(arguments.directory)
        if arguments.animate:
            paths = [draw_animation(run, arguments.field, arguments.output, scale,
                                    arguments.window)]
        else:
            paths = draw(run, arguments.field, arguments.time, arguments.arrows, arguments.output,
                         scale, arguments.window)
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
