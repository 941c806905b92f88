# SPDX-License-Identifier: BSD-3-Clause
"""Where a deformed model lies: its points moved by their displacements times a factor."""

from __future__ import annotations

import numpy as np

from percolith.run_directory import Frame
from percolith.vtu import Grid

_VISIBLE = 0.03  # of the model's extent: the largest displacement of a picture made to be seen


def displacement(matrix: Grid) -> np.ndarray:
    """Displacement (m) of every point, (n, 2)."""
    return matrix.point_data["displacement_m"]


def automatic_scale(matrix: Grid) -> float:
    """Factor of the displacements that lets the deformation just be seen: 1, 2 or 5 times a power
    of ten. It is 1 where the displacements are as large as the triangles, as in a collapse, or can
    be seen as they are."""
    largest = float(np.nanmax(np.hypot(*displacement(matrix).T), initial=0.0))
    corners = matrix.points[matrix.cells]
    edge = float(np.median(np.hypot(*(corners - np.roll(corners, 1, axis=1)).reshape(-1, 2).T)))
    if largest == 0.0 or largest >= edge:
        return 1.0
    wanted = _VISIBLE * float(np.ptp(matrix.points, axis=0).max()) / largest
    if wanted <= 1.0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(power * max(step for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-9)))


def deformed_points(matrix: Grid, scale: float) -> np.ndarray:
    """Places (m) of the points with their displacements times `scale`, (n, 2)."""
    return matrix.points + scale * displacement(matrix)


def crack_faces(frame: Frame) -> tuple[np.ndarray, np.ndarray]:
    """The edges of triangles that lie on a crack when undeformed: indices (n, 2) of their matrix
    points, and the crack segment (n,) each belongs to. Most segments have two, one a face."""
    matrix, cracks = frame.matrix, frame.cracks
    if cracks is None or not len(cracks.cells):
        return np.empty((0, 2), int), np.empty(0, int)
    both = np.concatenate([matrix.points, cracks.points])
    _, place = np.unique(both, axis=0, return_inverse=True)
    place = place.ravel()
    edges = np.concatenate([matrix.cells[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
    edge_key = _pair_keys(place[edges], len(both))
    segment_key = _pair_keys(place[len(matrix.points):][cracks.cells], len(both))
    chosen = np.isin(edge_key, segment_key)
    order = np.argsort(segment_key, kind="stable")
    found = np.searchsorted(segment_key[order], edge_key[chosen])
    return edges[chosen], order[found]


def _pair_keys(pairs: np.ndarray, count: int) -> np.ndarray:
    """A number for each pair of numbers below `count`, whatever their order."""
    return pairs.min(axis=1).astype(np.int64) * count + pairs.max(axis=1)
