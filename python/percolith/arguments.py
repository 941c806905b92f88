# SPDX-License-Identifier: BSD-3-Clause
"""Arguments from Python: which are none, and what messages of the simulator call them.

The simulator names options of the command line; from Python they are arguments of functions.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np

from percolith.errors import CaseError, FileError

_WORDS = [(r"^--set: ", ""), (r"^--output$", "output"), (r"^--resume$", "folder"),
          (r"error: --output = ", "error: output = "), (r"error: --resume = ", "error: folder = "),
          (r"another --output", "another output"), (r"--force to ", "force=True to "),
          (r"--resume to ", "percolith.resume to ")]


def in_python(text: str) -> str:
    """A message of the simulator with the names of arguments for those of options."""
    for option, argument in _WORDS:
        text = re.sub(option, argument, text, flags=re.MULTILINE)
    return text


def with_resume(text: str) -> str:
    """How a run that was interrupted says to go on, with the way from Python before that of the
    command line."""
    return re.sub(r"to go on: (percolith run --resume (.+))$",
                  lambda told: f"to go on: percolith.resume({told[2]!r}), or {told[1]}", text)


@contextmanager
def python_words() -> Iterator[None]:
    """Errors that pass through name arguments for options."""
    try:
        yield
    except CaseError as error:
        problems = [replace(one, message=in_python(one.message), key=in_python(one.key),
                            file="" if one.file == "--set" else one.file,
                            allowed=in_python(one.allowed)) for one in error.problems]
        raise CaseError(in_python(str(error)), problems) from None
    except FileError as error:
        raise FileError(in_python(str(error))) from None


def whole_number(name: str, value: Any, what: str) -> int:
    """A positive whole number. Raises CaseError, which says what it is to be, for anything else."""
    try:
        number = 0 if isinstance(value, (bool, np.bool_)) else operator.index(value)
    except TypeError:
        number = 0
    if number < 1:
        raise CaseError(f"error: {name} = {value!r}: no {what}; allowed: a whole number, 1 or more")
    return number


def numbers(name: str, given: Any, allowed: str) -> np.ndarray:
    """An array of numbers. Raises CaseError where it is none, rows of different lengths and texts
    among them."""
    try:
        return np.asarray(given, dtype=float)
    except (TypeError, ValueError):
        raise CaseError(f"error: {name}: no array of numbers; allowed: {allowed}") from None
