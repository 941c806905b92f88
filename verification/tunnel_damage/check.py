# SPDX-License-Identifier: BSD-3-Clause
"""A tunnel under a large vertical stress: place and depth of the broken zone beside it, and none
where the rock is strong enough."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from report import Chapter
from solid_formulas import mohr_coulomb, overstressed_depth
from studies import check_criteria, run_example

TITLE = "Tunnel with a damaged zone: place and depth by the stresses of Kirsch"
RADIUS, HORIZONTAL, VERTICAL = 2.0, 12.5e6, 25e6  # m, Pa
FRICTION = np.radians(30)
LARGEST = 3 * VERTICAL - HORIZONTAL  # Pa, at the side walls
ENOUGH = 1.1 * LARGEST / mohr_coulomb(0.0, 1.0, FRICTION)  # Pa, cohesion


def check(chapter: Chapter, work: Path) -> None:
    run = check_criteria(chapter, "tunnel_damage", work).results
    strength = mohr_coulomb(0.0, 7.5e6, FRICTION)
    expected = overstressed_depth(HORIZONTAL, VERTICAL, strength)
    places = np.column_stack([run.events["x_m"], run.events["y_m"]]) / RADIUS
    beside = abs(places[:, 1]) < abs(places[:, 0])
    for name, side in (("right", 1), ("left", -1)):
        reach = np.hypot(*places[beside & (places[:, 0] * side > 0)].T).max()
        chapter.at_most(f"depth.{name}", f"{name} wall: radii that the broken zone reaches over "
                        f"{expected:.3f}, less 1", abs(reach / expected - 1), 0.25)
    kinetic = run.history["kinetic_J_per_m"]
    chapter.at_most("rest", "kinetic energy at the end over the largest",
                    kinetic[-1] / kinetic.max(), 0.1)
    strong = run_example("tunnel_damage", work, "strong", {"material.near.cohesion": ENOUGH,
                         "material.near.tensile_strength": ENOUGH / 5,
                         "material.near.mode_1_energy": 120 * (ENOUGH / 7.5e6) ** 2,
                         "material.near.mode_2_energy": 2700 * (ENOUGH / 7.5e6) ** 2})
    chapter.at_most("strong.broken", "strength of 1.1 times the largest stress of Kirsch: joints "
                    "that broke", strong.results.summary["mechanics"]["broken_joints"], 0)
    chapter.at_most("strong.energy", "the same: error of the energy balance", strong.energy_error,
                    1e-3)
    chapter.add_figure(zone(run, expected), "Joints that broke, by how they broke; dashed: as "
                       "deep as the rock beside the tunnel is overstressed by Kirsch")
    chapter.add_figure(solid.energy_figure(run), "Energies")


def zone(run, depth: float):
    figure, axes = plt.subplots(figsize=(6.4, 6), layout="constrained")
    solid.draw_rock(axes, run.frame(), edges="white")
    solid.draw_cracks(axes, run.frame())
    angle = np.linspace(0, 2 * np.pi, 200)
    axes.plot(depth * RADIUS * np.cos(angle), depth * RADIUS * np.sin(angle), "k--", linewidth=0.8)
    axes.set_xlim(-4.2, 4.2)
    axes.set_ylim(-4.2, 4.2)
    return figure
