# SPDX-License-Identifier: BSD-3-Clause
"""Draws how fluid drives cracks: the pressure at which it is injected; length, volume and aperture
of the cracks; where the fluid went."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from percolith.crack_words import open_to_fluid
from percolith.history_picture import draw_curves
from percolith.panels import panels_of
from percolith.run_directory import RunDirectory, Table
from percolith.saving import save
from percolith.units import Scale, length_scale, power_scale, pressure_scale, time_scale

_PRESSURE, _VOLUME = ".pressure_Pa", ".volume_m2"
_VOLUMES = {"crack_volume_m2": "space in cracks", "crack_fluid_m2": "fluid in cracks"}


def _ending(history: Table, ending: str) -> dict[str, str]:
    """The columns that end so, with what stands before it."""
    return {name: name.removesuffix(ending) for name in history.columns if name.endswith(ending)}


def _groups(run: RunDirectory,
            history: Table) -> list[tuple[dict[str, str], Callable[[np.ndarray], Scale], str]]:
    """Columns with their names, choice of unit and quantity of each panel."""
    def volume_scale(values: np.ndarray) -> Scale:
        return power_scale(values, "m³/m")

    lengths = {"crack_length_m": open_to_fluid(run), "filled_crack_length_m": "full of fluid"}
    let_in = _ending(history, _VOLUME) | {"leaked_m2": "from cracks into the rock"}
    return [(_ending(history, _PRESSURE), pressure_scale, "Pressure at the source"),
            (lengths, length_scale, "Length of cracks"),
            (_VOLUMES, volume_scale, "Volume"),
            ({"mean_aperture_m": ""}, length_scale, "Mean hydraulic aperture"),
            (let_in, volume_scale, "Volume that went in")]


def _finite(history: Table, names) -> np.ndarray:
    joined = np.concatenate([history[name] for name in names])
    return joined[np.isfinite(joined)]


def _panels(run: RunDirectory, history: Table) -> list[tuple[dict[str, str], Scale, str]]:
    """Columns with their names, unit and quantity of each panel that has something to show."""
    panels = []
    for curves, scale_of, quantity in _groups(run, history):
        present = {name: label for name, label in curves.items()
                   if name in history and _finite(history, [name]).any()}
        if present:
            panels.append((present, scale_of(_finite(history, present)), quantity))
    return panels


def _without_mean_of_none(history: Table) -> Table:
    """The history with no mean aperture while there is no crack, which its column gives as 0."""
    if "mean_aperture_m" not in history or "crack_length_m" not in history:
        return history
    mean = np.where(history["crack_length_m"] > 0.0, history["mean_aperture_m"], np.nan)
    return Table({**history.columns, "mean_aperture_m": mean})


def crack_growth_figure(run: RunDirectory):
    """A figure with a panel a quantity. None in a run whose history has none of them."""
    history = _without_mean_of_none(run.history)
    panels = _panels(run, history)
    if not panels:
        return None
    time = time_scale(history["time_s"])
    figure, all_axes = panels_of(run, len(panels), 3.3)
    for axes, (curves, scale, quantity) in zip(all_axes, panels):
        draw_curves(axes, history, time, curves, scale, quantity)
        values = _finite(history, curves) / scale.factor
        if not (values < 0.0).any():
            axes.set_ylim(0.0, 1.05 * values.max())
        axes.set_xlabel(time.label("Time"))
        axes.grid(alpha=0.3)
    return figure


def draw_crack_growth(run: RunDirectory, path: Path) -> Path | None:
    """Writes the figure to `path` and returns it. None, and no file, where there is none."""
    figure = crack_growth_figure(run)
    return save(figure, path) if figure else None
