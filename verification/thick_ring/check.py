# SPDX-License-Identifier: BSD-3-Clause
"""A thick ring under pressure from inside: order of the displacement in the element size."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from program import run_case
from report import Chapter
from solid_formulas import ring_displacement
from studies import observed_order

TITLE = "Thick ring: order 2 of the displacement"
HERE = Path(__file__).parent


def radial_displacement(frame):
    """Radii and radial displacements of the points."""
    points = frame.matrix.points
    radius = np.hypot(*points.T)
    moved = frame.matrix.point_data["displacement_m"]
    return radius, (moved * points).sum(axis=1) / radius


def check(chapter: Chapter, work: Path) -> None:
    sizes, errors = [0.4, 0.2, 0.1], []
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    for size, colour in zip(sizes, plt.cm.viridis([0.75, 0.45, 0.15])):
        mesh = HERE / f"thick_ring_{round(100 * size)}.msh"
        run = run_case(HERE / "case.toml", work / mesh.stem, {"mesh.file": str(mesh)}).results
        radius, moved = radial_displacement(run.frame())
        exact = ring_displacement(radius, 1e4, 1, 3, 10e9, 0.25)
        errors.append(np.sqrt(np.mean((moved - exact) ** 2)) / exact.max())
        left.plot(radius, moved * 1e6, ".", markersize=4, color=colour, label=f"{size} m")
    chapter.at_most("error", "root mean square error of the displacement over the largest one, "
                    "elements of 0.1 m", errors[-1], 3e-3)
    chapter.at_least("order", "order in the element size over three meshes",
                     observed_order(sizes, errors), 1.8)
    line = np.linspace(1, 3, 100)
    left.plot(line, ring_displacement(line, 1e4, 1, 3, 10e9, 0.25) * 1e6, "k", linewidth=1,
              label="exact")
    left.set_xlabel("Radius (m)")
    left.set_ylabel("Radial displacement (µm)")
    right.loglog(sizes, errors, "o-", color=plt.cm.viridis(0.3), label="computed")
    right.loglog(sizes, errors[0] * (np.array(sizes) / sizes[0]) ** 2, "k:", label="order 2")
    right.set_xlabel("Element size (m)")
    right.set_ylabel("Relative error")
    for axes in (left, right):
        axes.grid(alpha=0.3, which="both")
        axes.legend(frameon=False)
    chapter.add_figure(figure, "Displacement of the ring and its error")
