# SPDX-License-Identifier: BSD-3-Clause
"""The pressure in a crack rises until it grows, at what its toughness bears (Griffith)."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from fracture_formulas import growth_pressure
from percolith.run_directory import read_table
from program import run_case
from report import Chapter

TITLE = "Pressure at which a crack grows"
HERE = Path(__file__).parent
EXPECTED = growth_pressure(toughness=1e6, half=1.0)
RAMP = ([0, 10e-3, 20e-3, 60e-3], [0, 0.5e6, 0.55e6, 0.6e6])  # s, Pa


def check(chapter: Chapter, work: Path) -> None:
    run = run_case(HERE / "case.toml", work / "case").results
    events = read_table(run.path / "events.csv", words=("mode", "material"))
    pressure = np.interp(events["time_s"], *RAMP)
    chapter.at_most("pressure", "pressure at which the first joint breaks, relative difference "
                    f"from K_Ic/sqrt(pi L) = {EXPECTED / 1e3:.1f} kPa",
                    abs(pressure[0] / EXPECTED - 1), 0.05)
    chapter.at_most("place", "distance of that joint from the tip, m",
                    abs(events["x_m"][0] - 0.5 * events["length_m"][0] - 1), 1e-6)
    chapter.at_most("energy", "error of the energy balance",
                    run.summary["mechanics"]["energy_error"], 1e-3)
    history = run.history
    figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
    axes.plot(np.interp(history["time_s"], *RAMP) / 1e3, history["broken_joints"],
              color=plt.cm.viridis(0.3))
    axes.axvline(EXPECTED / 1e3, color="black", linestyle=":", label="K_Ic/sqrt(pi L)")
    axes.set_xlabel("Pressure in the crack (kPa)")
    axes.set_ylabel("Broken joints")
    axes.set_xlim(540, 600)
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Joints ahead of the crack that broke")
