# SPDX-License-Identifier: BSD-3-Clause
"""Uplift on the base of a dam on whole rock, with an open fracture at its heel, a cut-off wall and
a drain, each against its exact solution."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from foundation_formulas import FlatDam
from percolith.plot import draw
from report import Chapter
from studies import check_criteria, run_example

TITLE = "Dam foundation: uplift by Pavlovsky, with a fracture, a wall or a drain"
DAM = FlatDam()
PLACE, DEPTH, LEVEL = -12.0, 12.0, 5.0  # m, of the curtain and the head of its gallery
WEIGHT, BASE = 9810.0, 40.0  # N/m3, m
CONDUCTIVITY, WIDTH = 9.81e-8, 100.0  # m/s, m

WHOLE = {"fracture.heel.initial_aperture": 1e-9}  # as tight as if it were not there
CURTAIN = {"fracture.curtain.groups": ["curtain"], "fracture.curtain.initial_aperture": 1e-3,
           "fracture.curtain.exchange": "inf", "boundary.gallery.groups": ["gallery"],
           "boundary.gallery.on": "crack", "boundary.gallery.head": LEVEL}
VARIANTS = {
    "whole": (WHOLE, DAM.bare),
    "wall": (WHOLE | CURTAIN | {"fracture.curtain.exchange": 0},
             lambda x: DAM.with_wall(x, PLACE, DEPTH)),
    "drain": (WHOLE | CURTAIN, lambda x: DAM.with_drain(x, PLACE, DEPTH, LEVEL)),
}


def head_of(result):
    """Places (m) along the base and heads there (m)."""
    rows = result.results.probe("base").at_time()
    return rows["x_m"], rows["pressure_Pa"] / WEIGHT


def check(chapter: Chapter, work: Path) -> None:
    shipped = check_criteria(chapter, "dam_foundation", work)
    curves = {"fracture": (*head_of(shipped), DAM.with_fracture(head_of(shipped)[0], DEPTH))}
    for name, (settings, exact) in VARIANTS.items():
        result = run_example("dam_foundation", work, name, settings)
        x, head = head_of(result)
        curves[name] = (x, head, exact(x))
        chapter.at_most(f"{name}.balance", f"{name}: error of the mass balance", result.balance,
                        1e-12)
        if name == "whole":
            rate = result.results.summary["rate_m2_per_s"]["boundary.reservoir"]
            chapter.at_most("whole.discharge", "whole: seepage over that of the exact solution, "
                            "less 1", abs(rate / DAM.discharge(CONDUCTIVITY, WIDTH) - 1), 0.01)
    # The rock of a drain that takes water for good would have to be wider: with 200 m for 100 m its
    # uplift is right within 0.4 %.
    for name, limit in (("whole", 0.005), ("wall", 0.01), ("drain", 0.03)):
        x, head, exact = curves[name]
        chapter.at_most(f"{name}.uplift", f"{name}: uplift over the exact one, "
                        f"{exact.mean() * WEIGHT * BASE / 1e6:.3f} MN/m, less 1",
                        abs(head.mean() / exact.mean() - 1), limit)
        chapter.at_most(f"{name}.head", f"{name}: root mean square difference of the head along "
                        "the base from the exact one over that of the reservoir",
                        np.sqrt(np.mean((head - exact) ** 2)) / DAM.head, 0.01)
    uplift = {name: head.mean() for name, (_, head, _) in curves.items()}
    order = [uplift[name] for name in ("drain", "wall", "whole", "fracture")]
    chapter.at_least("order", "drain, wall, whole rock, fracture: least rise of the uplift from "
                     "one to the next over that on whole rock",
                     np.diff(order).min() / uplift["whole"], 0.05)
    chapter.add_figure(base_figure(curves), "Head along the base; marks are exact")
    for path in draw(shipped.results, field="head", output=work / "head.png"):
        chapter.add_picture(path, "Hydraulic head with the open fracture at the heel")


def base_figure(curves: dict):
    figure, axes = plt.subplots(figsize=(8, 4.4), layout="constrained")
    colours = plt.cm.viridis([0.0, 0.3, 0.6, 0.9])
    for (name, (x, head, exact)), colour in zip(curves.items(), colours):
        axes.plot(x, head, color=colour,
                  label=f"{name}: {head.mean() * WEIGHT * BASE / 1e6:.2f} MN/m")
        axes.plot(x[::16], exact[::16], "o", markersize=4, markerfacecolor="none", color=colour)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("Head (m)")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False, title="uplift", fontsize="small")
    return figure
