# SPDX-License-Identifier: BSD-3-Clause
"""The pass criteria of the examples (`expected.toml`), evaluated on a run."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from pathlib import Path

import formulas
import numpy as np
from foundation_formulas import FlatDam
from percolith import RunDirectory
from percolith.run_directory import Table, read_table
from program import ROOT, Result

EXAMPLES = ROOT / "examples"
VERIFICATION = ROOT / "verification"


@dataclass
class Profile:
    """Computed and expected values at the same places of a line."""

    position: np.ndarray  # m
    computed: np.ndarray
    expected: np.ndarray


def _formula(name: str, rows: Table, time: float) -> np.ndarray:
    x, y = rows["x_m"], rows["y_m"]
    return {"strip": lambda: formulas.strip(x, time),
            "radial": lambda: formulas.radial(np.hypot(x, y)),
            "semi_infinite": lambda: formulas.semi_infinite(abs(x), time),
            "slab": lambda: formulas.slab(abs(x), time),
            "dam_on_fracture": lambda: FlatDam().with_fracture(x, 12.0)}[name]()


def profile(criterion: dict, run: RunDirectory, example: str) -> Profile:
    """The values that a criterion compares. Raises ValueError where its time was not output."""
    time = criterion.get("time")
    rows = run.probe(criterion["probe"]).at_time(time)
    if time is not None and abs(rows["time_s"][0] - time) > 1e-9 * time:
        raise ValueError(f"{run.path}: probe {criterion['probe']} was not output at {time} s")
    for column, (low, high) in criterion.get("where", {}).items():
        rows = rows.where((rows[column] >= low) & (rows[column] <= high))
    axis = criterion.get("position", "x_m")
    if "formula" in criterion:
        expected = _formula(criterion["formula"], rows, criterion.get("time", 0.0))
    else:
        reference = read_table(VERIFICATION / example / criterion["reference"])
        places = reference[axis]
        expected = np.interp(rows[axis], places, reference[criterion["column"]])
        expected = expected * criterion.get("column_unit", 1.0)
    return Profile(rows[axis], rows[criterion["quantity"]], expected)


def measure(kind: str, values: Profile, scale: float = 1.0) -> float:
    """The size of the difference, over `scale`."""
    error = values.computed - values.expected
    if not np.isfinite(error).all():
        return float("inf")
    sizes = {"maximum": lambda: abs(error).max(),
             "rms": lambda: np.sqrt(np.mean(error**2)),
             "rms_over_range": lambda: np.sqrt(np.mean(error**2)) / np.ptp(values.expected),
             "relative_sum": lambda: abs(error).sum() / abs(values.expected).sum()}
    return float(sizes[kind]()) / scale


def read(example: str) -> dict:
    """The file expected.toml of an example."""
    with open(EXAMPLES / example / "expected.toml", "rb") as file:
        return tomllib.load(file)


def history_value(criterion: dict, run: RunDirectory) -> float:
    """The last, largest or smallest value of a sum of columns of the history; where the criterion
    has an expected value, the relative difference from it, else the size over `scale`."""
    values = sum(run.history[column] for column in criterion["columns"])
    value = {"last": lambda: values[-1], "maximum": values.max, "minimum": values.min}[
        criterion["measure"]]()
    if "expected" in criterion:
        return float(abs(value / criterion["expected"] - 1))
    return float(abs(value) / criterion.get("scale", 1.0))


def event_value(criterion: dict, run: RunDirectory) -> float:
    """Of the places where joints broke, by their angle from a line through the origin at `axis`
    degrees: the share of those further than `within` degrees from it (measure "outside"), or, of
    those within, the largest distance from the origin, mean over both ends of the line, as the
    relative difference from `expected` ("reach"). Infinite where nothing broke at an end."""
    places = run.events["x_m"] + 1j * run.events["y_m"]
    places = places * np.exp(-1j * np.radians(criterion["axis"]))
    inside = abs(places.imag) <= abs(places.real) * np.tan(np.radians(criterion["within"]))
    ends = [abs(places[inside & (places.real * sign > 0)]) for sign in (1, -1)]
    if not all(len(end) for end in ends):
        return float("inf")
    if criterion["measure"] == "outside":
        return float(1 - inside.mean())
    return float(abs(np.mean([end.max() for end in ends]) / criterion["expected"] - 1))


def evaluate(example: str, result: Result) -> list[tuple[str, float, float]]:
    """(name, value, limit) for each criterion of an example."""
    expected = read(example)
    found = []
    if "balance" in expected:
        found.append(("mass balance error over fluid in place and throughput", result.balance,
                      expected["balance"]))
    if "energy" in expected:
        found.append(("error of the energy balance", result.energy_error, expected["energy"]))
    if "wall_time" in expected:
        found.append(("wall time, s", result.wall_time, expected["wall_time"]))
    for criterion in expected.get("rate", []):
        rates = result.results.summary["rate_m2_per_s"]
        rate = sum(rates[condition] for condition in criterion["conditions"])
        found.append((criterion["name"], abs(rate / criterion["expected"] - 1), criterion["limit"]))
    for criterion in expected.get("history", []):
        value = history_value(criterion, result.results)
        found.append((criterion["name"], value, criterion["limit"]))
    for criterion in expected.get("event", []):
        found.append((criterion["name"], event_value(criterion, result.results),
                      criterion["limit"]))
    for criterion in expected.get("probe", []):
        value = result.results.probe(criterion["probe"]).at_time()[criterion["quantity"]].mean()
        found.append((criterion["name"], abs(value / criterion["expected"] - 1),
                      criterion["limit"]))
    for criterion in expected.get("profile", []):
        values = profile(criterion, result.results, example)
        value = measure(criterion["measure"], values, criterion.get("scale", 1.0))
        found.append((criterion["name"], value, criterion["limit"]))
    return found
