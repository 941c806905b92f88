# SPDX-License-Identifier: BSD-3-Clause
"""Three parallel cracks: the outer ones turn away from the middle one, which goes straight on and
starts later; on two meshes, with effective stress, with the paper's
storage."""

from pathlib import Path

import coupled
import matplotlib.pyplot as plt
import numpy as np
import solid
from crack_paths import branches, broken_lines, deflection
from program import ROOT
from report import Chapter
from set_ups import mesh_figure
from studies import check_criteria, run_example

TITLE = "Three parallel cracks: deflection and delay by each other"
LENGTH, APART = 0.2, 0.3  # m
MOUTHS = {"upper": APART, "middle": 0.0, "lower": -APART}  # m
ROOTS = {name: [(0.0, y), (LENGTH, y)] for name, y in MOUTHS.items()}
BRIDGE = 0.06  # m, a crack may go on beside its tip, one element away
TIMES = [1e-3, 3e-3, 5e-3, 7e-3]  # s
PAPER_TIMES = [0.4e-3, 0.8e-3, 1.2e-3, 2e-3]  # s
NOTES = [(2, 1.85, "fixed, no pressure"), (0.55, -1.3, "on rollers, sealed"),
         (1.1, 0.0, "0.01 m²/s into each mouth")]
WINDOW = ((0, 1.6), (-1.2, 1.2))
COARSE = {"mesh.file": str(ROOT / "examples/three_cracks/three_cracks_coarse.msh")}
PAPER = {"model.crack_storage": "clamped", "time.end": 2e-3}
EFFECTIVE = {"model.joint_stress": "effective", "time.end": 3e-3}


def tips(frame) -> dict[str, np.ndarray]:
    """Of each crack the point (m) that is furthest from the tip it had at the start, to the right
    of that."""
    found = {}
    for name, points in branches(broken_lines(frame), ROOTS, BRIDGE).items():
        start = np.array([LENGTH, MOUTHS[name]])
        ahead = points[points[:, 0] >= LENGTH - 1e-9]
        found[name] = ahead[np.argmax(np.hypot(*(ahead - start).T))]
    return found


def growth(name: str, tip) -> float:
    """Distance of a tip from where it was at the start, m."""
    return float(np.hypot(tip[0] - LENGTH, tip[1] - MOUTHS[name]))


def angles(found: dict) -> dict[str, float]:
    return {name: deflection((LENGTH, MOUTHS[name]), tip) for name, tip in found.items()}


def turns_away(chapter: Chapter, label: str, run, time: float) -> None:
    found = tips(run.frame(time))
    angle = angles(found)
    when = f"{label}, {time * 1e3:.0f} ms"
    name = label.replace(" ", "_")
    chapter.at_least(f"{name}.upper", f"{when}: angle by which the upper crack turns up, degree",
                     angle["upper"], 15)
    chapter.at_least(f"{name}.lower", f"{when}: angle by which the lower crack turns down, degree",
                     -angle["lower"], 15)
    chapter.at_most(f"{name}.middle", f"{when}: angle of the middle crack, degree",
                    abs(angle["middle"]), 20)
    outer = 0.5 * (growth("upper", found["upper"]) + growth("lower", found["lower"]))
    chapter.at_most(f"{name}.lag", f"{when}: growth of the middle crack over the mean of the outer "
                    "ones", growth("middle", found["middle"]) / outer, 0.7)


def check(chapter: Chapter, work: Path) -> None:
    shipped = check_criteria(chapter, "three_cracks", work).results
    coupled.break_modes(chapter, shipped)
    coarse = run_example("three_cracks", work, "coarse", COARSE)
    paper = run_example("three_cracks", work, "paper", PAPER)
    effective = run_example("three_cracks", work, "effective", EFFECTIVE)
    turns_away(chapter, "0.05 m", shipped, 3e-3)
    turns_away(chapter, "0.07 m", coarse.results, 3e-3)
    turns_away(chapter, "effective stress", effective.results, 3e-3)
    turns_away(chapter, "as in the paper", paper.results, 2e-3)
    for name, result in (("coarse", coarse), ("effective", effective), ("paper", paper)):
        chapter.at_most(f"{name}.balance", f"{name}: error of the mass balance", result.balance,
                        1e-12)
        chapter.at_most(f"{name}.energy", f"{name}: error of the energy balance",
                        result.energy_error, 5e-3)
    pressures = [sum(run.history[f"source.{name}.pressure_Pa"][-1] for name in MOUTHS)
                 for run in (shipped, coarse.results)]
    chapter.at_most("mesh.pressure", "pressure at the mouths on the coarse mesh over that on the "
                    "other, less 1", abs(pressures[1] / pressures[0] - 1), 0.1)
    work_done = paper.results.history["fluid_work_J_per_m"][-1]
    put_in = injected_energy(paper.results)
    chapter.at_least("paper.work", "as in the paper: work of the fluid on the rock over what the "
                     "pumps put in, more than which it should not be", work_done / put_in, 1.0)
    work_done = shipped.history["fluid_work_J_per_m"][-1]
    chapter.at_most("work", "work of the fluid on the rock over what the pumps put in",
                    work_done / injected_energy(shipped), 1.0)
    frames = coupled.at_times(shipped, TIMES)
    chapter.add_figure(coupled.pressure_series(frames, WINDOW),
                       "Pressure in pores and cracks; cracks have a white edge, and are dark "
                       "inside where they are dry; the mouths are above the scale", "fluid")
    chapter.add_figure(coupled.pressure_series(coupled.at_times(paper.results, PAPER_TIMES),
                                               WINDOW),
                       "The same with the paper's storage, which does more work than is put in",
                       "paper_storage")
    chapter.add_figure(coupled.stress_series(frames, (-2, 2), WINDOW),
                       "Effective principal stress and cracks")
    ends = [("0.05 m", shipped.frame(5e-3)), ("0.07 m", coarse.results.frame(5e-3)),
            ("as in the paper, 2 ms", paper.results.frame())]
    chapter.add_figure(coupled.pressure_series(ends, WINDOW, largest=10),
                       "Meshes after 5 ms; storage as in the paper")
    chapter.add_figure(mesh_figure([("", shipped.frame(0.0))], NOTES),
                       "The mesh and the three cracks; the other sides are as the upper one",
                       "mesh")
    curves(chapter, {"0.05 m": shipped, "0.07 m": coarse.results,
                     "as in the paper": paper.results})
    chapter.add_figure(solid.energy_figure(shipped), "Energies")


def injected_energy(run) -> float:
    """Volume times pressure summed over the mouths, J/m."""
    history = run.history
    return float(sum(np.trapezoid(history[f"source.{name}.pressure_Pa"],
                                  history[f"source.{name}.volume_m2"]) for name in MOUTHS))


def curves(chapter: Chapter, runs: dict) -> None:
    figure, row = plt.subplots(1, 3, figsize=(13, 4), layout="constrained")
    colours = dict(zip(MOUTHS, plt.cm.viridis([0.1, 0.5, 0.85])))
    for (label, run), style in zip(runs.items(), ("-", "--", ":")):
        found = [tips(run.frame(time)) for time in run.times]
        milliseconds = np.array(run.times) * 1e3
        for name, colour in colours.items():
            row[0].plot(milliseconds, [growth(name, tip[name]) for tip in found], style,
                        color=colour, label=f"{name}, {label}")
            row[1].plot(milliseconds, [angles(tip)[name] for tip in found], style, color=colour)
            row[2].plot(run.history["time_s"] * 1e3,
                        run.history[f"source.{name}.pressure_Pa"] / 1e6, style, color=colour)
    for axes, label in zip(row, ("Growth (m)", "Angle (degree)", "Pressure at the mouth (MPa)")):
        axes.set_xlabel("Time (ms)")
        axes.set_ylabel(label)
        axes.grid(alpha=0.3)
    row[0].set_ylim(0, 1.2)
    row[0].legend(frameon=False, fontsize="x-small", ncols=3)
    chapter.add_figure(figure, "Growth, direction and pressure of the three cracks", "growth")
