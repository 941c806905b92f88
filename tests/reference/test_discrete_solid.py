# SPDX-License-Identifier: BSD-3-Clause
"""The program against a second implementation of the motion of a rock, with triangles that share
nodes and with joints that soften."""

from math import radians
from pathlib import Path

import numpy as np
import pytest
from discrete_solid import Bond, JointPoint, Rock, Solid, softening_integral
from program import run_case
from triangulation import Triangulation, cracked_square, write_msh

BOND = Bond(2e6, 5e6, radians(30), 60.0, 120.0)
GRAVITY, NODAL, PULL = 9.81, 2e4, (1.3e6, -5e5)
STEP, STEPS = 2e-6, 300

CASE = """
format = 1
title = "A square pulled at one side"
[mesh]
file = "square.msh"
[model]
physics = "mechanics"
gravity = 9.81
[material.rock]
regions = ["rock"]
density = 2500
young_modulus = 10e9
poisson_ratio = 0.25
{joints}
[boundary.left]
groups = ["left"]
fixed = true
[boundary.right]
groups = ["right"]
traction_x = 1.3e6
traction_y = -5e5
[damping]
nodal_viscosity = 2e4
element_viscosity = {viscosity}
[time]
step = 2e-6
end = {end}
"""
BREAKABLE = """tensile_strength = 2e6
cohesion = 5e6
friction_angle = "30 deg"
mode_1_energy = 60
mode_2_energy = 120"""


def cells_of(mesh: Triangulation, grid):
    """Pairs of a cell of the frame and the triangle of the mesh it is."""
    key = {tuple(np.round(p.mean(axis=0), 9)): t
           for t, p in enumerate(mesh.points[mesh.triangles])}
    for i, cell in enumerate(grid.cells):
        yield i, cell, key[tuple(np.round(grid.points[cell].mean(axis=0), 9))]


def corner_vectors(mesh: Triangulation, grid, name: str) -> np.ndarray:
    values = np.full((3 * len(mesh.triangles), 2), np.nan)
    for _, cell, t in cells_of(mesh, grid):
        for point in cell:
            away = np.linalg.norm(mesh.points[mesh.triangles[t]] - grid.points[point], axis=1)
            values[3 * t + away.argmin()] = np.asarray(grid.point_data[name][point])[:2]
    return values


@pytest.mark.parametrize("viscosity", [0.0, 2e4])
@pytest.mark.parametrize("bond", [None, BOND])
def test_motion(tmp_path: Path, bond, viscosity):
    mesh = cracked_square(4, 0.2)
    write_msh(mesh, tmp_path / "square.msh")
    case = tmp_path / "case.toml"
    case.write_text(CASE.format(joints=BREAKABLE if bond else 'joints = "elastic"',
                                viscosity=viscosity, end=STEP * STEPS))
    run = run_case(case, tmp_path / "results").results
    solid = Solid(mesh, Rock(2500, 10e9, 0.25, viscosity), bond, GRAVITY, NODAL)
    solid.hold("left")
    solid.pull("right", PULL)
    for _ in range(STEPS):
        solid.advance(STEP)
    grid = run.frame().matrix
    scale = abs(solid.u).max()
    assert scale > 1e-5
    assert abs(corner_vectors(mesh, grid, "displacement_m") - solid.u).max() <= 1e-7 * scale
    damage = np.zeros(len(mesh.triangles))
    for i, _, t in cells_of(mesh, grid):
        damage[t] = grid.cell_data["damage"][i]
    assert abs(damage - solid.damage()).max() <= 1e-5
    if bond:
        assert 0.05 < damage.max() < 1, "joints must soften, and none must break"


def test_softening_spends_the_fracture_energy():
    """The second implementation itself: what is spent after the peak is G_I."""
    point = JointPoint(1e12, BOND, softening_integral())
    opening = np.linspace(2e-6, 2e-6 + point.opening_range, 20001)
    traction = np.array([point.traction(o, 0.0)[0] for o in opening])
    spent = float(((traction[1:] + traction[:-1]) / 2 * np.diff(opening)).sum())
    assert spent == pytest.approx(60.0, rel=1e-4)
    assert point.damage == pytest.approx(1.0)
