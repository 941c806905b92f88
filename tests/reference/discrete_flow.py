# SPDX-License-Identifier: BSD-3-Clause
"""The discrete laws of flow in pores and cracks, written down a second time, in plain Python and
with none of the program's tricks: unknowns are the nodes, flows run along pairs of nodes.

Laws: linear triangles (18), (19); finite joints (20); cubic law (27); exchange (33)-(36); contents
of pores and cracks with partial saturation."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg as sparse_linalg

from triangulation import Partition, Triangulation

INFINITE = float("inf")


@dataclass
class Rock:
    permeability: np.ndarray  # 2 x 2, m2
    porosity: float
    biot_modulus: float  # Pa


@dataclass
class Fracture:
    curve: str
    aperture: float  # m
    exchange: float  # m/(Pa s)
    transmissivity: float | None = None  # m3


@dataclass
class Flow:
    """A flow problem. Unknowns 0 .. n-1 are pressure nodes: pore nodes and open crack nodes, or
    both in one where the exchange is infinite."""

    mesh: Triangulation
    rock: Rock
    fractures: list[Fracture]
    viscosity: float
    density: float
    bulk_modulus: float
    gravity: float
    joint_factor: float | None = None  # n of finite joints; None: tied
    fixed: dict[int, float] = field(default_factory=dict)  # unknown -> pressure
    rate: dict[int, float] = field(default_factory=dict)  # unknown -> inflow, m2/s

    def __post_init__(self):
        self._connect()
        self._pairs()
        self._contents()

    # Unknowns --------------------------------------------------------------------------------

    def _connect(self):
        mesh = self.mesh
        self.broken = {edge: f for f in self.fractures for edge in mesh.edges([f.curve])}
        corners = 3 * len(mesh.triangles)
        sets = Partition(corners + len(mesh.points))  # corners, then vertices as crack nodes
        for edge, joint in mesh.joints.items():
            if edge in self.broken or self.joint_factor is not None:
                continue
            for first, second in joint.corners:
                sets.merge(first, second)
        for edge, fracture in self.broken.items():
            if fracture.exchange == INFINITE:
                for vertex, sides in zip(edge, mesh.joints[edge].corners):
                    for corner in sides:
                        sets.merge(corner, corners + vertex)
        open_vertices = sorted({v for edge in self.broken for v in edge})
        used = list(range(corners)) + [corners + v for v in open_vertices]
        roots = sorted({sets.find(i) for i in used})
        number = {root: i for i, root in enumerate(roots)}
        self.of_corner = np.array([number[sets.find(c)] for c in range(corners)])
        self.of_crack = {v: number[sets.find(corners + v)] for v in open_vertices}
        self.unknowns = len(roots)
        self.elevation = np.zeros(self.unknowns)
        self.elevation[self.of_corner] = mesh.points[mesh.triangles.ravel(), 1]
        for v, unknown in self.of_crack.items():
            self.elevation[unknown] = mesh.points[v, 1]

    # Conductances ----------------------------------------------------------------------------

    def _pairs(self):
        """All pairs (first, second, conductance): flow = conductance x difference of potential."""
        pairs = [*self._triangle_pairs(), *self._crack_pairs()]
        if self.joint_factor is not None:
            pairs += self._joint_pairs()
        self.first, self.second = (np.array([p[i] for p in pairs]) for i in (0, 1))
        self.conductance = np.array([p[2] for p in pairs])

    def _triangle_pairs(self):
        for t, vertices in enumerate(self.mesh.triangles):
            x = np.column_stack([np.ones(3), self.mesh.points[vertices]])
            gradients = np.linalg.inv(x)[1:]  # of the three shape functions, as columns
            stiffness = (self.mesh.area[t] / self.viscosity
                         * gradients.T @ self.rock.permeability @ gradients)
            for i in range(3):
                for j in range(i):
                    yield self.of_corner[3 * t + i], self.of_corner[3 * t + j], -stiffness[i, j]

    def _joint_pairs(self):
        mesh = self.mesh
        for edge, joint in mesh.joints.items():
            if edge in self.broken:
                continue
            tangent = (mesh.points[edge[1]] - mesh.points[edge[0]]) / mesh.length(edge)
            normal = np.array([tangent[1], -tangent[0]])
            across = normal @ self.rock.permeability @ normal
            # The element size is the edge of the equilateral triangle of the same area; the two
            # sides act in series, so their sizes are averaged.
            size = np.mean([np.sqrt(4 * mesh.area[t] / np.sqrt(3)) for t in joint.triangles])
            exchange = self.joint_factor * across / (self.viscosity * size)
            for first, second in joint.corners:
                yield (self.of_corner[first], self.of_corner[second],
                       exchange * mesh.length(edge) / 2)

    def _crack_pairs(self):
        mesh = self.mesh
        for edge, fracture in self.broken.items():
            start, stop = (self.of_crack[v] for v in edge)
            yield start, stop, self.crack_conductance(edge)
            if fracture.exchange == INFINITE:
                continue
            for vertex, sides in zip(edge, mesh.joints[edge].corners):
                for corner in sides:
                    yield (self.of_crack[vertex], self.of_corner[corner],
                           fracture.exchange * mesh.length(edge) / 2)

    def crack_conductance(self, edge) -> float:
        fracture = self.broken[edge]
        transmissivity = fracture.transmissivity or fracture.aperture**3 / 12
        return transmissivity / (self.viscosity * self.mesh.length(edge))

    # Contents --------------------------------------------------------------------------------

    def _contents(self):
        """Storage (m2/Pa) and void volume (m2) of each unknown."""
        self.storage = np.zeros(self.unknowns)
        self.void = np.zeros(self.unknowns)
        third = np.repeat(self.mesh.area / 3, 3)
        np.add.at(self.storage, self.of_corner, third / self.rock.biot_modulus)
        np.add.at(self.void, self.of_corner, third * self.rock.porosity)
        for edge, fracture in self.broken.items():
            for v in edge:
                volume = fracture.aperture * self.mesh.length(edge) / 2
                self.storage[self.of_crack[v]] += volume / self.bulk_modulus
                self.void[self.of_crack[v]] += volume

    def state(self, excess: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Pressure and saturation of nodes with `excess` fluid over full at pressure 0 (m2)."""
        is_full = excess >= 0
        return (np.where(is_full, excess / self.storage, 0.0),
                np.where(is_full, 1.0, 1.0 + excess / self.void))

    def inflow(self, pressure: np.ndarray, saturation: np.ndarray) -> np.ndarray:
        """Net inflow of every unknown through its pairs, m2/s."""
        potential = pressure + self.density * self.gravity * self.elevation
        flow = self.conductance * (potential[self.first] - potential[self.second])
        upstream = np.where(flow > 0, self.first, self.second)
        s = saturation[upstream]
        flow = flow * s * s * (3 - 2 * s)
        total = np.zeros(self.unknowns)
        np.add.at(total, self.second, flow)
        np.add.at(total, self.first, -flow)
        return total

    # Conditions ------------------------------------------------------------------------------

    def boundary_unknowns(self, curve: str) -> set[int]:
        """Pore and crack unknowns on a part of the boundary."""
        found = set()
        for edge in self.mesh.edges([curve]):
            triangle = self.mesh.boundary[edge]
            for v in edge:
                found.add(int(self.of_corner[self.mesh.corner(triangle, v)]))
                found |= {self.of_crack[v]} if v in self.of_crack else set()
                found |= self._corners_at(v)
        return found

    def _corners_at(self, vertex: int) -> set[int]:
        """Unknowns of all corners at a vertex: with finite joints a fan of corners ends there."""
        return {int(u) for u in self.of_corner[self.mesh.triangles.ravel() == vertex]}

    def add_flux(self, curve: str, flux: float) -> None:
        for edge in self.mesh.edges([curve]):
            triangle = self.mesh.boundary[edge]
            for v in edge:
                unknown = int(self.of_corner[self.mesh.corner(triangle, v)])
                share = flux * self.mesh.length(edge) / 2
                self.rate[unknown] = self.rate.get(unknown, 0.0) + share

    def _rates(self) -> np.ndarray:
        rates = np.zeros(self.unknowns)
        for unknown, value in self.rate.items():
            rates[unknown] += value
        return rates

    # Solutions -------------------------------------------------------------------------------

    def _matrix(self) -> sparse.csr_matrix:
        i, j, c = self.first, self.second, self.conductance
        rows, columns = np.concatenate([i, j, i, j]), np.concatenate([i, j, j, i])
        entries = np.concatenate([c, c, -c, -c])
        return sparse.csr_matrix((entries, (rows, columns)), (self.unknowns, self.unknowns))

    def _solve(self, matrix, right: np.ndarray) -> np.ndarray:
        """Pressures for a saturated linear system with the fixed pressures put in."""
        gravity = self.density * self.gravity * self.elevation
        right = right - self._matrix() @ gravity
        pressure = np.zeros(self.unknowns)
        pressure[list(self.fixed)] = list(self.fixed.values())
        free = np.array([u for u in range(self.unknowns) if u not in self.fixed])
        right = right - matrix @ pressure
        pressure[free] = sparse_linalg.spsolve(matrix[free][:, free].tocsc(), right[free])
        return pressure

    def steady(self) -> np.ndarray:
        """Pressures (Pa) of the steady saturated state."""
        return self._solve(self._matrix(), self._rates())

    def backward_euler(self, pressure: np.ndarray, step: float, steps: int) -> np.ndarray:
        """Pressures after `steps` implicit steps of a saturated state."""
        matrix = self._matrix() + sparse.diags(self.storage / step)
        for _ in range(steps):
            pressure = self._solve(matrix.tocsr(), self._rates() + self.storage / step * pressure)
        return pressure

    def forward_euler(self, excess: np.ndarray, step: float, steps: int):
        """Pressures and saturations after `steps` explicit steps that may be partly saturated."""
        fixed = np.array(list(self.fixed), dtype=int)
        value = np.array(list(self.fixed.values()))
        excess = excess.copy()
        excess[fixed] = self.storage[fixed] * value
        for _ in range(steps):
            excess = excess + step * (self.inflow(*self.state(excess)) + self._rates())
            excess[fixed] = self.storage[fixed] * value
        return self.state(excess)
