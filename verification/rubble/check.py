# SPDX-License-Identifier: BSD-3-Clause
"""A stack of blocks that collapses and comes to rest: energy, overlap, nothing lost."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from report import Chapter
from studies import check_criteria

TITLE = "Rubble: a stack of 120 blocks collapses"
WIDTH, HEIGHT, WEIGHT = 0.173, 1.85, 2500 * 9.81  # m, of a block, of the stack; N/m3
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


def expected_depths(first) -> np.ndarray:
    """How deep a corner of a block goes into each triangle under a pile of blocks as high as the
    stack, m.

    A corner of 120 degrees that goes in by d overlaps over d^2 tan 60; where it is d deep the
    potential of the triangle is 3 d/height. Its derivative by d is the force of the triangle alone,
    3 p tan 60 d^2/height; that of the block comes on top, so that this is the largest depth."""
    corners = first.matrix.points[first.matrix.cells]
    edges = corners - np.roll(corners, 1, axis=1)
    area = 0.5 * np.abs(np.cross(edges[:, 0], edges[:, 1]))
    height = 2 * area / np.hypot(*np.moveaxis(edges, -1, 0)).max(axis=1)
    penalty = PENALTY * height / (6 * 2 * np.sqrt(area / np.sqrt(3)))
    stone = penalty[first.matrix.cell_data["region"] == 0].min()
    both = 2 * penalty * stone / (penalty + stone)
    return np.sqrt(WEIGHT * HEIGHT * WIDTH * height / (3 * both * np.tan(np.pi / 3)))


def deepest_overlap(frame, block: np.ndarray, expected: np.ndarray) -> float:
    """Largest depth of a corner in a triangle of another block or of the tray over what is expected
    of that triangle. `block` is the number of the body of each triangle."""
    corners, cells = deformed(frame), frame.matrix.cells
    deepest = 0.0
    for cell, own in zip(cells, block):
        for point in corners[cell]:
            depths = depth_into(point, corners[cells]) / expected
            deepest = max(deepest, depths[block != own].max())
    return float(deepest)


def check(chapter: Chapter, work: Path) -> None:
    run = check_criteria(chapter, "rubble", work).results
    history, first, last = run.history, run.frame(0.0), run.frame()
    kinetic = history["kinetic_J_per_m"]
    block = first.matrix.cell_data["fragment"]
    stones = first.matrix.cell_data["region"] == 0
    chapter.at_least("fragments", "separate blocks", len(np.unique(block[stones])), 120)
    chapter.at_most("rest", "kinetic energy at the end over the largest",
                    kinetic[-1] / kinetic.max(), 1e-5)
    fall = solid.mean_of(first, "displacement_m", stones) - solid.mean_of(last, "displacement_m",
                                                                        stones)
    chapter.at_least("collapse", "fall of the middle of mass over its height",
                     fall[1] / HEIGHT, 0.1)
    lowest = deformed(last)[last.matrix.cells][stones][..., 1].min()
    chapter.at_least("floor", "lowest point of a block, m", lowest, -0.01)
    chapter.at_most("overlap", "largest overlap at the end over that of a corner under a pile of "
                    "blocks as high as the stack", deepest_overlap(last, block,
                                                                   expected_depths(first)), 1.0)
    chapter.at_most("balance", "error of the energy balance", solid.residual(run), 1e-3)
    figure, row = plt.subplots(2, 2, figsize=(12, 6), layout="constrained", sharey=True)
    colours = np.random.default_rng(1).permutation(block.max() + 1)[block].astype(float)
    for time, axes in zip((0.0, 0.5, 1.0, 4.0), row.flat):
        frame = run.frame(time)
        solid.draw_rock(axes, frame, colours, (0, block.max()), magnify=1.0)
        axes.set_title(f"{frame.time:.1f} s", fontsize=10)
    chapter.add_figure(figure, "The blocks, by their numbers")
    chapter.add_figure(solid.energy_figure(run), "Energies of the collapse")
