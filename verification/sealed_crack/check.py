# SPDX-License-Identifier: BSD-3-Clause
"""Fluid pumped into a sealed crack, a stiff one and a soft one: pressure once the pump stops."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from fracture_formulas import PressedCrack
from program import run_case
from report import Chapter
from solid_formulas import plane_modulus

TITLE = "Sealed crack: pressure of a pumped volume"
HERE = Path(__file__).parent
CRACK = PressedCrack(1.0, plane_modulus(10e9, 0.25))
ROOM = 2e-3  # m2: aperture times length of both wings
RAMPS, PUMPING = 1e-3, 10e-3  # s: of the rate, up and down; until it falls
# Modulus of the fluid, Pa, and rate into each wing, m2/s. The stiff one gives way much less than
# the rock, the soft one about as much; of it so little is pumped that its own law stays linear.
FLUIDS = {"stiff": (2.2e9, 3e-2), "soft": (3.4e6, 3e-4)}


SLOW_RATE, SLOW_TIME = 5e-7, 600.0  # m2/s into each wing, s


def check_slow(chapter: Chapter, work: Path) -> None:
    """The volume of the stiff fluid again, pumped in ten minutes by the quasi-static scheme."""
    run = run_case(HERE / "slow.toml", work / "slow").results
    expected = CRACK.sealed_pressure(2 * SLOW_RATE * SLOW_TIME, ROOM, 2.2e9)
    history = run.history
    shut_in = history["source.pump.pressure_Pa"][history["time_s"] > 700.0]
    chapter.at_most("slow.pressure", "ten minutes of pumping, quasi-static: relative error of the "
                    "pressure after the pump stops, largest", np.max(abs(shut_in / expected - 1)),
                    0.02)
    chapter.at_most("slow.mass", "ten minutes of pumping: error of the mass balance",
                    run.summary["mass_balance"]["relative_error"], 1e-12)
    chapter.at_most("slow.steps", "ten minutes of pumping and ten of rest: steps",
                    run.summary["steps"], 100)


def check(chapter: Chapter, work: Path) -> None:
    check_slow(chapter, work)
    figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
    for (name, (modulus, rate)), colour in zip(FLUIDS.items(), plt.cm.viridis([0.2, 0.7])):
        pump = {"times": [0, RAMPS, PUMPING, PUMPING + RAMPS], "values": [0, rate, rate, 0]}
        run = run_case(HERE / "case.toml", work / name, {"fluid.bulk_modulus": modulus,
                                                         "source.pump.rate": pump}).results
        history = run.history
        injected = 2 * rate * PUMPING
        expected = CRACK.sealed_pressure(injected, ROOM, modulus)
        found = [history[f"{bound}_crack_pressure_Pa"][-1] for bound in ("minimum", "maximum")]
        chapter.at_most(f"{name}.pressure", f"{name} fluid: relative error of the pressure at the "
                        "end", abs(np.mean(found) / expected - 1), 0.02)
        chapter.at_most(f"{name}.uniform", f"{name} fluid: spread of the pressure along the crack "
                        "at the end, relative", (found[1] - found[0]) / expected, 1e-4)
        chapter.at_most(f"{name}.mass", f"{name} fluid: error of the mass balance",
                        run.summary["mass_balance"]["relative_error"], 1e-12)
        axes.plot(history["time_s"] * 1e3, history["maximum_crack_pressure_Pa"] / expected,
                  color=colour, label=f"{name} fluid: {expected / 1e3:.4g} kPa")
    axes.axhline(1, color="black", linewidth=0.8)
    axes.set_xlabel("Time (ms)")
    axes.set_ylabel("Largest pressure in the crack over expected")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Pressure over time; the pump runs for 11 ms")
