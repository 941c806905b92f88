# SPDX-License-Identifier: BSD-3-Clause
"""What the options of a case mean, from their declarations in the simulator."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from typing import Any

from percolith import _core
from percolith.errors import CaseError, did_you_mean


@dataclass(frozen=True)
class Option:
    """An option: its dotted path, where `*` stands for a name you choose; what it means; its SI
    unit, "" where it has none; its entry in the JSON Schema with bounds and default."""

    path: str
    help: str
    unit: str
    schema: dict[str, Any]

    def __str__(self) -> str:
        unit = f" ({self.unit})" if self.unit else ""
        return f"{self.path}{unit}: {self.help}"


@cache
def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of case files."""
    return json.loads(_core.schema())


@cache
def option_names() -> tuple[str, ...]:
    """The dotted paths of all options; `*` stands for a name you choose."""
    return tuple(_core.option_paths())


def describe(path: str) -> Option:
    """What the option at a dotted path means; names you chose may stand as they are or as `*`.
    Raises CaseError with the nearest names for one that does not exist."""
    names = path.split(".")
    for known in option_names():
        parts = known.split(".")
        if len(parts) == len(names) and all(p in ("*", n) for p, n in zip(parts, names)):
            return _option(known)
    raise CaseError(f"error: {path}: there is no such option"
                    + did_you_mean(path, option_names()))


def _option(path: str) -> Option:
    node = schema()
    for name in path.split("."):
        node = node["additionalProperties"] if name == "*" else node["properties"][name]
    return Option(path, node.get("description", ""), node.get("x-unit", ""), node)
