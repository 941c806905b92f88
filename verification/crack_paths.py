# SPDX-License-Identifier: BSD-3-Clause
"""How far cracks have run: broken joints that hang together with the place they began at."""

from __future__ import annotations

import heapq
from collections import defaultdict

import numpy as np
from percolith.run_directory import Frame

SAME_PLACE = 1e-6  # m, points nearer than this are one


def _place(point) -> tuple[int, int]:
    return int(round(point[0] / SAME_PLACE)), int(round(point[1] / SAME_PLACE))


def is_broken(frame: Frame) -> np.ndarray:
    """Which lines of the cracks are broken joints; all where rock does not move."""
    if "mode" not in frame.cracks.cell_data:
        return np.ones(len(frame.cracks.cells), dtype=bool)
    return frame.cracks.cell_data["mode"] >= 0


def broken_lines(frame: Frame) -> np.ndarray:
    """Ends (m) of the joints that are broken, undeformed, one pair a joint; those broken from the
    start are among them."""
    if frame.cracks is None or not len(frame.cracks.cells):
        return np.empty((0, 2, 2))
    return frame.cracks.points[frame.cracks.cells][is_broken(frame)]


def _neighbours(lines: np.ndarray, roots: dict[str, list], bridge: float) -> dict:
    """Of each place the others that a line or a bridge leads to, with the distance (m)."""
    found = defaultdict(list)

    def join(first, second):
        length = float(np.hypot(*np.subtract(second, first)))
        a, b = _place(first), _place(second)
        found[a].append((b, length))
        found[b].append((a, length))

    for first, second in lines:
        join(first, second)
    if bridge > 0:
        points = [*lines.reshape(-1, 2), *(place for places in roots.values() for place in places)]
        points = np.unique(np.array(points).reshape(-1, 2), axis=0)
        apart = np.hypot(*np.moveaxis(points[:, None] - points[None, :], 2, 0))
        for i, j in zip(*np.nonzero(np.triu(apart <= bridge, 1))):
            join(points[i], points[j])
    return found


def branches(lines: np.ndarray, roots: dict[str, list],
             bridge: float = 0.0) -> dict[str, np.ndarray]:
    """Points (m) that broken lines join to the places `roots` (m, a list for each name). A crack
    may go on beside its tip: ends up to `bridge` (m) apart count as joined. A point that several
    reach belongs to the one from which the way along the cracks is shortest."""
    neighbours = _neighbours(lines, roots, bridge)
    queue = [(0.0, name, _place(place)) for name, places in roots.items() for place in places]
    heapq.heapify(queue)
    owner: dict[tuple[int, int], str] = {}
    while queue:
        way, name, place = heapq.heappop(queue)
        if place in owner:
            continue
        owner[place] = name
        for other, length in neighbours[place]:
            if other not in owner:
                heapq.heappush(queue, (way + length, name, other))
    reached = defaultdict(list)
    for place, name in owner.items():
        reached[name].append(np.array(place) * SAME_PLACE)
    return {name: np.array(reached[name]).reshape(-1, 2) for name in roots}


def deflection(start, tip) -> float:
    """Angle (degree) of the line from `start` to `tip` (m) against the x axis; 0 where they are
    one place."""
    along, across = np.subtract(tip, start)
    if np.hypot(along, across) < SAME_PLACE:
        return 0.0
    return float(np.degrees(np.arctan2(across, along)))
