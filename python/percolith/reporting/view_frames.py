# SPDX-License-Identifier: BSD-3-Clause
"""The arrays of the frames of a view: that of the frame asked for as they are, those of the others
rounded. What two frames share is held once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from percolith.deformation import CrackGaps, can_deform, crack_gaps, displacement
from percolith.reporting.nodes import Nodes, hubs, joined_points, nodes_of
from percolith.reporting.packed import Packed, pack, pack_rounded
from percolith.reporting.view_fields import ViewField, crack_values, rock_values
from percolith.rigid_bodies import rigid_triangles
from percolith.run_directory import Frame, RunDirectory, carries_fluid
from percolith.vtu import Grid

FARTHEST_ROUNDED = 1000  # times the median displacement


class NoRoom(Exception):
    """More letters than there is room for."""


@dataclass
class HeldArrays:
    """Arrays by their keys; of two of one name that are the same one is held. `add` raises NoRoom
    where they take more than `most` letters."""

    most: float = float("inf")
    arrays: dict[str, Packed] = field(default_factory=dict)
    _keys: dict[tuple[str, Packed], str] = field(default_factory=dict)

    def add(self, name: str, packed: Packed) -> str:
        """The key of an array: its name, with a number where that is taken."""
        if (name, packed) not in self._keys:
            number = sum(known == name for known, _ in self._keys)
            key = f"{name}@{number}" if number else name
            self._keys[name, packed], self.arrays[key] = key, packed
            if self.letters > self.most:
                raise NoRoom
        return self._keys[name, packed]

    @property
    def letters(self) -> int:
        """How much of a page they take."""
        return sum(len(packed.text) for packed in self.arrays.values())


def has_mesh_of(one: Grid, other: Grid) -> bool:
    return np.array_equal(one.cells, other.cells) and np.array_equal(one.points, other.points)


def nodes_over_time(frames: Sequence[Frame]) -> list[Nodes]:
    """The nodes of each frame, the same for all that have the same mesh, so that a page holds them
    once. Only an excavation changes the mesh."""
    found: list[Nodes] = []
    for frame in frames:
        same = [has_mesh_of(frame.matrix, other.matrix) for other in frames]
        before = same.index(True)
        found.append(found[before] if before < len(found) else nodes_of(
            frame.matrix, [other.cracks for other, is_same in zip(frames, same)
                           if is_same and other.cracks is not None]))
    return found


def _without_bodies(run: RunDirectory, frame: Frame, values: np.ndarray,
                    at_points: bool) -> np.ndarray:
    """NaN for rigid bodies, which no field of the rock describes. A model of rigid bodies alone is
    shown as rock."""
    rigid = rigid_triangles(run, frame.matrix)
    if not rigid.any() or rigid.all():
        return values
    values = np.array(values, float)
    values[frame.matrix.cells[rigid].ravel() if at_points else rigid] = np.nan
    return values


class FrameArrays:
    """Packs the arrays of one frame into `held`; `keys` tells which they are by their names."""

    def __init__(self, run: RunDirectory, frame: Frame, cracks: Grid | None, nodes: Nodes,
                 held: HeldArrays, is_rounded: bool):
        """`cracks` are those of the frame that are shown."""
        self.run, self.frame, self.cracks, self.nodes = run, frame, cracks, nodes
        self.held, self.is_rounded = held, is_rounded
        self.keys: dict[str, str] = {}

    @cached_property
    def _gaps(self) -> CrackGaps:
        return crack_gaps(Frame(self.frame.time, self.frame.matrix, self.cracks))

    @property
    def segment(self) -> np.ndarray:
        """The segments of the cracks whose values are packed, in that order."""
        if can_deform(self.frame.matrix):
            return self._gaps.segment
        return np.arange(0 if self.cracks is None else len(self.cracks.cells))

    def _add(self, name: str, packed: Packed) -> None:
        self.keys[name] = self.held.add(name, packed)

    def _add_values(self, name: str, values: np.ndarray) -> None:
        self._add(name, (pack_rounded if self.is_rounded else pack)(values))

    def add_mesh(self, origin: np.ndarray) -> None:
        """Places of the nodes (from `origin`), the node of each point, the points of triangles."""
        matrix, nodes = self.frame.matrix, self.nodes
        self._add("places", pack(matrix.points[nodes.first] - origin))
        self._add("node", pack(nodes.node, "uint32"))
        self._add("cells", pack(matrix.cells, "uint32"))

    def add_motion(self) -> None:
        """Displacements of the nodes, those that hang together at this time moving as one; the gaps
        of the cracks, four nodes each, two on either face; what these leave open where they
        meet."""
        frame, nodes = self.frame, self.nodes
        joined = joined_points(frame.matrix, [] if frame.cracks is None else [frame.cracks])
        count = np.maximum(np.bincount(joined), 1)
        moved = [(np.bincount(joined, along) / count)[joined[nodes.first]]
                 for along in displacement(frame.matrix).T]
        self._add_displacement(np.stack(moved, axis=1))
        cracks, gaps = self.cracks, self._gaps
        if cracks is None or not len(cracks.cells):
            return
        self._add("gaps", pack(nodes.node[gaps.corners], "uint32"))
        if len(gaps.segment):
            self._add_hubs(joined, gaps.corners, carries_fluid(cracks)[gaps.segment])

    def _add_displacement(self, moved: np.ndarray) -> None:
        """Displacements (n, 2); unrounded where a piece has flown so far that steps of its way are
        as large as the openings of cracks elsewhere."""
        median = np.median(np.hypot(*moved.T)) if len(moved) else 0.0
        if np.ptp(moved) > FARTHEST_ROUNDED * median:
            self._add("displacement", pack(moved))
        else:
            self._add_values("displacement", moved)

    def _add_hubs(self, joined: np.ndarray, gaps: np.ndarray, is_wet: np.ndarray) -> None:
        """Three nodes of each triangle, and the end of a gap whose value it has, of one that holds
        fluid where there is one: twice the number of the gap, and one more at the second end."""
        corners, at = hubs(self.frame.matrix, joined)
        places = self.frame.matrix.points @ [1.0, 1.0j]
        ends = places[gaps[:, :2]].ravel()
        order = np.lexsort([np.repeat(~is_wet, 2), ends.imag, ends.real])  # as complex numbers sort
        found = np.minimum(np.searchsorted(ends[order], places[at]), len(ends) - 1)
        number = order[found]
        touched = ends[number] == places[at]
        self._add("hubs", pack(self.nodes.node[corners[touched]], "uint32"))
        self._add("hub-ends", pack(number[touched], "uint32"))

    def add_rock(self, fields: Sequence[ViewField]) -> None:
        for one in fields:
            values = rock_values(self.frame, one.name)
            if one.names:
                self._add(f"rock-{one.name}", pack(values))
            else:
                self._add_field(one, _without_bodies(self.run, self.frame, values, one.at_points))

    def _add_field(self, one: ViewField, values: np.ndarray) -> None:
        """Values of a field; of points one a node where that loses nothing, and in rounded frames
        the mean over each node."""
        if one.at_points:
            nodes = self.nodes
            values = np.asarray(values, float)
            if nodes.holds(values):
                values = values[nodes.first]
            elif self.is_rounded and nodes.holds(np.isnan(values)):
                values = nodes.means(values)
        self._add_values(f"rock-{one.name}", values)

    def add_cracks(self, fields: Sequence[ViewField], origin: np.ndarray) -> None:
        """Values of the cracks, and of rock at rest where they are."""
        cracks, segment = self.cracks, self.segment
        if not can_deform(self.frame.matrix):
            self._add("ends", pack(cracks.points[cracks.cells] - origin))
        for one in fields:
            values = crack_values(cracks, one.name)[segment]
            if one.names:
                self._add(f"crack-{one.name}", pack(values))
            else:
                self._add_values(f"crack-{one.name}", values)
