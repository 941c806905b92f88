# SPDX-License-Identifier: BSD-3-Clause
"""A triangulation with joints, written down a second time and independently of the program."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

import numpy as np


class Partition:
    """Sets that merge (union-find)."""

    def __init__(self, count: int):
        self.parent = list(range(count))

    def find(self, i: int) -> int:
        while self.parent[i] != i:
            i = self.parent[i]
        return i

    def merge(self, i: int, j: int) -> None:
        self.parent[self.find(i)] = self.find(j)


@dataclass
class Joint:
    """An interior edge: the triangles and, per end, the local corners on both sides."""

    triangles: tuple[int, int]
    ends: tuple[int, int]  # vertices
    corners: tuple[tuple[int, int], tuple[int, int]]  # [end][side], numbered 3 triangle + local


@dataclass
class Triangulation:
    points: np.ndarray  # (n, 2), m
    triangles: np.ndarray  # (m, 3), counter-clockwise
    curves: dict[str, list[tuple[int, int]]]  # named edges

    def __post_init__(self):
        p = self.points[self.triangles]
        a, b = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
        self.area = 0.5 * (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])
        assert (self.area > 0).all()
        owners = defaultdict(list)
        for t, vertices in enumerate(self.triangles):
            for k in range(3):
                edge = tuple(sorted((vertices[k], vertices[(k + 1) % 3])))
                owners[edge].append(t)
        self.joints: dict[tuple[int, int], Joint] = {}
        self.boundary: dict[tuple[int, int], int] = {}
        for edge, sides in owners.items():
            if len(sides) == 1:
                self.boundary[edge] = sides[0]
            else:
                corners = tuple(tuple(self.corner(t, v) for t in sides) for v in edge)
                self.joints[edge] = Joint(tuple(sides), edge, corners)

    def corner(self, triangle: int, vertex: int) -> int:
        return 3 * triangle + list(self.triangles[triangle]).index(vertex)

    def length(self, edge: tuple[int, int]) -> float:
        return float(np.linalg.norm(self.points[edge[1]] - self.points[edge[0]]))

    def edges(self, names: list[str]) -> list[tuple[int, int]]:
        return [tuple(sorted(edge)) for name in names for edge in self.curves[name]]


def cracked_square(cells: int, shift: float) -> Triangulation:
    """The unit square in `cells` x `cells` squares, each halved along a diagonal. Curves: left,
    right, bottom, top, and two fractures on grid lines that cross: `level`, which ends inside at
    both ends, and `upright`, which ends at the bottom. Points off those lines are moved by up to
    `shift` of a cell, so that no two triangles are alike."""
    assert cells % 2 == 0 and cells >= 4
    number = {(i, j): i + j * (cells + 1) for j in range(cells + 1) for i in range(cells + 1)}
    half = cells // 2
    noise = np.random.default_rng(7)
    points = np.zeros((len(number), 2))
    for (i, j), n in number.items():
        inside = 0 < i < cells and 0 < j < cells and i != half and j != half
        points[n] = np.array([i, j]) / cells
        points[n] += noise.uniform(-shift, shift, 2) / cells if inside else 0.0
    triangles = []
    for i in range(cells):
        for j in range(cells):
            a, b = number[i, j], number[i + 1, j]
            c, d = number[i + 1, j + 1], number[i, j + 1]
            triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    along = range(cells)
    curves = {
        "left": [(number[0, j], number[0, j + 1]) for j in along],
        "right": [(number[cells, j], number[cells, j + 1]) for j in along],
        "bottom": [(number[i, 0], number[i + 1, 0]) for i in along],
        "top": [(number[i, cells], number[i + 1, cells]) for i in along],
        "level": [(number[i, half], number[i + 1, half]) for i in range(1, cells - 1)],
        "upright": [(number[half, j], number[half, j + 1]) for j in range(cells - 1)],
    }
    return Triangulation(points, np.array(triangles), curves)


def write_msh(mesh: Triangulation, path: Path) -> None:
    """Writes the mesh as Gmsh 2.2 ASCII: one region `rock`, the curves by their names."""
    names = list(mesh.curves)
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names) + 1)]
    lines += [f'1 {i + 1} "{name}"' for i, name in enumerate(names)]
    lines += [f'2 {len(names) + 1} "rock"']
    lines += ["$EndPhysicalNames", "$Nodes", str(len(mesh.points))]
    lines += [f"{i + 1} {x!r} {y!r} 0" for i, (x, y) in enumerate(mesh.points.tolist())]
    elements = [(1, i + 1, edge) for i, name in enumerate(names) for edge in mesh.curves[name]]
    elements += [(2, len(names) + 1, triangle) for triangle in mesh.triangles.tolist()]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    for i, (kind, tag, vertices) in enumerate(elements):
        places = " ".join(str(v + 1) for v in vertices)
        lines.append(f"{i + 1} {kind} 2 {tag} {tag} {places}")
    path.write_text("\n".join(lines + ["$EndElements", ""]))
