# SPDX-License-Identifier: BSD-3-Clause
"""Opens a run directory: what `percolith run` writes."""

from __future__ import annotations

import csv
import io
import json
import math
import os
import tomllib
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from percolith.errors import Error, FileError, unknown_name
from percolith.run_pictures import RunPictures
from percolith.short_text import counted, listed, table_text
from percolith.times import ALLOWED, seconds
from percolith.vtu import Grid, VtuError, read_vtu

if TYPE_CHECKING:
    import pandas

EVENT_WORDS = ("mode", "material")
"""Columns of the events that hold text."""

_Content = TypeVar("_Content")
# What parsers raise where the content of a file is not what they expect.
_DAMAGE = (ValueError, TypeError, KeyError, csv.Error, ElementTree.ParseError, RecursionError)


class RunDirectoryError(Error, ValueError):
    """The directory holds no results, or not those asked for."""


class ArgumentError(RunDirectoryError):
    """An argument that means nothing, or not for this run. The message begins with its name, which
    is that of the option of the command line without its dashes."""


@contextmanager
def _reading(path: str | os.PathLike) -> Iterator[None]:
    """Turns what goes wrong while a file of results is read into errors that name it and tell what
    to do: FileError where it cannot be read, RunDirectoryError where it is damaged."""
    try:
        yield
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror or error}") from error
    except RunDirectoryError:
        raise
    except _DAMAGE as error:
        why = "not a text in UTF-8" if isinstance(error, UnicodeDecodeError) else error
        raise RunDirectoryError(f"{path}: damaged: {why}; copy the results anew from where they "
                                "were made, or run the case again") from error


def read_file(path: str | os.PathLike, parse: Callable[[str], _Content]) -> _Content:
    """What `parse` makes of the text of a file of results. Raises FileError where the file cannot
    be read, and RunDirectoryError naming it and what to do where `parse` finds it damaged."""
    with _reading(path):
        return parse(Path(path).read_bytes().decode("utf-8"))


def carries_fluid(cracks: Grid) -> np.ndarray:
    """True (n,) for each crack segment that fluid can be in: all where the rock is at rest. A joint
    past its peak that is not broken may hold none; the values at its ends mean nothing then."""
    wet = cracks.cell_data.get("wet")
    return np.ones(len(cracks.cells), bool) if wet is None else wet != 0


@dataclass
class Frame:
    """The fields at one time (s): the matrix as triangles, the cracks as line segments."""

    time: float
    matrix: Grid
    cracks: Grid | None

    def __repr__(self) -> str:
        cracks = "no cracks" if self.cracks is None else f"cracks of {self.cracks.size_text}"
        return f"Frame(time={self.time:g} s, matrix of {self.matrix.size_text}, {cracks})"

    def crack_table(self) -> Table:
        """The segments of the cracks, a row each: x0_m, y0_m, x1_m, y1_m of their ends and all that
        is known of them. What is known at the ends, as pressure_Pa and saturation, is the mean of
        both, and NaN where the segment holds no fluid. Without rows where there is no crack."""
        if self.cracks is None:
            return Table({name: np.empty(0) for name in ("x0_m", "y0_m", "x1_m", "y1_m")})
        ends = self.cracks.points[self.cracks.cells]
        places = {f"{axis}{end}_m": ends[:, end, i] for end in (0, 1)
                  for i, axis in enumerate("xy")}
        wet = carries_fluid(self.cracks)
        means = {name: np.where(wet, values[self.cracks.cells].mean(axis=1), np.nan)
                 for name, values in self.cracks.point_data.items() if values.ndim == 1}
        return Table({**places, **means, **self.cracks.cell_data})


@dataclass
class Table:
    """Columns of a CSV file by their names, in the order of the file. A name that is not there
    raises UnknownNameError, a KeyError that tells those that are. `print` shows the first and last
    rows."""

    columns: dict[str, np.ndarray]

    def __repr__(self) -> str:
        return f"Table({counted(len(self), 'row')}; columns: {listed(self.columns)})"

    def __str__(self) -> str:
        return table_text(self.columns)

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.columns:
            raise unknown_name("column", name, self.columns)
        return self.columns[name]

    def __contains__(self, name: str) -> bool:
        return name in self.columns

    def __len__(self) -> int:
        return len(next(iter(self.columns.values()), ()))

    def where(self, mask: np.ndarray) -> Table:
        """The rows that `mask` chooses."""
        return Table({name: values[mask] for name, values in self.columns.items()})

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a frame of pandas. Raises ImportError where that is not installed."""
        try:
            import pandas
        except ImportError as error:
            raise ImportError("tables become those of the package pandas: pip install pandas"
                              ) from error
        return pandas.DataFrame(self.columns)

    def at_time(self, time: float | None = None) -> Table:
        """The rows at the time (s) nearest to `time`; the last time when None. Raises
        RunDirectoryError when there is no row."""
        times = np.unique(self["time_s"])
        if not len(times):
            raise RunDirectoryError("the table has no rows; did the run end? see run.log")
        chosen = times[-1] if time is None else times[np.argmin(abs(times - time))]
        return self.where(self["time_s"] == chosen)


def column_names(path: str | os.PathLike) -> list[str]:
    """The names in the first line of a CSV file that is no comment; none in an empty file."""
    with _reading(path), open(path, encoding="utf-8", newline="") as file:
        return next(_rows(file), [])


def read_table(path: str | os.PathLike, words: tuple[str, ...] = ()) -> Table:
    """Reads a CSV file with a line of names; lines that start with `#` are comments. Columns named
    in `words` hold text, all others numbers, where a field that is empty becomes NaN. Raises
    RunDirectoryError naming the file where a field is no number, and FileError where it cannot be
    read."""
    return read_file(path, lambda text: parse_table(io.StringIO(text, newline=""), str(path),
                                                    words))


def _rows(lines: Iterable[str]) -> Iterator[list[str]]:
    return csv.reader(line for line in lines if not line.startswith("#"))


def parse_table(lines: Iterable[str], name: str, words: tuple[str, ...] = ()) -> Table:
    """The same from the lines of a file; `name` is for messages."""
    rows = list(_rows(lines))
    if not rows:
        raise RunDirectoryError(f"{name}: empty table")
    names, rows = rows[0], rows[1:]
    if any(len(row) != len(names) for row in rows):
        raise RunDirectoryError(f"{name}: not a table of numbers: rows of different lengths")
    try:
        return Table({name: np.array([row[i] for row in rows], dtype=str) if name in words
                      else np.array([float(row[i] or "nan") for row in rows], dtype=float)
                      for i, name in enumerate(names)})
    except ValueError as error:
        raise RunDirectoryError(f"{name}: not a table of numbers: {error}") from error


class RunDirectory(RunPictures):
    """The results of one run, as `percolith.open_run` opens them. Files are read when first asked
    for; arrays and columns carry their SI units in their names.

    Raises RunDirectoryError when `path` is no directory or holds no results.
    """

    def __init__(self, path: str | os.PathLike):
        self.path = Path(path)
        if not self.path.is_dir():
            raise RunDirectoryError(f"{path}: no such directory")
        if not (self.path / "resolved.toml").is_file():
            raise RunDirectoryError(
                f"{path}: not a run directory (no resolved.toml); "
                "make one with `percolith run CASE.toml --output DIR`"
            )

    def __repr__(self) -> str:
        # Reads anew, and keeps nothing: to look at a run that goes on must not freeze its frames.
        try:
            return (f"RunDirectory({str(self.path)!r}, outcome={self._present_outcome()}, "
                    f"frames={len(_series(self.path / 'matrix.pvd'))})")
        except Error:
            return f"RunDirectory({str(self.path)!r}, damaged)"

    def _present_outcome(self) -> str:
        if not self.has_summary:
            return "none yet"
        return read_file(self.path / "summary.json", _summary).get("outcome", "finished")

    @cached_property
    def resolved(self) -> dict:
        """The complete input with defaults, as nested dictionaries."""
        return read_file(self.path / "resolved.toml", tomllib.loads)

    @property
    def resolved_text(self) -> str:
        """The same as it was written, with units and derived values in comments."""
        return read_file(self.path / "resolved.toml", str)

    @cached_property
    def summary(self) -> dict:
        """What summary.json says: end time, steps, wall time; of flow its mass balance and
        extremes, of mechanics its results."""
        return read_file(self._file("summary.json"), _summary)

    @property
    def has_summary(self) -> bool:
        """False while a run goes on, and after one that was killed."""
        return (self.path / "summary.json").is_file()

    @cached_property
    def history(self) -> Table:
        """history.csv: one row a reported time."""
        return read_table(self._file("history.csv"))

    @cached_property
    def events(self) -> Table:
        """events.csv: one row a broken joint, in the order of time; `mode` and `material` are text.
        Raises RunDirectoryError in a run of flow."""
        if not self.has_mechanics:
            raise RunDirectoryError(f"{self.path}: a run of flow has no events")
        return read_table(self._file("events.csv"), words=EVENT_WORDS)

    @cached_property
    def fragments(self) -> Table:
        """fragments.csv: one row a fragment and output time. Raises RunDirectoryError in a run of
        flow."""
        if not self.has_mechanics:
            raise RunDirectoryError(f"{self.path}: a run of flow has no fragments")
        return read_table(self._file("fragments.csv"))

    @cached_property
    def quantities(self) -> frozenset[str]:
        """Names of what there is: the arrays of the first frame of the rock whose file is sound and
        the columns of the history."""
        names: set[str] = set()
        if self.times:
            matrix = self.sound_matrix(self.times)
            names |= matrix.point_data.keys() | matrix.cell_data.keys()
        if (self.path / "history.csv").is_file():
            names |= set(column_names(self.path / "history.csv"))
        return frozenset(names)

    def sound_matrix(self, times: Iterable[float]) -> Grid:
        """The rock at the first of some times (s) of frames whose file is sound. Raises as
        `read_vtu` where none is."""
        problem: Exception | None = None
        for time in times:
            try:
                return read_vtu(self._matrix_files[time])
            except (VtuError, FileError) as error:
                problem = problem or error
        raise problem or RunDirectoryError(f"{self.path}: no frames")

    @property
    def has_flow(self) -> bool:
        """Whether fluid flows through the rock. Tells what there is, whatever the physics is
        called; of a run that has left nothing yet, what its case asks for."""
        if self.quantities:
            return not self.quantities.isdisjoint(("pressure_Pa", "stored_m2"))
        return self._physics != "mechanics"

    @property
    def has_mechanics(self) -> bool:
        """Whether the rock deforms; see `has_flow`."""
        if self.quantities:
            return not self.quantities.isdisjoint(("displacement_m", "kinetic_J_per_m"))
        return self._physics != "seepage"

    @property
    def _physics(self) -> str:
        return self.resolved.get("model", {}).get("physics", "seepage")

    @property
    def title(self) -> str:
        """The title of the case, or the name of the folder."""
        return self.resolved.get("title", "") or self.path.name

    @property
    def is_steady(self) -> bool:
        """Whether the run found a steady flow and nothing else."""
        return not self.has_mechanics and self.resolved.get("time", {}).get("scheme") == "steady"

    @property
    def probe_names(self) -> list[str]:
        """Names of the probes, in alphabetical order."""
        return sorted(file.stem for file in (self.path / "probes").glob("*.csv"))

    def probe(self, name: str) -> Table:
        """All rows of one probe: time_s, x_m, y_m and its quantities."""
        if name not in self.probe_names:
            known = ", ".join(self.probe_names) or "none"
            raise RunDirectoryError(f"{self.path}: no probe {name}; there are: {known}")
        return read_table(self.path / "probes" / f"{name}.csv")

    @cached_property
    def times(self) -> list[float]:
        """Times (s) of the frames, ascending."""
        return sorted(self._matrix_files)

    def frame(self, time: float | str | None = None) -> Frame:
        """The frame nearest to `time` (s, or a text such as "10 ms"); the last one when None. Raises
        RunDirectoryError for what is no time, and where there are no frames."""
        try:
            wanted = None if time is None else seconds(time)
        except ValueError as error:
            raise ArgumentError(f"time = {time!r}: {error}; allowed: {ALLOWED}") from None
        if not self.times:
            raise RunDirectoryError(f"{self.path}: no frames; "
                                    + self._failure_or(self._reason_for_no_frames()))
        chosen = (self.times[-1] if wanted is None
                  else min(self.times, key=lambda time: abs(time - wanted)))
        cracks = self._crack_files.get(chosen)
        matrix = read_vtu(self._matrix_files[chosen])
        return Frame(chosen, matrix, read_vtu(cracks) if cracks else None)

    @property
    def last_cracks(self) -> Grid | None:
        """The cracks of the last frame that has some; None where there never are any."""
        files = self._crack_files
        return read_vtu(files[max(files)]) if files else None

    def frames(self) -> Iterator[Frame]:
        """All frames in the order of time, each read when its turn comes."""
        return (self.frame(time) for time in self.times)

    def _file(self, name: str) -> Path:
        path = self.path / name
        if not path.is_file():
            raise RunDirectoryError(f"{path}: missing; "
                                    + self._failure_or("did the run end? see run.log"))
        return path

    @property
    def lost_frames(self) -> bool:
        """Whether the run came to its end with frames, and matrix.pvd, which lists them, is gone."""
        wanted = self.resolved.get("output", {}).get("fields") is True
        ended = self.has_summary and self.summary.get("outcome") == "finished"
        return wanted and ended and not (self.path / "matrix.pvd").is_file()

    def _reason_for_no_frames(self) -> str:
        if self.resolved.get("output", {}).get("fields") is False:
            return "the case sets output.fields = false"
        if self.lost_frames:
            return ("matrix.pvd, which lists them, is missing; copy the results anew from where they "
                    "were made, or run the case again")
        return "did the run end? see run.log"

    def _failure_or(self, other: str) -> str:
        """That the run failed, and of what; or `other` where it did not."""
        told = self.summary if self.has_summary else {}
        failed = told.get("outcome") == "failed"
        return f"the run failed: {told.get('reason', '')}" if failed else other

    @cached_property
    def _matrix_files(self) -> dict[float, Path]:
        return _series(self.path / "matrix.pvd")

    @cached_property
    def _crack_files(self) -> dict[float, Path]:
        return _series(self.path / "cracks.pvd")


def _summary(text: str) -> dict:
    summary = json.loads(text)
    if not isinstance(summary, dict):
        raise ValueError("not a JSON object")
    return summary


def _series(path: Path) -> dict[float, Path]:
    """The files of a ParaView collection by their time (s); empty where there is none."""
    return read_file(path, partial(_entries, path.parent)) if path.is_file() else {}


def _entries(folder: Path, text: str) -> dict[float, Path]:
    files = {}
    for entry in ElementTree.fromstring(text).iter("DataSet"):
        time, name = entry.get("timestep", ""), entry.get("file")
        if name is None or not math.isfinite(float(time)):
            raise ValueError(f'timestep = "{time}", file = "{name}" is no frame')
        files[float(time)] = folder / name
    return files


def open_run(path: str | os.PathLike) -> RunDirectory:
    """Opens the results of a run. Raises RunDirectoryError where there are none."""
    return RunDirectory(path)
