# SPDX-License-Identifier: BSD-3-Clause
"""Tables and lists of names in few lines, as `print` shows them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

WIDTH = 100  # characters of a line
_ROWS = 4  # shown of the beginning, and as many of the end
_CELL = 32  # characters of a value
_NAMES = 60  # characters of a list of names
_GAP = "  "


def cut(text: str, width: int) -> str:
    """The text in one line of at most so many characters; dots stand for what is cut off."""
    line = " ".join(text.split())
    return line if len(line) <= width else line[: width - 3] + "..."


def listed(names: Iterable[str], width: int = _NAMES) -> str:
    """Names in about so many characters: "time_s, x_m and 3 more"; "none" without any."""
    names = [cut(str(name), width) for name in names]
    shown = names[:1]
    while len(shown) < len(names) and len(", ".join([*shown, names[len(shown)]])) <= width:
        shown.append(names[len(shown)])
    more = len(names) - len(shown)
    return (", ".join(shown) or "none") + (f" and {more} more" if more else "")


def counted(count: int, what: str) -> str:
    """A number with its noun, as 1 row or 2 rows."""
    return f"{count} {what}" + ("" if count == 1 else "s")


def table_text(columns: Mapping[str, np.ndarray]) -> str:
    """A table in at most 11 lines of at most WIDTH characters: what there is; the names of columns;
    the first and last rows. Columns that have no room are named in the first line alone."""
    count = len(next(iter(columns.values()), ()))
    texts = [_column(name, values, count) for name, values in columns.items()]
    fitting = _fitting(texts)
    hidden = list(columns)[len(fitting):]
    size = f"{counted(count, 'row')}, {counted(len(columns), 'column')}"
    beyond = "; not shown: " if hidden else ""
    room = WIDTH - len(f"Table of {size}{beyond} and {len(hidden)} more")
    head = f"Table of {size}{beyond}" + (listed(hidden, room) if hidden else "")
    return "\n".join([head, *(_GAP.join(line).rstrip() for line in zip(*fitting))])


def _shown_rows(count: int) -> list[int | None]:
    """Numbers of the rows that are shown; None stands for those between."""
    if count <= 2 * _ROWS + 1:
        return list(range(count))
    return [*range(_ROWS), None, *range(count - _ROWS, count)]


def _column(name: str, values: np.ndarray, count: int) -> list[str]:
    """The lines of a column, all of one width: its name, and the rows that are shown."""
    lines = [cut(name, WIDTH)]
    lines += ["..." if row is None else _value(values[row]) for row in _shown_rows(count)]
    width = max(map(len, lines))
    is_text = np.asarray(values).dtype.kind not in "biuf"
    return [line.ljust(width) if is_text else line.rjust(width) for line in lines]


def _value(value: object) -> str:
    if isinstance(value, np.ndarray):  # a vector, as the flux of a segment
        return cut("(" + ", ".join(map(_value, value)) + ")", _CELL)
    if isinstance(value, (float, np.floating)):
        return f"{value:.6g}"
    return cut(str(value), _CELL)


def _fitting(texts: Sequence[list[str]]) -> list[list[str]]:
    """Those first columns that have room in a line; one at least."""
    fitting, width = [], -len(_GAP)
    for lines in texts:
        width += len(_GAP) + len(lines[0])
        if fitting and width > WIDTH:
            break
        fitting.append(lines)
    return fitting
