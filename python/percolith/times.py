# SPDX-License-Identifier: BSD-3-Clause
"""A time as users give it, to choose a frame: seconds, or a text with a unit."""

from __future__ import annotations

import importlib.util
import math
import re
from numbers import Real

from percolith.errors import CaseError

ALLOWED = 'seconds, or a number with a unit of time, such as "3 hour"'

# What is read where the package was built without the simulator, whose units are those of UDUNITS.
_UNITS = {"us": 1e-6, "µs": 1e-6, "ms": 1e-3, "s": 1.0, "second": 1.0, "min": 60.0, "minute": 60.0,
          "h": 3600.0, "hour": 3600.0, "d": 86400.0, "day": 86400.0, "week": 604800.0,
          "year": 31556925.9747}
_NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*")


def seconds(time: float | str) -> float:
    """A time in s, from a number of seconds or a text such as "10 ms". Raises ValueError for what
    is no finite time, with the reason alone; ALLOWED tells what is."""
    if isinstance(time, str):
        value = _from_text(time)
    elif isinstance(time, Real):
        value = float(time)
    else:
        raise ValueError("no time")
    if not math.isfinite(value):
        raise ValueError("not a finite time")
    return value


def _from_text(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        pass
    if importlib.util.find_spec("percolith._core") is None:
        return _without_simulator(text)
    from percolith.simulation import quantity

    try:
        return quantity(text, "s")
    except CaseError as error:
        reason = error.problems[0].reason if error.problems else str(error)
        raise ValueError(reason.removeprefix(f'"{text}": ')) from None


def _without_simulator(text: str) -> float:
    parts = _NUMBER.fullmatch(text)
    if parts is None:
        raise ValueError("does not begin with a number")
    number, unit = parts.groups()
    word = unit.lower().removesuffix("s") if len(unit) > 3 else unit
    factor = _UNITS.get(word)
    if factor is None:
        raise ValueError(f'the unit "{unit}" is not one of time that is read here: '
                         f'{", ".join(_UNITS)}')
    return float(number) * factor
