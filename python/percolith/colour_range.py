# SPDX-License-Identifier: BSD-3-Clause
"""The ends of the colours of a picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import matplotlib.pyplot as plt
import numpy as np

from percolith.units import Scale


@dataclass(frozen=True)
class ColourRange:
    """The values (SI) at the ends of the colours and the unit they are shown in; at which ends
    there are values beyond: "neither", "min", "max" or "both"."""

    low: float
    high: float
    scale: Scale
    beyond: str = "neither"

    @property
    def norm(self) -> plt.Normalize:
        """For values in the unit that is shown."""
        return plt.Normalize(self.low / self.scale.factor, self.high / self.scale.factor)


def widened(low: float, high: float) -> tuple[float, float]:
    """The same ends, or ends further apart where a field is the same everywhere."""
    if high - low <= 1e-12 * max(abs(low), abs(high)):
        return low - 0.5 * (abs(low) or 1.0), high + 0.5 * (abs(high) or 1.0)
    return low, high


def beyond_which(below: bool, above: bool) -> str:
    """At which ends there are values beyond."""
    return ("both" if above else "min") if below else ("max" if above else "neither")


def cut_range(values: np.ndarray, cut: float, scale: Callable[[list[float]], Scale]) -> ColourRange:
    """Ends beyond which lie at most `cut` per cent of the values on either side. At least one value
    must be finite."""
    values = values[np.isfinite(values)]
    least, low, high, most = np.percentile(values, [0.0, cut, 100.0 - cut, 100.0]).tolist()
    beyond = beyond_which(least < low, most > high)
    low, high = widened(low, high)
    return ColourRange(low, high, scale([low, high]), beyond)
