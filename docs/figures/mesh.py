# SPDX-License-Identifier: BSD-3-Clause
"""Triangles with corners of their own, joints between them, and how a node splits as joints break."""

from __future__ import annotations

import numpy as np
from style import AMBER, CRACK, EDGE, FLUID, NODE, arrow, canvas, dots, fill, note, shrunk

RING = np.array([[1.0, 0.05], [0.45, 0.9], [-0.5, 0.85], [-1.05, -0.05], [-0.5, -0.9], [0.55, -0.85]])
FAN = [np.array([[0.0, 0.0], RING[i], RING[(i + 1) % 6]]) for i in range(6)]


def triangles():
    """A mesh, and the same taken apart: what each triangle owns."""
    figure, (whole, apart) = canvas(7.2, 3.4, 2)
    for triangle in FAN:
        fill(whole, triangle)
    dots(whole, [[0, 0], *RING], EDGE)
    note(whole, "vertex", (0.05, 1.25), (0.0, 0.04))
    note(whole, "triangle", (1.25, 0.95), (0.55, 0.3))
    whole.set_title("mesh", fontsize=10)

    for triangle in FAN:
        fill(apart, shrunk(triangle, 0.78))
        dots(apart, shrunk(triangle, 0.78))
    for first, second in zip(FAN, FAN[1:] + FAN[:1], strict=True):
        # The joint between two neighbours has the two corners of each at the edge they share.
        one, other = shrunk(first, 0.78), shrunk(second, 0.78)
        fill(apart, [one[0], one[2], other[1], other[0]], "#F6D9A8", AMBER, 0.8)
    note(apart, "corner: each triangle\nhas its own three", (1.35, 1.15), shrunk(FAN[0], 0.78)[2])
    note(apart, "joint: between two triangles,\nwith four corners", (0.0, -1.3),
         (shrunk(FAN[3], 0.78)[2] + shrunk(FAN[4], 0.78)[1]) / 2 * 0.75)
    apart.set_title("what Percolith computes with", fontsize=10)
    for axis in (whole, apart):
        axis.set_xlim(-1.35, 1.9)
        axis.set_ylim(-1.5, 1.4)
    return figure


def joints():
    """Two triangles at a joint that is tied, finite or broken."""
    figure, axes = canvas(7.6, 3.5, 3)
    for axis, kind, gap in zip(axes, ("tied", "finite", "broken"), (0.0, 0.09, 0.16), strict=True):
        fill(axis, [[-gap, -0.7], [-gap, 0.7], [-1.1 - gap, 0.1]])
        fill(axis, [[gap, -0.7], [gap, 0.7], [1.1 + gap, -0.1]])
        faces = [[side * gap, y] for side in (-1, 1) for y in (-0.7, 0.7)]
        dots(axis, faces, NODE if kind != "broken" else FLUID, size=7)
        axis.set_title(kind, fontsize=10)
        axis.set_xlim(-1.5, 1.5)
        axis.set_ylim(-1.45, 1.05)
    tied, finite, broken = axes
    note(tied, "both sides share\none pressure at each end", (0, -1.15))
    for y in (-0.7, 0.7):
        arrow(finite, (-0.28, y * 0.72), (0.28, y * 0.72))
    note(finite, "two pressures, and flow\nacross a large conductance", (0, -1.15))
    fill(broken, [[-0.16, -0.7], [-0.16, 0.7], [0.16, 0.7], [0.16, -0.7]], "#CFE4F3", FLUID)
    dots(broken, [[0, -0.7], [0, 0.7]], CRACK, "s", 7)
    arrow(broken, (0, -0.5), (0, 0.5), FLUID, 2.0)
    for y in (-0.45, 0.45):
        arrow(broken, (0.02, y), (0.4, y), FLUID, 1.1)
        arrow(broken, (-0.02, y), (-0.4, y), FLUID, 1.1)
    note(broken, "crack node", (0.95, 0.9), (0.03, 0.7), CRACK)
    note(broken, "flow along the crack\nand into both faces", (0, -1.15))
    return figure


def network():
    """A crack inside the rock grows by one joint: a vertex at which two broken joints meet splits."""
    figure, axes = canvas(7.6, 2.9, 2)
    top = [[-1.5, 0.9], [-0.5, 0.95], [0.5, 0.9], [1.5, 0.95]]
    bottom = [[x, -y] for x, y in top]
    for axis, opening, title in zip(axes, (0.0, 0.1), ("one joint is broken",
                                                      "two joints are broken"), strict=True):
        middle = [[x, 0.0] for x in (-2.0, -1.0, 0.0, 1.0, 2.0)]
        upper, lower = ([*middle[:2], [0.0, side * opening], *middle[3:]] for side in (1, -1))
        for side, row in ((upper, top), (lower, bottom)):
            for i in range(4):
                fill(axis, [side[i], side[i + 1], row[i]])
            for i in range(3):
                fill(axis, [side[i + 1], row[i], row[i + 1]])
        if opening:
            fill(axis, [middle[1], upper[2], middle[3], lower[2]], "#CFE4F3", FLUID)
            dots(axis, [upper[2], lower[2]], NODE, size=7)
            dots(axis, middle[1:4], CRACK, "s", 8)
            note(axis, "two pore nodes:\nthe pressure may jump", (0.0, 1.4), upper[2])
        else:
            axis.plot([-1.0, 0.0], [0, 0], color=FLUID, linewidth=3)
            dots(axis, middle[1:3], CRACK, "s", 8)
            note(axis, "one pore node: one can\nwalk round the tip", (0.0, 1.4), (0.02, 0.06))
        note(axis, "crack node", (-1.6, -1.25), (-1.03, -0.07), CRACK)
        axis.set_title(title, fontsize=10)
        axis.set_xlim(-2.2, 2.2)
        axis.set_ylim(-1.45, 1.7)
    return figure


FIGURES = {"triangles": triangles, "joints": joints, "network": network}
