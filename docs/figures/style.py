# SPDX-License-Identifier: BSD-3-Clause
"""What the figures of the documents have in common: colours that the colour-blind tell apart, sizes,
and files that are the same each time they are drawn."""

from __future__ import annotations

from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

# Okabe and Ito.
ROCK, FLUID, CRACK, NODE = "#E8DCC8", "#0072B2", "#D55E00", "#000000"
EDGE, NOTE, GREEN, AMBER = "#8A7A5C", "#444444", "#009E73", "#E69F00"

SETTINGS = {"svg.hashsalt": "percolith", "svg.fonttype": "path", "font.size": 10,
            "font.family": "DejaVu Sans", "axes.spines.top": False, "axes.spines.right": False,
            "figure.facecolor": "white", "mathtext.fontset": "dejavusans"}


def canvas(width: float, height: float, columns: int = 1, *, plain: bool = True):
    """A figure of that size in inches with `columns` axes side by side; plain ones have no frame and
    equal scales."""
    plt.rcParams.update(SETTINGS)
    figure, axes = plt.subplots(1, columns, figsize=(width, height), layout="constrained",
                                squeeze=False)
    for axis in axes[0] if plain else []:
        axis.set_aspect("equal")
        axis.axis("off")
    return figure, list(axes[0])


def save(figure, file: Path) -> None:
    figure.savefig(file, format="svg", metadata={"Date": None}, bbox_inches="tight", pad_inches=0.1)
    plt.close(figure)


def shrunk(points: np.ndarray, factor: float = 0.86) -> np.ndarray:
    """Corners of a triangle moved towards its centre, so that the joints around it can be seen."""
    centre = points.mean(axis=0)
    return centre + factor * (points - centre)


def fill(axis, points, colour: str = ROCK, edge: str = EDGE, width: float = 0.8) -> None:
    axis.fill(*np.asarray(points).T, facecolor=colour, edgecolor=edge, linewidth=width)


def dots(axis, points, colour: str = NODE, marker: str = "o", size: float = 5.0) -> None:
    points = np.atleast_2d(points)
    axis.plot(points[:, 0], points[:, 1], marker, color=colour, markersize=size,
              markeredgecolor="white", markeredgewidth=0.6, zorder=5)


def note(axis, text: str, at, of=None, colour: str = NOTE, **options) -> None:
    """A text at a place, with a thin line to what it tells of."""
    options = {"ha": "center", "va": "center", "fontsize": 9, **options}
    if of is None:
        axis.text(*at, text, color=colour, **options)
    else:
        axis.annotate(text, xy=of, xytext=at, color=colour,
                      arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.7,
                                  "shrinkB": 1}, **options)


def arrow(axis, start, end, colour: str = FLUID, width: float = 1.4, style: str = "-|>",
          curve: float = 0.0) -> None:
    axis.annotate("", xy=end, xytext=start, zorder=4,
                  arrowprops={"arrowstyle": style, "color": colour, "linewidth": width,
                              "shrinkA": 0, "shrinkB": 0,
                              "connectionstyle": f"arc3,rad={curve}"})
