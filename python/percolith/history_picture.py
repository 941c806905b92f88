# SPDX-License-Identifier: BSD-3-Clause
"""Draws the history of flow: mass balance, its error, extremes of the pressure, rates."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np

from percolith.run_directory import RunDirectory, Table
from percolith.units import Scale, format_value, power_scale, pressure_scale, time_scale

_MOMENTS = 0.03  # of the time of a run
_CUT_ABOVE = 3.0  # times the range of what lasts longer than moments
_LEGEND_WIDTH = 100  # letters of small type across a panel; a handle takes 13
_LEGEND_ROWS = 4  # at most above a panel
_GREY = "#A0A0A0"  # of curves without a name


def largest_curves(history: Table, names: list[str], count: int) -> list[str]:
    """So many of the columns, those that come farthest from zero, in the order they are in."""
    def size(name: str) -> float:
        values = np.abs(history[name])
        return float(np.max(values[np.isfinite(values)], initial=0.0))

    kept = sorted(names, key=size, reverse=True)[:count]
    return [name for name in names if name in kept]


def _named(history: Table, curves: dict[str, str]) -> tuple[list[str], int]:
    """The columns that a legend of few rows names, and in how many columns: where they are too many
    those that are largest, with a place left for the others."""
    columns = max(1, _LEGEND_WIDTH // (13 + max(map(len, curves.values()))))
    if len(curves) <= columns * _LEGEND_ROWS:
        rows = -(-len(curves) // columns)
        return list(curves), -(-len(curves) // rows)
    return largest_curves(history, list(curves), columns * _LEGEND_ROWS - 1), columns


def draw_curves(axes, history: Table, time: Scale, curves: dict[str, str], scale: Scale,
                quantity: str) -> None:
    """Draws columns of a history over time; `curves` gives each of them its name in the legend,
    which is left out where they have none. Of many curves the largest have names and colours, the
    others are thin and grey."""
    moments = history["time_s"] / time.factor
    marker = "." if len(history) <= 100 else ""
    named, columns = _named(history, curves)
    colours = plt.cm.viridis(np.linspace(0.0, 0.85, max(len(named), 2)))
    styles = ["-", "--", "-.", ":"]
    for i, column in enumerate(named):
        axes.plot(moments, history[column] / scale.factor, label=curves[column], color=colours[i],
                  linestyle=styles[i % 4], marker=marker)
    others = [column for column in curves if column not in named]
    for i, column in enumerate(others):
        label = f"{len(others)} others, smaller" if i == 0 else None
        axes.plot(moments, history[column] / scale.factor, label=label, color=_GREY, linewidth=0.8,
                  zorder=1.5)
    axes.set_ylabel(scale.label(quantity))
    if any(curves.values()):
        # Above the panel: no place inside is free of curves in every run.
        axes.legend(fontsize="small", frameon=False, loc="lower left", bbox_to_anchor=(0.0, 1.0),
                    borderpad=0.0, columnspacing=1.2, ncols=columns)


def lasting_range(time: np.ndarray, curves: np.ndarray) -> tuple[float, float]:
    """The ends of a range that has 0 in it and that each of the curves (n, times) leaves on either
    side for moments only: a small share of the time."""
    share = np.gradient(time) if len(time) > 1 else np.ones(len(time))
    low, high = 0.0, 0.0
    for values in curves:
        known = np.isfinite(values)
        order = np.argsort(values[known], kind="stable")
        passed = np.cumsum(share[known][order])
        if not len(order) or passed[-1] <= 0.0:
            continue
        first, last = np.searchsorted(passed, np.array([_MOMENTS, 1.0 - _MOMENTS]) * passed[-1])
        low = min(low, values[known][order[first]])
        high = max(high, values[known][order[last]])
    return float(low), float(high)


def _rates(history: Table) -> dict[str, str]:
    ending = "_m2_per_s"
    return {name: name.removesuffix(ending) for name in history.columns if name.endswith(ending)}


def _draw_rates(axes, history: Table, time: Scale, rates: dict[str, str]) -> None:
    """The rate of each condition. Where a jump of a pressure lets in far more for a moment than
    later, the panel ends at what lasts, and tells of the rest."""
    joined = np.array([history[name] for name in rates])
    ends = lasting_range(history["time_s"], joined)
    lowest, highest = min(0.0, float(np.nanmin(joined))), max(0.0, float(np.nanmax(joined)))
    is_cut = highest - lowest > _CUT_ABOVE * (ends[1] - ends[0]) > 0.0
    scale = power_scale(np.array(ends) if is_cut else joined, "m²/s")
    draw_curves(axes, history, time, rates, scale, "Rate into the model")
    if not is_cut:
        return
    margin = 0.15 * (ends[1] - ends[0])
    low, high = max(ends[0] - margin, lowest), min(ends[1] + margin, highest)
    axes.set_ylim((low - 0.2 * margin) / scale.factor, (high + 0.2 * margin) / scale.factor)
    beyond = [f"{word} {format_value(value, power_scale([value], 'm²/s'))}"
              for word, value, is_beyond in (("up to", highest, highest > high),
                                             ("down to", lowest, lowest < low)) if is_beyond]
    axes.text(0.98, 0.96, "for moments beyond the panel: " + ", ".join(beyond), ha="right",
              va="top", fontsize="small", transform=axes.transAxes,
              bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.8, "pad": 2.0})


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
        _draw_rates(grid[1, 1], history, time, rates)
    grid[1, 1].set_visible(bool(rates))
    for axes in grid.flat:
        axes.grid(alpha=0.3)
    for axes in grid[1]:
        axes.set_xlabel(time.label("Time"))
    figure.suptitle(run.title, fontsize=11)
    return figure
