# SPDX-License-Identifier: BSD-3-Clause
"""Figures of several panels."""

from __future__ import annotations

import matplotlib.pyplot as plt

from percolith.run_directory import RunDirectory


def panels_of(run: RunDirectory, count: int, height: float, alone: float = 5.5):
    """A figure with the title of the run and `count` panels in at most two columns, each `height`
    inches high, a single one `alone` inches wide; and the axes of the panels."""
    columns = min(count, 2)
    rows = -(-count // columns)
    size = (alone if columns == 1 else 11.0, height * rows + 0.4)
    figure, grid = plt.subplots(rows, columns, figsize=size, layout="constrained", squeeze=False)
    for axes in grid.flat[count:]:
        axes.set_visible(False)
    figure.suptitle(run.title, fontsize=11)
    return figure, grid.flat[:count]
