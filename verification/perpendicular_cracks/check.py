# SPDX-License-Identifier: BSD-3-Clause
"""Two cracks across each other: one runs into the other, which turns away from it; as printed,
where all fluid leaks off; by Biot coefficient and by mesh."""

from pathlib import Path

import coupled
import matplotlib.pyplot as plt
import numpy as np
import solid
from crack_paths import branches, broken_lines
from program import ROOT, run_case
from report import Chapter
from set_ups import mesh_figure
from studies import check_criteria, run_example

TITLE = "Perpendicular cracks: one runs into the other"
EXAMPLE = ROOT / "examples/perpendicular_cracks"
ROOTS = {"horizontal": [(-0.9, 0.0), (-0.5, 0.0), (-0.1, 0.0)],
         "vertical": [(0.3, -0.4), (0.3, 0.0), (0.3, 0.4)]}
TIMES = [0.1, 0.3, 0.6, 0.98]  # s
EARLY = 0.4  # s, end of the variants
NOTES = [(0, 1.85, "all sides fixed, no pressure"), (-0.5, 0.12, "0.01 m²/s"),
         (0.7, 0.0, "0.01 m²/s")]
VARIANTS = {"0.09 m": {"mesh.file": str(EXAMPLE / "perpendicular_cracks_fine.msh")},
            "Biot coefficient 1": {"material.rock.biot_coefficient": 1}}
PERMEABILITY, VISCOSITY, RATE = 1e-11, 1e-3, 0.02  # m2, Pa s, m2/s: as printed, both sources


def reach(frame) -> dict[str, float]:
    """How far (m) the cracks have come: left, up and down, how far right the upper and the lower
    end of the vertical one; and the way between both cracks that is not broken."""
    points = branches(broken_lines(frame), ROOTS)
    vertical, horizontal = points["vertical"], points["horizontal"]
    top, bottom = vertical[np.argmax(vertical[:, 1])], vertical[np.argmin(vertical[:, 1])]
    apart = vertical[:, None, :] - horizontal[None, :, :]
    joined = connected(frame)
    return {"left": -horizontal[:, 0].min(), "up": top[1], "down": -bottom[1],
            "upper_right": top[0], "lower_right": bottom[0],
            "gap": 0.0 if joined else float(np.hypot(*np.moveaxis(apart, 2, 0)).min())}


def connected(frame) -> bool:
    """Whether broken joints lead from one crack to the other."""
    points = branches(broken_lines(frame), {"horizontal": ROOTS["horizontal"]})["horizontal"]
    return bool((np.hypot(*(points - np.array(ROOTS["vertical"][1])).T) < 1e-6).any())


def behaviour(chapter: Chapter, run) -> None:
    history, found = run.history, reach(run.frame())
    first = run.events["time_s"][0]
    before = history["time_s"] < first
    peak = history["source.horizontal.pressure_Pa"][before].max()
    after = (history["time_s"] > first) & (history["time_s"] < 2 * first)
    chapter.at_least("builds_up", "pressure before the first joint breaks over tensile strength",
                     peak / 2e6, 0.9)
    chapter.at_most("drops", "lowest pressure soon after it over that before",
                    history["source.horizontal.pressure_Pa"][after].min() / peak, 0.2)
    chapter.at_most("meets", "way between the cracks that is not broken, m", found["gap"], 0)
    chapter.at_least("left", "way of the horizontal crack to the left, m; the side is at 2",
                     found["left"], 1.6)
    for name, label in (("up", "upper"), ("down", "lower")):
        chapter.at_least(name, f"way of the {label} end of the vertical crack, m; the side is at 2",
                         found[name], 1.2)
        chapter.at_least(f"{label}_bends", f"bend of its {label} end to the right, m",
                         found[f"{label}_right"] - 0.3, 0.1)


def seeps(chapter: Chapter, run) -> None:
    """The pore pressure rises, beside the cracks."""
    pressures = [mean_pressure(run.frame(time)) for time in TIMES]
    chapter.at_least("seeps", "mean pore pressure, least rise from one picture to the next over "
                     "that in the first", np.diff(pressures).min() / pressures[0], 0.1)
    frame = run.frame(TIMES[-1])
    pressure = solid.pore_pressure(frame)
    most = solid.centres(frame)[pressure > np.percentile(pressure, 95)]
    middles = broken_lines(frame).mean(axis=1)
    apart = np.hypot(*np.moveaxis(most[:, None] - middles[None], 2, 0)).min(axis=1)
    chapter.at_most("near_cracks", f"{frame.time:.2f} s: median way to a crack from the twentieth "
                    "of the triangles with most pore pressure, m", np.median(apart), 0.15)


def mean_pressure(frame) -> float:
    """Of all pores, Pa."""
    weight = solid.areas(frame)
    return float(weight @ solid.pore_pressure(frame) / weight.sum())


def as_printed(chapter: Chapter, work: Path):
    """Pressure that drives the injected fluid out: of a circle of 0.4 m, about half of what both
    cracks span, in one of 2.2 m, about the block."""
    result = run_case(EXAMPLE / "as_printed.toml", work / "as_printed")
    run = result.results
    expected = RATE * np.log(2.2 / 0.4) * VISCOSITY / (2 * np.pi * PERMEABILITY)
    pressure = run.history["source.horizontal.pressure_Pa"][-1]
    chapter.at_most("printed.pressure", "as printed: pressure in the cracks over that of radial "
                    f"flow, {expected / 1e6:.2f} MPa, less 1", abs(pressure / expected - 1), 0.2)
    chapter.at_most("printed.broken", "as printed: joints that broke",
                    run.history["broken_joints"][-1], 0)
    leaks = -run.history["boundary.outer_m2_per_s"][-1] / RATE
    chapter.at_most("printed.leaks", "as printed: what leaves through the sides over what is "
                    "injected, less 1", abs(leaks - 1), 0.02)
    return run


def check(chapter: Chapter, work: Path) -> None:
    shipped = check_criteria(chapter, "perpendicular_cracks", work).results
    behaviour(chapter, shipped)
    coupled.break_modes(chapter, shipped)
    printed = as_printed(chapter, work)
    runs = {"0.15 m": shipped}
    for name, settings in VARIANTS.items():
        label = name.replace(" ", "_")
        result = run_example("perpendicular_cracks", work, label, {**settings, "time.end": EARLY})
        runs[name] = result.results
        chapter.at_most(f"{label}.balance", f"{name}: error of the mass balance", result.balance,
                        1e-12)
        chapter.at_most(f"{label}.energy", f"{name}: error of the energy balance",
                        result.energy_error, 5e-3)
    compare_meshes(chapter, shipped.frame(EARLY), runs["0.09 m"].frame())
    seeps(chapter, shipped)
    frames = coupled.at_times(shipped, TIMES, 1, "s")
    chapter.add_figure(coupled.crack_pressure_series(frames, largest=4), "Pressure in the cracks; "
                       "2 MPa is the tensile strength", "cracks")
    chapter.add_figure(coupled.pressure_series(frames), "Pressure in pores and cracks; cracks have "
                       "a white edge", "fluid")
    chapter.add_figure(coupled.stress_series(frames, (-2, 2)),
                       "Effective principal stress and cracks")
    ends = {name: (f"{name}, {EARLY:g} s", run.frame(EARLY)) for name, run in runs.items()}
    chapter.add_figure(coupled.pressure_series([ends["0.15 m"], ends["0.09 m"]]),
                       "Two meshes after 0.4 s: pressure in pores and cracks", "meshes")
    chapter.add_figure(coupled.pressure_series([ends["Biot coefficient 1"]]),
                       "Biot coefficient 1 after 0.4 s: pressure in pores and cracks")
    last = printed.frame()
    chapter.add_figure(coupled.pressure_series([(f"as printed, {last.time:.2g} s", last)]),
                       "As printed, where nothing breaks: pressure in pores and cracks", "printed")
    chapter.add_figure(mesh_figure([("", shipped.frame(0.0))], NOTES),
                       "The mesh and the two cracks", "mesh")
    curves(chapter, {**runs, "as printed": printed})
    chapter.add_figure(solid.energy_figure(shipped), "Energies")


def compare_meshes(chapter: Chapter, coarse, fine) -> None:
    first, second = reach(coarse), reach(fine)
    for name, label in (("left", "the horizontal crack to the left"),
                        ("up", "the upper end"), ("down", "the lower end")):
        chapter.at_most(f"mesh.{name}", f"0.4 s: way of {label}, 0.09 m less 0.15 m, m",
                        abs(second[name] - first[name]), 0.3)
    chapter.at_most("mesh.meets", "0.09 m, 0.4 s: way between the cracks that is not broken, m",
                    second["gap"], 0)


def curves(chapter: Chapter, runs: dict) -> None:
    figure, row = plt.subplots(1, 2, figsize=(12, 4), layout="constrained")
    for (name, run), colour in zip(runs.items(), plt.cm.viridis([0.05, 0.35, 0.6, 0.85])):
        history = run.history
        row[0].plot(history["time_s"], history["source.horizontal.pressure_Pa"] / 1e6,
                    color=colour, linewidth=0.9, label=name)
        row[1].plot(history["time_s"], history["crack_length_m"], color=colour, label=name)
    for axes, label in zip(row, ("Pressure of injection (MPa)", "Length of cracks (m)")):
        axes.set_xlabel("Time (s)")
        axes.set_ylabel(label)
        axes.grid(alpha=0.3)
        axes.legend(frameon=False, fontsize="small")
    chapter.add_figure(figure, "Pressure where the horizontal crack is fed; length of cracks",
                       "injection")
