# SPDX-License-Identifier: BSD-3-Clause
"""What `resolved.toml` says beside its values: units, and what was derived from the input."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

_TABLE = re.compile(r"\[\s*(\w+)")
_OPTION = re.compile(r"(\w+) = (?![\"\[]\"?[A-Za-z])(.*\S)  # (\S.*)")
_DERIVED = re.compile(r"# (.+) = (.+)")
_NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
_LIMIT = "limit of the explicit step by "
_TOGETHER = "all together"


@dataclass(frozen=True)
class Derived:
    """A derived value; `value` is text where it is no number."""

    name: str
    value: float | int | str
    unit: str


@dataclass
class ResolvedText:
    """units: by kind of table and option, as ("material", "density"). derived: in the order of the
    file, limits of the step left out. limits: of the explicit step (s), by what sets each."""

    units: dict[tuple[str, str], str] = field(default_factory=dict)
    derived: list[Derived] = field(default_factory=list)
    limits: dict[str, float] = field(default_factory=dict)

    @property
    def together(self) -> float | None:
        """The limit (s) that all mechanisms set together."""
        return self.limits.get(_TOGETHER)

    @property
    def single_limits(self) -> dict[str, float]:
        """Those of one mechanism each, the smallest, which rules, first."""
        single = {name: limit for name, limit in self.limits.items() if name != _TOGETHER}
        return dict(sorted(single.items(), key=lambda entry: entry[1]))


def _value(text: str) -> tuple[float | int | str, str]:
    first, _, unit = text.partition(" ")
    if not _NUMBER.fullmatch(first):
        return text, ""
    return (int(first) if first.lstrip("-").isdigit() else float(first)), unit


def read_resolved(text: str) -> ResolvedText:
    """Reads the text of a `resolved.toml`."""
    read, table, is_derived = ResolvedText(), "", False
    for line in text.splitlines():
        is_derived = is_derived or line == "# Derived values"
        if match := _TABLE.match(line):
            table = match[1]
        elif match := _OPTION.fullmatch(line):
            read.units[table, match[1]] = match[3]
        elif is_derived and (match := _DERIVED.fullmatch(line)):
            value, unit = _value(match[2])
            if match[1].startswith(_LIMIT):
                read.limits[match[1].removeprefix(_LIMIT)] = float(value)
            else:
                read.derived.append(Derived(match[1], value, unit))
    return read
