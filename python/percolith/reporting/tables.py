# SPDX-License-Identifier: BSD-3-Clause
"""Tables of a page, and those of the options of a case."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from percolith.reporting.quantities import number_text, quantity_text, unit_of
from percolith.reporting.resolved_text import ResolvedText

# Tables of the case in the order of the page; others follow by their own name.
_TITLES = {"material": "Rocks", "fracture": "Fractures", "new_cracks": "New cracks",
           "fluid": "Fluid", "boundary": "Boundaries", "source": "Sources",
           "point_force": "Forces at points", "body": "Bodies", "excavation": "Excavations",
           "in_situ": "In-situ stress", "initial": "Start", "damping": "Damping",
           "contact": "Contact", "model": "Laws", "time": "Time"}
_LEFT_OUT = ("mesh", "output", "probe")


@dataclass
class Table:
    """Rows of texts; the first cell of each names it. Without `head` there are no column names."""

    title: str
    rows: list[list[str]]
    head: list[str] = field(default_factory=list)
    note: str = ""


def _numbers(values: list, unit: str) -> str:
    return ", ".join(option_text(value, unit) for value in values)


def option_text(value: Any, unit: str) -> str:
    """The value of an option as a reader expects it."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, dict) and "times" in value:
        steps = [f"{option_text(v, unit)} at {quantity_text(t, 's')}"
                 for t, v in zip(value["times"], value["values"])]
        return "; ".join(steps) + (" (in steps)" if value.get("interpolation") == "step" else "")
    if isinstance(value, list):
        return _numbers(value, unit)
    if isinstance(value, (int, float)):
        return quantity_text(value, unit)
    return str(value)


def _says_something(values: list) -> bool:
    """Whether a row is more than an option that is off, or an empty list."""
    return any(value is not None and value is not False and value != [] for value in values)


def _table(title: str, kind: str, columns: dict[str, dict], text: ResolvedText) -> Table | None:
    """A row an option, a column a table; what is off everywhere is left out."""
    names = list(dict.fromkeys(name for options in columns.values() for name in options))
    rows = []
    for name in names:
        values = [options.get(name) for options in columns.values()]
        unit = text.units.get((kind, name), "")
        if _says_something(values):
            rows.append([name.replace("_", " "), *("" if value is None else option_text(value, unit)
                                                   for value in values)])
    head = [] if list(columns) == [""] else ["", *columns]
    return Table(title, rows, head) if rows else None


def option_tables(resolved: dict, text: ResolvedText) -> list[Table]:
    """The options of a case, table by table: rocks and fractures first, with a column each."""
    present = [name for name, value in resolved.items()
               if isinstance(value, dict) and value and name not in _LEFT_OUT]
    order = [name for name in _TITLES if name in present]
    order += [name for name in present if name not in order]
    tables = []
    for name in order:
        options = resolved[name]
        are_named = all(isinstance(value, dict) and "times" not in value
                        for value in options.values())
        columns = options if are_named else {"": options}
        tables.append(_table(_TITLES.get(name, name.replace("_", " ")), name, columns, text))
    return [table for table in tables if table]


def result_rows(results: dict, labels: dict[str, str], volumes: set[str]) -> list[list[str]]:
    """A row a number of `results`, whose names carry the units; `labels` says what each is, and
    `volumes` which of those in m² are volumes of a slice of one metre."""
    rows = []
    for name, value in results.items():
        unit = "m3/m" if name in volumes else unit_of(name)
        shown = quantity_text(value, unit) if unit else number_text(value)
        rows.append([labels[name], shown])
    return rows
