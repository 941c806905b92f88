# SPDX-License-Identifier: BSD-3-Clause
"""A fluid without viscosity to speak of drives a crack: length, width and pressure over a decade of
time."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from fracture_formulas import ToughnessCrack
from program import run_case
from report import Chapter
from solid_formulas import plane_modulus

TITLE = "Hydraulic fracture ruled by toughness: length, width and pressure"
HERE = Path(__file__).parent
EXACT = ToughnessCrack(rate=1e-2, toughness=1e6, modulus=plane_modulus(30e9, 0.25))
HALF_RAMP = 1e-4  # s: the rate stands for one that comes at once in the middle of its ramp


def half_length(frame) -> float:
    """Distance of the front of damage from the middle, m."""
    ends = frame.cracks.points[frame.cracks.cells][:, :, 0].max(axis=1)
    return ends[frame.cracks.cell_data["damage"] > 0].max()


def width(frame) -> float:
    """Opening of the segment in the middle, m."""
    ends = frame.cracks.points[frame.cracks.cells][:, :, 0].min(axis=1)
    return frame.cracks.cell_data["opening_m"][ends.argmin()]


def pressure(history, time: float) -> float:
    """Mean over a twentieth of the time: it rises and falls as joint after joint breaks, Pa."""
    near = abs(history["time_s"] / time - 1) < 0.025
    return history["maximum_crack_pressure_Pa"][near].mean()


def check(chapter: Chapter, work: Path) -> None:
    run = run_case(HERE / "case.toml", work / "case").results
    history = run.history
    times = np.array(run.times[1:-1])
    found = {"length": np.array([half_length(run.frame(time)) for time in times]),
             "width": np.array([width(run.frame(time)) for time in times]),
             "pressure": np.array([pressure(history, time) for time in times])}
    since = times - HALF_RAMP
    exact = {"length": EXACT.half_length, "width": EXACT.width, "pressure": EXACT.pressure}
    for name, values in found.items():
        error = abs(values / exact[name](since) - 1)
        chapter.at_most(name, f"{name} from 0.01 to 0.1 s: largest relative error", error.max(),
                        0.05)
    chapter.at_most("mass", "error of the mass balance",
                    run.summary["mass_balance"]["relative_error"], 1e-12)
    chapter.at_most("energy", "error of the energy balance",
                    run.summary["mechanics"]["energy_error"], 1e-2)
    figure, panels = plt.subplots(1, 3, figsize=(12, 4), layout="constrained")
    line = np.geomspace(1e-3, 0.1, 100)
    scales = {"length": (1, "Half-length (m)"), "width": (1e3, "Width in the middle (mm)"),
              "pressure": (1e-6, "Pressure (MPa)")}
    late = history["time_s"] > 1e-3
    panels[2].loglog(history["time_s"][late] - HALF_RAMP,
                     history["maximum_crack_pressure_Pa"][late] * 1e-6, linewidth=0.6,
                     color=plt.cm.viridis(0.7), label="computed, all")
    for axes, (name, (scale, label)) in zip(panels, scales.items()):
        axes.loglog(since, found[name] * scale, "o", color=plt.cm.viridis(0.3), label="computed")
        axes.loglog(line, exact[name](line) * scale, "k", linewidth=1, label="exact")
        axes.set_xlabel("Time (s)")
        axes.set_ylabel(label)
        axes.grid(alpha=0.3, which="both")
        axes.legend(frameon=False, fontsize="small")
    chapter.add_figure(figure, "Growth of the crack")
