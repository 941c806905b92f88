# SPDX-License-Identifier: BSD-3-Clause
"""A fluid without viscosity to speak of drives a crack: length, width and pressure over a decade of
time, by the motion within a tenth of a second and by slow injection within ten minutes."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from fracture_formulas import ToughnessCrack
from program import run_case
from report import Chapter
from solid_formulas import plane_modulus
from studies import check_criteria

TITLE = "Hydraulic fracture ruled by toughness: length, width and pressure"
HERE = Path(__file__).parent
EXACT = ToughnessCrack(rate=1e-2, toughness=1e6, modulus=plane_modulus(30e9, 0.25))
HALF_RAMP = 1e-4  # s: the rate stands for one that comes at once in the middle of its ramp
SLOW = ToughnessCrack(rate=1e-6, toughness=np.sqrt(200 * plane_modulus(30e9, 0.25)),
                      modulus=plane_modulus(30e9, 0.25))
FAR = 2e6  # Pa, stress across the crack of the example
HALF_ELEMENT = 5e-3  # m: a front of damage lies at one end of an edge or at the other
DECADE = 60, 600  # s


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


def growth_figure(found: dict, exact: ToughnessCrack, line):
    """Length, width and pressure over time: `found` holds times and values of each, `line` times of
    the exact solution."""
    figure, panels = plt.subplots(1, 3, figsize=(12, 4), layout="constrained")
    scales = {"length": (1, "Half-length (m)", exact.half_length),
              "width": (1e3, "Width in the middle (mm)", exact.width),
              "pressure": (1e-6, "Pressure (MPa)", exact.pressure)}
    for axes, (name, (scale, label, formula)) in zip(panels, scales.items()):
        times, values = found[name]
        axes.loglog(times, values * scale, "o", color=plt.cm.viridis(0.3), label="computed")
        axes.loglog(line, formula(line) * scale, "k", linewidth=1, label="exact")
        axes.set_xlabel("Time (s)")
        axes.set_ylabel(label)
        axes.grid(alpha=0.3, which="both")
        axes.legend(frameon=False, fontsize="small")
    return figure, panels


def fast(chapter: Chapter, work: Path) -> None:
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
    figure, panels = growth_figure({name: (since, values) for name, values in found.items()},
                                   EXACT, np.geomspace(1e-3, 0.1, 100))
    late = history["time_s"] > 1e-3
    panels[2].loglog(history["time_s"][late] - HALF_RAMP,
                     history["maximum_crack_pressure_Pa"][late] * 1e-6, linewidth=0.6,
                     color=plt.cm.viridis(0.7), label="computed, all", zorder=1)
    panels[2].legend(frameon=False, fontsize="small")
    chapter.add_figure(figure, "Growth of the crack")


def slow(chapter: Chapter, work: Path) -> None:
    """The example slow_fracture: the rock at rest at every step, under stress across the crack."""
    run = check_criteria(chapter, "slow_fracture", work).results
    history = run.history
    times = np.array(run.times[1:])
    lengths = np.array([half_length(run.frame(time)) for time in times])
    widths = np.array([width(run.frame(time)) for time in times])
    decade = (history["time_s"] >= DECADE[0]) & (history["time_s"] <= DECADE[1])
    moments = history["time_s"][decade]
    pressures = history["maximum_crack_pressure_Pa"][decade] - FAR
    exact = SLOW.half_length(times)
    beyond = np.maximum(abs(lengths - exact) - HALF_ELEMENT, 0) / exact
    chapter.at_most("slow.length", "slow injection: length from 60 to 600 s: largest relative error"
                    " beyond half an element", beyond.max(), 0.05)
    chapter.at_most("slow.width", "slow injection: width from 60 to 600 s: largest relative error",
                    abs(widths / SLOW.width(times) - 1).max(), 0.05)
    error = abs(pressures / SLOW.pressure(moments) - 1)
    chapter.at_most("slow.pressure", "slow injection: pressure above the far stress from 60 to"
                    " 600 s: mean relative error of the steps", error.mean(), 0.05)
    chapter.at_most("slow.pressure_steps", "slow injection: the same, largest error of a step",
                    error.max(), 0.07)
    balance = run.summary["mass_balance"]
    chapter.at_most("slow.mass", "slow injection: error of the mass balance over the fluid pumped",
                    abs(balance["error_m2"]) / balance["in_m2"], 1e-9)
    found = {"length": (times, lengths), "width": (times, widths), "pressure": (moments, pressures)}
    figure, panels = growth_figure(found, SLOW, np.geomspace(*DECADE, 100))
    for axes in panels:  # less than a decade: marks of 10 to a power would run into each other
        axes.set_xticks([60, 100, 200, 300, 600], labels=["60", "100", "200", "300", "600"])
        axes.xaxis.set_minor_formatter("")
        axes.yaxis.set_minor_formatter("{x:g}")
        axes.yaxis.set_major_formatter("{x:g}")
    panels[2].set_ylabel("Pressure above the far stress (MPa)")
    chapter.add_figure(figure, "Growth of the crack by slow injection")


def check(chapter: Chapter, work: Path) -> None:
    fast(chapter, work)
    slow(chapter, work / "slow")
