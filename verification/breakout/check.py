# SPDX-License-Identifier: BSD-3-Clause
"""Breakouts of a borehole: where they lie, how wide and deep they are, and mud that prevents
them."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from report import Chapter
from solid_formulas import breakout_half_width, mohr_coulomb, overstressed_depth
from studies import check_criteria, run_example

TITLE = "Breakouts of a borehole: azimuth, width and depth, and heavy mud"
RADIUS, SMALLER, LARGER = 0.1, 20e6, 45e6  # m, Pa
MUD = 5e6  # Pa
COHESION, FRICTION = 14e6, np.radians(25)
WALL = 1.08  # radii: joints that end at the wall


def angles(frame, chosen: np.ndarray) -> np.ndarray:
    """Of the middles of chosen crack segments at the wall, from the direction of the smaller
    stress, degree."""
    middles = frame.cracks.points[frame.cracks.cells].mean(axis=1)
    chosen = chosen & (np.hypot(*middles.T) < WALL * RADIUS)
    return np.degrees(np.arctan2(abs(middles[chosen, 0]), abs(middles[chosen, 1])))


def heavy_mud() -> float:
    """Pressure (Pa) under which the wall bears what Kirsch says, with a twentieth to spare."""
    bare = mohr_coulomb(0.0, COHESION, FRICTION)
    growth = mohr_coulomb(1.0, COHESION, FRICTION) - bare
    return 1.05 * (3 * LARGER - SMALLER - bare) / (1 + growth)


def under_mud(pressure: float) -> dict:
    """Options of the example that put another pressure into the hole, in balance at the start."""
    def loads(last: float) -> dict:
        return {"times": [0, 4e-3], "values": [pressure, last]}

    return {"in_situ.stress_xx": -pressure, "in_situ.stress_yy": -pressure,
            "boundary.wall.normal_pressure": pressure,
            "boundary.sides.normal_pressure": loads(LARGER),
            "boundary.ends.normal_pressure": loads(SMALLER)}


def check(chapter: Chapter, work: Path) -> None:
    run = check_criteria(chapter, "breakout", work).results
    frame = run.frame()
    width = np.degrees(breakout_half_width(SMALLER, LARGER, MUD, COHESION, FRICTION))
    mode = frame.cracks.cell_data["mode"]
    softened, broken = angles(frame, mode != 0), angles(frame, mode > 0)
    chapter.at_most("width.most", "largest angle of a joint at the wall that is past its peak or "
                    f"broken over that of Kirsch, {width:.0f} degrees", softened.max() / width, 1.1)
    chapter.at_least("width.least", "the same, as a lower limit", softened.max() / width, 0.5)
    chapter.at_most("width.broken", "largest angle of a joint at the wall that broke over the same",
                    broken.max() / width, 1.0)
    mud = heavy_mud()
    held = run_example("breakout", work, "heavy_mud", under_mud(mud))
    chapter.at_most("mud.broken", f"mud of {mud / 1e6:.1f} MPa: joints that broke",
                    held.results.summary["mechanics"]["broken_joints"], 0)
    chapter.at_most("mud.energy", "the same: error of the energy balance", held.energy_error, 1e-3)
    chapter.add_figure(breakouts(run, width), "Joints that broke; dashed: width of Kirsch, and "
                       "depth of the overstressed zone")


def breakouts(run, width: float):
    figure, axes = plt.subplots(figsize=(6.4, 6), layout="constrained")
    solid.draw_rock(axes, run.frame(), edges="white")
    solid.draw_cracks(axes, run.frame())
    depth = overstressed_depth(SMALLER, LARGER, mohr_coulomb(0.0, COHESION, FRICTION), MUD)
    for middle in (90, 270):
        angle = np.radians(np.linspace(middle - width, middle + width, 50))
        axes.plot(depth * RADIUS * np.cos(angle), depth * RADIUS * np.sin(angle), "k--",
                  linewidth=0.8)
        for end in (angle[0], angle[-1]):
            axes.plot(RADIUS * np.array([1, depth]) * np.cos(end),
                      RADIUS * np.array([1, depth]) * np.sin(end), "k--", linewidth=0.8)
    axes.set_xlim(-0.18, 0.18)
    axes.set_ylim(-0.18, 0.18)
    return figure
