# SPDX-License-Identifier: BSD-3-Clause
"""The b-value of a list of events: how steeply their number falls with their magnitude."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

MINIMUM_COUNT = 20
BIN_WIDTH = 0.1  # of magnitudes, dM


@dataclass(frozen=True)
class BValue:
    """log10 N(>= M) = a - b M, fitted to the events of the smallest magnitude that counts and
    above."""

    value: float  # b
    error: float  # standard error of b
    smallest: float  # M_min, the middle of its bin
    count: int  # events at or above it

    def number_above(self, magnitude: np.ndarray) -> np.ndarray:
        """Number of events the fit gives at or above a magnitude."""
        return self.count * 10.0 ** (-self.value * (magnitude - self.smallest + 0.5 * BIN_WIDTH))


def b_value(magnitudes: np.ndarray) -> BValue | None:
    """Maximum likelihood (Aki 1965, for bins Utsu 1966): b = log10(e)/(mean(M) - M_min + dM/2) over
    the events in the fullest bin and above; below it the mesh, which has no smaller joints, leaves
    events out. Standard error b/sqrt(n). None with fewer than 20 events."""
    finite = magnitudes[np.isfinite(magnitudes)]
    if len(finite) < MINIMUM_COUNT:
        return None
    bins = np.floor(finite / BIN_WIDTH + 0.5).astype(np.int64)
    numbers, counts = np.unique(bins, return_counts=True)
    first = numbers[np.argmax(counts)]
    chosen = bins[bins >= first]
    value = np.log10(np.e) / (BIN_WIDTH * (chosen.mean() - first + 0.5))
    return BValue(float(value), float(value / np.sqrt(len(chosen))), float(first * BIN_WIDTH),
                  len(chosen))
