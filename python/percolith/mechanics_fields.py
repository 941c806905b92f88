# SPDX-License-Identifier: BSD-3-Clause
"""Values of the fields of mechanics that pictures show, and the ends of their colours."""

from __future__ import annotations

import numpy as np

from percolith.colour_range import ColourRange, cut_range
from percolith.deformation import damage_since_the_start
from percolith.rigid_bodies import rigid_triangles, split_off_rigid_bodies
from percolith.run_directory import Frame, RunDirectory, RunDirectoryError
from percolith.units import Scale, length_scale, power_scale, scale_of, without_unit
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
_OTHERS = {
    "stress_xx": "Stress xx",
    "stress_yy": "Stress yy",
    "stress_xy": "Stress xy",
    "stress_zz": "Stress zz, across the plane",
    "strain_xx": "Strain xx",
    "strain_yy": "Strain yy",
    "strain_xy": "Strain xy, half the angle of shear",
    "region": "Regions",
}
# Arrays that pictures show by another name, or as crosses.
_SHOWN = ("pressure_Pa", "head_m", "saturation", "darcy_flux_m_per_s", "principal_direction",
          "damage", "fragment", *VECTORS.values(), *STRESSES.values())
_FAR = 1.5  # times what 99 % of the points do not exceed: a loose piece


def other_fields(matrix: Grid) -> dict[str, str]:
    """Names and arrays of what else the points or triangles of a frame have."""
    arrays = [*matrix.point_data, *matrix.cell_data]
    return {without_unit(array): array for array in arrays if array not in _SHOWN}


def label_of(frame: Frame, field: str) -> str:
    """What a colour bar calls a field; stress is effective where there is fluid."""
    label = LABEL.get(field) or _OTHERS.get(field) or field.replace("_", " ").capitalize()
    if "stress" in field and "pressure_Pa" in frame.matrix.point_data:
        return f"Effective {label[0].lower()}{label[1:]}"
    return label


def is_category(values: np.ndarray) -> bool:
    """Whether values are numbers of things, as of regions and fragments."""
    return values.dtype.kind in "iu"


def array_of(data: dict[str, np.ndarray], name: str) -> np.ndarray:
    if name not in data:
        raise RunDirectoryError(f"no {name} in the field files of this run")
    return data[name]


def values_of(frame: Frame, field: str) -> np.ndarray:
    """Values in SI: one a point for sizes of vectors, one a triangle for all else; of other arrays
    of the frame as they are there, of vectors their size."""
    if field in VECTORS:
        return np.hypot(*array_of(frame.matrix.point_data, VECTORS[field]).T)
    if field == "fragments":
        return array_of(frame.matrix.cell_data, "fragment")
    if field == "damage":
        if frame.cracks is not None:
            array_of(frame.cracks.cell_data, "damage")
        return damage_since_the_start(frame)
    name = STRESSES.get(field) or other_fields(frame.matrix).get(field, field)
    points = frame.matrix.point_data
    values = points[name] if name in points else array_of(frame.matrix.cell_data, name)
    return np.hypot(*values.T) if values.ndim == 2 else values


def is_at_points(frame: Frame, field: str) -> bool:
    """Whether `values_of` gives one a point."""
    name = VECTORS.get(field) or other_fields(frame.matrix).get(field)
    return name in frame.matrix.point_data


def fragment_count(frame: Frame) -> int:
    """Into how many pieces the rock has come apart."""
    return len(np.unique(values_of(frame, "fragments")))


def rock_and_bodies(run: RunDirectory, frame: Frame) -> tuple[Frame, Grid | None]:
    """The rock and the rigid bodies, None where there are none or nothing else would be left to
    show: then the frame stays as it is, and nothing of it is unpacked."""
    rigid = rigid_triangles(run, frame.matrix)
    if rigid.all() or not rigid.any():
        return frame, None
    return split_off_rigid_bodies(frame, rigid)


def range_of_values(field: str, values: np.ndarray, array: str = "") -> ColourRange:
    """The ends of the colours; `array` names the unit of a field that is none of MECHANICS_FIELDS.
    Stresses grow without bound towards the tips of cracks, on ever finer meshes, and are cut at the
    last per cent on either side; so are displacements and velocities where a few loose pieces go
    far beyond all others."""
    if field == "damage":
        return ColourRange(0.0, 1.0, Scale(1.0, ""))
    if not np.isfinite(values).any():
        raise RunDirectoryError(f"{LABEL.get(field, field).lower()}: no finite value")
    if field in VECTORS:
        most, largest = (float(end) for end in np.nanpercentile(values, [99, 100]))
        high = (most if 0.0 < most < largest / _FAR else largest) or 1.0
        scale = length_scale([high]) if field == "displacement" else power_scale([high], "m/s")
        return ColourRange(0.0, high, scale, "max" if largest > high else "neither")
    unit = STRESSES.get(field) or array
    return cut_range(values, 1.0, lambda ends: scale_of(unit, ends))
