# SPDX-License-Identifier: BSD-3-Clause
"""The outline of a model, outside and in its holes, and how wide the empty space before each piece
of it is."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from percolith.deformation import pair_keys
from percolith.vtu import Grid

_ROUNDING = 1e-3  # of the length of an edge: a narrower gap is two walls that touch
_LARGEST_BLOCK = 500_000  # pairs of edges that are looked at together


class Outline(NamedTuple):
    """Edges that only one triangle has when undeformed. Faces of cracks are none: two triangles
    meet there."""

    points: np.ndarray  # indices (n, 2) of matrix points
    triangle: np.ndarray  # (n,) that each is an edge of


def outline_of(matrix: Grid) -> Outline:
    """The outline of a matrix, in which one place may have many points."""
    # One complex number a place, and one whole number an edge, sort much faster than pairs.
    _, place = np.unique(matrix.points[:, 0] + 1j * matrix.points[:, 1], return_inverse=True)
    edges = np.concatenate([matrix.cells[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
    key = pair_keys(place.ravel()[edges], len(matrix.points))
    _, first, count = np.unique(key, return_index=True, return_counts=True)
    single = np.sort(first[count == 1])
    return Outline(edges[single], single % len(matrix.cells))


class Openings(NamedTuple):
    """Lines across empty space, each from the middle of an edge of the outline, at right angles to
    it, to the outline on the other side."""

    near: np.ndarray  # indices (n, 2) of the matrix points of the edge it starts from
    triangle: np.ndarray  # (n,) that this is an edge of
    far: np.ndarray  # indices (n, 2) of the matrix points of the edge it ends on
    share: np.ndarray  # (n,) of that edge from its first point to where the line ends
    direction: np.ndarray  # unit vectors (n, 2)
    width: np.ndarray  # lengths (n,), m


def _outward(matrix: Grid, outline: Outline) -> tuple[np.ndarray, np.ndarray]:
    """Unit normals (n, 2) that point away from the rock, and lengths (n,) of the edges."""
    ends = matrix.points[outline.points]
    along = ends[:, 1] - ends[:, 0]
    length = np.hypot(*along.T)
    normal = np.stack([along[:, 1], -along[:, 0]], axis=1) / length[:, None]
    inside = matrix.points[matrix.cells[outline.triangle]].mean(axis=1) - ends[:, 0]
    return np.where(((normal * inside).sum(axis=1) > 0.0)[:, None], -normal, normal), length


def _first_hits(start: np.ndarray, direction: np.ndarray, ends: np.ndarray,
                least: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """For lines from (n, 2) along (n, 2): the first edge among (m, 2, 2) that each meets beyond a
    length of `least` (n,), where on it, and how far away that is; infinite where it meets none."""
    along = ends[:, 1] - ends[:, 0]
    offset = ends[None, :, 0] - start[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        across = direction[:, :1] * along[:, 1] - direction[:, 1:] * along[:, 0]
        width = (offset[..., 0] * along[:, 1] - offset[..., 1] * along[:, 0]) / across
        share = (offset[..., 0] * direction[:, 1:] - offset[..., 1] * direction[:, :1]) / across
    width[~((share >= 0.0) & (share <= 1.0) & (width > least[:, None]))] = np.inf
    edge = width.argmin(axis=1)
    rows = np.arange(len(start))
    return edge, share[rows, edge], width[rows, edge]


def openings_of(matrix: Grid) -> Openings:
    """The lines across all holes and notches. Where the outline faces the outside there is none."""
    outline = outline_of(matrix)
    normal, length = _outward(matrix, outline)
    ends = matrix.points[outline.points]
    start = ends.mean(axis=1)
    block = max(1, _LARGEST_BLOCK // max(1, len(ends)))
    hits = [_first_hits(start[i:i + block], normal[i:i + block], ends,
                        _ROUNDING * length[i:i + block]) for i in range(0, len(ends), block)]
    edge, share, width = (np.concatenate(parts) for parts in zip(*hits))
    found = np.isfinite(width)
    return Openings(outline.points[found], outline.triangle[found],
                    outline.points[edge[found]], share[found], normal[found], width[found])
