# SPDX-License-Identifier: BSD-3-Clause
"""A column of blocks that collapses and comes to rest: energy, overlap, nothing lost."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from report import Chapter
from studies import check_criteria

TITLE = "Rubble: a column of 112 blocks collapses"
SIDE, HEIGHT, WEIGHT = 0.1, 14 * 0.1732, 2500 * 9.81  # m, m, N/m3
PENALTY = 20 * 20e6  # Pa


def deformed(frame) -> np.ndarray:
    return frame.matrix.points + frame.matrix.point_data["displacement_m"]


def depth_into(point: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """How deep a point lies in each of the triangles, m; negative outside."""
    depths = []
    for k in range(3):
        a, b = triangles[:, k], triangles[:, (k + 1) % 3]
        edge, to = b - a, point - a
        depths.append((edge[:, 0] * to[:, 1] - edge[:, 1] * to[:, 0]) / np.hypot(*edge.T))
    return np.min(depths, axis=0)


def deepest_overlap(frame, block: np.ndarray) -> float:
    """Largest depth of a corner in a triangle of another block or of the floor, m. `block` is the
    number of the body of each triangle."""
    corners, cells = deformed(frame), frame.matrix.cells
    deepest = 0.0
    for cell, own in zip(cells, block):
        for point in corners[cell]:
            depths = depth_into(point, corners[cells])
            deepest = max(deepest, depths[block != own].max())
    return float(deepest)


def check(chapter: Chapter, work: Path) -> None:
    run = check_criteria(chapter, "rubble", work).results
    history, first, last = run.history, run.frame(0.0), run.frame()
    kinetic = history["kinetic_J_per_m"]
    block = first.matrix.cell_data["fragment"]
    stones = solid.centres(first)[:, 1] > 0
    chapter.at_least("fragments", "separate blocks", len(np.unique(block[stones])), 100)
    chapter.at_most("rest", "kinetic energy at the end over the largest",
                    kinetic[-1] / kinetic.max(), 1e-4)
    fall = solid.mean_of(first, "displacement_m", stones) - solid.mean_of(last, "displacement_m",
                                                                        stones)
    chapter.at_least("collapse", "fall of the middle of mass over the height of the column",
                     fall[1] / HEIGHT, 0.1)
    lowest = deformed(last)[last.matrix.cells][stones][..., 1].min()
    chapter.at_least("floor", "lowest point of a block, m", lowest, -0.01)
    # The whole column on one corner: stress of its weight over the penalty, over a side.
    estimate = WEIGHT * HEIGHT / PENALTY * SIDE
    chapter.at_most("overlap", "largest overlap at the end over that of the weight of the column "
                    "on the penalty", deepest_overlap(last, block) / estimate, 5.0)
    chapter.at_most("balance", "error of the energy balance", solid.residual(run), 1e-3)
    figure, row = plt.subplots(1, 4, figsize=(15, 4.5), layout="constrained", sharey=True)
    colours = np.random.default_rng(1).permutation(block.max() + 1)[block].astype(float)
    for time, axes in zip((0.0, 0.5, 1.0, 4.0), row):
        frame = run.frame(time)
        solid.draw_rock(axes, frame, colours, (0, block.max()), magnify=1.0)
        axes.set_xlim(-1.5, 3)
        axes.set_ylim(-0.2, 2.6)
        axes.set_title(f"{frame.time:.1f} s", fontsize=10)
    chapter.add_figure(figure, "The blocks, by their numbers")
    chapter.add_figure(solid.energy_figure(run), "Energies of the collapse")
