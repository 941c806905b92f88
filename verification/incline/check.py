# SPDX-License-Identifier: BSD-3-Clause
"""A block on a slope: slides below its friction angle's slope not at all, above it by the law."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import ROOT, run_case
from report import Chapter
from solid_formulas import slide_distance
from studies import check_criteria, run_example

TITLE = "Incline: a block slides or stays"
FRICTION = np.radians(30)


def distance(run) -> tuple[np.ndarray, np.ndarray]:
    """Times (s) and how far the middle of the block has moved (m)."""
    rows = run.probe("block")
    return rows["time_s"], np.hypot(rows["displacement_x_m"], rows["displacement_y_m"])


def check(chapter: Chapter, work: Path) -> None:
    slide = check_criteria(chapter, "incline", work).results
    mesh = ROOT / "examples/incline/incline_25.msh"
    stay = run_example("incline", work, "stays", {
        "mesh.file": str(mesh), "probe.block.point": [0.88518, 0.46794]}).results
    expected = slide_distance(1.0, np.radians(35), FRICTION)
    chapter.at_most("slides", "slope of 35 degrees: distance after 1 s, relative difference from "
                    f"{expected:.4f} m", abs(distance(slide)[1][-1] / expected - 1), 0.01)
    chapter.at_most("stays", "slope of 25 degrees: distance after 1 s, m",
                    distance(stay)[1][-1], 1e-3)
    chapter.at_most("energy", "error of the energy balance", solid.residual(slide), 1e-3)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    line = np.linspace(0, 1, 100)
    exact = [slide_distance(time, np.radians(35), FRICTION) for time in line]
    left.plot(line, exact, "k", linewidth=1, label="exact")
    for label, run, colour in (("35 degrees", slide, 0.3), ("25 degrees", stay, 0.7)):
        left.plot(*distance(run), "o", markersize=4, color=plt.cm.viridis(colour), label=label)
    left.set_xlabel("Time (s)")
    left.set_ylabel("Distance (m)")
    left.grid(alpha=0.3)
    left.legend(frameon=False)
    solid.draw_rock(right, slide.frame(), magnify=1.0, edges="#808080")
    right.set_title("The block after 1 s", fontsize=10)
    chapter.add_figure(figure, "Distance over time, and the block at the end")
