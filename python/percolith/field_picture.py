# SPDX-License-Identifier: BSD-3-Clause
"""Draws one field of one frame: the matrix in colours, the cracks over it in the same colours."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from percolith.fine_triangles import refine
from percolith.run_directory import Frame, RunDirectory, RunDirectoryError
from percolith.units import Scale, format_time, power_scale, pressure_scale, time_scale
from percolith.vtu import Grid

FIELDS = ("pressure", "head", "saturation", "flux")
_ARRAY = {"pressure": "pressure_Pa", "head": "head_m", "saturation": "saturation"}
_LABEL = {
    "pressure": "Pressure",
    "head": "Hydraulic head",
    "saturation": "Saturation",
    "flux": "Darcy flux",
}
_OUTLINE = "#202020"
_COLOURS = 256  # of the colour map


@dataclass(frozen=True)
class ColourRange:
    """The values (SI) at the ends of the colours and the unit they are shown in."""

    low: float
    high: float
    scale: Scale

    @staticmethod
    def of_values(field: str, values: list[np.ndarray]) -> ColourRange:
        joined = np.concatenate(values)
        if not np.isfinite(joined).any():
            raise RunDirectoryError(f"{_LABEL[field].lower()}: no finite value")
        if field == "saturation":
            return ColourRange(0.0, 1.0, Scale(1.0, ""))
        low, high = float(np.nanmin(joined)), float(np.nanmax(joined))
        if field == "flux":
            # The flux grows without bound towards the tips of cracks, on ever finer meshes.
            low, high = 0.0, float(np.nanpercentile(joined, 99))
        if high - low <= 1e-12 * max(abs(low), abs(high)):
            low, high = low - 0.5 * (abs(low) or 1.0), high + 0.5 * (abs(high) or 1.0)
        scale = {
            "pressure": pressure_scale,
            "head": lambda v: power_scale(v, "m"),
            "flux": lambda v: power_scale(v, "m/s"),
        }[field](np.array([low, high]))
        return ColourRange(low, high, scale)

    @staticmethod
    def of_frame(frame: Frame, field: str) -> ColourRange:
        return ColourRange.of_values(field, _shown_values(frame, field))

    @staticmethod
    def of_frames(run: RunDirectory, field: str) -> ColourRange:
        """The range over all frames of a run."""
        values = []
        for time in run.times:
            shown = _shown_values(run.frame(time), field)
            values += [v for v in shown if v.size]
        return ColourRange.of_values(field, values)


def _values(grid: Grid, field: str) -> np.ndarray:
    """Matrix or crack values of a point field. Raises RunDirectoryError where there is none."""
    if _ARRAY[field] not in grid.point_data:
        raise RunDirectoryError(f"no {field} in this run (head needs model.gravity > 0)")
    return grid.point_data[_ARRAY[field]]


def _flux_size(frame: Frame) -> np.ndarray:
    return np.hypot(*frame.matrix.cell_data["darcy_flux_m_per_s"].T)


def _shown_values(frame: Frame, field: str) -> list[np.ndarray]:
    if field == "flux":
        return [_flux_size(frame)]
    grids = [frame.matrix] + ([frame.cracks] if frame.cracks else [])
    return [_values(grid, field) for grid in grids]


def model_figure(points: np.ndarray):
    """A figure that suits the shape of the model, with its axes; wide models get the bar below."""
    width, height = np.ptp(points, axis=0)
    is_wide = width > 2.2 * height
    size = (8.0, 8.0 * height / width + 1.75) if is_wide else (
        6.4 * min(1.0, 1.25 * width / height) + 1.4, 6.4 * min(height / width, 1.25) + 0.6)
    figure, axes = plt.subplots(figsize=size, layout="constrained")
    axes.set_aspect("equal")
    margin = 0.01 * max(width, height)
    axes.set_xlim(points[:, 0].min() - margin, points[:, 0].max() + margin)
    axes.set_ylim(points[:, 1].min() - margin, points[:, 1].max() + margin)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    return figure, axes, is_wide


def _draw_matrix(axes, frame: Frame, field: str, colours: dict,
                 shown: ColourRange) -> PolyCollection:
    """Draws flat triangles, fine enough that no step between two of them can be seen."""
    corners = frame.matrix.points[frame.matrix.cells]
    if field == "flux":
        values = _flux_size(frame)
    else:
        at_corners = _values(frame.matrix, field)[frame.matrix.cells]
        fine = refine(corners, at_corners, (shown.high - shown.low) / _COLOURS)
        corners, values = fine.corners, fine.values
    picture = PolyCollection(corners, array=values / shown.scale.factor, antialiased=False,
                             linewidths=0.0, rasterized=True, **colours)
    axes.add_collection(picture, autolim=False)
    return picture


def _draw_cracks(axes, cracks: Grid, field: str, colours: dict, factor: float) -> None:
    ends = cracks.points[cracks.cells]
    outline = LineCollection(ends, colors=_OUTLINE, linewidths=3.4, capstyle="round")
    if field == "flux":
        outline.set_linewidths(1.2)
        axes.add_collection(outline)
        return
    axes.add_collection(outline)
    middle = ends.mean(axis=1)
    values = _values(cracks, field)[cracks.cells]
    mean = values.mean(axis=1)
    # Two halves a segment, each in the colour a quarter of the way from its end.
    halves = np.concatenate([np.stack([ends[:, 0], middle], 1), np.stack([middle, ends[:, 1]], 1)])
    shown = np.concatenate([(values[:, 0] + mean) / 2, (values[:, 1] + mean) / 2])
    axes.add_collection(LineCollection(halves, array=shown / factor, linewidths=2.0,
                                       capstyle="round", **colours))


def one_a_square(places: np.ndarray, spacing: float) -> np.ndarray:
    """Indices of the places nearest to the middle of each square of the given size."""
    square = np.floor(places / spacing).astype(np.int64)
    nearest = np.argsort(np.hypot(*(places - (square + 0.5) * spacing).T), kind="stable")
    _, first = np.unique(square[nearest], axis=0, return_index=True)
    return nearest[first]


def _draw_arrows(axes, frame: Frame) -> None:
    """Direction and size of the Darcy flux at about 25 places across the model."""
    centre = frame.matrix.points[frame.matrix.cells].mean(axis=1)
    flux = frame.matrix.cell_data["darcy_flux_m_per_s"]
    spacing = max(np.ptp(centre, axis=0)) / 25
    chosen = one_a_square(centre, spacing)
    size = np.hypot(*flux.T)
    largest = np.percentile(size, 95) or 1.0
    length = np.minimum(size, largest) / np.where(size > 0, size, 1.0) * 0.9 * spacing / largest
    axes.quiver(*centre[chosen].T, *(flux[chosen] * length[chosen, None]).T, angles="xy",
                scale_units="xy", scale=1.0, width=0.0025, color="white", edgecolor=_OUTLINE,
                linewidth=0.4, pivot="mid")


def draw_field(run: RunDirectory, frame: Frame, field: str, path: Path, arrows: bool = False,
               colour_range: ColourRange | None = None) -> Path:
    """Writes the picture of `field` at the time of `frame` to `path` and returns it. Raises
    RunDirectoryError where the run has no such field."""
    shown = colour_range or ColourRange.of_frame(frame, field)
    factor = shown.scale.factor
    colours = {"cmap": "viridis", "norm": plt.Normalize(shown.low / factor, shown.high / factor)}
    figure, axes, is_wide = model_figure(frame.matrix.points)
    picture = _draw_matrix(axes, frame, field, colours, shown)
    if arrows or field == "flux":
        _draw_arrows(axes, frame)
    if frame.cracks is not None and len(frame.cracks.cells):
        _draw_cracks(axes, frame.cracks, field, colours, factor)
    extend = "max" if field == "flux" else "neither"
    figure.colorbar(picture, ax=axes, extend=extend, label=shown.scale.label(_LABEL[field]),
                    **({"orientation": "horizontal", "aspect": 40, "shrink": 0.7} if is_wide else
                       {"shrink": 0.85}))
    moment = f"t = {format_time(frame.time, time_scale(run.times))}"
    moment = "steady state" if run.is_steady else moment
    axes.set_title(f"{run.title}\n{_LABEL[field]}, {moment}", fontsize=11)
    figure.savefig(path, dpi=120, pil_kwargs={"optimize": True})
    plt.close(figure)
    return path
