# SPDX-License-Identifier: BSD-3-Clause
"""`percolith plot DIR`: pictures of the results of a run."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

from percolith.animation import draw_animation
from percolith.animation import FORMATS as OF_ANIMATIONS
from percolith.errors import CaseError
from percolith.flow_fields import FIELDS
from percolith.mechanics_fields import MECHANICS_FIELDS
from percolith.overlays import CRACKS, Overlays
from percolith.pictures import draw
from percolith.run_directory import ArgumentError, RunDirectory, RunDirectoryError
from percolith.saving import FORMATS
from percolith.times import ALLOWED as ALLOWED_TIMES
from percolith.times import seconds
from percolith.vtu import VtuError
from percolith.window import ALLOWED, window_from

__all__ = ["draw", "main"]

DESCRIPTION = """Draws a run: the fields (pressure.png, ...), the probes (probes.png) and, unless it
is steady, the history (history.png), written into the run directory. Of mechanics it draws every
field on the deformed shape, the reaction of loaded boundaries over their displacement (loading.png)
and the joints that broke, with their magnitudes and the b-value (events.png), as well; of rock that
fluid breaks also the fluid (fluid.png) and the cracks with the pressure of injection
(crack_growth.png)."""


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="percolith plot", description=DESCRIPTION)
    parser.add_argument("directory", metavar="DIR", help="the run directory")
    parser.add_argument("--field", metavar="FIELD",
                        help=f"what to draw: of flow {', '.join(FIELDS)} (default pressure); of "
                        f"mechanics {', '.join(MECHANICS_FIELDS)} (default all but velocity); or "
                        "any other array of the field files, such as stress_xx, strain_xy, region")
    parser.add_argument("--time", help="time in s or with a unit, such as \"10 ms\" (the nearest "
                        "frame), last (default) or all")
    parser.add_argument("--cracks", default="auto", choices=CRACKS, metavar="QUANTITY",
                        help=f"what cracks are coloured by: {', '.join(CRACKS)}; auto (default) is "
                        "the field of a picture of flow but the flux, and in others mode or thin, "
                        "which is dark")
    parser.add_argument("--crosses", action="store_true", default=None,
                        help="draw crosses of the principal stresses over the field")
    parser.add_argument("--arrows", action="store_true",
                        help="draw arrows of the Darcy flux over the field")
    parser.add_argument("--scale", default="auto",
                        help="of mechanics: factor of the displacements, or auto (default): 1 "
                        "where they are as large as the triangles, otherwise so that they can "
                        "just be seen and close no opening")
    parser.add_argument("--window", nargs=4, metavar=("X0", "X1", "Y0", "Y1"),
                        help="show only this part of maps, from X0 to X1 and from Y0 to Y1 in m, "
                        "in colours that suit what is seen")
    parser.add_argument("--reference", type=Path, action="append", default=[], metavar="FILE.csv",
                        help="draw the values of this table as markers over the probes; may be "
                        "given several times")
    parser.add_argument("--animate", action="store_true",
                        help="draw one field over time instead, as FIELD.gif (default pressure, or "
                        "principal_stress_1 of a run without flow)")
    parser.add_argument("--output", type=Path, metavar="FILE",
                        help="write only the field, to this file: FILE.png, FILE.pdf or FILE.svg, "
                        "or with --animate FILE.gif or FILE.mp4")
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
    if arguments.animate and arguments.time:
        parser.error("--animate shows all times; leave out --time")
    if arguments.reference and (arguments.animate or arguments.output):
        parser.error("--reference is for the picture of the probes; leave out --animate and "
                     "--output, which draw a field alone")
    if arguments.output:
        kind, known = (("an animation", OF_ANIMATIONS) if arguments.animate else
                       ("a picture", FORMATS))
        if arguments.output.suffix.lower() not in known:
            parser.error(f"--output = {arguments.output}: not the name of {kind}; allowed: "
                         + ", ".join(f"FILE{ending}" for ending in known))
    arguments.time = arguments.time or "last"
    if arguments.time not in ("last", "all"):
        try:
            arguments.time = seconds(arguments.time)
        except ValueError as error:
            parser.error(f"--time = {arguments.time}: {error}; allowed: last, all, {ALLOWED_TIMES}")
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
            overlays = Overlays(arguments.cracks, arguments.crosses, arguments.arrows)
            paths = [draw_animation(run, arguments.field, arguments.output, scale,
                                    arguments.window, overlays)]
        else:
            paths = draw(run, arguments.field, arguments.time, arguments.arrows, arguments.output,
                         scale, arguments.window, arguments.cracks, arguments.crosses,
                         arguments.reference)
    except CaseError as error:
        for line in str(error).splitlines():
            print(f"percolith-plot: error: {line}", file=sys.stderr)
        return 2
    except ArgumentError as error:
        print(f"percolith-plot: error: --{error}", file=sys.stderr)
        return 2
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
