# SPDX-License-Identifier: BSD-3-Clause
"""An empty crack with sealed faces fills from its mouth at constant pressure."""

from pathlib import Path

import formulas
import matplotlib.pyplot as plt
import numpy as np
from program import run_case
from report import Chapter

TITLE = "Filling of an empty crack: a front that moves with the square root of time"
HERE = Path(__file__).parent
APERTURE, PRESSURE, VISCOSITY, ELEMENT = 1e-4, 1e5, 1e-3, 5e-3


def fronts(result):
    """Times and the length that the fluid in the crack fills, from the saturation."""
    table = result.results.probe("crack")
    times = np.unique(table["time_s"])[1:]
    filled = [np.trapezoid(rows["saturation"], rows["x_m"])
              for rows in (table.at_time(time) for time in times)]
    return times, np.array(filled)


def check(chapter: Chapter, work: Path) -> None:
    figure, axes = plt.subplots(figsize=(7, 4.4), layout="constrained")
    for label, settings, mark in (
            ("implicit", {}, "o"),
            # The explicit step shrinks with the stiffness of the fluid: a softer one, less time.
            ("explicit", {"time.scheme": "explicit", "fluid.bulk_modulus": 2e7, "time.end": 0.5,
                          "output.interval": 0.05}, "x")):
        result = run_case(HERE / "case.toml", work / label, settings)
        times, front = fronts(result)
        exact = formulas.filling_front(times, PRESSURE, APERTURE, VISCOSITY)
        chapter.at_most(f"{label}.front", f"{label}: largest error of the front, m, at elements "
                        "of 5 mm", abs(front - exact).max(), 0.0075)
        slope = np.polyfit(np.log(times), np.log(front), 1)[0]
        chapter.at_most(f"{label}.slope", f"{label}: exponent of time, difference from 1/2",
                        abs(slope - 0.5), 0.02)
        chapter.at_most(f"{label}.balance", f"{label}: mass balance error", result.balance, 1e-12)
        axes.plot(times, front, mark, label=label, markerfacecolor="none")
        # The node at the mouth, half an element, is full from the start.
        let_in = result.results.summary["mass_balance"]["in_m2"] / APERTURE + ELEMENT / 2
        chapter.at_most(f"{label}.volume", f"{label}: fluid let in over the aperture, minus the "
                        "front, m", abs(let_in - front[-1]), 1e-3)
    time = np.linspace(0, 3, 200)
    axes.plot(time, formulas.filling_front(time, PRESSURE, APERTURE, VISCOSITY), "k",
              linewidth=1, label="analytic")
    axes.set_xlabel("Time (s)")
    axes.set_ylabel("Filled length (m)")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Filled length of the crack over time")
