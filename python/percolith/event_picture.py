# SPDX-License-Identifier: BSD-3-Clause
"""Draws the joints that broke: when, where, how, and how many of which magnitude."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

from percolith.b_value import BValue, b_value, reason_for_none
from percolith.colours import BLACK, BLUE, RED
from percolith.crack_picture import MODES
from percolith.outline import outline_of
from percolith.run_directory import RunDirectory, Table
from percolith.saving import save
from percolith.units import prefix_scale, time_scale

_MARKERS = {"tensile": "o", "shear": "^", "mixed": "s"}
_SMALLER = 0.4  # of the area of markers, where they lie side by side along a crack
_SMALL = 0.3  # of the extent of the model
_MINUS = "\N{MINUS SIGN}"


def _sizes(magnitude: np.ndarray) -> np.ndarray:
    """Areas of the markers, from the smallest magnitude to the largest."""
    finite = magnitude[np.isfinite(magnitude)]
    if not len(finite) or np.ptp(finite) == 0.0:
        return np.full(len(magnitude), 24.0)
    share = (np.clip(magnitude, finite.min(), finite.max()) - finite.min()) / np.ptp(finite)
    return 12.0 + 68.0 * share**2


def _scatter(axes, events: Table, x: np.ndarray, y: np.ndarray, share: float = 1.0) -> None:
    sizes = share * _sizes(events["magnitude"])
    for mode, colour in MODES.values():
        chosen = events["mode"] == mode
        if chosen.any():
            axes.scatter(x[chosen], y[chosen], s=sizes[chosen], color=colour,
                         marker=_MARKERS[mode], alpha=0.7, linewidths=0.0,
                         label=f"{mode} ({chosen.sum()})")
    if len(events):
        axes.legend(fontsize="small", frameon=False, loc="lower left", bbox_to_anchor=(0.0, 1.0),
                    borderpad=0.0, ncols=3, handletextpad=0.2)


def _outline(run: RunDirectory) -> np.ndarray:
    """Ends of the undeformed outline of the model, (n, 2, 2), at the last time whose file is
    sound: what an excavation has changed is no reason to go without a picture of events."""
    matrix = run.sound_matrix(reversed(run.times)) if run.times else run.frame().matrix
    return matrix.points[outline_of(matrix).points]


def shown_window(outline: np.ndarray, places: np.ndarray) -> np.ndarray:
    """Lower left and upper right end (2, 2) of what is shown: the model, or, where the events fill
    but a small part of it, their surroundings."""
    low, high = outline.min(axis=(0, 1)), outline.max(axis=(0, 1))
    margin = 0.03 * (high - low).max()
    first, last = places.min(axis=0), places.max(axis=0)
    extent = (last - first).max()
    if len(places) > 1 and 0.0 < extent < _SMALL * (high - low).max():
        middle = 0.5 * (first + last)
        low, high = np.maximum(low, middle - extent), np.minimum(high, middle + extent)
    return np.stack([low - margin, high + margin])


def _draw_places(axes, run: RunDirectory, events: Table, window: np.ndarray | None) -> None:
    ends = window
    if window is not None:
        places = np.stack([events["x_m"], events["y_m"]], axis=1)
        events = events.where(((places >= window[0]) & (places <= window[1])).all(axis=1))
    _scatter(axes, events, events["x_m"], events["y_m"], _SMALLER)
    if run.times:
        outline = _outline(run)
        axes.add_collection(LineCollection(outline, colors="#808080", linewidths=0.8),
                            autolim=False)
        if window is None:
            ends = shown_window(outline, np.stack([events["x_m"], events["y_m"]], axis=1))
    if ends is not None:
        axes.set_xlim(ends[:, 0])
        axes.set_ylim(ends[:, 1])
    axes.set_aspect("equal", adjustable="box")
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")


def _draw_energy(axes, events: Table, time) -> None:
    released = np.cumsum(events["released_energy_J_per_m"])
    scale = prefix_scale(released, "J/m")
    axes.step(events["time_s"] / time.factor, released / scale.factor, where="post", color=BLACK)
    axes.set_ylim(bottom=0)
    axes.set_xlabel(time.label("Time"))
    axes.set_ylabel(scale.label("Released energy, summed"))


def _draw_fit(axes, fit: BValue, largest: float) -> None:
    ends = np.array([fit.smallest, max(largest, fit.smallest + 0.1)])
    label = f"b = {fit.value:.2f} ± {fit.error:.2f} from M = {fit.smallest:.1f} on".replace(
        "= -", f"= {_MINUS}")
    axes.plot(ends, fit.number_above(ends), color=RED, linewidth=1.6,
              label=f"{label} ({fit.count} events)")


def _draw_numbers(axes, events: Table) -> None:
    """Numbers over the magnitude, with the b-value or the reason why there is none."""
    magnitude = np.sort(events["magnitude"][np.isfinite(events["magnitude"])])
    axes.set_visible(len(magnitude) > 0)
    if not len(magnitude):
        return
    axes.plot(magnitude, np.arange(len(magnitude), 0, -1), linestyle="none", marker="o",
              markersize=3.5, color=BLUE, label="events")
    axes.set_yscale("log")
    fit = b_value(magnitude)
    if fit is None:
        axes.set_title(f"no b-value: {reason_for_none(magnitude)}", fontsize="small", loc="left")
    else:
        _draw_fit(axes, fit, magnitude[-1])
        axes.legend(fontsize="small", frameon=False, loc="lower left", bbox_to_anchor=(0.0, 1.0),
                    borderpad=0.0, ncols=2)
    axes.set_ylim(bottom=0.7)
    axes.set_xlabel("Magnitude M")
    axes.set_ylabel("Number of events of M or more")


def events_figure(run: RunDirectory, window: np.ndarray | None = None):
    """A figure of four panels: magnitudes over time, places, released energy, and the numbers over
    the magnitude with the b-value. None where no joint broke. `window` gives lower left and upper
    right end (2, 2) of the map of places, in m; the other panels count every event."""
    events = run.events if run.has_mechanics else ()
    if not len(events):
        return None
    time = time_scale(events["time_s"])
    figure, grid = plt.subplots(2, 2, figsize=(11, 8.5), layout="constrained")
    _scatter(grid[0, 0], events, events["time_s"] / time.factor, events["magnitude"])
    grid[0, 0].set_xlabel(time.label("Time"))
    grid[0, 0].set_ylabel("Magnitude M")
    _draw_places(grid[0, 1], run, events, window)
    _draw_energy(grid[1, 0], events, time)
    _draw_numbers(grid[1, 1], events)
    for axes in (grid[0, 0], grid[1, 0], grid[1, 1]):
        axes.grid(alpha=0.3)
    figure.suptitle(run.title, fontsize=11)
    return figure


def draw_events(run: RunDirectory, path: Path, window: np.ndarray | None = None) -> Path | None:
    """Writes the figure to `path` and returns it. None, and no file, where no joint broke."""
    figure = events_figure(run, window)
    return save(figure, path) if figure else None
