# SPDX-License-Identifier: BSD-3-Clause
"""Steady flow from a well to a circle: pressure, gradient, order in the element size."""

from pathlib import Path

import formulas
import numpy as np
from report import Chapter
from set_ups import mesh_figure
from studies import check_example, compare_figure, observed_order, run_example

TITLE = "Radial: steady flow from a well"


def errors_at_nodes(result) -> np.ndarray:
    """Errors at all pore nodes over the well pressure."""
    grid = result.results.frame().matrix
    exact = formulas.radial(np.hypot(*grid.points.T))
    return (grid.point_data["pressure_Pa"] - exact) / 1e7


def gradient_curve(result):
    """Mean radius, pressure gradient from the Darcy flux and its reference, ring by ring."""
    grid = result.results.frame().matrix
    centre = grid.points[grid.cells].mean(axis=1)
    radius = np.hypot(*centre.T)
    outward = (grid.cell_data["darcy_flux_m_per_s"] * centre).sum(axis=1) / radius
    ring = np.digitize(radius, np.linspace(0.1, 1.0, 31))
    rings = np.unique(ring)
    mean = np.array([[radius[ring == i].mean(), -outward[ring == i].mean() * 1e-3 / 1e-13,
                      formulas.radial_gradient(radius[ring == i]).mean()] for i in rings])
    return mean.T


def check(chapter: Chapter, work: Path) -> None:
    tied = check_example(chapter, "radial", work)
    finite = run_example("radial", work, "finite", {"model.pore_joints": "finite"})
    chapter.at_most("tied", "tied nodes: largest error at any node over the well pressure",
                    abs(errors_at_nodes(tied)).max(), 2e-3)
    chapter.at_most("finite", "finite joints, n = 100: largest error at any node over the well "
                    "pressure", abs(errors_at_nodes(finite)).max(), 1e-2)
    summary = finite.results.summary
    chapter.at_most("finite.balance", "finite joints: what enters minus what leaves, over the "
                    "throughput", abs(sum(summary["rate_m2_per_s"].values()))
                    / summary["throughput_m2_per_s"], 1e-10)
    curves = []
    for label, result in (("tied", tied), ("finite, n = 100", finite)):
        rows = result.results.probe("radius").at_time()
        curves.append((label, rows["x_m"], rows["pressure_Pa"], formulas.radial(rows["x_m"])))
    chapter.add_figure(compare_figure(curves, "r (m)", "Pressure (MPa)", 1e6),
                       "Pressure along the radius; circles: analytic", "pressure")
    radius, gradient, exact = gradient_curve(tied)
    chapter.at_most("gradient", "mean gradient in rings of 0.03 m: largest error over the "
                    "gradient there", abs(gradient / exact - 1).max(), 0.02)
    chapter.add_figure(compare_figure([("tied", radius, gradient, exact)], "r (m)",
                                      "Pressure gradient (MPa/m)", 1e6),
                       "Pressure gradient, mean over rings; circles: analytic", "gradient")
    notes = [(0, 0, "10 MPa"), (0.71, 0.78, "1 MPa")]
    chapter.add_figure(mesh_figure([("", tied.results.frame())], notes, width=6.0),
                       "The mesh and the pressures at its boundaries", "mesh")
    order(chapter, work)


def order(chapter: Chapter, work: Path) -> None:
    """The finer of two meshes must have a quarter of the error at half the size."""
    sizes, errors = [0.12, 0.06, 0.03], []
    for size, file in zip(sizes, ("radial_coarsest.msh", "radial_coarse.msh", "radial.msh")):
        result = run_example("radial", work, f"size_{size}",
                             {"mesh.file": file})
        errors.append(np.sqrt(np.mean(errors_at_nodes(result) ** 2)))
    chapter.at_least("order", "order in the element size, 0.12 to 0.03 m (root mean square)",
                     observed_order(sizes, errors), 1.8)
