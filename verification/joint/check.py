# SPDX-License-Identifier: BSD-3-Clause
"""A single joint: the energy that breaks it in opening, sliding and between; the hand-over to
contact under pressure."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import run_case
from report import Chapter
from solid_formulas import mixed_energy

TITLE = "A single joint: fracture energies, and breakage under pressure"
HERE = Path(__file__).parent
LENGTH, STRENGTH, COHESION, MODE_1, MODE_2 = 0.1, 5e6, 10e6, 100.0, 200.0
SPEED = 0.01  # m/s


def parting(history, direction: float):
    """How far the sides moved (m), the force along the motion (N/m)."""
    force = (history["body.upper.reaction_x_N_per_m"] * np.sin(direction)
             + history["body.upper.reaction_y_N_per_m"] * np.cos(direction))
    return SPEED * history["time_s"], force


def energies(chapter: Chapter, work: Path) -> None:
    figure, axes = plt.subplots(figsize=(7, 4.4), layout="constrained")
    directions = {"mode_1": 0.0, "mixed": np.pi / 4, "mode_2": np.pi / 2}
    for (name, direction), colour in zip(directions.items(), plt.cm.viridis([0.1, 0.5, 0.8])):
        velocity = SPEED * np.array([np.sin(direction), np.cos(direction)])
        run = run_case(HERE / "case.toml", work / name,
                       {"body.upper.velocity_x": float(velocity[0]),
                        "body.upper.velocity_y": float(velocity[1])}).results
        moved, force = parting(run.history, direction)
        expected = mixed_energy(direction, STRENGTH, COHESION, MODE_1, MODE_2)
        work_done = np.trapezoid(force, moved) / LENGTH
        chapter.at_most(f"{name}.work", f"{name}: work of the force over the area, relative "
                        f"difference from {expected:.1f} J/m2", abs(work_done / expected - 1), 0.01)
        spent = run.history["fracture_J_per_m"][-1] / LENGTH
        chapter.at_most(f"{name}.joint", f"{name}: energy spent in the joint, the same",
                        abs(spent / expected - 1), 0.01)
        chapter.at_most(f"{name}.energy", f"{name}: error of the energy balance",
                        solid.residual(run), 1e-3)
        axes.plot(moved * 1e6, force / LENGTH / 1e6, color=colour,
                  label=f"{name.replace('_', ' ')}: {work_done:.1f} J/m²")
    axes.set_xlabel("Displacement of one side (µm)")
    axes.set_ylabel("Traction along it (MPa)")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Traction of a joint that is opened, sheared, and both alike")


def pressed(chapter: Chapter, work: Path) -> None:
    run = run_case(HERE / "pressed.toml", work / "pressed").results
    history = run.history
    time = history["time_s"]
    shear = history["body.upper.reaction_x_N_per_m"] / LENGTH
    normal = -history["body.upper.reaction_y_N_per_m"] / LENGTH
    pressure = normal[time <= 1e-3][-1]
    peak = COHESION + pressure * np.tan(np.pi / 6)
    chapter.at_most("pressed.peak", "pressed: peak of the shear traction, relative difference from "
                    "c + p tan(phi)", abs(shear.max() / peak - 1), 0.01)
    chapter.at_most("pressed.friction", "pressed: shear traction at the end, relative difference "
                    "from p tan(phi)", abs(shear[-1] / (normal[-1] * np.tan(np.pi / 6)) - 1), 0.02)
    step = abs(np.diff(normal[time > 1e-3])).max() / pressure
    chapter.at_most("pressed.jump", "pressed: largest change of the normal traction from row to "
                    "row, over the pressure", step, 0.01)
    chapter.at_most("pressed.energy", "pressed: error of the energy balance", solid.residual(run),
                    1e-3)
    chapter.at_least("pressed.broken", "pressed: broken joints", history["broken_joints"][-1], 1)
    figure, axes = plt.subplots(figsize=(7, 4.4), layout="constrained")
    axes.plot(time * 1e3, shear / 1e6, color=plt.cm.viridis(0.2), label="shear")
    axes.plot(time * 1e3, normal / 1e6, color=plt.cm.viridis(0.7), label="pressure")
    axes.axhline(peak / 1e6, color="k", linestyle=":", linewidth=1, label="c + p tan φ")
    axes.axhline((peak - COHESION) / 1e6, color="k", linestyle="--", linewidth=1, label="p tan φ")
    axes.set_xlabel("Time (ms)")
    axes.set_ylabel("Traction (MPa)")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    chapter.add_figure(figure, "A joint sheared to failure under pressure")
    chapter.add_figure(solid.energy_figure(run), "Its energies")


def check(chapter: Chapter, work: Path) -> None:
    energies(chapter, work)
    pressed(chapter, work)
