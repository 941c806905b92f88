# SPDX-License-Identifier: BSD-3-Clause
"""The points of a sweep as a table: their options and what came of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from percolith.errors import CaseError
from percolith.options import describe
from percolith.run_directory import Table
from percolith.simulation import quantity

if TYPE_CHECKING:
    from percolith.sweeps import Point


def table_of(points: Sequence[Point]) -> Table:
    """A row a point: number, state, options, and the numbers of its summary. An option whose values
    are all numbers, or texts with a unit, is in SI, and its unit ends the name of its column; NaN
    stands where a point has none."""
    columns: dict[str, np.ndarray] = {
        "point": np.array([point.number for point in points]),
        "state": _column([point.state for point in points])}
    for path in dict.fromkeys(path for point in points for path in point.options):
        name, values = _option(path, [point.options.get(path) for point in points])
        columns[name] = _column(values)
    rows = [_numbers(point) for point in points]
    for name in dict.fromkeys(name for row in rows for name in row):
        columns[name] = _column([row.get(name) for row in rows])
    return Table(columns)


def _option(path: str, values: list[Any]) -> tuple[str, list[Any]]:
    """The name of the column of an option, and its values, in SI where all are numbers."""
    try:
        unit = describe(path).unit
        numbers = [value if value is None else _number(value, unit) for value in values]
    except CaseError:
        return path, values
    return path + _ending(unit), numbers


def _number(value: Any, unit: str) -> Any:
    """The value in SI. Raises CaseError for what is no number."""
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if is_number or (isinstance(value, str) and unit):
        return quantity(value, unit) if isinstance(value, str) else value
    raise CaseError(f"error: {value!r}: no number")


def _ending(unit: str) -> str:
    """The unit as names of columns have it: _m2_per_s."""
    if unit in ("", "1"):
        return ""
    return "_" + unit.replace("/(", "/").rstrip(")").replace("/", "_per_").replace(" ", "_")


def _numbers(point: Point) -> dict[str, float]:
    """What the summary of a point tells in numbers, by the names of columns."""
    if not point.outcome:
        return {}
    summary = point.results().summary
    inner = ("mechanics", "mass_balance", "extremes")
    parts = [summary, *(summary.get(name, {}) for name in inner)]
    row = {name: value for part in parts for name, value in part.items()
           if isinstance(value, (int, float)) and not isinstance(value, bool)}
    rates = summary.get("rate_m2_per_s", {})
    row |= {f"{name}_m2_per_s": rate for name, rate in rates.items()}
    peaks = summary.get("mechanics", {}).get("peak_pressures", {})
    row |= {f"peak_pressures.{name}.{quantity}": value for name, peak in peaks.items()
            for quantity, value in peak.items()}
    return row


def _column(values: list[Any]) -> np.ndarray:
    if all(value is None or (isinstance(value, (int, float)) and not isinstance(value, bool))
           for value in values):
        return np.array([np.nan if value is None else value for value in values])
    return np.array(["" if value is None else str(value) for value in values])
