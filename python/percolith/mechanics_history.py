# SPDX-License-Identifier: BSD-3-Clause
"""Draws the history of a run of mechanics: energies, balance, cracks and reactions."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from percolith.colours import BLACK, BLUE, RED
from percolith.history_columns import HELD, fitting_scale, present, reactions
from percolith.history_picture import draw_curves
from percolith.run_directory import RunDirectory, Table
from percolith.saving import save
from percolith.units import Scale, time_scale

_EXCHANGED = {"external_work_J_per_m": "external work", "fluid_work_J_per_m": "fluid",
              "gravity_J_per_m": "gravity",
              "fracture_J_per_m": "fracture", "friction_J_per_m": "friction",
              "damping_J_per_m": "damping", "absorbed_J_per_m": "absorbed"}
# Share of the force that goes with the strain energy. Under fluid on whole rings noise was seen to
# be 1e-5 of it; a slender arm is bent by a hundredth.
_NOISE_OF_FORCE = 1e-4
_FLAT = 5e-3  # share of the largest curve of a panel below which another lies on its zero line


def _visible(history: Table, curves: dict[str, str]) -> dict[str, str]:
    """Those that can be told from zero beside the largest."""
    size = {name: np.nanmax(np.abs(history[name])) for name in present(history, curves)}
    largest = max(size.values(), default=0.0)
    return {name: curves[name] for name in size if size[name] > _FLAT * largest}


def force_scale(run: RunDirectory) -> float:
    """The force (N/m) that goes with the strain energy W of a run, sqrt(2 E W): stress
    sqrt(2 E W/A) on the width sqrt(A) of the area A that it is in. E is the largest Young's
    modulus; 0 where nothing has one."""
    moduli = [table.get("young_modulus") for table in run.resolved.get("material", {}).values()]
    stiffest = max((value for value in moduli if isinstance(value, float | int)), default=0.0)
    energy = np.nanmax(np.abs(run.history["elastic_J_per_m"]), initial=0.0)
    return float(np.sqrt(2.0 * stiffest * energy))


def _reactions_to_show(run: RunDirectory) -> dict[str, str]:
    """The reactions, where any is more than what rounding and an uneven mesh make of zero, as where
    fluid presses on a whole ring."""
    curves = reactions(run.history)
    largest = max((np.nanmax(np.abs(run.history[name])) for name in curves), default=0.0)
    return curves if largest > _NOISE_OF_FORCE * force_scale(run) else {}


def _draw_group(axes, history: Table, time: Scale, curves: dict[str, str], unit: str,
                quantity: str) -> None:
    """Draws curves of one unit; hides the panel where there is none."""
    shown = _visible(history, curves)
    axes.set_visible(bool(shown))
    if shown:
        joined = np.concatenate([history[name] for name in shown])
        draw_curves(axes, history, time, shown, fitting_scale(joined, unit), quantity)


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
    scale = fitting_scale(history["residual_J_per_m"], "J/m")
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


def mechanics_history_figure(run: RunDirectory):
    """A figure of six panels: energies held, energies exchanged, residual of the energy balance,
    unbalanced force, numbers of broken joints and fragments, reactions."""
    history = run.history
    time = time_scale(history["time_s"])
    figure, grid = plt.subplots(3, 2, figsize=(11, 9.5), layout="constrained", sharex=True)
    _draw_group(grid[0, 0], history, time, HELD, "J/m", "Energy held")
    _draw_group(grid[0, 1], history, time, _EXCHANGED, "J/m", "Energy exchanged")
    _draw_residual(grid[1, 0], history, time)
    _draw_unbalance(grid[1, 1], history, time)
    _draw_counts(grid[2, 0], history, time)
    _draw_group(grid[2, 1], history, time, _reactions_to_show(run), "N/m", "Reaction")
    for axes in grid.flat:
        axes.grid(alpha=0.3)
        axes.tick_params(labelbottom=True)
        axes.set_xlabel(time.label("Time"))
    figure.suptitle(run.title, fontsize=11)
    return figure


def draw_mechanics_history(run: RunDirectory, path: Path) -> Path:
    """Writes the figure to `path` and returns it."""
    return save(mechanics_history_figure(run), path)
