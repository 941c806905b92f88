# SPDX-License-Identifier: BSD-3-Clause
"""Cuts the triangles of a mesh finely enough to show a linear field in flat colours.

Colours blended between the corners of a triangle need not lie on the colour map where the field is
steep; values interpolated first always do.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

LARGEST_COUNT = 400_000


@dataclass(frozen=True)
class FineTriangles:
    """Flat triangles: their corners and the value of the field at their centroids."""

    corners: np.ndarray  # (n, 3, 2), m
    values: np.ndarray  # (n,)


def barycentric_parts(number: int) -> np.ndarray:
    """Barycentric coordinates of the corners of the number² equal parts of a triangle, every edge
    of which is cut into `number` pieces: shape (number², 3 corners, 3 coordinates)."""
    i, j = np.meshgrid(np.arange(number), np.arange(number), indexing="ij")
    upright, inverted = i + j < number, i + j < number - 1
    i_up, j_up, i_in, j_in = i[upright], j[upright], i[inverted], j[inverted]
    first = np.concatenate([np.stack([i_up, i_up + 1, i_up], 1),
                            np.stack([i_in + 1, i_in + 1, i_in], 1)])
    second = np.concatenate([np.stack([j_up, j_up, j_up + 1], 1),
                             np.stack([j_in, j_in + 1, j_in + 1], 1)])
    return np.stack([number - first - second, first, second], 2) / number


def edge_pieces(values: np.ndarray, step: float, largest_count: int = LARGEST_COUNT) -> np.ndarray:
    """Into how many pieces to cut the edges of each triangle, given the values at its corners
    (n, 3): so that neighbouring parts differ by `step` at most, where `largest_count` triangles in
    all allow it; the steepest triangles are cut less where they do not."""
    most = max(1, int(np.sqrt(largest_count)))
    span = np.nan_to_num(np.ptp(values, axis=1), posinf=0.0)
    pieces = np.clip(np.ceil(span / step), 1, most).astype(int)
    low, high = 1, most
    while low < high:
        middle = (low + high + 1) // 2
        fits = (np.minimum(pieces, middle) ** 2).sum() <= largest_count
        low, high = (middle, high) if fits else (low, middle - 1)
    return np.minimum(pieces, low)


def refine(corners: np.ndarray, values: np.ndarray, step: float,
           largest_count: int = LARGEST_COUNT, smallest: float = 0.0) -> FineTriangles:
    """Cuts triangles with the given corners (n, 3, 2) and values at them (n, 3) into flat ones that
    carry the linear interpolation of the values at their centroids. `step` is the difference of
    values that may be seen, `smallest` the length (in the unit of the corners) that may be: no edge
    is cut into pieces shorter than that. Triangles share nothing, so a jump across a crack stays a
    jump."""
    pieces = edge_pieces(values, step, largest_count)
    if smallest > 0.0:
        longest = np.hypot(*(corners - np.roll(corners, 1, axis=1)).T).max(axis=0)
        pieces = np.minimum(pieces, np.maximum(longest / smallest, 1.0).astype(int))
    fine_corners, fine_values = [np.empty((0, 3, 2))], [np.empty(0)]
    for number in np.unique(pieces):
        chosen = pieces == number
        parts = barycentric_parts(int(number))
        fine_corners.append(np.einsum("pcb,nbx->npcx", parts, corners[chosen]).reshape(-1, 3, 2))
        fine_values.append((values[chosen] @ parts.mean(axis=1).T).ravel())
    return FineTriangles(np.concatenate(fine_corners), np.concatenate(fine_values))
