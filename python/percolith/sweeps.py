# SPDX-License-Identifier: BSD-3-Clause
"""Many runs of one case with other options, side by side in processes or over the jobs of a cluster.

A sweep is a folder: `sweep.json` with its points, and a folder of results for each. What has
finished is not run again, what was interrupted goes on from its checkpoint. From a shell, for
instance of a job array:

    python -m percolith.sweeps FOLDER             runs all that is left, in processes
    python -m percolith.sweeps FOLDER --point 3   runs one point
    python -m percolith.sweeps FOLDER --list      tells how far each is
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import signal
import subprocess
import sys
import warnings
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from percolith import errors
from percolith.case import Case
from percolith.errors import CaseError, CaseWarning, Error, FileError
from percolith.run_directory import RunDirectory, Table
from percolith.simulation import resume
from percolith.toml_text import plain

_PLAN = "sweep.json"


@dataclass(frozen=True)
class Point:
    """A run of a sweep: its number, the options that are its own, its folder of results."""

    number: int
    options: dict[str, Any]
    folder: Path

    @property
    def state(self) -> str:
        """finished, failed, interrupted, or waiting: not begun, killed or at work."""
        try:
            return json.loads((self.folder / "summary.json").read_text(encoding="utf-8"))["outcome"]
        except (OSError, ValueError, KeyError, TypeError):
            return "waiting"

    def results(self) -> RunDirectory:
        """Opens the results. Raises RunDirectoryError where there are none."""
        return RunDirectory(self.folder)


class Sweep:
    """A sweep in its folder. Raises CaseError where the folder holds none."""

    def __init__(self, folder: str | os.PathLike):
        self.folder = Path(folder)
        try:
            plan = json.loads((self.folder / _PLAN).read_text(encoding="utf-8"))
            self._plan = {name: plan[name] for name in ("case", "directory", "points")}
        except (OSError, ValueError) as error:
            raise CaseError(f"{folder}: error: no sweep here: {error}") from error
        except (KeyError, TypeError) as error:
            raise CaseError(f"{folder}: error: no sweep here: {_PLAN} is not a plan") from error

    @property
    def points(self) -> list[Point]:
        """All runs, in the order of their numbers from 0."""
        return [Point(number, options, self.folder / f"{number:04d}")
                for number, options in enumerate(self._plan["points"])]

    def case(self, number: int) -> Case:
        """The case of one point. Raises CaseError for a number that is none."""
        if not 0 <= number < len(self._plan["points"]):
            raise CaseError(f"error: point {number}: no number of a point; allowed: 0 to "
                            f"{len(self._plan['points']) - 1}")
        case = Case.from_toml(self._plan["case"], directory=self._plan["directory"])
        for key, value in self._plan["points"][number].items():
            case[key] = value
        return case

    def run_point(self, number: int, *, threads: int | None = None) -> RunDirectory:
        """Runs one point, or what is left of it, and opens its results. Raises CaseError,
        SolverError and FileError; a run that failed is begun again."""
        case = self.case(number)
        point = self.points[number]
        if point.state == "finished":
            return point.results()
        if point.state != "failed" and (point.folder / "checkpoint.bin").is_file():
            return resume(point.folder, threads=threads)
        return case.run(point.folder, force=True, threads=threads)

    def run(self, *, processes: int | None = None, threads: int = 1) -> dict[int, Error]:
        """Runs all that is left, in so many processes of so many threads each; as many processes as
        there are processors for when None. Returns the errors of the points that failed, by their
        numbers; the others are run all the same. After Ctrl-C nothing new is begun, and the next
        call goes on."""
        if processes is None:
            processes = max(1, len(os.sched_getaffinity(0)) // threads)
        if processes < 1:
            raise CaseError(f"error: processes = {processes}: allowed: 1 or more")
        left = [point.number for point in self.points if point.state != "finished"]
        working: set[subprocess.Popen] = set()
        with ThreadPoolExecutor(processes) as pool:
            jobs = [pool.submit(_run_elsewhere, self.folder, number, threads, working)
                    for number in left]
            try:
                ended = [job.result() for job in jobs]
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                for process in list(working):
                    process.send_signal(signal.SIGINT)
                raise
        return {number: error for number, error in zip(left, ended) if error is not None}

    def table(self) -> Table:
        """A row a point: `point`, `state`, its options, and the numbers of its summary, those of
        mechanics and of the mass balance among them, and the rate of each condition at the end as
        `boundary.left_m2_per_s`, called as in the history; NaN where there is none."""
        rows = [_row(point) for point in self.points]
        names = list(dict.fromkeys(name for row in rows for name in row))
        return Table({name: _column([row.get(name) for row in rows]) for name in names})


def _run_elsewhere(folder: Path, number: int, threads: int,
                   working: set[subprocess.Popen]) -> Error | None:
    """Runs a point in a process of its own; returns what went wrong. Warnings are in the log of
    the run. The process does not import the program that asks for it."""
    package = str(Path(__file__).absolute().parent.parent)
    path = os.pathsep.join([package, *filter(None, [os.environ.get("PYTHONPATH")])])
    words = [sys.executable, "-W", "ignore", "-m", "percolith.sweeps", str(folder), "--point",
             str(number), "--threads", str(threads), "--errors", "json"]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               env={**os.environ, "PYTHONPATH": path})
    working.add(process)
    out, told = process.communicate()
    working.discard(process)
    if process.returncode == 0:
        return None
    try:
        failure = json.loads(out)
        return getattr(errors, failure["error"])(failure["message"])
    except (ValueError, KeyError, AttributeError):
        return Error(f"the process of point {number} ended with exit code {process.returncode}: "
                     f"{told.strip()[-1000:]}")


def _row(point: Point) -> dict[str, Any]:
    row: dict[str, Any] = {"point": point.number, "state": point.state, **point.options}
    if point.state != "waiting":
        summary = point.results().summary
        parts = [summary, summary.get("mechanics", {}), summary.get("mass_balance", {})]
        row |= {name: value for part in parts for name, value in part.items()
                if isinstance(value, (int, float)) and not isinstance(value, bool)}
        rates = summary.get("rate_m2_per_s", {})
        row |= {f"{name}_m2_per_s": rate for name, rate in rates.items()}
    return row


def _column(values: list[Any]) -> np.ndarray:
    if all(value is None or isinstance(value, (int, float)) for value in values):
        return np.array([np.nan if value is None else value for value in values])
    return np.array(["" if value is None else str(value) for value in values])


def _points(options: Mapping[str, Sequence[Any]] | Sequence[Mapping[str, Any]]) -> list[dict]:
    if not isinstance(options, Mapping):
        return [plain(dict(point)) for point in options]
    lists = {}
    for key, values in options.items():
        if isinstance(values, (str, Mapping)) or not hasattr(values, "__iter__"):
            raise CaseError(f"error: {key} = {values!r}: no list of values to run through")
        lists[key] = [plain(value) for value in values]
    return [dict(zip(lists, values)) for values in itertools.product(*lists.values())]


def sweep(case: Case, options: Mapping[str, Sequence[Any]] | Sequence[Mapping[str, Any]],
          folder: str | os.PathLike) -> Sweep:
    """Plans a sweep of a case in a folder, or opens the same one that was planned there before.

    options: lists of values by dotted path, all combinations of which are run; or a list of
    dictionaries, each with the options of one point. All points are checked before anything is
    written. Raises CaseError for options that cannot be, and where the folder holds another sweep;
    FileError where it cannot be written.

        done = percolith.sweep(case, {"material.rock.permeability": [1e-15, 1e-14]}, "study")
        done.run()
        done.table().to_pandas()
    """
    points = _points(options)
    if not points:
        raise CaseError("error: a sweep without points; allowed: one value or more for each option")
    for point in points:
        other = case.copy()
        for key, value in point.items():
            other[key] = value
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", CaseWarning)
            other.validate()
    plan = {"case": case.to_toml(), "directory": str(case.file.absolute().parent),
            "points": points}
    _write_plan(Path(folder), plan)
    return Sweep(folder)


def _write_plan(folder: Path, plan: dict[str, Any]) -> None:
    file = folder / _PLAN
    if file.is_file():
        if Sweep(folder)._plan != json.loads(json.dumps(plan)):
            raise CaseError(f"{folder}: error: the folder holds another sweep; allowed: a new "
                            "folder, or the same case and options to go on with it")
        return
    try:
        folder.mkdir(parents=True, exist_ok=True)
        part = folder / f"{_PLAN}.part"
        part.write_text(json.dumps(plan, indent=2), encoding="utf-8")
        part.replace(file)
    except OSError as error:
        raise FileError(f"{folder}: cannot write the sweep: {error}") from error


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m percolith.sweeps",
                                     description="Runs what is left of a sweep.")
    parser.add_argument("folder", metavar="FOLDER", help="the folder of the sweep")
    parser.add_argument("--point", type=int, metavar="N", help="run this point alone")
    parser.add_argument("--list", action="store_true", help="tell how far each point is")
    parser.add_argument("--processes", type=int, metavar="N", help="runs at once")
    parser.add_argument("--threads", type=int, default=None, metavar="N", help="of each run")
    parser.add_argument("--errors", choices=("text", "json"), default="text",
                        help="how the error of a point is told: as text, or to the standard output "
                        "as JSON")
    return parser


def main(words: list[str] | None = None) -> int:
    """Runs the command; returns 0, or 2 where a point or an argument was wrong."""
    arguments = _parser().parse_args(words)
    try:
        chosen = Sweep(arguments.folder)
        if arguments.list:
            for point in chosen.points:
                print(point.number, point.state, json.dumps(point.options))
            return 0
        if arguments.point is not None:
            chosen.run_point(arguments.point, threads=arguments.threads)
            return 0
        failed = chosen.run(processes=arguments.processes, threads=arguments.threads or 1)
    except Error as error:
        if arguments.errors == "json":
            print(json.dumps({"error": type(error).__name__, "message": str(error)}))
        else:
            print(error, file=sys.stderr)
        return 2
    for number, error in failed.items():
        print(f"point {number}: {error}", file=sys.stderr)
    return 2 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
