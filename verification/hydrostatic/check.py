# SPDX-License-Identifier: BSD-3-Clause
"""Fluid at rest stays at rest, in the rock and in the fractures."""

from pathlib import Path

import numpy as np
from program import run_case
from report import Chapter

TITLE = "Hydrostatic rest: no flow in rock and fractures"
HERE = Path(__file__).parent
WEIGHT = 1000 * 9.81  # rho g, Pa/m
ROCK = 1e-13 / 1e-3 * WEIGHT  # flux under a unit gradient of head, m/s
CRACK = 1e-3**3 / 12 / 1e-3 * WEIGHT  # the same in a fracture, m2/s


def check(chapter: Chapter, work: Path) -> None:
    variants = {
        "implicit": {},
        "steady": {},
        "explicit": {"time.scheme": "explicit", "time.end": 0.01, "output.times": []},
        "finite": {"model.pore_joints": "finite"},
        "datum": {"model.head_datum": 5},
    }
    for label, settings in variants.items():
        case = "steady.toml" if label == "steady" else "case.toml"
        run = run_case(HERE / case, work / label, settings).results
        frames = [run.frame(time) for time in run.times]
        rock = max(np.hypot(*f.matrix.cell_data["darcy_flux_m_per_s"].T).max() for f in frames)
        crack = max(abs(f.cracks.cell_data["flux_m2_per_s"]).max() for f in frames)
        head = max(abs(f.matrix.point_data["head_m"] - 20).max() for f in frames)
        chapter.at_most(f"{label}.rock", f"{label}: largest Darcy flux over k rho g/mu",
                        rock / ROCK, 1e-9)
        chapter.at_most(f"{label}.crack", f"{label}: largest flux in a fracture over a^3 rho g/(12 "
                        "mu)", crack / CRACK, 1e-9)
        chapter.at_most(f"{label}.head", f"{label}: largest error of the head, m", head, 1e-9)
