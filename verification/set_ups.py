# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of what is computed: the mesh, its fractures, and notes on what is prescribed."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
from crack_paths import broken_lines
from matplotlib.collections import LineCollection, PolyCollection
from percolith.run_directory import Frame


def mesh_figure(panels: list[tuple[str, Frame]], notes: list[tuple[float, float, str]] = (),
                width: float = 7.0):
    """Meshes below each other, each with its title and its number of triangles; fractures in red.
    `notes` are (x, y, text), m. A panel is `width` inches wide."""
    low, high = panels[0][1].matrix.points.min(axis=0), panels[0][1].matrix.points.max(axis=0)
    height = width * (high - low)[1] / (high - low)[0]
    figure, axes = plt.subplots(len(panels), 1, figsize=(width, (height + 0.7) * len(panels)),
                                layout="constrained", sharex=True, squeeze=False)
    for (title, frame), panel in zip(panels, axes[:, 0]):
        _draw_mesh(panel, frame)
        panel.set_title(f"{title}{len(frame.matrix.cells)} triangles", fontsize=11)
        panel.label_outer()
        for x, y, text in notes:
            panel.annotate(text, (x, y), ha="center", va="center", fontsize=9, annotation_clip=False,
                           bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.85,
                                 "pad": 1.5})
    return figure


def _draw_mesh(axes, frame: Frame) -> None:
    corners = frame.matrix.points[frame.matrix.cells]
    thin = 0.6 if len(corners) < 1000 else 0.25
    axes.add_collection(PolyCollection(corners, facecolor="#f2f2f2", edgecolor="#707070",
                                       linewidth=thin))
    axes.add_collection(LineCollection(broken_lines(frame), colors="#d55e00", linewidths=2.2))
    axes.set_aspect("equal")
    margin = 0.02 * np.ptp(corners.reshape(-1, 2), axis=0).max()
    axes.autoscale_view()
    axes.margins(0)
    axes.set_xlim(corners[..., 0].min() - margin, corners[..., 0].max() + margin)
    axes.set_ylim(corners[..., 1].min() - margin, corners[..., 1].max() + margin)
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
