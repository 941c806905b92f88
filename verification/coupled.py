# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of rock that fluid breaks, for several verifications: fields at a few times side by
side, with the cracks in the colour of the pressure in them or of how they broke."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
import solid
from crack_paths import broken_lines
from matplotlib.collections import LineCollection
from percolith import RunDirectory
from percolith.run_directory import Frame
from report import Chapter

PORES = "plasma"
STRESS = "viridis"


def _pore_pressure(frame: Frame) -> np.ndarray:
    """Mean of the triangles, MPa."""
    return frame.matrix.point_data["pressure_Pa"][frame.matrix.cells].mean(axis=1) / 1e6


def _crack_pressure(frame: Frame) -> np.ndarray:
    """Mean of the broken joints, MPa."""
    cells = frame.cracks.cells[frame.cracks.cell_data["mode"] >= 0]
    return frame.cracks.point_data["pressure_Pa"][cells].mean(axis=1) / 1e6


def has_cracks(frame: Frame) -> bool:
    return len(broken_lines(frame)) > 0


def break_modes(chapter: Chapter, run: RunDirectory) -> None:
    """How joints broke: a fluid opens rock, so shear helps at most."""
    modes = np.array(run.events["mode"])
    chapter.at_least("tensile", "share of the joints that broke by opening alone",
                     float(np.mean(modes == "tensile")), 0.2)
    chapter.at_most("shear", "share of the joints that broke by shear alone; the rest is mixed",
                    float(np.mean(modes == "shear")), 0.05)


def _panels(number: int):
    return plt.subplots(1, number, figsize=(4.2 * number, 4.2), layout="constrained", sharey=True,
                        squeeze=False)


def _finish(axes, title: str, window) -> None:
    axes.set_title(title, fontsize=10)
    if window is not None:
        axes.set_xlim(*window[0])
        axes.set_ylim(*window[1])


def pressure_series(frames: list[tuple[str, Frame]], window=None, largest: float | None = None):
    """The pore pressure with the cracks in the colour of the pressure in them, one colour scale
    for all. `window` is ((x, x), (y, y)) in m; `largest` cuts the scale of the pores, MPa."""
    if largest is None:
        largest = max(np.percentile(_pore_pressure(frame), 99.9) for _, frame in frames)
    figure, row = _panels(len(frames))
    for (title, frame), axes in zip(frames, row[0]):
        rock = solid.draw_rock(axes, frame, _pore_pressure(frame), (0, largest), colours=PORES)
        if has_cracks(frame):
            lines = broken_lines(frame)
            axes.add_collection(LineCollection(lines, colors="white", linewidths=3.0))
            cracks = LineCollection(lines, array=_crack_pressure(frame), cmap=PORES,
                                    linewidths=1.8)
            cracks.set_clim(0, largest)
            axes.add_collection(cracks)
        _finish(axes, title, window)
    figure.colorbar(rock, ax=row[0].tolist(), label="Pressure (MPa)", shrink=0.8, extend="max")
    return figure


def stress_series(frames: list[tuple[str, Frame]], limits: tuple[float, float], window=None):
    """The effective principal stress that is most tensile, in `limits` (MPa), and the cracks by
    how they broke."""
    figure, row = _panels(len(frames))
    for (title, frame), axes in zip(frames, row[0]):
        values = frame.matrix.cell_data["principal_stress_1_Pa"] / 1e6
        rock = solid.draw_rock(axes, frame, values, limits, colours=STRESS)
        solid.draw_cracks(axes, frame)
        _finish(axes, title, window)
    figure.colorbar(rock, ax=row[0].tolist(), label="Principal stress, most tensile (MPa)",
                    shrink=0.8, extend="both")
    return figure


def at_times(run: RunDirectory, times: list[float], unit: float = 1e-3, name: str = "ms"):
    """(title, frame) at each of the times (s)."""
    frames = [run.frame(time) for time in times]
    return [(f"{frame.time / unit:.4g} {name}", frame) for frame in frames]
