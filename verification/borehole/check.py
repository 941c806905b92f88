# SPDX-License-Identifier: BSD-3-Clause
"""Fluid spreads from a borehole into the rock, which swells: pore pressure and total stress, with a
wall on which nothing presses and with one on which the fluid does."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from percolith.run_directory import read_table
from poroelastic_formulas import PorousRock
from program import run_case
from report import Chapter

TITLE = "Borehole: pore pressure and stress round a wall under fluid pressure"
HERE = Path(__file__).parent
TIMES = ("0.01472", "0.1472")  # s, of the table
HALF_RAMP = 0.15e-3  # s: the pressure stands for one that comes at once in the middle of its ramp
WALL, RADIUS = 1e6, 0.1  # Pa, m
NEAR, FAR = 0.115, 0.6  # m: two elements from the wall, end of the table
BIOT = PorousRock().biot
LABELS = {"pressure": "pressure", "radial": "radial stress", "hoop": "hoop stress"}
SYMBOLS = {"pressure": "p", "radial": "srr", "hoop": "stt"}


def profiles(frame) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Radii of the vertices inside the rock (m); pressure, radial and hoop total stress (Pa)."""
    pressure = solid.pore_pressure(frame)
    radial, hoop = (stress - BIOT * pressure for stress in solid.polar_stress(frame))
    places, radial = solid.recovered(frame, radial)
    _, hoop = solid.recovered(frame, hoop)
    order = np.lexsort(np.round(frame.matrix.points, 9).T[::-1])
    pressure = frame.matrix.point_data["pressure_Pa"][order]
    radius = np.hypot(*places.T)
    inside = (radius > NEAR) & (radius < FAR) & (places.min(axis=1) > 1e-6)
    return radius[inside], {"pressure": pressure[inside], "radial": radial[inside],
                            "hoop": hoop[inside]}


def reference(table, radius, time: str, pressurised: bool) -> dict[str, np.ndarray]:
    exact = {name: np.interp(radius, table["r_m"], table[f"{symbol}_t{time}s"])
             for name, symbol in SYMBOLS.items()}
    if pressurised:
        exact["radial"] = exact["radial"] - WALL * (RADIUS / radius) ** 2
        exact["hoop"] = exact["hoop"] + WALL * (RADIUS / radius) ** 2
    return exact


def draw(axes, radius, found, line, exact, label: str) -> None:
    colours = plt.cm.viridis([0.1, 0.5, 0.8])
    for (name, values), colour in zip(found.items(), colours):
        axes.plot(radius, values / 1e6, ".", markersize=2, color=colour, label=name)
        axes.plot(line, exact[name] / 1e6, "k", linewidth=0.8)
    axes.set_title(label, fontsize=10)
    axes.set_xlabel("Radius (m)")
    axes.grid(alpha=0.3)


def check(chapter: Chapter, work: Path) -> None:
    table = read_table(HERE / "borehole_wall_pressure.csv")
    line = table["r_m"]
    figure, all_axes = plt.subplots(1, 3, figsize=(12, 4.2), layout="constrained")
    variants = (("bare", {}, TIMES),
                ("pressurised", {"boundary.wall.pressurised": True, "time.end": 0.01487,
                                 "output.times": []}, TIMES[:1]))
    panels = iter(all_axes)
    for name, settings, times in variants:
        run = run_case(HERE / "case.toml", work / name, settings).results
        for time in times:
            radius, found = profiles(run.frame(float(time) + HALF_RAMP))
            exact = reference(table, radius, time, name == "pressurised")
            for quantity, values in found.items():
                chapter.at_most(f"{name}.{quantity}.{time}", f"{name} wall, {time} s: largest "
                                f"error of the {LABELS[quantity]} over the wall pressure",
                                abs(values - exact[quantity]).max() / WALL, 0.02)
            draw(next(panels), radius, found, line,
                 reference(table, line, time, name == "pressurised"), f"{name} wall, {time} s")
        chapter.at_most(f"{name}.mass", f"{name} wall: error of the mass balance",
                        run.summary["mass_balance"]["relative_error"], 1e-12)
    all_axes[0].set_ylabel("Pressure, total stress (MPa)")
    all_axes[0].legend(frameon=False, markerscale=4)
    chapter.add_figure(figure, "Pressure and stress at all vertices over the radius; black: table")
