# SPDX-License-Identifier: BSD-3-Clause
"""Values of the fields of flow that pictures show, and the ends of their colours."""

from __future__ import annotations

import numpy as np

from percolith.colour_range import ColourRange, beyond_which, widened
from percolith.run_directory import Frame, RunDirectoryError
from percolith.units import Scale, power_scale, pressure_scale
from percolith.vtu import Grid

FIELDS = ("pressure", "head", "saturation", "flux")
LABEL = {
    "pressure": "Pressure",
    "head": "Hydraulic head",
    "saturation": "Saturation",
    "flux": "Darcy flux",
}
_ARRAY = {"pressure": "pressure_Pa", "head": "head_m", "saturation": "saturation"}
_FLUX = "darcy_flux_m_per_s"
_CUT_ROCK, _CUT_CRACKS = 0.1, 1.0  # per cent of the values at either end, where the rock deforms
_WIDER = 2.0  # times the range of the rock: cracks get colours of their own beyond


def point_values(grid: Grid, field: str) -> np.ndarray:
    """Values (SI) at the points of the rock or the cracks. Raises RunDirectoryError where there are
    none."""
    if _ARRAY[field] not in grid.point_data:
        raise RunDirectoryError(f"no {field} in this run (head needs model.gravity > 0)")
    return grid.point_data[_ARRAY[field]]


def flux(frame: Frame) -> np.ndarray:
    """Darcy flux (m/s) of every triangle, (n, 2). Raises RunDirectoryError where there is none."""
    if _FLUX not in frame.matrix.cell_data:
        raise RunDirectoryError(f"no {_FLUX} in the field files of this run")
    return frame.matrix.cell_data[_FLUX]


def flux_size(frame: Frame) -> np.ndarray:
    return np.hypot(*flux(frame).T)


def is_dry(grid: Grid) -> np.ndarray:
    """True at the points that are not full of fluid: its pressure there is none, and the head but
    the elevation."""
    full = 1.0 - 1e-9
    return grid.point_data.get("saturation", np.ones(len(grid.points))) < full


def rock_values(frame: Frame, field: str) -> np.ndarray:
    """What the colours of a field span: of the head that of rock full of fluid, where there is
    any."""
    if field == "flux":
        return flux_size(frame)
    values = point_values(frame.matrix, field)
    if field != "head":
        return values
    dry = is_dry(frame.matrix)
    return values if dry.all() else np.where(dry, np.nan, values)


def _scale(field: str, low: float, high: float) -> Scale:
    if field == "pressure":
        return pressure_scale([low, high])
    return power_scale([low, high], "m" if field == "head" else "m/s")


def range_of_values(field: str, values: np.ndarray, cut: float = 0.0) -> ColourRange:
    """The ends of the colours; beyond them lie at most `cut` per cent of the values on either side.
    The flux grows without bound towards the tips of cracks, on ever finer meshes, and is cut at its
    last per cent. Raises RunDirectoryError where no value is finite."""
    if not np.isfinite(values).any():
        raise RunDirectoryError(f"{LABEL[field].lower()}: no finite value")
    if field == "saturation":
        return ColourRange(0.0, 1.0, Scale(1.0, ""))
    least, low, high, most = np.nanpercentile(values, [0.0, cut, 100.0 - cut, 100.0]).tolist()
    if field == "flux":
        least, low, high = 0.0, 0.0, float(np.nanpercentile(values, 99))
    beyond = beyond_which(least < low, field == "flux" or most > high)
    low, high = widened(low, high)
    return ColourRange(low, high, _scale(field, low, high), beyond)


def rock_and_crack_ranges(field: str, rock: np.ndarray, cracks: np.ndarray,
                          deforms: bool) -> tuple[ColourRange, ColourRange | None]:
    """The ends of the colours of the rock and, where they differ, of the cracks. Rock that deforms
    squeezes the fluid in a few triangles to pressures far above all others, for which colours are
    not stretched. Where fluid is forced into tight rock, the pressure in cracks is so far above
    that of the rock that one range would show the rock in one colour."""
    if not deforms or field not in ("pressure", "head"):
        return range_of_values(field, np.concatenate([rock, cracks])), None
    of_rock = range_of_values(field, rock, _CUT_ROCK)
    if not np.isfinite(cracks).any():
        return of_rock, None
    of_cracks = range_of_values(field, cracks, _CUT_CRACKS)
    low, high = min(of_rock.low, of_cracks.low), max(of_rock.high, of_cracks.high)
    if high - low > _WIDER * (of_rock.high - of_rock.low):
        return of_rock, of_cracks
    both = np.concatenate([rock, cracks])
    beyond = beyond_which(np.nanmin(both) < low, np.nanmax(both) > high)
    return ColourRange(low, high, _scale(field, low, high), beyond), None
