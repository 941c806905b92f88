# SPDX-License-Identifier: BSD-3-Clause
"""A well under pressure: cracks run outward from its wall, fluid follows, tension moves with the
tips; both kinds of strength, both kinds of crack storage."""

from pathlib import Path

import coupled
import matplotlib.pyplot as plt
import numpy as np
import solid
from crack_paths import branches, broken_lines
from report import Chapter
from studies import check_criteria, run_example

TITLE = "Pressurised well: radial cracks that fluid drives"
WALL = 0.1  # m
WINDOW = ((-0.7, 0.7), (-0.7, 0.7))
COUNTED = (1.4e-4, 3.5e-4)  # s: 1000 and 2500 steps of 1.4e-7 s, as in the paper's figures
TIMES = [0.05e-3, *COUNTED, 0.45e-3]  # s
VARIANTS = {"total stress": {"model.joint_stress": "total"},
            "clamped storage": {"model.crack_storage": "clamped"},
            "undamped": {"damping.local": 0}}


def from_wall(frame):
    """Points (m) of the cracks that hang together with the wall."""
    lines = broken_lines(frame)
    ends = lines.reshape(-1, 2)
    return branches(lines, {"wall": list(ends[np.hypot(*ends.T) < 1.001 * WALL])})["wall"]


def tip(frame) -> float:
    """Largest radius (m) of the cracks that hang together with the wall."""
    points = from_wall(frame)
    return float(np.hypot(*points.T).max()) if len(points) else WALL


def main_cracks(frame, radius: float, apart: float = np.radians(12)) -> int:
    """Number of cracks that cross a circle; joints nearer than `apart` (rad) count once."""
    lines = broken_lines(frame)
    ends = np.hypot(lines[..., 0], lines[..., 1])
    middles = lines[(ends.min(axis=1) <= radius) & (ends.max(axis=1) > radius)].mean(axis=1)
    if not len(middles):
        return 0
    angle = np.sort(np.arctan2(middles[:, 1], middles[:, 0]))
    gaps = np.diff(np.append(angle, angle[0] + 2 * np.pi))
    return max(1, int((gaps > apart).sum()))


def hoop_stress(frame):
    """Radius (m) of the triangles, effective stress (Pa) round the well."""
    x, y = solid.centres(frame).T
    angle = np.arctan2(y, x)
    cells = frame.matrix.cell_data
    s, c = np.sin(angle), np.cos(angle)
    hoop = (cells["stress_xx_Pa"] * s**2 + cells["stress_yy_Pa"] * c**2
            - 2 * cells["stress_xy_Pa"] * s * c)
    return np.hypot(x, y), hoop


def mean_pressure_at_wall(frame) -> float:
    """Of the pores within 4 cm of the wall, Pa."""
    near = np.hypot(*solid.centres(frame).T) < WALL + 0.04
    weight = solid.areas(frame)[near]
    return float(weight @ solid.pore_pressure(frame)[near] / weight.sum())


def broken_at(run, time: float) -> int:
    return int((run.events["time_s"] <= time).sum())


def behaviour(chapter: Chapter, run) -> None:
    last, early = run.frame(), run.frame(0.15e-3)
    chapter.at_least("tip", "radius that the cracks reach, m", tip(last), 0.4)
    chapter.at_least("main_cracks", "cracks that cross r = 0.3 m", main_cracks(last, 0.3), 4)
    chapter.at_least("outward", "radius of the tips at the end less that at 0.15 ms, m",
                     tip(last) - tip(early), 0.1)
    lag = run.history["filled_crack_length_m"][-1] / run.history["crack_length_m"][-1]
    chapter.at_most("fluid_follows", "length of cracks that fluid fills over their length", lag,
                    0.98)
    radius, hoop = hoop_stress(last)
    near = radius < 0.14
    chapter.at_most("compression", "effective hoop stress within 4 cm of the wall, mean, Pa",
                    hoop[near].mean(), 0)
    for name, frame in (("early", early), ("late", last)):
        radius, hoop = hoop_stress(frame)
        tensile = hoop > np.percentile(hoop, 99)
        chapter.at_most(f"tension_{name}", f"{frame.time * 1e3:.2f} ms: median radius of the "
                        "hundredth of the triangles with most hoop tension less that of the tips, "
                        "m", abs(np.median(radius[tensile]) - tip(frame)), 0.15)
    pressures = [mean_pressure_at_wall(run.frame(time)) for time in TIMES]
    chapter.at_least("wall_rises", "pore pressure within 4 cm of the wall, mean, least rise from "
                     "one picture to the next, MPa", np.diff(pressures).min() / 1e6, 0.05)
    summary = run.summary["mechanics"]
    chapter.at_most("shear", "joints that broke in shear alone over all that broke",
                    summary["broken_joints_shear"] / summary["broken_joints"], 0.05)
    new = last.cracks.cell_data["mode"] > 0
    opening = np.median(last.cracks.cell_data["opening_m"][new])
    slip = np.median(abs(last.cracks.cell_data["slip_m"][new]))
    chapter.at_least("opening", "median opening of the new cracks over their median slip",
                     opening / slip, 1.2)


def check(chapter: Chapter, work: Path) -> None:
    shipped = check_criteria(chapter, "pressurised_well", work).results
    behaviour(chapter, shipped)
    runs = {"effective stress": shipped}
    for name, settings in VARIANTS.items():
        result = run_example("pressurised_well", work, name.replace(" ", "_"), settings)
        runs[name] = result.results
        label = name.split()[0]
        chapter.at_most(f"{label}.balance", f"{name}: error of the mass balance", result.balance,
                        1e-12)
        chapter.at_most(f"{label}.energy", f"{name}: error of the energy balance",
                        result.energy_error, 1e-3)
        chapter.at_least(f"{label}.tip", f"{name}: radius that the cracks reach, m",
                         tip(result.results.frame()), 0.4)
    counts = {name: [broken_at(run, time) for time in COUNTED] for name, run in runs.items()}
    chapter.at_most("total.fewer", "joints broken at 0.35 ms with total over those with effective "
                    "stress: pore pressure strengthens there", counts["total stress"][1]
                    / counts["effective stress"][1], 0.8)
    chapter.at_most("clamped.same", "apertures stay below maximum_aperture: joints broken with "
                    "clamped less those with unclamped storage",
                    abs(counts["clamped storage"][1] - counts["effective stress"][1]), 0)
    frames = coupled.at_times(shipped, TIMES)
    chapter.add_figure(coupled.stress_series(frames, (-4, 4), WINDOW),
                       "Effective principal stress and cracks, coloured by how they broke; 0.14 "
                       "and 0.35 ms are 1000 and 2500 steps of the paper", "stress")
    chapter.add_figure(coupled.pressure_series(frames, WINDOW, largest=10),
                       "Pressure in pores and cracks; cracks have a white edge, and are dark "
                       "inside where they are dry", "fluid")
    curves(chapter, runs)
    chapter.add_figure(solid.energy_figure(shipped), "Energies")


def curves(chapter: Chapter, runs: dict) -> None:
    figure, row = plt.subplots(1, 3, figsize=(13, 4), layout="constrained")
    for (name, run), colour in zip(runs.items(), plt.cm.viridis([0.05, 0.35, 0.6, 0.85])):
        history = run.history
        style = "--" if name == "clamped storage" else "-"
        row[0].plot(history["time_s"] * 1e3, history["broken_joints"], style, color=colour,
                    label=name)
        row[1].plot(np.array(run.times) * 1e3, [tip(run.frame(time)) for time in run.times], style,
                    color=colour)
        row[2].plot(history["time_s"] * 1e3, history["boundary.wall.volume_m2"] * 1e3, style,
                    color=colour)
    for axes, label in zip(row, ("Joints that broke", "Radius of the tips (m)",
                                 "Volume that left the well (10⁻³ m³/m)")):
        axes.set_xlabel("Time (ms)")
        axes.set_ylabel(label)
        axes.grid(alpha=0.3)
    row[0].legend(frameon=False, fontsize="small")
    row[0].set_ylim(0, 400)  # without damping more than a thousand
    chapter.add_figure(figure, "Cracks over time: by the stress that strength is compared with, by "
                       "what cracks hold, and without damping", "growth")
