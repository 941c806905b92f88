# SPDX-License-Identifier: BSD-3-Clause
"""Lines that a mesh can follow: crossings become points, what nearly touches is merged, and lines
that meet at a small angle run together until they are apart."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from percolith.errors import MeshError
from percolith.mesh.closeness import close_pairs, crossings, near_pieces
from percolith.mesh.fractures import Fracture, clip
from percolith.mesh.outline import Outline

BOUNDARY = -1  # owner of edges of the outline
_MOST_PASSES = 500


@dataclass(frozen=True)
class Change:
    """What was done to fractures so that they can be meshed. kind: "points merged", "end moved to
    a line", "run together", "left out", of a part, or "left out as a whole". fractures: their
    numbers, from 0; of two that run together the second follows the first. place: m, where two that
    run together meet. distance: m, by how much something was moved, or over which length two run
    together or one was left out. reason: why one is left out as a whole. groups: of the fractures.
    until: m, to where two run together. side: of the outline, where a fracture follows it."""

    kind: str
    fractures: tuple[int, ...]
    place: tuple[float, float]
    distance: float
    reason: str = ""
    groups: tuple[str, ...] = ()
    until: tuple[float, float] | None = None
    side: str = ""

    def __str__(self) -> str:
        groups = [f" ({group})" for group in self.groups] or [""] * len(self.fractures)
        who = " and ".join(f"{number}{group}" for number, group in zip(self.fractures, groups))
        along = self.side and f" and side {self.side}"
        # Two may run together to both sides of where they meet.
        where = (f"at {_place_text(self.place)}" if self.until is None
                 else f"from {_place_text(self.place)} to {_place_text(self.until)}")
        return (f"{self.kind} {where}: fracture {who or 'none'}{along}, "
                f"{self.distance:.3g} m{self.reason and ', ' + self.reason}")


def _place_text(place: tuple[float, float]) -> str:
    x, y = (round(value, 9) + 0.0 for value in place)
    return f"({x:.6g}, {y:.6g})"


@dataclass(frozen=True)
class Edge:
    """A straight piece between two nodes: of the fracture `owner`, or of the side `side`."""

    a: int
    b: int
    owner: int
    side: str = ""


class Arrangement:
    """Nodes and edges without crossings, nodes not closer than `tolerance` (m) to each other, nor
    than 0.86 of it to edges they do not belong to, but for those of the outline among themselves.
    At sides that have a tolerance of their own, that counts.
    """

    def __init__(self, outline: Outline, fractures: Sequence[Fracture], tolerance: float,
                 smallest_angle_deg: float, side_tolerances: Mapping[str, float]):
        self.tolerance = tolerance
        self._side_tolerances = side_tolerances
        self._angle = math.radians(smallest_angle_deg)
        self.nodes = np.empty((0, 2))
        self.fixed = np.empty(0, dtype=bool)
        self.edges: list[Edge] = []
        self.changes: list[Change] = []
        self._covered: dict[int, dict[str, None]] = {}  # what lies where each fracture would
        self._outline = outline
        self._groups = [fracture.group for fracture in fractures]
        for loop in [outline, *outline.holes]:
            self._add_line(np.vstack([loop.corners, loop.corners[:1]]), BOUNDARY, loop.sides)
        self._outside: set[int] = set()  # fractures that lose something there
        for number, fracture in enumerate(fractures):
            for part in self._parts_in_the_rock(number, fracture.points):
                self._add_line(part, number)
        self._settle()
        self._leave_out_what_is_outside()
        self._tell_what_is_gone(fractures)

    @property
    def fracture_length(self) -> float:
        """m, of all fractures together; where they lie on each other it counts once"""
        return sum(self.length(edge) for edge in self.edges if edge.owner != BOUNDARY)

    @property
    def left_out(self) -> tuple[int, ...]:
        """Numbers, from 0, of the fractures of which nothing is left."""
        return tuple(change.fractures[0] for change in self.changes
                     if change.kind == "left out as a whole")

    def _add_node(self, place: np.ndarray, fixed: bool) -> int:
        self.nodes = np.vstack([self.nodes, place])
        self.fixed = np.append(self.fixed, fixed)
        return len(self.nodes) - 1

    def _add_line(self, points: np.ndarray, owner: int, sides: Sequence[str] = ()) -> None:
        is_loop = owner == BOUNDARY
        numbers = [self._add_node(place, is_loop) for place in points[:-1 if is_loop else None]]
        if is_loop:
            numbers.append(numbers[0])
        for i, (a, b) in enumerate(zip(numbers, numbers[1:])):
            self.edges.append(Edge(a, b, owner, sides[i] if is_loop else ""))

    def _parts_in_the_rock(self, number: int, points: np.ndarray) -> list[np.ndarray]:
        """A line without what lies outside over more than the tolerance: within a small hole it
        would be drawn to the wall."""
        parts: list[list[np.ndarray]] = [[points[0]]]
        for start, end in zip(points, points[1:]):
            inside = clip(start, end, self._outline)
            outer = zip([start, *(last for _, last in inside)], [*(one for one, _ in inside), end])
            for leaves, enters in outer:
                length = float(np.hypot(*(enters - leaves)))
                if length <= self.tolerance or self._is_on_the_outline(0.5 * (leaves + enters)):
                    continue
                self._leave_out(number, 0.5 * (leaves + enters), length)
                if (leaves != parts[-1][-1]).any():
                    parts[-1].append(leaves)
                parts.append([enters])
            if (end != parts[-1][-1]).any():
                parts[-1].append(end)
        return [np.array(part) for part in parts if len(part) > 1]

    def _is_on_the_outline(self, place: np.ndarray) -> bool:
        return bool(len(near_pieces(self._outline.edges(), place[None], 1e-6 * self.tolerance)[0]))

    def _leave_out(self, number: int, place: np.ndarray, length: float) -> None:
        self._note("left out", {number}, place, length)
        self._outside.add(number)

    def _tolerance_at(self, edge: Edge) -> float:
        return self._side_tolerances.get(edge.side, self.tolerance)

    def _tolerances_at_nodes(self) -> dict[int, float]:
        """Of nodes at sides that have one of their own."""
        return {node: self._tolerance_at(edge) for edge in self.edges
                if edge.side in self._side_tolerances for node in (edge.a, edge.b)}

    def _settle(self) -> None:
        for _ in range(_MOST_PASSES):
            if not (self._merge_nodes() or self._split_at_nodes() or self._cross()
                    or self._part_small_angles()):
                return
        raise MeshError("the fractures cannot be brought apart; a smaller tolerance or fewer "
                        "fractures may help")

    def _note(self, kind: str, owners, place: np.ndarray, distance: float,
              until: np.ndarray | None = None, side: str = "") -> None:
        numbers = tuple(sorted({owner for owner in owners if owner != BOUNDARY}))
        self.changes.append(Change(
            kind, numbers, (float(place[0]), float(place[1])), float(distance),
            groups=tuple(self._groups[number] for number in numbers),
            until=None if until is None else (float(until[0]), float(until[1])), side=side))

    def _owners(self, node: int) -> set[int]:
        return {edge.owner for edge in self.edges if node in (edge.a, edge.b)}

    def _replace(self, edges: list[Edge]) -> None:
        """Takes over edges; of those between the same nodes that of the outline, or else of the
        first fracture, stays."""
        kept: dict[tuple[int, int], Edge] = {}
        for edge in sorted(edges, key=lambda edge: edge.owner):
            if edge.a != edge.b:
                first = kept.setdefault((min(edge.a, edge.b), max(edge.a, edge.b)), edge)
                if first.owner != edge.owner:
                    name = (f"side {first.side}" if first.owner == BOUNDARY
                            else f"fracture {first.owner}")
                    self._covered.setdefault(edge.owner, {})[name] = None
        self.edges = list(kept.values())

    def _used(self) -> np.ndarray:
        return np.unique([node for edge in self.edges for node in (edge.a, edge.b)])

    def _ends(self) -> np.ndarray:
        """Places of the ends of the edges, (edges, 2, 2)."""
        return self.nodes[[[edge.a, edge.b] for edge in self.edges]]

    def _merge_nodes(self) -> bool:
        """Brings together pairs of nodes that are too close, the closest first; what touches a pair
        waits for the next pass."""
        used = self._used()
        first, second, gaps = close_pairs(self.nodes[used], self.tolerance)
        own = self._tolerances_at_nodes()
        done: dict[int, int] = {}
        for i in np.argsort(gaps, kind="stable"):
            stays, goes = int(used[first[i]]), int(used[second[i]])
            if self.fixed[goes]:
                stays, goes = goes, stays
            if self.fixed[goes] or {stays, goes} & done.keys():
                continue
            if gaps[i] >= min(own.get(node, self.tolerance) for node in (stays, goes)):
                continue
            if gaps[i] > 0.0:
                self._note("points merged", self._owners(stays) | self._owners(goes),
                           self.nodes[stays], gaps[i])
            done |= {stays: stays, goes: stays}
        self._replace([Edge(done.get(edge.a, edge.a), done.get(edge.b, edge.b), edge.owner, edge.side)
                       for edge in self.edges] if done else self.edges)
        return bool(done)

    def _split(self, edge: Edge, node: int) -> None:
        self._split_all({edge: node})

    def _split_all(self, at: dict[Edge, int]) -> None:
        """Splits edges, each at its node."""
        rest = [edge for edge in self.edges if edge not in at]
        halves = [half for edge, node in at.items()
                  for half in (Edge(edge.a, node, edge.owner, edge.side),
                               Edge(node, edge.b, edge.owner, edge.side))]
        self._replace([*rest, *halves])

    def _split_at_nodes(self) -> bool:
        """Splits edges at nodes that are too close to them, the closest first; an edge or a node
        that has been dealt with waits for the next pass."""
        used = self._used()
        numbers, places, gaps, feet = near_pieces(self._ends(), self.nodes[used], self.tolerance)
        own = self._tolerances_at_nodes()
        at: dict[Edge, int] = {}
        touched: set[int] = set()
        for i in np.argsort(gaps, kind="stable"):
            edge, node = self.edges[numbers[i]], int(used[places[i]])
            if (node in (edge.a, edge.b) or edge in at or node in touched
                    or (edge.owner == BOUNDARY and self.fixed[node])):
                continue
            if gaps[i] >= min(self._tolerance_at(edge), own.get(node, self.tolerance)):
                continue
            # Of a small triangle only the longest side goes: otherwise they would take turns.
            if self.length(edge) <= max(self._distance(node, edge.a), self._distance(node, edge.b)):
                continue
            if gaps[i] > 1e-9 * self.tolerance:
                self._note("end moved to a line", self._owners(node) | {edge.owner}, feet[i], gaps[i])
            if edge.owner == BOUNDARY:
                self.nodes[node] = feet[i]
                self.fixed[node] = True
            at[edge] = node
            touched |= {node, edge.a, edge.b}
        self._split_all(at)
        return bool(at)

    def _cross(self) -> bool:
        """Makes nodes where edges cross, one an edge in a pass."""
        nodes = np.array([[edge.a, edge.b] for edge in self.edges])
        at: dict[Edge, int] = {}
        for i, j, place in zip(*crossings(self._ends(), nodes)):
            one, other = self.edges[i], self.edges[j]
            if one not in at and other not in at:
                at[one] = at[other] = self._add_node(place, BOUNDARY in (one.owner, other.owner))
        self._split_all(at)
        return bool(at)

    def _part_small_angles(self) -> bool:
        """Where two edges leave a node at a small angle, lets the second run along the first to
        where they are as far apart as nodes must be."""
        leaving: dict[int, list[tuple[float, int, Edge]]] = {}
        for edge in self.edges:
            for node, far in ((edge.a, edge.b), (edge.b, edge.a)):
                way = self.nodes[far] - self.nodes[node]
                leaving.setdefault(node, []).append((math.atan2(way[1], way[0]), far, edge))
        present = set(self.edges)
        parted = False
        for node, around in leaving.items():
            around.sort(key=lambda one: one[0])
            for first, second in zip(around, around[1:] + around[:1]):
                angle = (second[0] - first[0]) % (2.0 * math.pi)
                if (first[2] is not second[2] and angle < self._angle
                        and {first[2], second[2]} <= present
                        and (first[2].owner, second[2].owner) != (BOUNDARY, BOUNDARY)):
                    keep, move = sorted([first, second], key=lambda one: one[2].owner)
                    self._run_together(node, keep, move, angle)
                    present.intersection_update(self.edges)
                    parted = True
                    break
        return parted

    def _run_together(self, node: int, keep, move, angle: float) -> None:
        # A little more than the tolerance, so that both ends of the step between them stay.
        tolerance = min(self._tolerance_at(keep[2]), self._tolerance_at(move[2]))
        way = 1.2 * tolerance / (2.0 * math.sin(0.5 * angle))
        on_keep = self._node_along(node, keep, way, tolerance)
        along = min(self._distance(node, on_keep), self._distance(node, move[1]))
        self._note("run together", {keep[2].owner, move[2].owner}, self.nodes[node], along,
                   self.nodes[on_keep], keep[2].side)
        rest = [edge for edge in self.edges if edge != move[2]]
        on_move = move[1]
        if way < self._distance(node, move[1]) - tolerance:
            on_move = self._node_along(node, move, way, tolerance, split=False)
            rest.append(Edge(on_move, move[1], move[2].owner, move[2].side))
        self._replace([*rest, Edge(on_keep, on_move, move[2].owner, move[2].side)])

    def _distance(self, a: int, b: int) -> float:
        return float(np.hypot(*(self.nodes[a] - self.nodes[b])))

    def length(self, edge: Edge) -> float:
        """m"""
        return self._distance(edge.a, edge.b)

    def _node_along(self, node: int, leaving, way: float, tolerance: float,
                    split: bool = True) -> int:
        """The node `way` (m) from `node` along an edge; its far end where that is not beyond."""
        _, far, edge = leaving
        length = self._distance(node, far)
        if way >= length - tolerance and split:
            return far
        place = self.nodes[node] + way / length * (self.nodes[far] - self.nodes[node])
        new = self._add_node(place, edge.owner == BOUNDARY)
        if split:
            self._split(edge, new)
        return new

    def _leave_out_what_is_outside(self) -> None:
        middles = np.array([0.5 * (self.nodes[edge.a] + self.nodes[edge.b]) for edge in self.edges])
        inside = self._outline.contains(middles)
        kept = []
        for edge, middle, is_inside in zip(self.edges, middles, inside):
            if edge.owner == BOUNDARY or is_inside:
                kept.append(edge)
            else:
                self._leave_out(edge.owner, middle, self.length(edge))
        self.edges = kept

    def _tell_what_is_gone(self, fractures: Sequence[Fracture]) -> None:
        """Puts a change for each fracture without an edge before all others."""
        present = {edge.owner for edge in self.edges}
        gone = []
        for number, fracture in enumerate(fractures):
            if number in present:
                continue
            reasons = ["outside the rock"] * (number in self._outside)
            if covering := self._covered.get(number):
                reasons.append(f"covered by {' and '.join(covering)}")
            if fracture.length == 0.0:
                reasons = ["without length"]
            x, y = fracture.points.mean(axis=0)
            gone.append(Change("left out as a whole", (number,), (float(x), float(y)),
                               fracture.length, " and ".join(reasons) or "merged to a point",
                               (fracture.group,)))
        self.changes[:0] = gone


def arrange(outline: Outline, fractures: Sequence[Fracture], tolerance: float,
            smallest_angle_deg: float = 20.0,
            side_tolerances: Mapping[str, float] | None = None) -> Arrangement:
    """Outline and fractures as nodes and edges that a mesh can follow; see `Arrangement`.
    side_tolerances: of sides that have one of their own, m, by name. Raises MeshError."""
    return Arrangement(outline, fractures, tolerance, smallest_angle_deg, side_tolerances or {})
