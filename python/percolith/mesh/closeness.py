# SPDX-License-Identifier: BSD-3-Clause
"""Which points and straight pieces of a drawing touch, or nearly do. All at once with numpy, over
parts that lie side by side, so that thousands of them are no burden."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

_PART = 64  # pieces that are compared with all that lie beside them at once


def close_pairs(places: np.ndarray, tolerance: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Pairs of places (n, 2) that are closer than the tolerance, m: the numbers of both, the smaller
    first, and the distance of each pair."""
    order = np.argsort(places[:, 0], kind="stable")
    sorted_places = places[order]
    firsts, seconds, gaps = [], [], []
    for step in range(1, len(places)):
        apart = sorted_places[step:] - sorted_places[:-step]
        if not (apart[:, 0] < tolerance).any():
            break
        gap = np.hypot(*apart.T)
        near = np.flatnonzero(gap < tolerance)
        firsts.append(order[near])
        seconds.append(order[near + step])
        gaps.append(gap[near])
    if not firsts:
        return np.empty(0, int), np.empty(0, int), np.empty(0)
    a, b = np.concatenate(firsts), np.concatenate(seconds)
    return np.minimum(a, b), np.maximum(a, b), np.concatenate(gaps)


def _parts(ends: np.ndarray, margin: float) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Pieces (n, 2, 2) in parts that lie side by side: their numbers, and the lower left and upper
    right end of what they reach."""
    order = np.argsort(ends[:, :, 0].mean(axis=1), kind="stable")
    for first in range(0, len(order), _PART):
        chosen = order[first:first + _PART]
        corners = ends[chosen].reshape(-1, 2)
        yield chosen, corners.min(axis=0) - margin, corners.max(axis=0) + margin


def near_pieces(ends: np.ndarray, places: np.ndarray,
                tolerance: float) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Places (m, 2) closer than the tolerance, m, to pieces (n, 2, 2), beside them and not beyond
    their ends: numbers of piece and place, distance, and foot of the place on the piece (k, 2)."""
    found = []
    for chosen, low, high in _parts(ends, tolerance):
        beside = np.flatnonzero(((places >= low) & (places <= high)).all(axis=1))
        start, way = ends[chosen, 0], ends[chosen, 1] - ends[chosen, 0]
        to_place = places[beside] - start[:, None]
        share = np.einsum("pnx,px->pn", to_place, way) / np.sum(way**2, axis=1)[:, None]
        gap = np.hypot(*(to_place - share[:, :, None] * way[:, None]).transpose(2, 0, 1))
        piece, place = np.nonzero((gap < tolerance) & (share > 0.0) & (share < 1.0))
        foot = start[piece] + share[piece, place][:, None] * way[piece]
        found.append((chosen[piece], beside[place], gap[piece, place], foot))
    return tuple(np.concatenate(column) for column in zip(*found))


def crossings(ends: np.ndarray, nodes: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Pairs of pieces (n, 2, 2) that cross within both: numbers of the pieces, the smaller first,
    and where (k, 2). nodes: numbers of their ends (n, 2); pieces that share one do not cross."""
    found = []
    lowest, highest = ends.min(axis=1), ends.max(axis=1)
    for chosen, low, high in _parts(ends, 0.0):
        beside = np.flatnonzero(((highest >= low) & (lowest <= high)).all(axis=1))
        start, way = ends[chosen, 0][:, None], (ends[chosen, 1] - ends[chosen, 0])[:, None]
        apart = ends[beside, 0] - start
        other = (ends[beside, 1] - ends[beside, 0])[None]
        across = way[..., 0] * other[..., 1] - way[..., 1] * other[..., 0]
        with np.errstate(divide="ignore", invalid="ignore"):
            own = (apart[..., 0] * other[..., 1] - apart[..., 1] * other[..., 0]) / across
            its = (apart[..., 0] * way[..., 1] - apart[..., 1] * way[..., 0]) / across
        shared = (nodes[chosen][:, None, :, None] == nodes[beside][None, :, None, :]).any(axis=(2, 3))
        first, second = np.nonzero((across != 0.0) & (own > 0.0) & (own < 1.0) & (its > 0.0)
                                   & (its < 1.0) & ~shared & (chosen[:, None] < beside[None]))
        place = start[first, 0] + own[first, second][:, None] * way[first, 0]
        found.append((chosen[first], beside[second], place))
    return tuple(np.concatenate(column) for column in zip(*found))
