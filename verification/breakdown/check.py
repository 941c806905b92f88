# SPDX-License-Identifier: BSD-3-Clause
"""Pressure in a borehole rises until its wall breaks: with a wall that lets the fluid into the
rock, with a sealed one, and with joints that feel the total stress."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from fracture_formulas import (breakdown_open_wall, breakdown_open_wall_by_total_stress,
                               breakdown_sealed_wall)
from percolith.run_directory import read_table
from poroelastic_formulas import PorousRock
from program import run_case
from report import Chapter

TITLE = "Breakdown of a borehole: open and sealed wall, effective and total stress"
HERE = Path(__file__).parent
STRESSES = (5e6, 7e6, 4e6, 1e6)  # Pa: S_h, S_H, tensile strength, pore pressure
ETA = PorousRock().eta
RAMP = {"times": [0, 2e-3, 6e-3, 16e-3], "values": [1e6, 1e6, 6e6, 13e6]}
STEEP = {"times": [0, 2e-3, 6e-3, 16e-3], "values": [1e6, 1e6, 30e6, 60e6]}
# In the sealed case a fluid that gives way much keeps the pressure of the pores as it was.
VARIANTS = {
    "open": (RAMP, {}, breakdown_open_wall(*STRESSES, ETA)),
    "sealed": (RAMP, {"boundary.wall.on": "crack", "material.rock.biot_modulus": 5e8,
                      "time.end": 14.5e-3}, breakdown_sealed_wall(*STRESSES)),
    "total": (STEEP, {"model.joint_stress": "total", "time.end": 12.5e-3},
              breakdown_open_wall_by_total_stress(*STRESSES, ETA)),
}


def check(chapter: Chapter, work: Path) -> None:
    figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
    found = {}
    for (name, (ramp, settings, expected)), colour in zip(VARIANTS.items(),
                                                          plt.cm.viridis([0.15, 0.5, 0.8])):
        run = run_case(HERE / "case.toml", work / name,
                       {"boundary.wall.pressure": ramp, **settings}).results
        history = run.history
        events = read_table(run.path / "events.csv", words=("mode", "material"))
        found[name] = np.interp(events["time_s"][0], ramp["times"], ramp["values"])
        chapter.at_most(f"{name}.pressure", f"{name}: pressure at which the first joint breaks, "
                        f"relative difference from {expected / 1e6:.4g} MPa",
                        abs(found[name] / expected - 1), 0.05)
        distance = events["x_m"][0] - 0.5 * events["length_m"][0] - 0.1
        chapter.at_most(f"{name}.place", f"{name}: distance of that joint from the wall, m",
                        abs(distance), 1e-6)
        pressure = np.interp(history["time_s"], ramp["times"], ramp["values"]) / 1e6
        axes.plot(pressure, history["broken_joints"], color=colour, label=name)
        axes.axvline(expected / 1e6, color=colour, linestyle=":")
    chapter.at_least("between", "how far the sealed wall bears more than the open one, MPa",
                     (found["sealed"] - found["open"]) / 1e6, 1.0)
    axes.set_xlabel("Pressure in the borehole (MPa)")
    axes.set_ylabel("Broken joints")
    axes.set_xscale("log")
    axes.minorticks_off()
    axes.set_xlim(5, 60)
    axes.set_xticks([5, 10, 20, 50], ["5", "10", "20", "50"])
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Joints of the line that broke; dotted: where theory has it")
