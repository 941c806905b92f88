# SPDX-License-Identifier: BSD-3-Clause
"""The part of a model that a picture shows."""

from __future__ import annotations

import math

import numpy as np

from percolith.deformation import can_deform, crack_faces, deformed_points
from percolith.rigid_bodies import part_of
from percolith.run_directory import ArgumentError, Frame
from percolith.vtu import Grid

_HALF_PIXEL = 1 / 1400  # of the window
ALLOWED = "X0 X1 Y0 Y1 in m, with X0 < X1 and Y0 < Y1"


def window_from(words: list) -> np.ndarray:
    """Lower left and upper right end (2, 2) of the window X0 X1 Y0 Y1 in m. Raises ValueError with
    the reason where it is none."""
    try:
        left, right, low, high = (float(word) for word in words)
    except (TypeError, ValueError):
        raise ValueError("not four numbers") from None
    if not all(map(math.isfinite, (left, right, low, high))):
        raise ValueError("not finite")
    if left >= right or low >= high:
        raise ValueError("without width" if left == right or low == high else "reversed")
    return np.array([[left, low], [right, high]])


def as_window(window) -> np.ndarray | None:
    """The window (2, 2) of X0, X1, Y0, Y1 in m, or of its lower left and upper right end; None where
    there is none. Raises RunDirectoryError where these mean nothing."""
    if window is None:
        return None
    try:
        ends = np.asarray(window)
        return window_from((ends.T if ends.shape == (2, 2) else ends).ravel().tolist())
    except ValueError as error:
        raise ArgumentError(f"window = {window}: {error}; allowed: {ALLOWED}") from error


def meets(corners: np.ndarray, window: np.ndarray) -> np.ndarray:
    """True (n,) for each convex shape with the given corners (n, k, 2) that shares a place with the
    window: no line at right angles to a side of either has one on this and one on that side."""
    low, high = window
    apart = ((corners.max(axis=1) < low) | (corners.min(axis=1) > high)).any(axis=1)
    ends = np.array([[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]])
    for side in (corners - np.roll(corners, 1, axis=1)).transpose(1, 0, 2):
        normal = np.stack([-side[:, 1], side[:, 0]], axis=1)
        shape = np.einsum("nkx,nx->nk", corners, normal)
        frame = normal @ ends.T
        apart |= (shape.max(axis=1) < frame.min(axis=1)) | (shape.min(axis=1) > frame.max(axis=1))
    return ~apart


def _cracks_in(frame: Frame, scale: float, window: np.ndarray) -> Grid | None:
    """The crack segments of which a face can be seen; of rock at rest the segment itself."""
    cracks = frame.cracks
    if cracks is None:
        return None
    if can_deform(frame.matrix):
        faces, segment, _ = crack_faces(frame)
        inside = meets(deformed_points(frame.matrix, scale)[faces], window)
        kept = np.isin(np.arange(len(cracks.cells)), segment[inside])
    else:
        kept = meets(cracks.points[cracks.cells], window)
    return Grid(cracks.points, cracks.cells[kept], cracks.point_data,
                {name: values[kept] for name, values in cracks.cell_data.items()}, cracks.time)


def visible(frame: Frame, scale: float, window: np.ndarray) -> Frame:
    """The triangles and cracks of a frame that a window shows, with displacements times `scale`. A
    triangle that reaches in by less than can be seen does not count for the colours."""
    matrix = frame.matrix
    margin = _HALF_PIXEL * (window[1] - window[0])
    inside = meets(deformed_points(matrix, scale)[matrix.cells], window + [margin, -margin])
    return Frame(frame.time, part_of(matrix, inside), _cracks_in(frame, scale, window))


def check_shows(count: int, window: np.ndarray, whole: np.ndarray) -> None:
    """Raises RunDirectoryError where a window shows none of the triangles of a model that fills
    `whole`, both (2, 2), m."""
    if count:
        return
    (left, low), (right, high) = window
    shown = f"{left:g} {right:g} {low:g} {high:g}"
    (left, low), (right, high) = whole
    raise ArgumentError(f"window = {shown}: no rock there; the rock reaches from x = {left:.6g} to "
                        f"{right:.6g} m and from y = {low:.6g} to {high:.6g} m")
