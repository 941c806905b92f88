# SPDX-License-Identifier: BSD-3-Clause
"""Colours of the interactive view as bytes, the same as those of the pictures."""

from __future__ import annotations

import base64

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap, to_rgb

from percolith.colours import distinct_colour

MOST_NAMED = 1024  # different colours of numbers that are names


def _text(colours: np.ndarray) -> str:
    """Red, green, blue and opacity of each colour (n, 3), 0 to 1, as base64."""
    opaque = np.column_stack([colours, np.ones(len(colours))])
    return base64.b64encode(np.round(255 * opaque).astype(np.uint8).tobytes()).decode()


def of_map(name: str | LinearSegmentedColormap) -> str:
    """256 colours of a colour map of matplotlib."""
    return _text(plt.get_cmap(name)(np.linspace(0, 1, 256))[:, :3])


def of_names(colours: list[str]) -> str:
    """Given colours, one a name."""
    return _text(np.array([to_rgb(colour) for colour in colours]))


def distinct(count: int) -> str:
    """Colours that differ, for so many numbers; more than MOST_NAMED of them begin anew."""
    return _text(np.array([distinct_colour(i) for i in range(min(count, MOST_NAMED))]))
