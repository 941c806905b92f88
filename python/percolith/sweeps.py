# SPDX-License-Identifier: BSD-3-Clause
"""Many runs of one case with other options, side by side in processes or over the jobs of a cluster.

A sweep is a folder: `sweep.json` with its points, and a folder of results for each. What has
finished is not run again, what was interrupted goes on from its checkpoint. From a shell, for
instance of a job array:

    python -m percolith.sweeps FOLDER             runs all that is left, in processes
    python -m percolith.sweeps FOLDER --point 3   runs one point
    python -m percolith.sweeps FOLDER --list      tells how far each is

Ctrl-C and SIGTERM, which a batch system sends before the time runs out, end it after the present
steps: results and checkpoints are kept, and the same command goes on with them.
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
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import nullcontext, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from percolith import errors
from percolith.arguments import whole_number
from percolith.case import Case, Options
from percolith.errors import CaseError, CaseWarning, Error, FileError
from percolith.run_directory import RunDirectory, Table
from percolith.short_text import counted
from percolith.simulation import resume, start_run
from percolith.sweep_process import (
    Terminated,
    as_plain,
    end_with,
    error_from,
    heeding_sigterm,
    run_elsewhere,
    warnings_to,
)
from percolith.sweep_progress import SweepProgress, Tally, display
from percolith.sweep_table import table_of
from percolith.toml_text import plain

_PLAN = "sweep.json"
_FEW = 1000  # points, whose states are soon read
_OF_THE_MESH = ("file", "element_size", "groups", "regions", "point", "points")
"""Names of options that only the mesh can tell to be wrong."""


@dataclass(frozen=True)
class Point:
    """A run of a sweep: its number, the options that are its own, its folder of results."""

    number: int
    options: dict[str, Any]
    folder: Path

    @property
    def state(self) -> str:
        """finished, failed, at its start or later, interrupted, or waiting: not begun, killed or
        at work."""
        return self.outcome or ("failed" if self.failure else "waiting")

    @property
    def outcome(self) -> str:
        """What its results say of how it ended; "" where there are none yet."""
        return str(self._summary.get("outcome", ""))

    @property
    def failure(self) -> Error | None:
        """Why it failed; None where it did not."""
        if (told := _read(self._failure_file)):
            return error_from(told)
        summary = self._summary
        if summary.get("outcome") != "failed":
            return None
        return errors.SolverError(f"point {self.number}: {summary.get('reason', '')}")

    @property
    def _summary(self) -> dict[str, Any]:
        return _read(self.folder / "summary.json")

    @property
    def _failure_file(self) -> Path:
        # Beside the folder of results, which may not be there, or not be ours.
        return self.folder.parent / f"{self.folder.name}.failure.json"

    def _note_failure(self, error: Error) -> None:
        with suppress(OSError):  # What the point itself raises is of more use.
            self._failure_file.write_text(json.dumps(as_plain(error)), encoding="utf-8")

    def _forget_failure(self) -> None:
        with suppress(OSError):  # Where it cannot be removed, nothing can be run either.
            self._failure_file.unlink(missing_ok=True)

    def results(self) -> RunDirectory:
        """Opens the results. Raises RunDirectoryError where there are none."""
        return RunDirectory(self.folder)


class Sweep:
    """A sweep in its folder. Raises CaseError where the folder holds none."""

    def __init__(self, folder: str | os.PathLike):
        self.folder = Path(folder)
        self._warned: set[str] = set()
        try:
            plan = json.loads((self.folder / _PLAN).read_text(encoding="utf-8"))
            self._plan = {name: plan[name] for name in ("case", "directory", "points")}
        except (OSError, ValueError) as error:
            raise CaseError(f"{folder}: error: no sweep here: {error}") from error
        except (KeyError, TypeError) as error:
            raise CaseError(f"{folder}: error: no sweep here: {_PLAN} is not a plan") from error

    def __repr__(self) -> str:
        count = len(self._plan["points"])
        told = [counted(count, "point")]
        if count <= _FEW:
            states = Counter(point.state for point in self.points)
            told += [f"{number} {state}" for state, number in sorted(states.items())]
        return f"Sweep({self.folder}: {', '.join(told)})"

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
        SolverError and FileError, whose messages name the point, and which `failure` of the point
        keeps; a run that failed is begun again."""
        case = self.case(number)
        point = self.points[number]
        if point.outcome == "finished":
            return point.results()
        point._forget_failure()  # An attempt that is killed tells nothing, and did not fail so.
        try:
            if point.outcome != "failed" and (point.folder / "checkpoint.bin").is_file():
                return resume(point.folder, threads=threads)
            return case.run(point.folder, force=True, threads=threads)
        except Error as error:
            named = _named(error, number)
            if not _is_at_work(error):
                point._note_failure(named)
            raise named from error

    def run(self, *, processes: int | None = None, threads: int = 1,
            progress: bool | Callable[[SweepProgress], object] | None = None) -> dict[int, Error]:
        """Runs all that is left, in so many processes of so many threads each; as many processes as
        there are processors for when None. Returns the errors of the points that failed, by their
        numbers; the others are run all the same. What a point warns of is a CaseWarning when it has
        ended, once for all that warn of the same. After Ctrl-C nothing new is begun, and the next
        call goes on.

        progress: None shows how far it is in one line that is renewed as runs end, on a terminal
        and in a notebook; True prints a line a run that ended, False nothing. A function is called
        with a SweepProgress at the beginning and as runs end; what it raises ends the sweep as
        Ctrl-C does."""
        try:
            return self._run_left(processes, threads, progress)
        except KeyboardInterrupt:
            print(f"{self.folder}: ended by Ctrl-C; results and checkpoints are kept, and the same "
                  "lines go on with them", file=sys.stderr)
            raise

    def _run_left(self, processes: int | None, threads: int,
                  progress: bool | Callable[[SweepProgress], object] | None) -> dict[int, Error]:
        threads = whole_number("threads", threads, "number of threads")
        if processes is None:
            processes = max(1, len(os.sched_getaffinity(0)) // threads)
        processes = whole_number("processes", processes, "number of processes")
        shown, points = display(progress), self.points
        left = [point.number for point in points if point.state != "finished"]
        tally = Tally(len(points), len(points) - len(left), len(left), processes)
        working: set[subprocess.Popen] = set()

        def work(number: int) -> tuple[int, Error | None, list[str]]:
            tally.begin(number)
            return number, *run_elsewhere(self.folder, number, threads, working)

        with ThreadPoolExecutor(processes) as pool:
            jobs = [pool.submit(work, number) for number in left]
            try:
                shown.tell(tally.progress)
                for job in as_completed(jobs):
                    number, error, texts = job.result()
                    tally.end(number, error is not None)
                    for text in _new(texts, self._warned):
                        shown.clear()
                        warnings.warn(text, CaseWarning, stacklevel=3)
                    how = "finished" if error is None else "failed"
                    shown.tell(tally.progress, f"point {number} {how}")
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                for process in list(working):
                    process.send_signal(signal.SIGINT)
                raise
            finally:
                shown.close()
        return {number: error for number, error, _ in (job.result() for job in jobs)
                if error is not None}

    def table(self) -> Table:
        """A row a point: `point`, `state`, its options, and the numbers of its summary, those of
        mechanics and of the mass balance among them, and the rate of each condition at the end as
        `boundary.left_m2_per_s`, called as in the history; NaN where there is none. Options whose
        values are numbers, or texts with a unit, are in SI, with the unit at the end of the name:
        `source.pump.rate_m2_per_s`; those with other values among them are texts by their path. Of
        flow it has the extremes at the end, as `maximum_crack_pressure_Pa`. The highest pressure
        of a source in cracks is in `peak_pressures.source.pump.pressure_Pa`, reached at
        `peak_pressures.source.pump.time_s`."""
        return table_of(self.points)


def _new(texts: list[str], known: set[str]) -> list[str]:
    """Those warnings that say what none before has said, wherever in a case they say it of: the
    plan has other lines than the case file. `known` holds what has been said."""
    new = []
    for text in texts:
        said = text.partition("warning: ")[2] or text
        if said not in known:
            known.add(said)
            new.append(text)
    return new


def _read(file: Path) -> dict[str, Any]:
    """What a JSON file holds; empty where there is none that can be read."""
    try:
        told = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return told if isinstance(told, dict) else {}


def _named(error: Error, number: int) -> Error:
    """The same error with the point before each line of its message."""
    lines = "\n".join(f"point {number}: {line}" for line in str(error).splitlines())
    return type(error)(lines, error.problems) if isinstance(error, CaseError) else type(error)(lines)


def _is_at_work(error: Error) -> bool:
    """Whether a point could not be run because another process does."""
    return any("another run" in problem.reason for problem in getattr(error, "problems", ()))


def _points(options: Mapping[str, Sequence[Any]] | Sequence[Mapping[str, Any]]) -> list[dict]:
    if not isinstance(options, Mapping):
        return [plain(dict(point)) for point in options]
    lists = {}
    for key, values in options.items():
        if isinstance(values, (str, Mapping)) or not hasattr(values, "__iter__"):
            raise CaseError(f"error: {key} = {values!r}: no list of values to run through")
        lists[key] = [plain(value, key) for value in values]
    return [dict(zip(lists, values)) for values in itertools.product(*lists.values())]


def sweep(case: Case, options: Mapping[str, Sequence[Any]] | Sequence[Mapping[str, Any]],
          folder: str | os.PathLike) -> Sweep:
    """Plans a sweep of a case in a folder, or opens the same one that was planned there before.

    options: lists of values by dotted path, all combinations of which are run; or a list of
    dictionaries, each with the options of one point. All points are checked before anything is
    written: options, and for each different mesh, with the groups, regions and places that a point
    asks of it, the model as a whole. Raises CaseError for options that cannot be, with the number
    of the point, and where the folder holds another sweep; FileError where a mesh cannot be read or
    the sweep be written. What points warn of is a CaseWarning, once for all that warn of the same.

        done = percolith.sweep(case, {"material.rock.permeability": [1e-15, 1e-14]}, "study")
        done.run()
        done.table().to_pandas()
    """
    points = _points(options)
    if not points:
        raise CaseError("error: a sweep without points; allowed: one value or more for each option")
    seen: set[str] = set()
    texts: list[str] = []
    warned: set[str] = set()
    for number, point in enumerate(points):
        other = case.copy()
        try:
            for key, value in point.items():
                other[key] = value
            with warnings_to(texts.append):
                _check(other, seen)
        except Error as error:
            raise _named(error, number) from error
    for text in _new(texts, warned):
        warnings.warn(text, CaseWarning, stacklevel=2)
    plan = {"case": case.to_toml(), "directory": str(case.file.absolute().parent),
            "points": points}
    _write_plan(Path(folder), plan)
    planned = Sweep(folder)
    planned._warned = warned
    return planned


def _check(case: Case, seen: set[str]) -> None:
    """Checks the options, and builds the model once for all that is alike in what needs the mesh;
    `seen` holds what has been built."""
    case.validate()
    asked = json.dumps(sorted(_of_the_mesh(case, "")))
    if asked not in seen:
        start_run(case.source)
        seen.add(asked)


def _of_the_mesh(options: Options, path: str) -> Iterator[tuple[str, str]]:
    for name, value in options.items():
        if isinstance(value, Options):
            yield from _of_the_mesh(value, f"{path}.{name}")
        elif name in _OF_THE_MESH:
            yield f"{path}.{name}", repr(value)


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
    parser.add_argument("--progress", action="store_true", default=None,
                        help="print a line for each run that ends; without, a terminal shows one "
                        "line that is renewed")
    parser.add_argument("--errors", choices=("text", "json"), default="text",
                        help="how the error and the warnings of a point are told: as text, or to "
                        "the standard output as lines of JSON")
    parser.add_argument("--parent", type=int, metavar="PID", help=argparse.SUPPRESS)
    return parser


def main(words: list[str] | None = None) -> int:
    """Runs the command; returns 0, 2 where a point or an argument was wrong, and 128 and the number
    of the signal where one ended it."""
    arguments = _parser().parse_args(words)
    try:
        with heeding_sigterm():
            if arguments.parent is not None:
                end_with(arguments.parent)
            return _run(arguments)
    except KeyboardInterrupt as interrupt:
        ending = signal.SIGTERM if isinstance(interrupt, Terminated) else signal.SIGINT
    _tell(Error(f"{arguments.folder}: ended by {ending.name}; results and checkpoints are kept, and "
                "the same command goes on with them"), arguments)
    return 128 + ending


def _tell(error: Error, arguments: argparse.Namespace) -> None:
    if arguments.errors == "json":
        print(json.dumps(as_plain(error)))
    else:
        print(error, file=sys.stderr)


def _tell_warning(text: str) -> None:
    print(json.dumps({"warning": text}), flush=True)


def _run(arguments: argparse.Namespace) -> int:
    try:
        chosen = Sweep(arguments.folder)
        if arguments.list:
            for point in chosen.points:
                print(point.number, point.state, json.dumps(point.options))
            return 0
        if arguments.point is not None:
            heeded = warnings_to(_tell_warning) if arguments.errors == "json" else nullcontext()
            with heeded:
                chosen.run_point(arguments.point, threads=arguments.threads)
            return 0
        threads = 1 if arguments.threads is None else arguments.threads
        # Not `run`: main tells of an end by a signal.
        failed = chosen._run_left(arguments.processes, threads, arguments.progress)
    except Error as error:
        _tell(error, arguments)
        return 2
    for error in failed.values():
        print(error, file=sys.stderr)
    return 2 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
