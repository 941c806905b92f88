# SPDX-License-Identifier: BSD-3-Clause
"""Draws how fluid drives cracks: the pressure at which it is injected; length, volume and aperture
of the cracks over time."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from percolith.history_picture import draw_curves
from percolith.run_directory import RunDirectory, Table
from percolith.units import Scale, length_scale, power_scale, pressure_scale, time_scale

_INJECTION = ".pressure_Pa"
_SIZES = {
    "crack_length_m": ("Length of cracks", length_scale),
    "crack_volume_m2": ("Volume of cracks", lambda values: power_scale(values, "m³/m")),
    "mean_aperture_m": ("Mean aperture", length_scale),
}


def _injection(history: Table) -> dict[str, str]:
    """The columns of the pressure at sources, with the name of each."""
    return {name: name.removesuffix(_INJECTION) for name in history.columns
            if name.startswith("source.") and name.endswith(_INJECTION)}


def _finite(history: Table, names) -> np.ndarray:
    joined = np.concatenate([history[name] for name in names])
    return joined[np.isfinite(joined)]


def _panels(history: Table) -> list[tuple[dict[str, str], Scale, str]]:
    """Columns with their names, unit and quantity of each panel that has something to show."""
    panels = []
    injection = _injection(history)
    if injection and len(_finite(history, injection)):
        scale = pressure_scale(_finite(history, injection))
        panels.append((injection, scale, "Pressure at the source"))
    for name, (quantity, scale_of) in _SIZES.items():
        if name in history and _finite(history, [name]).any():
            panels.append(({name: ""}, scale_of(_finite(history, [name])), quantity))
    return panels


def draw_crack_growth(run: RunDirectory, path: Path) -> Path | None:
    """Writes a panel a quantity to `path` and returns it. None, and no file, in a run whose history
    has none of them."""
    history = run.history
    panels = _panels(history)
    if not panels:
        return None
    time = time_scale(history["time_s"])
    columns = min(len(panels), 2)
    rows = -(-len(panels) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(5.5 * columns, 3.3 * rows + 0.4),
                                layout="constrained", squeeze=False)
    for axes, (curves, scale, quantity) in zip(grid.flat, panels):
        draw_curves(axes, history, time, curves, scale, quantity)
        if not (_finite(history, curves) < 0.0).any():
            axes.set_ylim(bottom=0.0)
        axes.set_xlabel(time.label("Time"))
        axes.grid(alpha=0.3)
    for axes in grid.flat[len(panels):]:
        axes.set_visible(False)
    figure.suptitle(run.title, fontsize=11)
    figure.savefig(path, dpi=120)
    plt.close(figure)
    return path
