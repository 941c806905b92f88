# SPDX-License-Identifier: BSD-3-Clause
"""Wet rock in equilibrium with its weight, its fluid and its stress stays at rest."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import run_case
from report import Chapter

TITLE = "Rest of wet rock with fractures under its weight"
HERE = Path(__file__).parent
WEIGHT = 1000 * 9.81  # of the fluid, rho g, Pa/m
ROCK = 1e-13 / 1e-3 * WEIGHT  # flux under a unit gradient of head, m/s
CRACK = 1e-3**3 / 12 / 1e-3 * WEIGHT  # the same in a fracture, m2/s
# Motion is compared with that of the rock while it falls freely for 1 ms.
FALL = 9.81 * 1e-3  # m/s
MASS = 2500 * 40 * 30  # kg/m
STRENGTH = ("tensile_strength", "cohesion", "mode_1_energy", "mode_2_energy")
VARIANTS = {
    "breakable": {},
    "total": {"model.joint_stress": "total"},
    "finite": {"model.pore_joints": "finite"},
    "softening": {"model.fluid_enters": "softening"},
    "elastic": {"material.rock.joints": "elastic", "new_cracks": None,
                **{f"material.rock.{name}": None for name in STRENGTH}},
}


def check(chapter: Chapter, work: Path) -> None:
    for label, settings in VARIANTS.items():
        run = run_case(HERE / "case.toml", work / label, settings).results
        frames = [run.frame(time) for time in run.times]
        speed = np.sqrt(2 * run.history["kinetic_J_per_m"].max() / MASS)
        rock = max(np.hypot(*f.matrix.cell_data["darcy_flux_m_per_s"].T).max() for f in frames)
        crack = max(abs(f.cracks.cell_data["flux_m2_per_s"]).max() for f in frames)
        head = max(abs(f.matrix.point_data["head_m"] - 20).max() for f in frames)
        chapter.at_most(f"{label}.speed", f"{label}: speed of the rock, root mean square, over "
                        "that of a free fall of 1 ms", speed / FALL, 1e-9)
        chapter.at_most(f"{label}.rock", f"{label}: largest Darcy flux over k rho g/mu",
                        rock / ROCK, 1e-9)
        chapter.at_most(f"{label}.crack", f"{label}: largest flux in a fracture over a^3 rho g/(12 "
                        "mu)", crack / CRACK, 1e-9)
        chapter.at_most(f"{label}.head", f"{label}: largest error of the head, m", head, 1e-9)
        chapter.at_most(f"{label}.broken", f"{label}: joints that broke",
                        run.history["broken_joints"][-1], 0)
    figure, axes = plt.subplots(figsize=(7, 4.6), layout="constrained")
    stress = frames[-1].matrix.cell_data["stress_yy_Pa"] / 1e6
    rock = solid.draw_rock(axes, frames[-1], stress)
    for ends in frames[-1].cracks.points[frames[-1].cracks.cells]:
        axes.plot(*ends.T, color="#d55e00", linewidth=2)
    solid.colour_bar(figure, axes, rock, "Vertical effective stress (MPa)")
    chapter.add_figure(figure, "The rock at the end, with its fractures")
