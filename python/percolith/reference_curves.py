# SPDX-License-Identifier: BSD-3-Clause
"""Reads curves that probes are compared with: measurements, formulas, results of other programs."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from percolith.located_table import LocatedTable
from percolith.run_directory import RunDirectory, Table

_PLACES = ("x_m", "y_m")
_NO_QUANTITY = ("probe", "time_s", "distance_m", *_PLACES)
_OFF_THE_LINE = 1e-3  # of the length of a probe's line
_SAME_TIME = 1e-2  # of a time


@dataclass(frozen=True)
class ReferenceCurve:
    """Values (SI) of one quantity to draw over one panel."""

    number: int  # of the file
    name: str  # of the file
    probe: str
    column: str  # of the probe's table
    time: float | None  # of the profile (s) it is compared with; None over a series in time
    x: np.ndarray  # m along the line of the probe, or s
    values: np.ndarray


def _probe_of_file(file: LocatedTable, run: RunDirectory) -> str:
    """The probe of a file that names none: the only one, or the one the file is called after."""
    if len(run.probe_names) == 1:
        return run.probe_names[0]
    if Path(file.path).stem in run.probe_names:
        return Path(file.path).stem
    file.refuse(file.first, "no column probe, which this run needs to tell its probes apart",
                f"a column probe with {', '.join(run.probe_names)}, or a file called after one "
                f"of them, as {run.probe_names[0]}.csv")
    return ""


def _quantities(file: LocatedTable, tables: dict[str, Table]) -> list[str]:
    """The columns that hold quantities."""
    known = sorted({name for table in tables.values() for name in table} - set(_NO_QUANTITY))
    quantities = [name for name in file.names if name not in _NO_QUANTITY]
    for name in quantities:
        if name not in known:
            file.refuse(file.first, f'unknown column "{name}"',
                        f"{', '.join(_NO_QUANTITY)} and {', '.join(known)}", name)
    for name in dict.fromkeys(name for name in file.names if file.names.count(name) > 1):
        file.refuse(file.first, f'two columns "{name}"', key=name)
    if not quantities:
        file.refuse(file.first, "no column with a quantity of a probe", ", ".join(known))
    return quantities


@dataclass(frozen=True)
class _Line:
    """The line of a probe, from its first place to its last; of a point without length."""

    start: np.ndarray
    along: np.ndarray
    length: float
    times: np.ndarray

    @classmethod
    def of(cls, table: Table) -> _Line:
        rows = table.at_time()
        places = np.stack([rows["x_m"], rows["y_m"]], axis=1)
        way = places[-1] - places[0]
        length = float(np.hypot(*way))
        return cls(places[0], way / length if length else way, length, np.unique(table["time_s"]))


def _distance(file: LocatedTable, line: int, cells: dict[str, str], probe: _Line) -> float:
    """Where on the line of its probe a row stands (m)."""
    if "distance_m" in cells:
        return file.number(line, "distance_m", cells["distance_m"])
    place = np.array([file.number(line, name, cells[name]) for name in _PLACES]) - probe.start
    off = abs(place[0] * probe.along[1] - place[1] * probe.along[0])
    if off > _OFF_THE_LINE * probe.length:
        end = probe.start + probe.length * probe.along
        file.refuse(line, f"the place is {off:.3g} m off the line of the probe",
                    f"places from ({probe.start[0]:g}, {probe.start[1]:g}) to "
                    f"({end[0]:g}, {end[1]:g})")
    return float(place @ probe.along)


def _profile_time(file: LocatedTable, line: int, cells: dict[str, str], probe: _Line) -> float:
    """The time of the profile that a row is compared with: the last one where it tells none."""
    if not cells.get("time_s", "").strip():
        return float(probe.times[-1])
    time = file.number(line, "time_s", cells["time_s"])
    nearest = float(probe.times[np.argmin(abs(probe.times - time))])
    if abs(nearest - time) > _SAME_TIME * abs(nearest):
        some = ", ".join(f"{one:g}" for one in probe.times[:20])
        file.refuse(line, f"time_s = {time:g}: the probe has no profile then",
                    some + ", ..." * (len(probe.times) > 20), "time_s", cells["time_s"])
    return nearest


def _needed(file: LocatedTable, name: str, line: _Line) -> None:
    """Refuses a file without the columns that a probe needs."""
    if not line.length and "time_s" not in file.names:
        file.refuse(file.first, f"no column time_s, which the probe {name} in one point needs")
    if line.length and "distance_m" not in file.names and not set(_PLACES) <= set(file.names):
        file.refuse(file.first, f"no place, which the probe {name} along a line needs",
                    "a column distance_m, or x_m and y_m")


def _rows_by_probe(file: LocatedTable, run: RunDirectory) -> list[tuple[int, str, dict[str, str]]]:
    """Line, probe and cells by their names of each row."""
    default = "" if "probe" in file.names else _probe_of_file(file, run)
    rows = []
    for line, cells in file.rows:
        row = dict(zip(file.names, cells))
        probe = row.get("probe", default).strip()
        if len(cells) != len(file.names):
            file.refuse(line, f"{len(cells)} fields in a row",
                        f"{len(file.names)}, as in the line of names")
        elif "probe" in row and probe not in run.probe_names:
            file.refuse(line, f'no probe "{probe}"', ", ".join(run.probe_names), "probe", probe)
        else:
            rows.append((line, probe, row))
    if not file.rows:
        file.refuse(file.first, "no rows below the names")
    file.raise_problems()
    return rows


def _value(file: LocatedTable, line: int, name: str, cell: str, probe: str, table: Table) -> float:
    """A value, NaN where there is none."""
    if name not in table and cell.strip():
        file.refuse(line, f"the probe {probe} has no {name}", "an empty cell", name, cell)
    return file.number(line, name, cell, may_be_empty=True)


def read_reference(path: str | os.PathLike, run: RunDirectory,
                   number: int = 0) -> list[ReferenceCurve]:
    """The curves of a CSV file with a line of names: quantities called as in the tables of the
    probes, in SI units; `time_s`; `distance_m` along the line of a probe, or `x_m` and `y_m`;
    `probe` where the run has several and the file is not called after one of them. Lines that begin
    with # are comments, cells may be empty. Without `time_s` values along a line belong to the last time.
    `number` tells files apart. Raises CaseError with FILE:LINE of all mistakes."""
    file = LocatedTable(path)
    if not run.probe_names:
        file.refuse(0, f"nothing to compare with: the run {run.path} has no probes")
        file.raise_problems()
    rows = _rows_by_probe(file, run)
    tables = {probe: run.probe(probe) for _, probe, _ in rows}
    quantities = _quantities(file, tables)
    lines = {probe: _Line.of(table) for probe, table in tables.items()}
    for name, along in lines.items():
        _needed(file, name, along)
    file.raise_problems()
    points: dict[tuple[str, str, float | None], list[tuple[float, float]]] = {}
    for line, probe, row in rows:
        along = lines[probe]
        time = _profile_time(file, line, row, along) if along.length else None
        x = (_distance(file, line, row, along) if along.length
             else file.number(line, "time_s", row["time_s"]))
        for name in quantities:
            value = _value(file, line, name, row[name], probe, tables[probe])
            points.setdefault((probe, name, time), []).append((x, value))
    file.raise_problems()
    return _curves(number, Path(path).stem, points)


def _curves(number: int, name: str, points: dict) -> list[ReferenceCurve]:
    """Curves of the points that have a value."""
    curves = []
    for (probe, column, time), pairs in points.items():
        x, values = np.array(pairs).T
        known = np.isfinite(values)
        if known.any():
            curves.append(ReferenceCurve(number, name, probe, column, time, x[known],
                                         values[known]))
    return curves


def read_references(paths: str | os.PathLike | Sequence[str | os.PathLike],
                    run: RunDirectory) -> list[ReferenceCurve]:
    """The curves of one file or of several."""
    paths = [paths] if isinstance(paths, str | os.PathLike) else list(paths)
    return [curve for number, path in enumerate(paths)
            for curve in read_reference(path, run, number)]
