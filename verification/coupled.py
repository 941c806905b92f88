# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of rock with fluid in pores and cracks, for several verifications: fields at a few times
side by side, with the cracks in the colour of the pressure in them or of how they broke."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
import solid
from crack_paths import broken_lines, is_broken
from matplotlib.collections import LineCollection
from percolith import RunDirectory
from percolith.run_directory import Frame
from report import Chapter

PORES = "plasma"
STRESS = "RdBu_r"  # white where there is none, red tension


def _pore_pressure(frame: Frame) -> np.ndarray:
    """Mean of the triangles, MPa."""
    return frame.matrix.point_data["pressure_Pa"][frame.matrix.cells].mean(axis=1) / 1e6


def _crack_pressure(frame: Frame) -> np.ndarray:
    """Mean of the broken joints, MPa."""
    cells = frame.cracks.cells[is_broken(frame)]
    return frame.cracks.point_data["pressure_Pa"][cells].mean(axis=1) / 1e6


def has_cracks(frame: Frame) -> bool:
    return len(broken_lines(frame)) > 0


def _panels(number: int, frame: Frame, window):
    """Axes for `number` pictures of the same window, four in two rows so that each is large; the
    axes without labels of their own share those of their neighbours."""
    columns = 2 if number == 4 else number
    low, high = frame.matrix.points.min(axis=0), frame.matrix.points.max(axis=0)
    (left, right), (bottom, top) = window or zip(low, high)
    width = 4.2 if top - bottom < 1.2 * (right - left) else 3.2
    height = (width - 0.6) * (top - bottom) / (right - left) + 0.5  # labels and title apart
    rows = -(-number // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(width * columns + 1.0, height * rows),
                                layout="constrained", sharex=True, sharey=True, squeeze=False)
    return figure, list(axes.flat)


def balances(chapter: Chapter, name: str, run: RunDirectory) -> None:
    """Errors of both balances."""
    chapter.at_most(f"{name}.balance", f"{name}: error of the mass balance",
                    run.summary["mass_balance"]["relative_error"], 1e-12)
    chapter.at_most(f"{name}.energy", f"{name}: error of the energy balance",
                    run.summary["mechanics"]["energy_error"], 1e-3)


def break_modes(chapter: Chapter, run: RunDirectory) -> None:
    """How joints broke: a fluid opens rock, so shear helps at most."""
    modes = np.array(run.events["mode"])
    chapter.at_least("tensile", "share of the joints that broke by opening alone",
                     float(np.mean(modes == "tensile")), 0.2)
    chapter.at_most("shear", "share of the joints that broke by shear alone; the rest is mixed",
                    float(np.mean(modes == "shear")), 0.05)


def _finish(axes, title: str, window) -> None:
    axes.set_title(title, fontsize=11)
    axes.label_outer()
    if window is not None:
        axes.set_xlim(*window[0])
        axes.set_ylim(*window[1])


def _draw_pores(axes, frame: Frame, largest: float):
    """The pore pressure (MPa), without steps but for those across cracks; returns the artist."""
    grid = frame.matrix
    rock = axes.tripcolor(*grid.points.T, grid.cells, grid.point_data["pressure_Pa"] / 1e6,
                          shading="gouraud", cmap=PORES, vmin=0, vmax=largest)
    axes.set_aspect("equal")
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    return rock


def _draw_pressed(axes, frame: Frame, largest: float, edge: str, width: float = 2.0):
    """The cracks in the colours of the pressure in them, with an edge in a colour of its own;
    returns the artist, or None where there are none."""
    if not has_cracks(frame):
        return None
    lines = broken_lines(frame)
    axes.add_collection(LineCollection(lines, colors=edge, linewidths=width + 1.6))
    cracks = LineCollection(lines, array=_crack_pressure(frame), cmap=PORES, linewidths=width)
    cracks.set_clim(0, largest)
    return axes.add_collection(cracks)


def pressure_series(frames: list[tuple[str, Frame]], window=None, largest: float | None = None):
    """The pore pressure with the cracks in the colour of the pressure in them, edged in white, one
    colour scale for all. `window` is ((x, x), (y, y)) in m; `largest` cuts the scale, MPa."""
    if largest is None:
        largest = max(np.percentile(_pore_pressure(frame), 99.9) for _, frame in frames)
    figure, panels = _panels(len(frames), frames[0][1], window)
    for (title, frame), axes in zip(frames, panels):
        rock = _draw_pores(axes, frame, largest)
        _draw_pressed(axes, frame, largest, "white")
        _finish(axes, title, window)
    beyond = any(_pore_pressure(frame).max() > largest for _, frame in frames)
    figure.colorbar(rock, ax=panels, label="Pressure in pores and cracks (MPa)", shrink=0.8,
                    extend="max" if beyond else "neither")
    return figure


def crack_pressure_series(frames: list[tuple[str, Frame]], largest: float, window=None):
    """The cracks alone in the colour of the pressure in them, up to `largest` (MPa), one colour
    scale for all."""
    figure, panels = _panels(len(frames), frames[0][1], window)
    for (title, frame), axes in zip(frames, panels):
        solid.draw_rock(axes, frame)
        cracks = _draw_pressed(axes, frame, largest, "#606060", 3.0)
        _finish(axes, title, window)
    figure.colorbar(cracks, ax=panels, label="Pressure in cracks (MPa)", shrink=0.8, extend="max")
    return figure


def stress_series(frames: list[tuple[str, Frame]], limits: tuple[float, float], window=None):
    """The effective principal stress that is most tensile, in `limits` (MPa), and the cracks by
    how they broke."""
    figure, panels = _panels(len(frames), frames[0][1], window)
    for (title, frame), axes in zip(frames, panels):
        values = frame.matrix.cell_data["principal_stress_1_Pa"] / 1e6
        rock = solid.draw_rock(axes, frame, values, limits, colours=STRESS)
        axes.add_collection(LineCollection(broken_lines(frame), colors="black", linewidths=2.6))
        solid.draw_cracks(axes, frame)
        _finish(axes, title, window)
    figure.colorbar(rock, ax=panels, label="Principal stress, most tensile (MPa)", shrink=0.8,
                    extend="both")
    return figure


def at_times(run: RunDirectory, times: list[float], unit: float = 1e-3, name: str = "ms"):
    """(title, frame) at each of the times (s)."""
    frames = [run.frame(time) for time in times]
    return [(f"{frame.time / unit:.4g} {name}", frame) for frame in frames]
