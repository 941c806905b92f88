# SPDX-License-Identifier: BSD-3-Clause
"""The ends of the colours of a picture."""

from __future__ import annotations

from dataclasses import dataclass

import matplotlib.pyplot as plt

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
