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


def distance(run) -> np.ndarray:
    """How far the top of the block has moved, m, at each row of the history."""
    return np.hypot(run.history["boundary.top.displacement_x_m"],
                    run.history["boundary.top.displacement_y_m"])


def check(chapter: Chapter, work: Path) -> None:
    slide = check_criteria(chapter, "incline", work).results
    mesh = ROOT / "examples/incline/incline_25.msh"
    stay = run_example("incline", work, "stays", {"mesh.file": str(mesh)}).results
    expected = slide_distance(1.0, np.radians(35), FRICTION)
    chapter.at_most("slides", "slope of 35 degrees: distance after 1 s, relative difference from "
                    f"{expected:.4f} m", abs(distance(slide)[-1] / expected - 1), 0.01)
    chapter.at_most("stays", "slope of 25 degrees: distance after 1 s, m", distance(stay)[-1], 1e-3)
    for name, run in (("slides", slide), ("stays", stay)):
        chapter.at_most(f"{name}.energy", f"{name}: error of the energy balance",
                        solid.residual(run), 1e-3)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    time = slide.history["time_s"]
    exact = [slide_distance(t, np.radians(35), FRICTION) for t in time]
    left.plot(time, distance(slide), color=plt.cm.viridis(0.3), label="35 degrees")
    left.plot(time[::50], exact[::50], "ko", markerfacecolor="none", markersize=4, label="exact")
    left.plot(stay.history["time_s"], distance(stay), color=plt.cm.viridis(0.7), label="25 degrees")
    left.set_xlabel("Time (s)")
    left.set_ylabel("Distance (m)")
    left.grid(alpha=0.3)
    left.legend(frameon=False)
    solid.draw_rock(right, slide.frame(), magnify=1.0, edges="#808080")
    right.set_title("The block after 1 s", fontsize=10)
    chapter.add_figure(figure, "Distance over time, and the block at the end")
