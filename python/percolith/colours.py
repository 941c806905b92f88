# SPDX-License-Identifier: BSD-3-Clause
"""Colours that stay apart for readers who see few of them (Okabe and Ito's set)."""

from __future__ import annotations

import colorsys

BLACK = "#000000"
ORANGE = "#E69F00"
GREEN = "#009E73"
BLUE = "#0072B2"
RED = "#D55E00"
PURPLE = "#CC79A7"

_GOLDEN = 0.618034  # of the circle of hues: the next colour falls into the widest gap
_LIGHTNESS = (0.80, 0.58, 0.38, 0.68, 0.48)


def distinct_colour(number: int) -> tuple[float, float, float]:
    """Red, green and blue (0 to 1) of the colour with this number; neighbours in number differ in
    hue and in lightness."""
    return colorsys.hls_to_rgb(0.58 + number * _GOLDEN, _LIGHTNESS[number % len(_LIGHTNESS)], 0.6)
