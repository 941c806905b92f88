# SPDX-License-Identifier: BSD-3-Clause
"""Rock under in-situ stress starts in equilibrium and stays at rest."""

from pathlib import Path

import numpy as np
from program import run_case
from report import Chapter
from solid_formulas import wave_speeds

TITLE = "In-situ stress: rest, uniform and under the weight of the rock"
HERE = Path(__file__).parent
STRESS = {"uniform": 20e6, "weight": 110 * 24525.0}  # Pa, largest


def check(chapter: Chapter, work: Path) -> None:
    speed = wave_speeds(10e9, 0.25, 2500.0)[0]
    for name, stress in STRESS.items():
        for joints in ("breakable", "elastic"):
            label = f"{name}_{joints}"
            settings = {}
            if joints == "elastic":
                settings = {"material.rock.joints": "elastic"} | {
                    f"material.rock.{option}": None for option in
                    ("tensile_strength", "cohesion", "mode_1_energy", "mode_2_energy")}
            run = run_case(HERE / f"{name}.toml", work / label, settings).results
            frames = [run.frame(time) for time in run.times]
            moving = max(np.hypot(*frame.matrix.point_data["velocity_m_per_s"].T).max()
                         for frame in frames)
            chapter.at_most(f"{label}.velocity", f"{name}, {joints}: largest velocity over that "
                            "of the stress released, sigma/(rho c)",
                            moving / (stress / (2500 * speed)), 1e-9)
            first, last = (frame.matrix.cell_data for frame in (frames[0], frames[-1]))
            change = max(abs(last[f"stress_{axes}_Pa"] - first[f"stress_{axes}_Pa"]).max()
                         for axes in ("xx", "yy", "xy"))
            chapter.at_most(f"{label}.stress", f"{name}, {joints}: largest change of the stress "
                            "over the stress", change / stress, 1e-9)
            chapter.at_most(f"{label}.start", f"{name}, {joints}: smallest stress at the start, "
                            "relative difference from the given one",
                            abs(first["stress_yy_Pa"].min() / -stress - 1), 0.01)
            chapter.at_most(f"{label}.broken", f"{name}, {joints}: joints that broke",
                            run.history["broken_joints"][-1] - run.history["broken_joints"][0], 0)
