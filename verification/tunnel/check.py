# SPDX-License-Identifier: BSD-3-Clause
"""A tunnel in stressed rock: its wall against Kirsch in elastic rock, damage where it breaks."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import run_case
from report import Chapter
from solid_formulas import tunnel_stress, tunnel_wall_displacement
from studies import check_criteria

TITLE = "Tunnel in in-situ stress: displacement of the wall, damage"
CASE = Path(__file__).with_name("elastic.toml")
STRESS_XX, STRESS_YY = -22.5e6, -15e6  # Pa


def wall_displacement(frame):
    """Angles (rad) and radial displacements (m) of the points of the wall that remains."""
    remains = np.hypot(*solid.centres(frame).T) > 1.0
    chosen = np.unique(frame.matrix.cells[remains])
    chosen = chosen[np.hypot(*frame.matrix.points[chosen].T) < 1 + 1e-6]
    points = frame.matrix.points[chosen]
    moved = (frame.matrix.point_data["displacement_m"][chosen] * points).sum(axis=1)
    angle = np.arctan2(points[:, 1], points[:, 0])
    order = np.argsort(angle)
    return angle[order], moved[order]


def near_axis(frame):
    """Places (m), stresses xx and yy (Pa) of triangles along the x axis to the right."""
    centres = solid.centres(frame)
    chosen = (abs(centres[:, 1]) < 0.15) & (centres[:, 0] > 1.05) & (centres[:, 0] < 5)
    cells = frame.matrix.cell_data
    return centres[chosen, 0], cells["stress_xx_Pa"][chosen], cells["stress_yy_Pa"][chosen]


def elastic(chapter: Chapter, work: Path):
    run = run_case(CASE, work / "elastic").results
    frame = run.frame()
    angle, moved = wall_displacement(frame)
    exact = tunnel_wall_displacement(angle, STRESS_XX, STRESS_YY, 1.0, 10e9, 0.25)
    chapter.at_most("wall", "elastic: largest error of the radial displacement of the wall over "
                    "the largest displacement (Kirsch; the rock ends at 12 radii)",
                    abs(moved - exact).max() / abs(exact).max(), 0.04)
    x, xx, yy = near_axis(frame)
    radial, hoop = tunnel_stress(x, STRESS_XX, STRESS_YY, 1.0)
    error = np.sqrt(np.mean((xx - radial) ** 2 + (yy - hoop) ** 2))
    chapter.at_most("stress", "elastic: root mean square error of the stress along the x axis over "
                    "the far stress", error / abs(STRESS_XX), 0.05)
    chapter.at_most("elastic.balance", "elastic: error of the energy balance",
                    solid.residual(run), 1e-3)
    return run


def check(chapter: Chapter, work: Path) -> None:
    intact = elastic(chapter, work)
    broken = check_criteria(chapter, "tunnel", work).results
    places = np.vstack(list(solid.broken_by_mode(broken.frame()).values()))
    chapter.at_least("damage", "breakable: joints that broke", len(places), 10)
    # The hoop stress is three times the strength at roof and floor, 1.3 times at the sides.
    upright = np.mean(abs(places[:, 1]) > abs(places[:, 0])) if len(places) else 0.0
    chapter.at_least("damage.place", "breakable: share of the broken joints nearer to roof and "
                     "floor than to the sides", upright, 0.7)
    chapter.at_most("balance", "breakable: error of the energy balance", solid.residual(broken),
                    2e-3)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6), layout="constrained")
    line = np.linspace(-np.pi, np.pi, 200)
    exact = tunnel_wall_displacement(line, STRESS_XX, STRESS_YY, 1.0, 10e9, 0.25)
    left.plot(np.degrees(line), -exact * 1e3, "k", linewidth=1, label="Kirsch")
    for name, run, mark in (("elastic", intact, "o"), ("breakable", broken, "x")):
        angle, moved = wall_displacement(run.frame())
        left.plot(np.degrees(angle), -moved * 1e3, mark, markersize=4, markerfacecolor="none",
                  color=plt.cm.viridis(0.2 if mark == "o" else 0.65), label=name)
    left.set_xlabel("Angle round the wall (degree)")
    left.set_ylabel("Inward displacement (mm)")
    left.set_ylim(0, 25)  # loose pieces fall further
    left.grid(alpha=0.3)
    left.legend(frameon=False)
    solid.draw_rock(right, broken.frame(), edges="white")
    solid.draw_cracks(right, broken.frame())
    right.set_xlim(-2.6, 2.6)
    right.set_ylim(-2.6, 2.6)
    chapter.add_figure(figure, "Displacement of the wall; joints that broke")
