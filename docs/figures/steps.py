# SPDX-License-Identifier: BSD-3-Clause
"""What a step of a coupled run does, in motion and quasi-static."""

from __future__ import annotations

import numpy as np
from style import AMBER, FLUID, NOTE, arrow, canvas

ROCK_BOX, FLUID_BOX, BOTH_BOX = "#F6D9A8", "#CFE4F3", "#E9E9E9"


def box(axis, at, text: str, colour: str, width: float = 2.3, height: float = 0.62) -> None:
    axis.text(*at, text, ha="center", va="center", fontsize=8.5, color="black", zorder=6)
    x, y = at[0] - width / 2, at[1] - height / 2
    axis.fill([x, x + width, x + width, x], [y, y, y + height, y + height], facecolor=colour,
              edgecolor=NOTE, linewidth=0.8, zorder=5)


def coupled_step():
    """The seven parts of a step in a ring."""
    figure, (axis,) = canvas(7.4, 5.0)
    parts = [("pressures press\non the rock", BOTH_BOX), ("forces; the rock moves", ROCK_BOX),
             ("failed joints break", ROCK_BOX), ("fluid may enter them", BOTH_BOX),
             ("the fluid learns\nthe new volumes", BOTH_BOX),
             ("flow in cracks and\ninto their faces, implicit", FLUID_BOX),
             ("flow in pores, explicit", FLUID_BOX)]
    angles = np.pi / 2 - 2 * np.pi * np.arange(7) / 7
    places = np.column_stack([3.1 * np.cos(angles), 2.3 * np.sin(angles)])
    for i, (text, colour) in enumerate(parts):
        box(axis, places[i], f"{i + 1}  {text}", colour)
        start, end = places[i], places[(i + 1) % 7]
        way = {0: 0.42, 3: 0.435, 6: 0.42}.get(i, 0.36)
        arrow(axis, start + way * (end - start), start + (1 - way) * (end - start), NOTE, 1.3)
    axis.text(0, 0.15, "one step,\na fraction of a microsecond\nto microseconds", ha="center",
              va="center", fontsize=9, color=NOTE)
    for y, colour, what in ((-3.0, ROCK_BOX, "rock"), (-3.0, FLUID_BOX, "fluid"),
                            (-3.0, BOTH_BOX, "both")):
        x = {"rock": -1.6, "fluid": 0.0, "both": 1.6}[what]
        box(axis, (x, y), what, colour, 1.2, 0.42)
    axis.set_xlim(-4.4, 4.4)
    axis.set_ylim(-3.3, 2.7)
    return figure


def quasi_static():
    """The iteration of a slow step, and what happens where rock breaks."""
    figure, (axis,) = canvas(7.4, 3.9)
    box(axis, (-3.2, 1.3), "a step of seconds\nto hours", BOTH_BOX, 2.0, 0.8)
    box(axis, (-0.2, 2.1), "flow with the\npresent volumes", FLUID_BOX, 2.2, 0.8)
    box(axis, (-0.2, 0.5), "rock goes to its\nbalance of forces", ROCK_BOX, 2.2, 0.8)
    box(axis, (3.1, 1.3), "settled:\nthe next step", BOTH_BOX, 2.0, 0.8)
    box(axis, (-0.2, -1.2), "joints break: the step is tried again in halves,\n"
        "and the flow is asked after every 25 steps of damped motion", ROCK_BOX, 6.4, 0.8)
    arrow(axis, (-2.2, 1.5), (-1.3, 2.0), NOTE)
    arrow(axis, (0.3, 1.7), (0.3, 0.92), AMBER)
    arrow(axis, (-0.7, 0.9), (-0.7, 1.68), FLUID)
    arrow(axis, (1.35, 1.3), (2.1, 1.3), NOTE)
    arrow(axis, (-0.2, 0.1), (-0.2, -0.78), NOTE)
    arrow(axis, (-3.2, -0.8), (-3.2, 0.88), NOTE)
    axis.text(0.4, 1.3, "pressures", fontsize=8, color=NOTE, va="center")
    axis.text(-0.8, 1.3, "volumes", fontsize=8, color=NOTE, va="center", ha="right")
    axis.set_xlim(-4.4, 4.4)
    axis.set_ylim(-1.8, 2.7)
    return figure


FIGURES = {"coupled_step": coupled_step, "quasi_static": quasi_static}
