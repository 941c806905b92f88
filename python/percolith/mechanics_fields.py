# SPDX-License-Identifier: BSD-3-Clause
"""Values of the fields of mechanics that pictures show, and the ends of their colours."""

from __future__ import annotations

import numpy as np

from percolith.colour_range import ColourRange, widened
from percolith.deformation import damage_since_the_start
from percolith.rigid_bodies import rigid_triangles, split_off_rigid_bodies
from percolith.run_directory import Frame, RunDirectory, RunDirectoryError
from percolith.units import Scale, length_scale, power_scale, pressure_scale
from percolith.vtu import Grid

VECTORS = {"displacement": "displacement_m", "velocity": "velocity_m_per_s"}
STRESSES = {"principal_stress_1": "principal_stress_1_Pa",
            "principal_stress_2": "principal_stress_2_Pa"}
LABEL = {
    "displacement": "Displacement",
    "velocity": "Velocity",
    "principal_stress_1": "Principal stress 1, most tensile",
    "principal_stress_2": "Principal stress 2, most compressive",
    "damage": "Damage since the start, largest of a triangle's joints",
    "fragments": "Fragments",
}
MECHANICS_FIELDS = tuple(LABEL)
_FAR = 1.5  # times what 99 % of the points do not exceed: a loose piece


def array_of(data: dict[str, np.ndarray], name: str) -> np.ndarray:
    if name not in data:
        raise RunDirectoryError(f"no {name} in the field files of this run")
    return data[name]


def values_of(frame: Frame, field: str) -> np.ndarray:
    """Values in SI: one a point for sizes of vectors, one a triangle for all else."""
    if field in VECTORS:
        return np.hypot(*array_of(frame.matrix.point_data, VECTORS[field]).T)
    if field == "fragments":
        return array_of(frame.matrix.cell_data, "fragment")
    if field == "damage":
        if frame.cracks is not None:
            array_of(frame.cracks.cell_data, "damage")
        return damage_since_the_start(frame)
    return array_of(frame.matrix.cell_data, STRESSES.get(field, field))


def fragment_count(frame: Frame) -> int:
    """Into how many pieces the rock has come apart."""
    return len(np.unique(values_of(frame, "fragments")))


def rock_and_bodies(run: RunDirectory, frame: Frame) -> tuple[Frame, Grid]:
    """The rock and the rigid bodies; rock alone where nothing else would be left to show."""
    rigid = rigid_triangles(run, frame.matrix)
    return split_off_rigid_bodies(frame, rigid & ~rigid.all())


def range_of_values(field: str, values: np.ndarray) -> ColourRange:
    """The ends of the colours. Stresses grow without bound towards the tips of cracks, on ever
    finer meshes, and are cut at the last per cent on either side; so are displacements and
    velocities where a few loose pieces go far beyond all others."""
    if field == "damage":
        return ColourRange(0.0, 1.0, Scale(1.0, ""))
    if not np.isfinite(values).any():
        raise RunDirectoryError(f"{LABEL[field].lower()}: no finite value")
    if field in VECTORS:
        most, high = (float(end) for end in np.nanpercentile(values, [99, 100]))
        high = (most if 0.0 < most < high / _FAR else high) or 1.0
        scale = length_scale([high]) if field == "displacement" else power_scale([high], "m/s")
        return ColourRange(0.0, high, scale)
    low, high = widened(*(float(end) for end in np.nanpercentile(values, [1, 99])))
    return ColourRange(low, high, pressure_scale([low, high]))
