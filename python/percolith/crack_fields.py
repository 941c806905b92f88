# SPDX-License-Identifier: BSD-3-Clause
"""Quantities of cracks that pictures show in colours, and the ends of these colours."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from percolith.colour_range import ColourRange, cut_range
from percolith.deformation import FROM_THE_START
from percolith.run_directory import Frame, carries_fluid
from percolith.units import Scale, scale_of
from percolith.vtu import Grid


class CrackField(NamedTuple):
    """A quantity of the cracks."""

    array: str  # in the field files
    label: str
    which: str  # segments that have it: `wet`, `broken`, `new` (broken since the start), or `all`
    cut: float  # per cent of the values beyond the colours on either side


CRACK_FIELDS = {
    "pressure": CrackField("pressure_Pa", "Pressure in cracks", "wet", 1.0),
    "head": CrackField("head_m", "Hydraulic head in cracks", "wet", 1.0),
    "saturation": CrackField("saturation", "Saturation of cracks", "wet", 0.0),
    "aperture": CrackField("aperture_m", "Aperture of cracks, hydraulic", "wet", 1.0),
    "flux": CrackField("flux_m2_per_s", "Flux along cracks", "wet", 1.0),
    "opening": CrackField("opening_m", "Opening of cracks", "broken", 1.0),
    "slip": CrackField("slip_m", "Slip of cracks", "broken", 1.0),
    "damage": CrackField("damage", "Damage of joints", "all", 0.0),
    "break_time": CrackField("break_time_s", "Time of breakage", "new", 0.0),
    "released_energy": CrackField("released_energy_J_per_m", "Energy released by breakage", "new",
                                  1.0),
}
_SHARES = ("saturation", "damage")  # from 0 to 1
_SIZES = ("flux", "slip")  # whose sign follows from the order of the ends


def has_crack_field(cracks: Grid, name: str) -> bool:
    """Whether there is such a quantity."""
    array = "mode" if name == "mode" else CRACK_FIELDS[name].array
    return array in cracks.point_data or array in cracks.cell_data


def chosen_segments(cracks: Grid, name: str) -> np.ndarray:
    """True (n,) for the crack segments that have a value of the quantity."""
    which = CRACK_FIELDS[name].which
    if which == "wet":
        return carries_fluid(cracks)
    mode = cracks.cell_data["mode"]
    least = {"all": mode.min(initial=0), "broken": FROM_THE_START, "new": FROM_THE_START + 1}
    return mode >= least[which]


def end_values(cracks: Grid, name: str) -> np.ndarray:
    """Values (n, 2), SI, of the quantity at the ends of all crack segments."""
    array = CRACK_FIELDS[name].array
    if array in cracks.point_data:
        return cracks.point_data[array][cracks.cells]
    values = cracks.cell_data[array]
    values = np.abs(values) if name in _SIZES else values
    return np.repeat(values[:, None], 2, axis=1)


def shown_values(frame: Frame, name: str) -> np.ndarray:
    """Values (SI) at the ends of the segments that have one."""
    cracks = frame.cracks
    if name not in CRACK_FIELDS or cracks is None or not len(cracks.cells):
        return np.empty(0)
    return end_values(cracks, name)[chosen_segments(cracks, name)].ravel()


def range_of_cracks(name: str, values: np.ndarray) -> ColourRange:
    """The ends of the colours; of a quantity that no segment has, from 0 to 1 of its unit."""
    field = CRACK_FIELDS[name]
    if name in _SHARES:
        return ColourRange(0.0, 1.0, Scale(1.0, ""))
    if not np.isfinite(values).any():
        scale = scale_of(field.array, np.zeros(1))
        return ColourRange(0.0, scale.factor, scale)
    return cut_range(values, field.cut, lambda ends: scale_of(field.array, ends))
