# SPDX-License-Identifier: BSD-3-Clause
"""Pressure that jumps across a crack, and the law by which a joint softens."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from style import AMBER, CRACK, FLUID, GREEN, NOTE, canvas, note

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "verification"))


def jump():
    """Flow across a crack whose faces resist, and rock that a crack under pressure feeds."""
    import formulas

    figure, (across, into) = canvas(7.6, 3.1, 2, plain=False)
    for resistance, colour, label in ((0.0, GREEN, 'exchange = "inf"'),
                                      (0.15, FLUID, "each face resists"),
                                      (0.6, AMBER, "each face resists more")):
        # Steady flow from 1 to 0 through rock of resistance 1 and two faces in series.
        flux = 1.0 / (1.0 + 2.0 * resistance)
        left, right = 1.0 - 0.5 * flux, 0.5 * flux
        across.plot([0, 0.5], [1, left], color=colour, linewidth=2, label=label)
        across.plot([0.5, 1], [right, 0], color=colour, linewidth=2)
        across.plot([0.5, 0.5], [left, right], color=colour, linewidth=1, linestyle=":")
    across.plot(0.5, 0.5, "s", color=CRACK, markersize=7, zorder=5)
    note(across, "pressure\nin the crack", (0.74, 0.75), (0.51, 0.51), CRACK)
    across.set_title("flow across a crack", fontsize=10)
    across.set_xlabel("way through the rock")
    across.set_ylabel("pressure over that at the left")
    across.legend(frameon=False, fontsize=8, loc="lower left")

    x = np.linspace(0, 60, 200)
    for time, colour in ((0.01, AMBER), (0.1, FLUID), (0.2, GREEN)):
        into.plot(x, formulas.semi_infinite(x, time) / 1e6, color=colour, linewidth=2,
                  label=f"in the rock at {time:g} s")
    into.axhline(8, xmax=0.06, color=CRACK, linewidth=2)
    into.plot(0, 8, "s", color=CRACK, markersize=7, clip_on=False)
    note(into, "crack held at 8 MPa", (20, 8), (1.2, 8), CRACK)
    into.set_title("a crack feeds rock", fontsize=10)
    into.set_xlabel("distance from the crack (m)")
    into.set_ylabel("pressure (MPa)")
    into.set_ylim(0, 8.6)
    into.legend(frameon=False, fontsize=8)
    return figure


def z(damage: np.ndarray) -> np.ndarray:
    """Share of the strength that is left, M9 of the theory."""
    a, b, c = 0.63, 1.8, 6.0
    rate = c * b / ((a + b) * (a + b - 1)) - a
    return ((1 - (a + b - 1) / (a + b) * np.exp(-rate * damage))
            * (a * (1 - damage) + b * (1 - damage) ** c))


def softening():
    """Traction of a joint over its opening, and over its slip under three pressures."""
    figure, (opening, slip) = canvas(7.6, 3.1, 2, plain=False)
    peak, end = 0.12, 1.0
    o = np.linspace(peak, end, 200)
    strength = z((o - peak) / (end - peak))
    opening.fill_between(o, strength, color="#F6D9A8")
    opening.plot([0, peak], [0, 1], color=FLUID, linewidth=2)
    opening.plot(o, strength, color=FLUID, linewidth=2)
    note(opening, "area: mode_1_energy", (0.6, 0.62), (0.35, 0.35))
    note(opening, "elastic", (0.3, 0.16), (0.06, 0.45))
    opening.set_xticks([0, peak, end], ["0", "$o_p$", "$o_r$"])
    opening.set_yticks([0, 1], ["0", "tensile\nstrength"])
    opening.set_xlabel("opening")
    opening.set_ylabel("normal traction")
    note(opening, "broken", (1.02, 0.14), (1.0, 0.01))
    opening.set_title("opened", fontsize=10)

    for pressure, colour in ((0.0, FLUID), (0.5, GREEN), (1.0, AMBER)):
        friction = 0.58 * pressure
        top = 0.12 * (1 + friction)
        way = np.linspace(top, top + 0.88, 200)
        slip.plot([0, top, *way, 1.35], [0, 1 + friction, *(friction + z((way - top) / 0.88)), friction],
                  color=colour, linewidth=2,
                  label=("no pressure" if pressure == 0 else f"pressure {pressure:g} cohesion"))
    slip.set_xticks([0], ["0"])
    slip.set_yticks([0, 1], ["0", "cohesion"])
    slip.set_xlabel("slip")
    slip.set_ylabel("shear traction")
    slip.legend(frameon=False, fontsize=8, labelcolor=NOTE)
    slip.set_title("sheared: friction stays", fontsize=10)
    return figure


FIGURES = {"jump": jump, "softening": softening}
