# SPDX-License-Identifier: BSD-3-Clause
"""Two elastic discs meet off their centres and part: energy and momentum."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import run_case
from report import Chapter

TITLE = "Elastic collision of two discs: energy and momentum"
CASE = Path(__file__).with_name("case.toml")
DENSITY = 2500.0


def momentum(frame, chosen=None) -> np.ndarray:
    """Of the chosen triangles, kg/s per metre of thickness."""
    weight = solid.areas(frame) if chosen is None else solid.areas(frame) * chosen
    return DENSITY * weight.sum() * solid.mean_of(frame, "velocity_m_per_s", chosen)


def check(chapter: Chapter, work: Path) -> None:
    run = run_case(CASE, work / "case").results
    history = run.history
    time = history["time_s"] * 1e3
    parts = {name: history[f"{name}_J_per_m"] for name in ("kinetic", "elastic", "contact")}
    total = sum(parts.values())
    frames = [run.frame(at) for at in run.times]
    large = solid.centres(frames[0])[:, 0] < 0
    sums = np.array([momentum(frame) for frame in frames])
    scale = abs(momentum(frames[0], large)).max()
    exchanged = abs(momentum(frames[-1], large) - momentum(frames[0], large)).max() / scale
    chapter.at_most("energy", "largest change of kinetic, elastic and contact energy together, "
                    "over the energy at the start", abs(total[1:] / total[1] - 1).max(), 1e-3)
    chapter.at_most("momentum", "largest change of the momentum of both over that of the large "
                    "disc", abs(sums - sums[0]).max() / scale, 1e-11)
    chapter.at_least("exchanged", "momentum that the large disc gave away over that it had",
                     exchanged, 0.3)
    chapter.at_most("parted", "energy that contact has kept after both parted, over the energy at "
                    "the start", abs(parts["contact"][-1]) / total[1], 1e-5)
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    for (name, values), colour in zip(parts.items(), plt.cm.viridis([0.1, 0.5, 0.8])):
        left.plot(time[1:], values[1:] / 1e3, color=colour, label=name)
    left.plot(time[1:], total[1:] / 1e3, "k--", linewidth=1, label="together")
    left.set_ylabel("Energy (kJ/m)")
    at = [frame.time * 1e3 for frame in frames]
    for label, chosen, colour in (("large", large, 0.2), ("small", ~large, 0.6)):
        values = np.array([momentum(frame, chosen) for frame in frames])
        for component, style in ((0, "-"), (1, ":")):
            right.plot(at, values[:, component], style, color=plt.cm.viridis(colour),
                       label=f"{label}, {'xy'[component]}")
    right.plot(at, sums[:, 0], "k--", linewidth=1, label="both, x")
    right.set_ylabel("Momentum (kg/s)")
    for axes in (left, right):
        axes.set_xlabel("Time (ms)")
        axes.grid(alpha=0.3)
        axes.legend(fontsize="small", frameon=False)
    chapter.add_figure(figure, "Energies and momenta over time")
