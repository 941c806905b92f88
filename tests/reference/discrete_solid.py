# SPDX-License-Identifier: BSD-3-Clause
"""The discrete laws of the solid, written down a second time, in plain Python: triangle after
triangle, joint after joint, with the exponential of the library.

Laws: Saint Venant-Kirchhoff triangles (8), (9); joints with softening, section 2.4, (10); motion
(1)-(3) with nodal and element viscosity."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, hypot, inf, sqrt, tan

import numpy as np

from triangulation import Partition, Triangulation

GAUSS = 0.5 / sqrt(3)  # distance of both points of a joint from its middle, over its length


@dataclass
class Rock:
    density: float
    young_modulus: float
    poisson_ratio: float
    viscosity: float = 0.0  # of 2 mu D, Pa s


@dataclass
class Bond:
    tensile: float
    cohesion: float
    friction_angle: float
    mode_1: float
    mode_2: float


def softening(damage: float) -> float:
    """Munjiza's curve."""
    a, b, c = 0.63, 1.8, 6.0
    rate = a + c * b / ((a + b) * (1 - a - b))
    return ((1 - (a + b - 1) / (a + b) * exp(damage * rate))
            * (a * (1 - damage) + b * (1 - damage) ** c))


def softening_integral(points: int = 4000) -> float:
    """By Simpson's rule."""
    x = np.linspace(0, 1, 2 * points + 1)
    z = np.array([softening(d) for d in x])
    return (z[0] + z[-1] + 4 * z[1::2].sum() + 2 * z[2:-1:2].sum()) / (6 * points)


class JointPoint:
    """An integration point of a joint that remembers its worst."""

    def __init__(self, stiffness: float, bond: Bond, integral: float):
        self.stiffness, self.bond = stiffness, bond
        self.opening_range = bond.mode_1 / (integral * bond.tensile)
        self.slip_range = bond.mode_2 / (integral * bond.cohesion)
        self.damage = self.most_opened = self.most_slid = 0.0
        self.slope = self.friction = self.slip = 0.0

    def traction(self, opening: float, slip: float) -> tuple[float, float]:
        bond = self.bond
        rub = max(0.0, -self.stiffness * opening) * tan(bond.friction_angle)
        opening_at_peak = bond.tensile / self.stiffness
        slip_at_peak = (bond.cohesion + rub) / self.stiffness
        self.damage = min(1.0, max(self.damage, hypot(
            max(0.0, opening - opening_at_peak) / self.opening_range,
            max(0.0, abs(slip) - slip_at_peak) / self.slip_range)))
        if self.damage == 0:
            return self.stiffness * opening, self.stiffness * slip
        if self.slope == 0:  # just past its peak, which friction bore its part of
            self.slope = inf
            self.slip = min(max(slip, -slip_at_peak), slip_at_peak)
            self.friction = self.stiffness * self.slip * rub / (bond.cohesion + rub)
        self.most_opened = max(self.most_opened, opening)
        self.most_slid = max(self.most_slid, abs(slip))
        left = softening(self.damage)
        normal = (left * bond.tensile * opening / max(self.most_opened, opening_at_peak)
                  if opening > 0 else self.stiffness * opening)
        self.slope = min(self.slope, left * bond.cohesion / max(self.most_slid, slip_at_peak))
        trial = self.friction + (self.stiffness - self.slope) * (slip - self.slip)
        self.friction = min(max(trial, -rub), rub)
        self.slip = slip
        return normal, self.slope * slip + self.friction


class Solid:
    """A rock at rest; `bond` None: its triangles share nodes."""

    def __init__(self, mesh: Triangulation, rock: Rock, bond: Bond | None, gravity: float = 0.0,
                 nodal_viscosity: float = 0.0):
        self.mesh, self.rock, self.bond = mesh, rock, bond
        self.gravity, self.nodal_viscosity = gravity, nodal_viscosity
        corners = 3 * len(mesh.triangles)
        self.u = np.zeros((corners, 2))
        self.v = np.zeros((corners, 2))
        self.load = np.zeros((corners, 2))
        self.held = np.zeros(corners, dtype=bool)
        self.mass = np.repeat(rock.density * mesh.area / 3, 3)
        self.step_before = 0.0
        self._share_nodes()
        self._make_joints()

    def _share_nodes(self):
        sets = Partition(len(self.u))
        for joint in self.mesh.joints.values() if self.bond is None else []:
            for first, second in joint.corners:
                sets.merge(first, second)
        roots = [sets.find(c) for c in range(len(self.u))]
        number = {root: n for n, root in enumerate(sorted(set(roots)))}
        self.node = np.array([number[root] for root in roots])
        self.node_mass = self._over_nodes(self.mass)

    def _over_nodes(self, values: np.ndarray) -> np.ndarray:
        total = np.zeros((self.node.max() + 1, *values.shape[1:]))
        np.add.at(total, self.node, values)
        return total

    def _make_joints(self):
        self.points = {}
        if self.bond is None:
            return
        integral = softening_integral()
        for edge, joint in self.mesh.joints.items():
            size = np.mean([np.sqrt(4 * self.mesh.area[t] / np.sqrt(3)) for t in joint.triangles])
            stiffness = 20 * self.rock.young_modulus / size
            self.points[edge] = [JointPoint(stiffness, self.bond, integral) for _ in range(2)]

    def hold(self, curve: str) -> None:
        """Fixes a side, and with it all corners of the rock at its vertices."""
        vertices = {v for edge in self.mesh.edges([curve]) for v in edge}
        self.held |= np.isin(self.mesh.triangles.ravel(), list(vertices))

    def pull(self, curve: str, traction) -> None:
        for edge in self.mesh.edges([curve]):
            for v in edge:
                corner = self.mesh.corner(self.mesh.boundary[edge], v)
                self.load[corner] += 0.5 * self.mesh.length(edge) * np.array(traction)

    def stress(self, strain: np.ndarray) -> np.ndarray:
        """Plane strain."""
        shear = self.rock.young_modulus / (2 * (1 + self.rock.poisson_ratio))
        lame = 2 * shear * self.rock.poisson_ratio / (1 - 2 * self.rock.poisson_ratio)
        return lame * np.trace(strain) * np.eye(2) + 2 * shear * strain

    def triangle_forces(self) -> np.ndarray:
        force = np.zeros_like(self.u)
        for t, vertices in enumerate(self.mesh.triangles):
            own = slice(3 * t, 3 * t + 3)
            gradients = np.linalg.inv(np.column_stack([np.ones(3), self.mesh.points[vertices]]))[1:]
            deformation = np.eye(2) + self.u[own].T @ gradients.T
            rate = self.v[own].T @ gradients.T
            second = self.stress(0.5 * (deformation.T @ deformation - np.eye(2)))
            second += self.rock.viscosity * (deformation.T @ rate + rate.T @ deformation)
            force[own] = -self.mesh.area[t] * (deformation @ second @ gradients).T
        return force

    def joint_forces(self) -> np.ndarray:
        force = np.zeros_like(self.u)
        place = self.mesh.points[self.mesh.triangles.ravel()] + self.u
        for edge, points in self.points.items():
            joint = self.mesh.joints[edge]
            # corners[end][side]; walked so that side 0 lies to the left.
            (a, b), (c, d) = joint.corners
            first = list(self.mesh.triangles[joint.triangles[0]])
            if first.index(edge[1]) != (first.index(edge[0]) + 1) % 3:
                a, b, c, d = c, d, a, b
            along = 0.5 * (place[c] + place[d] - place[a] - place[b])
            along = along / np.linalg.norm(along)
            across = np.array([along[1], -along[0]])
            apart = self.u[b] - self.u[a], self.u[d] - self.u[c]
            for share, point in zip((0.5 - GAUSS, 0.5 + GAUSS), points):
                here = (1 - share) * apart[0] + share * apart[1]
                normal, shear = point.traction(here @ across, here @ along)
                pull = 0.5 * self.mesh.length(edge) * (normal * across + shear * along)
                for corner, weight in ((a, 1 - share), (b, share - 1), (c, share), (d, -share)):
                    force[corner] += weight * pull
        return force

    def advance(self, step: float) -> None:
        force = self.triangle_forces() + self.joint_forces() + self.load
        force[:, 1] -= self.mass * self.gravity
        kick = 0.5 * (self.step_before + step) / self.node_mass[:, None]
        velocity = np.zeros((len(self.node_mass), 2))
        velocity[self.node] = self.v
        velocity = velocity + kick * self._over_nodes(force)
        velocity /= 1 + self.nodal_viscosity * kick
        self.v = velocity[self.node]
        self.v[self.held] = 0.0
        self.u += step * self.v
        self.step_before = step

    def damage(self) -> np.ndarray:
        """Per triangle, the largest of the joints round it."""
        damage = np.zeros(len(self.mesh.triangles))
        for edge, points in self.points.items():
            for t in self.mesh.joints[edge].triangles:
                damage[t] = max(damage[t], *(p.damage for p in points))
        return damage
