# SPDX-License-Identifier: BSD-3-Clause
"""A disc split by two opposite loads: strength and the place of the split, on a mesh without a
straight way for the crack and on one with it."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import ROOT
from report import Chapter
from studies import check_criteria, run_example

TITLE = "Brazilian disc: splitting strength"
DIAMETER, STRENGTH = 0.1, 5e6


def load(run) -> np.ndarray:
    """On the disc, N/m: mean of both sides, positive in compression."""
    return 0.5 * (run.history["boundary.bottom.reaction_y_N_per_m"]
                  - run.history["boundary.top.reaction_y_N_per_m"])


def split_share(run) -> float:
    """Share of 14 pieces of the loaded diameter beside which a joint broke."""
    broken = np.vstack(list(solid.broken_by_mode(run.frame()).values())) / DIAMETER
    beside = broken[abs(broken[:, 0]) < 0.07, 1]
    return float(np.mean(np.histogram(beside, np.linspace(-0.35, 0.35, 15))[0] > 0))


def check(chapter: Chapter, work: Path) -> None:
    runs = {"irregular": check_criteria(chapter, "brazilian", work).results}
    mesh = ROOT / "examples/brazilian/brazilian_straight.msh"
    runs["straight"] = run_example("brazilian", work, "straight", {"mesh.file": str(mesh)}).results
    figure, axes = plt.subplots(figsize=(7, 4.4), layout="constrained")
    for (name, run), colour in zip(runs.items(), plt.cm.viridis([0.2, 0.65])):
        strength = 2 * load(run) / (np.pi * DIAMETER)
        chapter.at_most(f"{name}.strength", f"{name} mesh: 2 P/(pi D) over the tensile "
                        "strength, less 1", abs(strength.max() / STRENGTH - 1), 0.1)
        chapter.at_least(f"{name}.split", f"{name} mesh: share of the middle seven tenths of the "
                         "loaded diameter along which joints broke", split_share(run), 0.9)
        chapter.at_most(f"{name}.balance", f"{name} mesh: error of the energy balance",
                        solid.residual(run), 1e-3)
        moved = (run.history["boundary.bottom.displacement_y_m"]
                 - run.history["boundary.top.displacement_y_m"])
        axes.plot(moved * 1e3, strength / 1e6, color=colour, label=f"{name} mesh")
    axes.axhline(STRENGTH / 1e6, color="k", linestyle="--", linewidth=1, label="tensile strength")
    axes.set_xlabel("Approach of the loaded arcs (mm)")
    axes.set_ylabel("2 P/(π D) (MPa)")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Load over displacement")
    picture(chapter, runs)


def picture(chapter: Chapter, runs: dict) -> None:
    figure, both = plt.subplots(1, 2, figsize=(11, 5), layout="constrained")
    for (name, run), axes in zip(runs.items(), both):
        solid.draw_rock(axes, run.frame(), edges="white")
        solid.draw_cracks(axes, run.frame())
        axes.set_title(f"{name.capitalize()} mesh", fontsize=10)
    chapter.add_figure(figure, "Joints that broke, by how they broke")
