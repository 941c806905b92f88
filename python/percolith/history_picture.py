# SPDX-License-Identifier: BSD-3-Clause
"""Draws the history of flow: mass balance, its error, extremes of the pressure, rates."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np

from percolith.run_directory import RunDirectory, Table
from percolith.units import Scale, power_scale, pressure_scale, time_scale

_LEGEND_WIDTH = 100  # letters of small type across a panel; a handle takes 13


def draw_curves(axes, history: Table, time: Scale, curves: dict[str, str], scale: Scale,
                quantity: str) -> None:
    """Draws columns of a history over time; `curves` gives each of them its name in the legend,
    which is left out where they have none."""
    moments = history["time_s"] / time.factor
    marker = "." if len(history) <= 100 else ""
    colours = plt.cm.viridis(np.linspace(0.0, 0.85, max(len(curves), 2)))
    styles = ["-", "--", "-.", ":"]
    for i, (column, label) in enumerate(curves.items()):
        axes.plot(moments, history[column] / scale.factor, label=label, color=colours[i],
                  linestyle=styles[i % 4], marker=marker)
    axes.set_ylabel(scale.label(quantity))
    if not any(curves.values()):
        return
    # Above the panel: no place inside is free of curves in every run.
    columns = max(1, _LEGEND_WIDTH // (13 + max(map(len, curves.values()))))
    rows = -(-len(curves) // columns)
    axes.legend(fontsize="small", frameon=False, loc="lower left", bbox_to_anchor=(0.0, 1.0),
                borderpad=0.0, columnspacing=1.2,
                ncols=-(-len(curves) // rows))


def _rates(history: Table) -> dict[str, str]:
    ending = "_m2_per_s"
    return {name: name.removesuffix(ending) for name in history.columns if name.endswith(ending)}


def _extremes(history: Table) -> dict[str, str]:
    curves = {"minimum_pressure_Pa": "pores, lowest", "maximum_pressure_Pa": "pores, highest",
              "minimum_crack_pressure_Pa": "cracks, lowest",
              "maximum_crack_pressure_Pa": "cracks, highest"}
    return {name: label for name, label in curves.items()
            if name in history and np.isfinite(history[name]).any()}


def history_figure(run: RunDirectory):
    """A figure of four panels: fluid volumes, relative error of the mass balance, extremes of the
    pressure, rate of each condition."""
    history = run.history
    time = time_scale(history["time_s"])
    figure, grid = plt.subplots(2, 2, figsize=(11, 7), layout="constrained", sharex=True)
    volumes = {"in_m2": "in", "out_m2": "out", "stored_m2": "stored"}
    joined = np.concatenate([history[name] for name in volumes])
    draw_curves(grid[0, 0], history, time, volumes, power_scale(joined, "m³/m"), "Fluid volume")
    error = {"relative_error": "error over fluid in place and throughput"}
    draw_curves(grid[0, 1], history, time, error, Scale(1.0, ""), "Mass balance error")
    grid[0, 1].set_yscale("symlog", linthresh=1e-16)
    grid[0, 1].set_ylim(bottom=0, top=max(1e-11, 2 * np.nanmax(history["relative_error"])))
    extremes = _extremes(history)
    joined = np.concatenate([history[name] for name in extremes])
    draw_curves(grid[1, 0], history, time, extremes, pressure_scale(joined), "Pressure")
    rates = _rates(history)
    if rates:
        joined = np.concatenate([history[name] for name in rates])
        draw_curves(grid[1, 1], history, time, rates, power_scale(joined, "m²/s"),
                    "Rate into the model")
    grid[1, 1].set_visible(bool(rates))
    for axes in grid.flat:
        axes.grid(alpha=0.3)
    for axes in grid[1]:
        axes.set_xlabel(time.label("Time"))
    figure.suptitle(run.title, fontsize=11)
    return figure
