# SPDX-License-Identifier: BSD-3-Clause
"""Plane waves: their speed, and how much an absorbing boundary reflects."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import run_case
from report import Chapter
from solid_formulas import lame, wave_speeds

TITLE = "Plane waves: speed of compression and shear, absorbing boundary"
HERE = Path(__file__).parent
YOUNG, POISSON, DENSITY = 10e9, 0.25, 2500.0
PEAK = 0.01  # m/s, of the pulse


# Rock so tight that its fluid moves with it.
WET = {"model.physics": "coupled", "material.rock.permeability": 1e-16,
       "material.rock.porosity": 0.1, "material.rock.biot_modulus": 10e9,
       "material.rock.biot_coefficient": 0.9, "fluid.cavitation_pressure": "-inf",
       "output.times": [0.0004, 0.00065]}


def profile(frame, component: int):
    """Places along the strip and velocities of all points, by place."""
    order = np.argsort(frame.matrix.points[:, 0])
    return (frame.matrix.points[order, 0],
            frame.matrix.point_data["velocity_m_per_s"][order, component])


def middle(frame, component: int) -> float:
    """Where the middle of the pulse is, m: the mean place weighted by the velocity."""
    cells = frame.matrix.cells
    velocity = frame.matrix.point_data["velocity_m_per_s"][cells, component].mean(axis=1)
    weight = velocity * solid.areas(frame)
    return weight @ solid.centres(frame)[:, 0] / weight.sum()


def pulse(x, time: float, speed: float, duration: float):
    late = time - np.asarray(x) / speed
    shape = 0.5 * PEAK * (1 - np.cos(2 * np.pi * late / duration))
    return np.where((late > 0) & (late < duration), shape, 0.0)


def wet(chapter: Chapter, work: Path) -> None:
    """A compression wave in sealed rock, which its fluid makes stiffer by alpha^2 M."""
    run = run_case(HERE / "compression.toml", work / "wet", WET).results
    first, shear = lame(YOUNG, POISSON)
    speed = np.sqrt((first + 2 * shear + 0.9**2 * 10e9) / DENSITY)
    frames = [run.frame(time) for time in run.times[1:3]]
    found = (middle(frames[1], 0) - middle(frames[0], 0)) / (frames[1].time - frames[0].time)
    chapter.at_most("wet.speed", f"compression wave in wet rock: error of its speed, {speed:.0f} "
                    "m/s, relative", abs(found / speed - 1), 0.01)
    chapter.at_most("wet.energy", "compression wave in wet rock: error of the energy balance",
                    solid.residual(run), 1e-3)


def check(chapter: Chapter, work: Path) -> None:
    speeds = wave_speeds(YOUNG, POISSON, DENSITY)
    figure, both = plt.subplots(2, 1, figsize=(8, 6), layout="constrained", sharex=True)
    waves = (("compression", 0, speeds[0], 2e-4), ("shear", 1, speeds[1], 3.2e-4))
    for (name, component, speed, duration), axes in zip(waves, both):
        run = run_case(HERE / f"{name}.toml", work / name).results
        frames = [run.frame(time) for time in run.times[1:3]]
        found = ((middle(frames[1], component) - middle(frames[0], component))
                 / (frames[1].time - frames[0].time))
        chapter.at_most(f"{name}.speed", f"{name} wave: error of its speed, {speed:.0f} m/s, "
                        "relative", abs(found / speed - 1), 0.01)
        history = run.history
        left = history["kinetic_J_per_m"][-1] + history["elastic_J_per_m"][-1]
        chapter.at_most(f"{name}.reflected", f"{name} wave: energy left in the strip after the "
                        "absorbing boundary over that of the wave",
                        left / history["external_work_J_per_m"].max(), 0.01)
        chapter.at_most(f"{name}.energy", f"{name} wave: error of the energy balance",
                        solid.residual(run), 1e-3)
        for frame, colour in zip(frames, plt.cm.viridis([0.2, 0.6])):
            x, velocity = profile(frame, component)
            axes.plot(x, velocity * 1e3, ".", markersize=3, color=colour,
                      label=f"{frame.time * 1e3:.2f} ms")
            axes.plot(x, pulse(x, frame.time, speed, duration) * 1e3, "k", linewidth=0.8)
        axes.set_title(f"{name.capitalize()} wave; black: exact", fontsize=10)
        axes.set_ylabel("Velocity (mm/s)")
        axes.grid(alpha=0.3)
        axes.legend(frameon=False)
    both[1].set_xlabel("x (m)")
    chapter.add_figure(figure, "Pulses on their way along the strip")
    wet(chapter, work)
