# SPDX-License-Identifier: BSD-3-Clause
"""Columns of a history of mechanics that several pictures share."""

from __future__ import annotations

import numpy as np

from percolith.run_directory import Table
from percolith.units import Scale, length_scale, prefix_scale

HELD = {"kinetic_J_per_m": "kinetic", "elastic_J_per_m": "elastic", "joint_J_per_m": "joints",
        "contact_J_per_m": "contact"}
INPUT = ("external_work_J_per_m", "fluid_work_J_per_m", "gravity_J_per_m")


def present(history: Table, curves: dict[str, str]) -> dict[str, str]:
    """Those that are there and not zero throughout."""
    return {name: label for name, label in curves.items()
            if name in history and np.any(np.nan_to_num(history[name]) != 0.0)}


def fitting_scale(values: np.ndarray, unit: str) -> Scale:
    """The unit of the finite values; a run that failed may have others."""
    values = values[np.isfinite(values)]
    return length_scale(values) if unit == "m" else prefix_scale(values, unit)


def reactions(history: Table) -> dict[str, str]:
    """The reactions of all conditions with their names, those that are not zero throughout."""
    curves = {}
    for axis in "xy":
        ending = f".reaction_{axis}_N_per_m"
        curves |= {name: f"{name.removesuffix(ending)}, {axis}" for name in history.columns
                   if name.endswith(ending)}
    return present(history, dict(sorted(curves.items())))
