# SPDX-License-Identifier: BSD-3-Clause
"""A fracture at constant pressure feeds rock on both sides through a film."""

from pathlib import Path

import criteria
import numpy as np
from percolith.run_directory import read_table
from report import Chapter
from set_ups import mesh_figure
from studies import check_example, compare_figure, expected_profiles, run_example

TITLE = "Single fracture: exchange with the rock"
HERE = Path(__file__).parent
TIMES = (0.001, 0.01, 0.1, 0.2)


def faces(frame) -> tuple[float, float]:
    """Mean pore pressure on the left and right face of the fracture."""
    grid = frame.matrix
    centre = grid.points[grid.cells].mean(axis=1)[:, 0]
    on_fracture = abs(grid.points[:, 0]) < 1e-9
    sides = []
    for side in (centre < 0, centre > 0):
        nodes = np.unique(grid.cells[side])
        sides.append(grid.point_data["pressure_Pa"][nodes[on_fracture[nodes]]].mean())
    return sides[0], sides[1]


def check(chapter: Chapter, work: Path) -> None:
    result = check_example(chapter, "single_fracture", work)
    right = read_table(HERE / "single_fracture_semi_infinite.csv")
    left = read_table(HERE / "single_fracture_slab20.csv")
    curves = []
    for time in TIMES:
        rows = result.results.probe("line").at_time(time)
        x = rows["x_m"]
        reference = np.where(x < 0, np.interp(-x, left["x_m"], left[f"p_Pa_t{time}s"]),
                             np.interp(x, right["x_m"], right[f"p_Pa_t{time}s"]))
        label = f"{time} s"
        curves.append((label, x, rows["pressure_Pa"], reference))
        chapter.at_most(f"profile.{time}", f"largest difference from the tables at {label} over "
                        "the fracture pressure",
                        abs(rows["pressure_Pa"] - reference).max() / 8e6, 0.01)
        left_face, right_face = faces(result.results.frame(time))
        expected = right["x_m"].argmin()
        chapter.at_most(f"face.{time}", f"right face at {label}: error over the fracture pressure",
                        abs(right_face - right[f"p_Pa_t{time}s"][expected]) / 8e6, 0.01)
        if time >= 0.1:
            chapter.at_least(f"jump.{time}", f"left above right face at {label}, MPa",
                             (left_face - right_face) / 1e6, 0.15)
    chapter.add_figure(compare_figure(curves, "x (m)", "Pressure (MPa)", 1e6, marks=60),
                       "Pressure along the rock at four times; circles: analytic", "profiles")
    notes = [(15, 5, "8 MPa in the fracture")]
    chapter.add_figure(mesh_figure([("", result.results.frame())], notes, width=10.0),
                       "The mesh; all sides are sealed", "mesh")
    finite(chapter, work)


def finite(chapter: Chapter, work: Path) -> None:
    result = run_example("single_fracture", work, "finite", {"model.pore_joints": "finite"})
    worst = max(
        criteria.measure("maximum", criteria.profile(entry, result.results, "single_fracture"), 8e6)
        for entry in expected_profiles("single_fracture"))
    chapter.at_most("finite", "finite joints, n = 100: largest error at all times over the "
                    "fracture pressure", worst, 0.01)
