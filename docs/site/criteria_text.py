# SPDX-License-Identifier: BSD-3-Clause
"""The pass criteria of an example, as its expected.toml gives them, in words."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass

from site_map import ROOT

WHOLE_RUN = {"balance": "mass balance error over fluid in place and throughput",
             "energy": "error of the energy balance",
             "wall_time": "wall time, s"}


@dataclass(frozen=True)
class Criterion:
    """What is compared, with what, and how far apart both may be."""

    quantity: str
    reference: str
    limit: float


def _reference(criterion: dict) -> str:
    if "expected" in criterion:
        return f"{criterion['expected']:g}"
    if "formula" in criterion:
        return f"formula {criterion['formula']}"
    return criterion.get("reference", "")


def read(example: str) -> list[Criterion]:
    """All criteria of an example. Raises KeyError where one lacks a name or a limit, and ValueError
    where expected.toml has what this does not know."""
    with open(ROOT / "examples" / example / "expected.toml", "rb") as file:
        expected = tomllib.load(file)
    found = []
    for key, value in expected.items():
        if key in WHOLE_RUN:
            found.append(Criterion(WHOLE_RUN[key], "", value))
        elif isinstance(value, list):
            found += [Criterion(one["name"], _reference(one), one["limit"]) for one in value]
        else:
            raise ValueError(f"examples/{example}/expected.toml: {key} is no criterion known here")
    return found


def table(criteria: list[Criterion]) -> str:
    """A Markdown table of criteria."""
    rows = "".join(f"| {one.quantity} | {one.reference} | {one.limit:g} |\n" for one in criteria)
    return "| quantity | compared with | at most |\n|---|---|---|\n" + rows
