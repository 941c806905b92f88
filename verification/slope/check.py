# SPDX-License-Identifier: BSD-3-Clause
"""A block on a joint in a rock slope: stays and slides on the two sides of limit equilibrium, dry
and with water in the joint and in the crack behind it."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from criteria import EXAMPLES
from program import run_case
from report import Chapter
from solid_formulas import plane_failure, slide_distance
from studies import check_criteria, run_example

TITLE = "Slope: plane failure by limit equilibrium, dry and wet"
DIP, FACE = np.radians(35), np.radians(60)
HEIGHT, OUT, BACK = 20.0, 4.0, 20.0  # m: of the bench, of the joint at its face, of the crack
GRAVITY, ROCK, WATER = 9.81, 2500 * 9.81, 9810.0  # m/s2, N/m3
REACH = BACK - OUT / np.tan(FACE)  # m, of the joint along x
DEPTH = HEIGHT - OUT - REACH * np.tan(DIP)  # m, of the crack
# The triangle between face, joint and crack less what sticks out above the ground.
AREA = 0.5 * (HEIGHT - OUT + DEPTH) * REACH - 0.5 * (HEIGHT - OUT) ** 2 / np.tan(FACE)
WEIGHT = AREA * ROCK  # N/m
UPLIFT = 0.5 * WATER * DEPTH * REACH / np.cos(DIP)  # N/m, of pressure that falls evenly
PUSH = 0.5 * WATER * DEPTH**2  # N/m


def friction_for(safety: float, wet: bool) -> float:
    """Friction angle (rad) that gives the block this factor of safety."""
    water = (UPLIFT, PUSH) if wet else (0.0, 0.0)
    return float(np.arctan(safety / plane_failure(WEIGHT, DIP, np.pi / 4, *water)))


def moved(run) -> tuple[np.ndarray, np.ndarray]:
    """Times (s), displacement of the middle of the block (m)."""
    rows = run.probe("block")
    return rows["time_s"], np.hypot(rows["displacement_x_m"], rows["displacement_y_m"])


def run_at(work: Path, safety: float, wet: bool):
    angle = friction_for(safety, wet)
    settings = {"fracture.joint.friction_angle": angle, "fracture.crack.friction_angle": angle}
    label = f"{'wet' if wet else 'dry'}_{safety:.2f}"
    if wet:
        return run_case(EXAMPLES / "slope/wet.toml", work / label, settings).results
    return run_example("slope", work, label, settings).results


def check(chapter: Chapter, work: Path) -> None:
    shipped = check_criteria(chapter, "slope", work).results
    acceleration(chapter, shipped)
    runs = {}
    for wet in (False, True):
        for safety in (0.95, 1.05):
            run = runs[wet, safety] = run_at(work, safety, wet)
            label = f"{'wet' if wet else 'dry'}.{'slides' if safety < 1 else 'stays'}"
            words = f"{'wet' if wet else 'dry'}, factor of safety {safety:.2f}"
            moves = moved(run)[1][-1]
            if safety < 1:
                chapter.at_least(label, f"{words}: displacement at the end, m", moves, 0.1)
            else:
                chapter.at_most(label, f"{words}: displacement at the end, m", moves, 2e-3)
                last = run.history["kinetic_J_per_m"]
                chapter.at_most(f"{label}.rest", f"{words}: kinetic energy at the end over the "
                                "largest", last[-1] / last.max(), 1e-3)
            chapter.at_most(f"{label}.balance", f"{words}: error of the energy balance",
                            solid.residual(run), 1e-3)
    water = runs[True, 1.05].probe("water").at_time()
    exact = WATER * DEPTH * (water["x_m"] - water["x_m"][0]) / np.ptp(water["x_m"])
    chapter.at_most("wet.pressure", "wet: largest difference of the pressure in the joint from one "
                    "that falls evenly to none at the face, over the largest",
                    abs(water["pressure_Pa"] - exact).max() / (WATER * DEPTH), 0.05)
    chapter.add_figure(motion(shipped, runs), "Displacement of the block over time, and the slope")


def acceleration(chapter: Chapter, run) -> None:
    rows = run.probe("block")
    speed = np.hypot(rows["velocity_x_m_per_s"], rows["velocity_y_m_per_s"])
    late = rows["time_s"] > 1.0
    found = np.polyfit(rows["time_s"][late], speed[late], 1)[0]
    expected = 2 * slide_distance(1.0, DIP, np.radians(32.22), GRAVITY)  # m/s2, from rest
    chapter.at_most("acceleration", "dry, factor of safety 0.90: acceleration over that of a block "
                    f"on a plane, {expected:.4f} m/s2, less 1", abs(found / expected - 1), 0.01)


def motion(shipped, runs: dict):
    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 4.4), layout="constrained")
    curves = {(False, 0.90): shipped} | runs
    for (wet, safety), run in curves.items():
        left.semilogy(*(values[1:] for values in moved(run)), "--" if wet else "-",
                      color=plt.cm.viridis((safety - 0.9) * 5),
                      label=f"{'wet' if wet else 'dry'}, factor of safety {safety:.2f}")
    left.set_xlabel("Time (s)")
    left.set_ylabel("Displacement (m)")
    left.set_ylim(1e-4, 3)
    left.grid(alpha=0.3)
    left.legend(frameon=False, fontsize="small")
    frame = shipped.frame()
    speed = np.hypot(*frame.matrix.point_data["velocity_m_per_s"].T)
    speed = speed[frame.matrix.cells].mean(axis=1)
    rock = solid.draw_rock(right, frame, speed, magnify=1.0)
    solid.colour_bar(figure, right, rock, "Velocity (m/s)")
    return figure
