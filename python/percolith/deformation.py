# SPDX-License-Identifier: BSD-3-Clause
"""Where a deformed model lies: its points moved by their displacements times a factor. Which
edges of its triangles lie on cracks, and what damage the cracks do them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from percolith.run_directory import Frame
from percolith.vtu import Grid

FROM_THE_START = 0  # of the field `mode`: a fracture that never was bonded


def displacement(matrix: Grid) -> np.ndarray:
    """Displacement (m) of every point, (n, 2)."""
    return matrix.point_data["displacement_m"]


def can_deform(matrix: Grid) -> bool:
    """False in a run of flow through rock at rest."""
    return "displacement_m" in matrix.point_data


def deformed_points(matrix: Grid, scale: float) -> np.ndarray:
    """Places (m) of the points with their displacements times `scale`, (n, 2); as they are where
    the rock is at rest."""
    return matrix.points + scale * displacement(matrix) if can_deform(matrix) else matrix.points


def pair_keys(pairs: np.ndarray, count: int) -> np.ndarray:
    """A number for each pair of numbers below `count`, whatever their order."""
    return pairs.min(axis=1).astype(np.int64) * count + pairs.max(axis=1)


def place_numbers(points: np.ndarray) -> np.ndarray:
    """Which place each of points (n, 2) is at, as numbers (n,)."""
    # One complex number a place sorts much faster than pairs.
    return np.unique(points @ [1.0, 1.0j], return_inverse=True)[1].ravel()


class EdgeKeys(NamedTuple):
    """Edges of triangles, and numbers that are the same for edges and crack segments between the
    same two places."""

    edges: np.ndarray  # indices (3 m, 2) of points, the first edges of all triangles first
    key: np.ndarray  # (3 m,)
    segments: list[np.ndarray]  # of each of the cracks (n,)
    place: np.ndarray  # of each point, as of `place_numbers`


def edge_keys(matrix: Grid, cracks: Sequence[Grid]) -> EdgeKeys:
    """The edges of a matrix, to be told which of them lie on cracks."""
    both = np.concatenate([matrix.points, *(grid.points for grid in cracks)])
    place, first = place_numbers(both), len(matrix.points)
    edges = np.concatenate([matrix.cells[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
    segments = []
    for grid in cracks:
        segments.append(pair_keys(place[first + grid.cells], len(both)))
        first += len(grid.points)
    return EdgeKeys(edges, pair_keys(place[edges], len(both)), segments, place)


class CrackFaces(NamedTuple):
    """Edges of triangles that lie on cracks."""

    points: np.ndarray  # indices (n, 2) of matrix points
    segment: np.ndarray  # crack segment (n,) that each belongs to
    triangle: np.ndarray  # (n,) that each is an edge of


def crack_faces(frame: Frame) -> CrackFaces:
    """The edges of triangles that lie on a crack when undeformed. Most segments have two, one a
    face."""
    matrix, cracks = frame.matrix, frame.cracks
    if cracks is None or not len(cracks.cells):
        none = np.empty(0, int)
        return CrackFaces(np.empty((0, 2), int), none, none)
    return matrix.found_with(cracks, _found_faces)  # every field of damage asks for them anew


def _found_faces(matrix: Grid, cracks: Grid) -> CrackFaces:
    edges, edge_key, (segment_key,), _ = edge_keys(matrix, [cracks])
    chosen = np.flatnonzero(np.isin(edge_key, segment_key))
    order = np.argsort(segment_key, kind="stable")
    found = np.searchsorted(segment_key[order], edge_key[chosen])
    return CrackFaces(edges[chosen], order[found], chosen % len(matrix.cells))


class CrackGaps(NamedTuple):
    """The space between the two faces of crack segments, counter-clockwise or clockwise: from the
    first to the second end on one face and back on the other."""

    corners: np.ndarray  # indices (n, 4) of matrix points
    segment: np.ndarray  # crack segment (n,)


def crack_gaps(frame: Frame) -> CrackGaps:
    """The gap of each segment that lies on the edge of a triangle; without width where it has but
    one face."""
    faces, segment, _ = crack_faces(frame)
    order = np.argsort(segment, kind="stable")
    faces, segment = faces[order], segment[order]
    if len(faces):
        first_end = frame.cracks.points[frame.cracks.cells[segment, 0]]
        turned = (frame.matrix.points[faces[:, 0]] != first_end).any(axis=1)
        faces = np.where(turned[:, None], faces[:, ::-1], faces)
    numbers, first, count = np.unique(segment, return_index=True, return_counts=True)
    last = first + count - 1
    return CrackGaps(np.hstack([faces[first], faces[last][:, ::-1]]), numbers)


def damage_since_the_start(frame: Frame) -> np.ndarray:
    """The largest damage (n,) of the joints of each triangle that were bonded at the start. The
    field `damage` also counts fractures that were open from the start and walls laid free by an
    excavation, where the rock may be sound."""
    damage = np.zeros(len(frame.matrix.cells))
    faces = crack_faces(frame)
    if len(faces.segment):
        data = frame.cracks.cell_data
        of_cracks = np.where(data["mode"] == FROM_THE_START, 0.0, data["damage"])
        np.maximum.at(damage, faces.triangle, of_cracks[faces.segment])
    return damage
