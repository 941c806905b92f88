# SPDX-License-Identifier: BSD-3-Clause
"""A column of wet rock settles under a load on its drained top, as its fluid leaves (Terzaghi)."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from percolith.run_directory import read_table
from poroelastic_formulas import Consolidation, PorousRock
from program import run_case
from report import Chapter
from studies import compare_figure

TITLE = "Consolidation of a column: pressure and settlement"
HERE = Path(__file__).parent
TIMES = ("0.0735795", "0.147159", "0.441477", "0.735795", "1.47159")  # s, of the table
HALF_RAMP = 0.6e-3  # s: the load stands for one that comes at once in the middle of its ramp
EXACT = Consolidation(PorousRock(), height=1.0, load=1e6)


# The same column where the fluid flows far faster than waves travel, under a load that grows
# steadily: pores at rest with it after the first waves.
FAST_END = 0.05  # s
FAST = {
    "material.rock.permeability": 1e-9,
    "boundary.top.traction_y": {"times": [0, FAST_END], "values": [0, -1e6]},
    "time.end": FAST_END,
    "time.pore_flow": "implicit",
    "output.times": None,
}


def settlement_figure(history):
    figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
    line = np.geomspace(1e-4, 1.47, 200)
    axes.semilogx(history["time_s"] - HALF_RAMP, -history["boundary.top.displacement_y_m"] * 1e6,
                  ".", markersize=3, color=plt.cm.viridis(0.4), label="computed")
    axes.semilogx(line, EXACT.settlement(line) * 1e6, "k", linewidth=1, label="exact")
    axes.set_ylim(30, 60)
    axes.set_xlim(left=1e-3)
    axes.set_xlabel("Time (s)")
    axes.set_ylabel("Settlement of the top (µm)")
    axes.grid(alpha=0.3, which="both")
    axes.legend(frameon=False)
    return figure


def check_fast(chapter: Chapter, work: Path) -> None:
    rock = PorousRock(mobility=1e-6)
    run = run_case(HERE / "case.toml", work / "fast", FAST).results
    rows = run.probe("axis").at_time(FAST_END)
    rate = rock.undrained_oedometer_pressure(-1e6) / FAST_END  # Pa/s, of pores that are sealed
    exact = rate * (1 - rows["y_m"]**2) / (2 * rock.diffusivity)
    chapter.at_most("fast.pressure", "implicit pores under a load that grows steadily: largest "
                    "difference of the pressure over the largest pressure",
                    abs(rows["pressure_Pa"] - exact).max() / exact.max(), 0.01)
    # What the fluid still bears, its mean pressure, has not settled.
    settled = (1e6 - rock.biot * exact.max() * 2 / 3) / rock.oedometer
    chapter.at_most("fast.settlement", "the same: settlement of the top, relative error",
                    abs(-rows["displacement_y_m"][-1] / settled - 1), 0.01)
    chapter.at_most("fast.mass", "the same: error of the mass balance",
                    run.summary["mass_balance"]["relative_error"], 1e-12)


def check(chapter: Chapter, work: Path) -> None:
    run = run_case(HERE / "case.toml", work / "case").results
    table = read_table(HERE / "terzaghi.csv")
    curves = []
    for time in TIMES:
        rows = run.probe("axis").at_time(float(time) + HALF_RAMP)
        reference = np.interp(rows["y_m"], table["z_m"], table[f"p_Pa_t{time}s"])
        curves.append((f"{float(time):.3g} s", rows["y_m"], rows["pressure_Pa"], reference))
        chapter.at_most(f"pressure.{time}", f"largest difference from the table at {time} s over "
                        "the first pressure",
                        abs(rows["pressure_Pa"] - reference).max() / EXACT.first_pressure, 0.01)
        settled = -rows["displacement_y_m"][-1]
        chapter.at_most(f"settlement.{time}", f"settlement of the top at {time} s, relative error",
                        abs(settled / EXACT.settlement(float(time))[0] - 1), 0.01)
    chapter.at_most("energy", "error of the energy balance", solid.residual(run), 1e-3)
    chapter.at_most("mass", "error of the mass balance",
                    run.summary["mass_balance"]["relative_error"], 1e-12)
    check_fast(chapter, work)
    chapter.add_figure(compare_figure(curves, "Height (m)", "Pressure (kPa)", 1e3),
                       "Pressure along the column; circles: table")
    chapter.add_figure(settlement_figure(run.history), "Settlement of the top")
