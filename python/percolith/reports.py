# SPDX-License-Identifier: BSD-3-Clause
"""`percolith report DIR`: one page of a run, with all that it left."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from percolith.pictures import check_scale
from percolith.reporting.page import page_of
from percolith.run_directory import ArgumentError, RunDirectory, RunDirectoryError
from percolith.saving import replacing, writing
from percolith.times import ALLOWED, seconds
from percolith.vtu import VtuError


def report(directory: str | os.PathLike, output: str | os.PathLike | None = None,
           time: float | str | None = None, scale: float | None = None) -> Path:
    """Writes one HTML page of a run directory, which needs no other file and no network, and
    returns its path: what was run, how it ended, balances, results, pictures, and a view to move
    about in. `output` is the file, None for report.html in the directory; `time` (s, or a text
    such as "10 ms") chooses the frame that is shown, None the last one; `scale` multiplies the
    displacements, None chooses it. A run that has not ended is reported as far as it got. Raises
    RunDirectoryError where there is no run directory or a file of a run that ended is missing or
    damaged, VtuError where a field file is damaged, and FileError where a file cannot be read or
    written; an earlier page then stays."""
    run = RunDirectory(directory)
    check_scale(run, scale)
    path = run.path / "report.html" if output is None else Path(output)
    with replacing(path) as part:
        page = page_of(run, time, scale)
        with writing(path):
            part.write_text(page, encoding="utf-8")
    return path


def _factor(word: str) -> float:
    try:
        number = float(word)
    except ValueError:
        number = -1.0
    if not 0.0 <= number < float("inf"):
        raise ValueError("no factor")
    return number


def _time(word: str) -> float:
    time = seconds(word)
    if time < 0.0:
        raise ValueError("a negative time")
    return time


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="percolith report",
        description="Writes one HTML page of a run, DIR/report.html, that needs no other file and "
        "no network: what was run and how it ended, warnings, balances, results, the pictures of "
        "percolith plot, animations that are in DIR, and a view of the run over time to move about "
        "in. A run that has not ended is reported as far as it got.",
        epilog="Example: percolith report case.results")
    parser.add_argument("directory", metavar="DIR", help="the run directory")
    parser.add_argument("--output", type=Path, metavar="FILE",
                        help="write the page to this file instead")
    parser.add_argument("--time",
                        help="show the frame nearest to this time in s or with a unit, such as \"10 "
                        "ms\", or last (default)")
    parser.add_argument("--scale", default="auto",
                        help="of mechanics: factor of the displacements, or auto (default)")
    return parser


def _arguments(words: list[str] | None) -> argparse.Namespace:
    parser = _parser()
    arguments = parser.parse_args(words)
    positive = "or a number that is not negative"
    for name, word, read, allowed in (("time", "last", _time, ALLOWED),
                                      ("scale", "auto", _factor, positive)):
        value = getattr(arguments, name) or word
        try:
            setattr(arguments, name, None if value == word else read(value))
        except ValueError as error:
            parser.error(f"--{name} = {value}: {error}; allowed: {word}, {allowed}")
    return arguments


def main(words: list[str] | None = None) -> int:
    """Runs the command; returns 0, 2 for an unusable directory or 4 for an unusable file."""
    arguments = _arguments(words)
    try:
        print(report(arguments.directory, arguments.output, arguments.time, arguments.scale))
    except ArgumentError as error:
        print(f"percolith-report: error: --{error}", file=sys.stderr)
        return 2
    except RunDirectoryError as error:
        print(f"percolith-report: error: {error}", file=sys.stderr)
        return 2
    except (OSError, VtuError) as error:
        print(f"percolith-report: error: {error}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
