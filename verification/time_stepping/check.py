# SPDX-License-Identifier: BSD-3-Clause
"""Order of the implicit scheme in the time step, and explicit against implicit."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from program import run_case
from report import Chapter
from studies import observed_order, run_example

TITLE = "Time stepping: order of backward Euler, explicit against implicit"
CASE = Path(__file__).with_name("case.toml")


def pressures(result) -> np.ndarray:
    frame = result.results.frame()
    return np.concatenate([frame.matrix.point_data["pressure_Pa"]]
                          + ([frame.cracks.point_data["pressure_Pa"]] if frame.cracks else []))


def backward_euler(chapter: Chapter, work: Path) -> None:
    steps = [1e-3 / 2**i for i in range(4)]
    runs = [pressures(run_case(CASE, work / f"step_{i}", {"time.step": step}))
            for i, step in enumerate(steps)]
    # The difference of two runs is half the error of the coarser one, at order 1.
    changes = [abs(a - b).max() for a, b in zip(runs, runs[1:])]
    order = observed_order(steps[:-1], changes)
    chapter.at_least("order.low", "fixed steps of backward Euler: order in time", order, 0.9)
    chapter.at_most("order.high", "the same, from above", order, 1.1)
    figure, axes = plt.subplots(figsize=(6, 4.2), layout="constrained")
    axes.loglog(np.array(steps[:-1]) * 1e3, np.array(changes) / 1e3, "o-",
                color=plt.cm.viridis(0.3), label="change when the step is halved")
    axes.loglog(np.array(steps[:-1]) * 1e3, changes[0] / 1e3 * np.array(steps[:-1]) / steps[0],
                "k:", label="order 1")
    axes.set_xlabel("Time step (ms)")
    axes.set_ylabel("Largest change of pressure (kPa)")
    axes.grid(alpha=0.3, which="both")
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Strip at 0.02 s: error of the fixed step of backward Euler")


def adaptive(chapter: Chapter, work: Path) -> None:
    """The error-controlled step against the same mesh with very small steps. An error per step
    of second order leaves an error of first order: it falls with the root of the tolerance."""
    exact = pressures(run_case(CASE, work / "small_steps", {"time.step": 2e-6}))
    errors = []
    for tolerance in (1e-2, 1e-3, 1e-4):
        result = run_case(CASE, work / f"tolerance_{tolerance}", {"time.tolerance": tolerance})
        errors.append(abs(pressures(result) - exact).max() / 1e5)
        chapter.at_most(f"tolerance.{tolerance}", f"adaptive steps, tolerance {tolerance}: largest "
                        "error of time over the pressure range", errors[-1], 0.2 * tolerance**0.5)
    chapter.at_least("tolerance.gain", "error at tolerance 1e-2 over that at 1e-4",
                     errors[0] / errors[2], 5)


def explicit(chapter: Chapter, work: Path) -> None:
    for name, end, step, limit in (("strip", 0.02, 2e-5, 1e-3),
                                   ("single_fracture", 0.01, 2e-6, 1e-3)):
        settings = {"time.end": end, "output.times": []}
        implicit = run_example(name, work, f"{name}_implicit", settings | {"time.step": step})
        forward = run_example(name, work, f"{name}_explicit",
                              settings | {"time.scheme": "explicit", "time.step": step})
        a, b = pressures(implicit), pressures(forward)
        chapter.at_most(f"explicit.{name}", f"{name}: explicit minus implicit over the pressure "
                        "range", abs(a - b).max() / np.ptp(a), limit)
        chapter.at_most(f"explicit.{name}.balance", f"{name}, explicit: mass balance error",
                        forward.balance, 1e-12)


def partly_saturated(chapter: Chapter, work: Path) -> None:
    """The front in a strip whose pores are 30 % full at the start, by both schemes and by the sharp
    front x = sqrt(2 k P t/(mu phi (1 - s_0)))."""
    end, empty = 200.0, 0.7
    sharp = np.sqrt(2 * 2e-13 * 1e5 * end / (1e-3 * 0.1 * empty))
    fronts = []
    for scheme in ("implicit", "explicit"):
        settings = {"time.scheme": scheme, "time.step": 0.02, "time.end": end,
                    "initial.saturation": 1 - empty, "fluid.bulk_modulus": 1e7}
        result = run_case(CASE, work / f"dry_{scheme}", settings)
        rows = result.results.probe("centre").at_time()
        inside = rows["x_m"] < 0.91  # the right end is held at pressure 0 and full
        filled = np.trapezoid(rows["saturation"][inside] - (1 - empty), rows["x_m"][inside])
        fronts.append(filled / empty)
        chapter.at_most(f"dry.{scheme}.front", f"partly saturated strip, {scheme}: error of the "
                        f"front at {sharp:.3g} m, m, elements of 0.05 m", abs(fronts[-1] - sharp),
                        0.025)
        chapter.at_most(f"dry.{scheme}.balance", f"partly saturated strip, {scheme}: mass balance "
                        "error", result.balance, 1e-12)
    chapter.at_most("dry.difference", "partly saturated strip: front, explicit minus implicit, m",
                    abs(fronts[0] - fronts[1]), 2e-3)


def check(chapter: Chapter, work: Path) -> None:
    backward_euler(chapter, work)
    adaptive(chapter, work)
    explicit(chapter, work)
    partly_saturated(chapter, work)
