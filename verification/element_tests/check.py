# SPDX-License-Identifier: BSD-3-Clause
"""A square of wet rock: pressed while sealed, pressed along one axis, and soaked under pressure."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from poroelastic_formulas import PorousRock
from program import run_case
from report import Chapter

TITLE = "Element tests: pressure of sealed rock, expansion of soaked rock"
HERE = Path(__file__).parent
ROCK = PorousRock(biot=0.8)
LOAD = 10e3  # Pa: the mean stress, the stress of the oedometer, the pressure of the fluid


def means(frame) -> dict[str, float]:
    """Over the area: pressure, total stress (Pa) and strain along x and y."""
    weight = solid.areas(frame) / solid.areas(frame).sum()
    cells = frame.matrix.cell_data
    pressure = weight @ solid.pore_pressure(frame)
    found = {"pressure": pressure}
    for axes in ("xx", "yy"):
        found[f"stress {axes}"] = weight @ cells[f"stress_{axes}_Pa"] - ROCK.biot * pressure
        found[f"strain {axes}"] = weight @ cells[f"strain_{axes}"]
    return found


def expected(stress_xx: float, stress_yy: float, pressure: float) -> dict[str, float]:
    strain_xx, strain_yy = ROCK.strain(stress_xx, stress_yy, pressure)
    return {"pressure": pressure, "stress xx": stress_xx, "stress yy": stress_yy,
            "strain xx": strain_xx, "strain yy": strain_yy}


def tests() -> dict[str, tuple[str, dict, dict]]:
    """Case file, settings and expected means of each test."""
    pressed = -1.2 * LOAD, -0.8 * LOAD
    pressure = ROCK.undrained_oedometer_pressure(-LOAD)
    across = -LOAD + 2 * (ROCK.oedometer - ROCK.plane_bulk) * (
        LOAD - ROCK.biot * pressure) / ROCK.oedometer
    ramp = {"times": [0, 2e-3], "values": [0, -LOAD]}
    oedometer = {"boundary.right.traction_x": None, "boundary.right.roller": True,
                 "boundary.top.traction_y": ramp}
    return {
        "compression": ("case.toml", {},
                        expected(*pressed, ROCK.undrained_pressure(sum(pressed)))),
        "oedometer": ("case.toml", oedometer, expected(across, -LOAD, pressure)),
        "free": ("soaked.toml", {}, expected(0, 0, LOAD)),
        "pressurised": ("soaked.toml", {"boundary.outside.pressurised": True},
                        expected(-LOAD, -LOAD, LOAD)),
    }


def check(chapter: Chapter, work: Path) -> None:
    figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
    colours = plt.cm.viridis(np.linspace(0, 0.85, 4))
    for (name, (case, settings, exact)), colour in zip(tests().items(), colours):
        run = run_case(HERE / case, work / name, settings).results
        found = means(run.frame())
        for kind in ("pressure", "stress", "strain"):
            names = [quantity for quantity in exact if quantity.startswith(kind)]
            size = LOAD if kind == "stress" else max(abs(exact[quantity]) for quantity in names)
            error = max(abs(found[quantity] - exact[quantity]) for quantity in names) / size
            chapter.at_most(f"{name}.{kind}", f"{name}: error of the {kind}, relative", error, 1e-3)
        history = run.history
        axes.plot(history["time_s"] * 1e3, history["maximum_pressure_Pa"] / 1e3, color=colour,
                  label=f"{name}: {exact['pressure']:.1f} Pa")
        axes.axhline(exact["pressure"] / 1e3, color=colour, linestyle=":", linewidth=1)
        chapter.at_most(f"{name}.mass", f"{name}: error of the mass balance",
                        run.summary["mass_balance"]["relative_error"], 1e-12)
    axes.set_xlim(0, 15)
    axes.set_xlabel("Time (ms)")
    axes.set_ylabel("Largest pore pressure (kPa)")
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small", frameon=False, title="Test and exact pressure")
    chapter.add_figure(figure, "Pore pressure over time; dotted: exact values")
