# SPDX-License-Identifier: BSD-3-Clause
"""Draws the history of a run of mechanics: energies, balance, cracks, reactions, and the reaction
of each loaded boundary over its displacement."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from percolith.colours import BLACK, BLUE, RED
from percolith.history_picture import draw_curves
from percolith.run_directory import RunDirectory, Table
from percolith.units import Scale, length_scale, prefix_scale, time_scale

_HELD = {"kinetic_J_per_m": "kinetic", "elastic_J_per_m": "elastic", "joint_J_per_m": "joints",
         "contact_J_per_m": "contact"}
_EXCHANGED = {"external_work_J_per_m": "external work", "fluid_work_J_per_m": "fluid",
              "gravity_J_per_m": "gravity",
              "fracture_J_per_m": "fracture", "friction_J_per_m": "friction",
              "damping_J_per_m": "damping", "absorbed_J_per_m": "absorbed"}
_INPUT = ("external_work_J_per_m", "fluid_work_J_per_m", "gravity_J_per_m")
_SMALL = 1e-3  # share of the largest work of a reaction below which a boundary counts as not loaded
# Share of the largest energy of a run below which the work of all reactions is noise. Where fluid
# presses on a whole ring, or on opposite sides, the reaction is what rounding and an uneven mesh
# make of zero, and so is the displacement; their product was seen to be 1e-8 of the energy. It is
# of the size of the energy wherever a load deforms the rock. Work is compared rather than force,
# because the end of a slender arm bends under a force far below those inside it.
_NOISE = 1e-6
_FLAT = 5e-3  # share of the largest curve of a panel below which another lies on its zero line
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


def _present(history: Table, curves: dict[str, str]) -> dict[str, str]:
    """Those that are there and not zero throughout."""
    return {name: label for name, label in curves.items()
            if name in history and np.any(np.nan_to_num(history[name]) != 0.0)}


def _visible(history: Table, curves: dict[str, str]) -> dict[str, str]:
    """Those that can be told from zero beside the largest."""
    size = {name: np.nanmax(np.abs(history[name])) for name in _present(history, curves)}
    largest = max(size.values(), default=0.0)
    return {name: curves[name] for name in size if size[name] > _FLAT * largest}


def _scale(values: np.ndarray, unit: str) -> Scale:
    """Of the finite values: a run that failed may have others."""
    values = values[np.isfinite(values)]
    return length_scale(values) if unit == "m" else prefix_scale(values, unit)


def _reactions(history: Table) -> dict[str, str]:
    curves = {}
    for axis in "xy":
        ending = f".reaction_{axis}_N_per_m"
        curves |= {name: f"{name.removesuffix(ending)}, {axis}" for name in history.columns
                   if name.endswith(ending)}
    return _present(history, dict(sorted(curves.items())))


def _largest_energy(history: Table) -> float:
    """Of what is held and what comes in. What damping takes does not count: where the motion only
    serves to find a balance it may be anything."""
    names = [name for name in (*_HELD, *_INPUT) if name in history]
    return max((float(np.nanmax(np.abs(history[name]), initial=0.0)) for name in names),
               default=0.0)


def load_curves(history: Table) -> list[LoadCurve]:
    """One a loaded boundary or body: along the axis on which its reaction does most work. None
    where no reaction does more work than noise would."""
    best: dict[str, tuple[float, LoadCurve]] = {}
    for column, label in _reactions(history).items():
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


def _draw_group(axes, history: Table, time: Scale, curves: dict[str, str], unit: str,
                quantity: str) -> None:
    """Draws curves of one unit; hides the panel where there is none."""
    shown = _visible(history, curves)
    axes.set_visible(bool(shown))
    if shown:
        joined = np.concatenate([history[name] for name in shown])
        draw_curves(axes, history, time, shown, _scale(joined, unit), quantity)


def _draw_counts(axes, history: Table, time: Scale) -> None:
    """Broken joints on the left, fragments on the right."""
    moments = history["time_s"] / time.factor
    for one, name, colour, line in ((axes, "broken_joints", BLUE, "-"),
                                    (axes.twinx(), "fragments", RED, "--")):
        one.plot(moments, history[name], color=colour, drawstyle="steps-post", linestyle=line)
        one.set_ylabel(name.replace("_", " ").capitalize(), color=colour)
        one.set_ylim(0, 1.05 * max(1.0, np.nanmax(history[name], initial=0.0)))
        one.yaxis.get_major_locator().set_params(integer=True)


def _draw_residual(axes, history: Table, time: Scale) -> None:
    scale = _scale(history["residual_J_per_m"], "J/m")
    axes.plot(history["time_s"] / time.factor, history["residual_J_per_m"] / scale.factor,
              color=BLACK, linewidth=1.2)
    axes.set_ylabel(scale.label("Energy residual"))


def _draw_unbalance(axes, history: Table, time: Scale) -> None:
    shown = np.isfinite(history["unbalanced_ratio"]) & (history["unbalanced_ratio"] > 0)
    axes.set_visible(bool(shown.any()))
    axes.plot(history["time_s"][shown] / time.factor, history["unbalanced_ratio"][shown],
              color=BLACK, linewidth=1.2)
    axes.set_yscale("log")
    # Before anything is loaded there is no force to compare with.
    axes.set_ylim(top=min(axes.get_ylim()[1], 10.0))
    axes.set_ylabel("Unbalanced force ratio")


def draw_mechanics_history(run: RunDirectory, path: Path) -> Path:
    """Writes six panels to `path` and returns it: energies held, energies exchanged, residual of
    the energy balance, unbalanced force, numbers of broken joints and fragments, reactions."""
    history = run.history
    time = time_scale(history["time_s"])
    figure, grid = plt.subplots(3, 2, figsize=(11, 9.5), layout="constrained", sharex=True)
    _draw_group(grid[0, 0], history, time, _HELD, "J/m", "Energy held")
    _draw_group(grid[0, 1], history, time, _EXCHANGED, "J/m", "Energy exchanged")
    _draw_residual(grid[1, 0], history, time)
    _draw_unbalance(grid[1, 1], history, time)
    _draw_counts(grid[2, 0], history, time)
    _draw_group(grid[2, 1], history, time, _reactions(history), "N/m", "Reaction")
    for axes in grid.flat:
        axes.grid(alpha=0.3)
        axes.tick_params(labelbottom=True)
        axes.set_xlabel(time.label("Time"))
    figure.suptitle(run.title, fontsize=11)
    figure.savefig(path, dpi=120)
    plt.close(figure)
    return path


def _draw_load_curve(axes, curve: LoadCurve) -> None:
    """Loading reads from the lower left to the upper right, whatever its sign."""
    across, up = _scale(curve.displacement, "m"), _scale(curve.reaction, "N/m")
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


def draw_loading(run: RunDirectory, path: Path) -> Path | None:
    """Writes a panel a loaded boundary to `path` and returns it: its reaction over its mean
    displacement, with the peak. None, and no file, where nothing is loaded."""
    curves = load_curves(run.history)
    if not curves:
        return None
    columns = min(len(curves), 2)
    rows = -(-len(curves) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(5.5 * columns, 4.0 * rows + 0.4),
                                layout="constrained", squeeze=False)
    for axes, curve in zip(grid.flat, curves):
        _draw_load_curve(axes, curve)
    for axes in grid.flat[len(curves):]:
        axes.set_visible(False)
    figure.suptitle(run.title, fontsize=11)
    figure.savefig(path, dpi=120)
    plt.close(figure)
    return path
