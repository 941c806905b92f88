# SPDX-License-Identifier: BSD-3-Clause
"""Draws the reaction of each loaded boundary over its displacement."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from percolith.colours import BLUE, RED
from percolith.history_columns import HELD, INPUT, fitting_scale, reactions
from percolith.panels import panels_of
from percolith.run_directory import RunDirectory, Table

_SMALL = 1e-3  # share of the largest work of a reaction below which a boundary counts as not loaded
# Share of the largest energy of a run below which the work of all reactions is noise. Where fluid
# presses on a whole ring, or on opposite sides, the reaction is what rounding and an uneven mesh
# make of zero, and so is the displacement; their product was seen to be 1e-8 to 4e-6 of the energy.
# It is of the size of the energy wherever a load deforms the rock. Work is compared rather than
# force, because the end of a slender arm bends under a force far below those inside it.
_NOISE = 2e-5
_FALL = 0.05  # share of the largest reaction that it must lose again to be called a peak
_MINUS = "\N{MINUS SIGN}"


@dataclass(frozen=True)
class LoadCurve:
    """The reaction of one condition along one axis over its mean displacement."""

    name: str  # option path and axis: "boundary.top, y"
    displacement: np.ndarray  # m
    reaction: np.ndarray  # N/m

    @property
    def peak(self) -> int | None:
        """Row of the largest reaction, where it falls again; None where it still grows."""
        size = np.nan_to_num(np.abs(self.reaction))
        row = int(np.argmax(size))
        return row if size[row:].min() < (1.0 - _FALL) * size[row] else None


def _largest_energy(history: Table) -> float:
    """Of what is held and what comes in. What damping takes does not count: where the motion only
    serves to find a balance it may be anything."""
    names = [name for name in (*HELD, *INPUT) if name in history]
    return max((float(np.nanmax(np.abs(history[name]), initial=0.0)) for name in names),
               default=0.0)


def load_curves(history: Table) -> list[LoadCurve]:
    """One a loaded boundary or body: along the axis on which its reaction does most work. None
    where no reaction does more work than noise would."""
    best: dict[str, tuple[float, LoadCurve]] = {}
    for column, label in reactions(history).items():
        moved = column.replace(".reaction_", ".displacement_").replace("_N_per_m", "_m")
        if moved not in history:
            continue
        curve = LoadCurve(label, history[moved], history[column])
        work = float(np.nanmax(np.abs(curve.displacement * curve.reaction), initial=0.0))
        name = label.rsplit(",", 1)[0]
        if name not in best or work > best[name][0]:
            best[name] = (work, curve)
    largest = max((work for work, _ in best.values()), default=0.0)
    least = max(_SMALL * largest, _NOISE * _largest_energy(history))
    return [curve for work, curve in best.values() if work > 0.0 and work >= least]


def _draw_load_curve(axes, curve: LoadCurve) -> None:
    """Loading reads from the lower left to the upper right, whatever its sign."""
    across, up = fitting_scale(curve.displacement, "m"), fitting_scale(curve.reaction, "N/m")
    x, y = curve.displacement / across.factor, curve.reaction / up.factor
    axes.plot(x, y, color=BLUE, linewidth=1.4)
    title, peak = curve.name, curve.peak
    if peak is not None:
        axes.plot(x[peak], y[peak], marker="o", markersize=5, color=RED)
        values = f"peak {y[peak]:.4g} {up.unit} at {x[peak]:.3g} {across.unit}"
        title += "\n" + values.replace("-", _MINUS)
    axes.set_title(title, fontsize=10)
    axes.set_xlabel(across.label("Mean displacement"))
    axes.set_ylabel(up.label("Reaction"))
    for values, invert in ((x, axes.invert_xaxis), (y, axes.invert_yaxis)):
        if values[np.nanargmax(np.abs(values))] < 0.0:
            invert()
    axes.grid(alpha=0.3)


def loading_figure(run: RunDirectory):
    """A figure with a panel a loaded boundary: its reaction over its mean displacement, with the
    peak. None where nothing is loaded."""
    curves = load_curves(run.history)
    if not curves:
        return None
    figure, panels = panels_of(run, len(curves), 4.0)
    for axes, curve in zip(panels, curves):
        _draw_load_curve(axes, curve)
    return figure
