# SPDX-License-Identifier: BSD-3-Clause
"""A dam with a free surface and a seepage face: discharge over time and its final value."""

from pathlib import Path

import matplotlib.pyplot as plt
from percolith.plot import draw
from report import Chapter
from studies import check_example

TITLE = "Dam: free surface, partly saturated, with a seepage face"
CHARNY = 2.3544e-5  # m2/s


def check(chapter: Chapter, work: Path) -> None:
    result = check_example(chapter, "dam", work)
    for path in draw(result.results, field="saturation", output=work / "saturation.png"):
        chapter.add_picture(path, "Saturation at the end")
    history = result.results.history
    days = history["time_s"] / 86400
    figure, axes = plt.subplots(figsize=(7, 4.4), layout="constrained")
    axes.semilogx(days[1:], history["boundary.upstream_m2_per_s"][1:] * 1e6, label="in, upstream")
    out = history["boundary.downstream_m2_per_s"] + history["boundary.face_m2_per_s"]
    axes.semilogx(days[1:], -out[1:] * 1e6, label="out, tail water and face")
    axes.axhline(CHARNY * 1e6, color="k", linewidth=1, linestyle="--", label="Charny")
    axes.set_xlim(1e-2, days[-1])
    axes.set_ylim(-10, 100)
    axes.set_xlabel("Time (d)")
    axes.set_ylabel("Flow (10⁻⁶ m²/s)")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Flow into and out of the dam over time")
