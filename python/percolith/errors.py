# SPDX-License-Identifier: BSD-3-Clause
"""What can go wrong, with the messages of the command line."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

_MOST_NAMES = 30  # in a message


@dataclass(frozen=True)
class Problem:
    """One mistake in a case: `message` as the command line prints it, and its parts. `line` and
    `column` count from 1; 0 where there is none."""

    message: str
    file: str
    line: int
    column: int
    key: str
    value: str
    reason: str
    allowed: str


class Error(Exception):
    """Base of every error that Percolith raises."""


class CaseError(Error, ValueError):
    """Something in a case, its mesh or an argument is wrong. `problems` lists all mistakes that
    were found, the message has a line for each."""

    def __init__(self, message: str, problems: Sequence[Problem] = ()):
        super().__init__(message)
        self.problems = tuple(problems)

    def __reduce__(self):
        return type(self), (str(self), self.problems)


class SolverError(Error, RuntimeError):
    """The computation cannot go on; the results up to the last output are kept."""


class FileError(Error, OSError):
    """A file cannot be read or written."""


class MeshError(Error, ValueError):
    """A geometry cannot be meshed as it was asked for."""


class UnknownNameError(Error, KeyError):
    """A table or a frame has nothing of this name. The message tells what it has, the nearest name
    first."""

    def __str__(self) -> str:
        return Exception.__str__(self)  # that of KeyError puts the message into quotes


def did_you_mean(name: object, known: Iterable[str], most: int = 3) -> str:
    """The end of a message on an unknown name: "; did you mean a, b?" with the nearest of those
    known, or nothing where none is near."""
    near = difflib.get_close_matches(str(name), list(known), n=most)
    return f"; did you mean {', '.join(near)}?" if near else ""


def unknown_name(what: str, name: object, known: Iterable[str]) -> UnknownNameError:
    """The error that there is no `what` of this name, only those known."""
    names = list(known)
    near = difflib.get_close_matches(str(name), names, n=3)
    ordered = near + [other for other in names if other not in near]
    more = f" and {len(ordered) - _MOST_NAMES} more" if len(ordered) > _MOST_NAMES else ""
    told = ", ".join(ordered[:_MOST_NAMES]) or "none"
    return UnknownNameError(f"no {what} {name}; there are: {told}{more}")


class CaseWarning(UserWarning):
    """What a case or a run warns of, in the words of the command line."""
