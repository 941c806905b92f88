# SPDX-License-Identifier: BSD-3-Clause
"""Which points of the rock hang together. The joints between triangles are springs, so that the
points at one place part a little even where nothing has broken; drawn with large displacements
those gaps look like cracks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from percolith.deformation import edge_keys, place_numbers
from percolith.vtu import Grid


def _bonded_pairs(matrix: Grid, cracks: Sequence[Grid]) -> np.ndarray:
    """Pairs (n, 2) of points at one place whose triangles share an edge that is on no crack."""
    edges, key, broken, place = edge_keys(matrix, cracks)
    order = np.argsort(key, kind="stable")
    twin = np.flatnonzero(key[order][1:] == key[order][:-1])
    twin = twin[~np.isin(key[order[twin]], np.concatenate([np.empty(0, int), *broken]))]
    one, other = edges[order[twin]], edges[order[twin + 1]]
    turned = place[one[:, 0]] != place[other[:, 0]]
    other = np.where(turned[:, None], other[:, ::-1], other)
    return np.stack([one.ravel(), other.ravel()], axis=1)


def joined_points(matrix: Grid, cracks: Sequence[Grid]) -> np.ndarray:
    """For each point of a matrix (n,) the lowest number of those it hangs together with: at the
    same place, and not parted from it by any of the cracks."""
    pairs = _bonded_pairs(matrix, cracks)
    lowest = np.arange(len(matrix.points))
    while True:  # as often as a corner has triangles around it
        low = lowest[pairs].min(axis=1)
        new = lowest.copy()
        np.minimum.at(new, pairs[:, 0], low)
        np.minimum.at(new, pairs[:, 1], low)
        if np.array_equal(new, lowest):
            return lowest
        lowest = new


class Nodes(NamedTuple):
    """Points that hang together at all times of a series, in the order of their first points:
    neighbours stay neighbours, which packs well."""

    first: np.ndarray  # a point (m,) of each node
    node: np.ndarray  # of each point (n,)

    def holds(self, values: np.ndarray) -> bool:
        """Whether the points of each node have the same value, of values (n,) that may be NaN."""
        return np.array_equal(values[self.first][self.node], values, equal_nan=True)

    def means(self, values: np.ndarray) -> np.ndarray:
        """Means (m,) of values (n,) of points; NaN where one of a node is."""
        return np.bincount(self.node, values) / np.bincount(self.node)


def nodes_of(matrix: Grid, cracks: Sequence[Grid]) -> Nodes:
    """The nodes of a matrix that any of the cracks part."""
    return Nodes(*np.unique(joined_points(matrix, cracks), return_inverse=True))


def hubs(matrix: Grid, joined: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The space between three or more pieces of rock that meet in a corner of the mesh, which the
    gaps of the cracks there leave open: triangles (k, 3) of points, one of each piece, and of each
    triangle a point (k,) at the corner. `joined` is as of `joined_points`."""
    place = place_numbers(matrix.points)
    piece, node = np.unique(joined, return_inverse=True)
    middle = matrix.points[matrix.cells].mean(axis=1)
    owner, corner = node[matrix.cells].ravel(), matrix.cells.ravel()
    towards = np.repeat(middle, 3, axis=0) - matrix.points[corner]
    around = np.arctan2(np.bincount(owner, towards[:, 1]), np.bincount(owner, towards[:, 0]))
    order = np.lexsort([around, place[piece]])
    # Pieces at one corner follow each other; each beyond the second makes one more triangle.
    at = place[piece[order]]
    start = np.searchsorted(at, at)
    beyond = np.flatnonzero(np.arange(len(at)) - start >= 2)
    corners = np.stack([start[beyond], beyond - 1, beyond], axis=1)
    return piece[order][corners], piece[order][start[beyond]]
