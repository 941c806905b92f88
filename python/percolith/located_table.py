# SPDX-License-Identifier: BSD-3-Clause
"""A CSV file that a user wrote, with the lines of its mistakes."""

from __future__ import annotations

import csv
import math
import os
from collections.abc import Iterator

from percolith.errors import CaseError, Problem


class LocatedTable:
    """The cells of a file, with where they stand."""

    def __init__(self, path: str | os.PathLike):
        self.path = str(path)
        self.problems: list[Problem] = []
        try:
            with open(path, newline="", encoding="utf-8-sig") as file:
                self.rows = list(_rows(file))
        except (OSError, UnicodeDecodeError) as error:
            reason = error.strerror if isinstance(error, OSError) else "not a text in UTF-8"
            self.refuse(0, f"cannot be read: {reason}")
            self.rows = []
        self.raise_problems()
        if not self.rows:
            self.refuse(0, "empty", "a line of names, then rows of numbers")
            self.raise_problems()
        self.first, names = self.rows.pop(0)
        self.names = [name.strip() for name in names]

    def refuse(self, line: int, reason: str, allowed: str = "", key: str = "",
               value: str = "") -> None:
        """Notes a mistake; line 0 stands for the whole file."""
        place = f"{self.path}:{line}" if line else self.path
        message = f"{place}: {reason}" + (f"; allowed: {allowed}" if allowed else "")
        self.problems.append(Problem(message, self.path, line, 0, key, value, reason, allowed))

    def raise_problems(self) -> None:
        """Raises CaseError with all mistakes that were noted."""
        if self.problems:
            raise CaseError("\n".join(one.message for one in self.problems), self.problems)

    def number(self, line: int, key: str, value: str, may_be_empty: bool = False) -> float:
        """The number in a cell; NaN where it is empty, which it may have to be refused for."""
        if may_be_empty and not value.strip():
            return float("nan")
        try:
            number = float(value)
        except ValueError:
            number = float("nan")
        if not math.isfinite(number):
            self.refuse(line, f'{key} = "{value.strip()}" is not a number',
                        "finite numbers in SI units", key, value)
        return number


def _rows(lines) -> Iterator[tuple[int, list[str]]]:
    """The rows with the numbers of their lines; those that are empty or begin with `#` left out."""
    for number, line in enumerate(lines, 1):
        if line.strip() and not line.startswith("#"):
            yield number, next(csv.reader([line]))
