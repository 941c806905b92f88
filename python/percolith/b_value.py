# SPDX-License-Identifier: BSD-3-Clause
"""The b-value of a list of events: how steeply their number falls with their magnitude."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

MINIMUM_COUNT = 50  # events from M_min on
MINIMUM_SPAN = 5  # bins from M_min to the largest magnitude
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


def complete_bins(magnitudes: np.ndarray) -> np.ndarray:
    """The numbers of the bins, ascending, of the events in the fullest bin and above. Below it the
    mesh, which has no smaller joints, leaves events out."""
    finite = magnitudes[np.isfinite(magnitudes)]
    bins = np.sort(np.floor(finite / BIN_WIDTH + 0.5).astype(np.int64))
    if not len(bins):
        return bins
    numbers, counts = np.unique(bins, return_counts=True)
    return bins[bins >= numbers[np.argmax(counts)]]


def reason_for_none(magnitudes: np.ndarray) -> str:
    """Why these events have no b-value; empty where they have one."""
    bins = complete_bins(magnitudes)
    if len(bins) < MINIMUM_COUNT:
        return f"fewer than {MINIMUM_COUNT} events in the fullest bin and above"
    if bins[-1] - bins[0] < MINIMUM_SPAN:
        return f"magnitudes from the fullest bin on span less than {MINIMUM_SPAN * BIN_WIDTH:g}"
    return ""


def b_value(magnitudes: np.ndarray) -> BValue | None:
    """Maximum likelihood (Aki 1965, for bins Utsu 1966): b = log10(e)/(mean(M) - M_min + dM/2) over
    the events of `complete_bins`. Standard error b/sqrt(n). None where these are too few, or too
    much alike, for a slope to mean anything."""
    if reason_for_none(magnitudes):
        return None
    bins = complete_bins(magnitudes)
    value = np.log10(np.e) / (BIN_WIDTH * (bins.mean() - bins[0] + 0.5))
    return BValue(float(value), float(value / np.sqrt(len(bins))), float(bins[0] * BIN_WIDTH),
                  len(bins))
