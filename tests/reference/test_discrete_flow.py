# SPDX-License-Identifier: BSD-3-Clause
"""The program against a second implementation of the same laws, on a small mesh with two fractures
that cross; one ends inside, one at the boundary."""

from pathlib import Path

import numpy as np
import pytest
from discrete_flow import Flow, Fracture, Rock
from program import run_case
from triangulation import Triangulation, cracked_square, write_msh

TENSOR = np.array([[3e-13, 0.8e-13], [0.8e-13, 1e-13]])
VISCOSITY, DENSITY, POROSITY = 1.3e-3, 980.0, 0.15
LEVEL = Fracture("level", 3e-4, 5e-9)
UPRIGHT = {"finite": Fracture("upright", 2e-4, 8e-10, 4e-12),
           "infinite": Fracture("upright", 2e-4, float("inf"))}
AGREEMENT = 1e-9

CASE = """
format = 1
title = "Two crossing fractures"
[mesh]
file = "square.msh"
[model]
gravity = {gravity}
{joints}
[fluid]
density = 980
viscosity = 1.3e-3
bulk_modulus = {bulk_modulus}
{cavitation}
[material.rock]
regions = ["rock"]
permeability = {permeability}
porosity = 0.15
biot_modulus = {biot_modulus}
[fracture.level]
groups = ["level"]
initial_aperture = 3e-4
exchange = 5e-9
[fracture.upright]
groups = ["upright"]
initial_aperture = 2e-4
{upright}
{conditions}
[time]
{time}
"""
SATURATED = 'cavitation_pressure = "-inf"'
LEFT = '[boundary.left]\ngroups = ["left"]\npressure = 2e5\n'
FLUX = '[boundary.right]\ngroups = ["right"]\nflux = 1e-6\n'


def build(tmp_path: Path, *, upright: str, joints: float | None, gravity: float, conditions: str,
          time: str, shift: float = 0.2, tensor: np.ndarray = TENSOR, cavitation: str = SATURATED,
          moduli: tuple[float, float] = (2e9, 9e9)):
    """The second implementation and the frame of the program's last state."""
    mesh = cracked_square(6, shift)
    write_msh(mesh, tmp_path / "square.msh")
    fracture = UPRIGHT[upright]
    options = f"exchange = {fracture.exchange}\n"
    if fracture.transmissivity:
        options += f"transmissivity = {fracture.transmissivity}\n"
    case = tmp_path / "case.toml"
    case.write_text(CASE.format(
        gravity=gravity, upright=options, conditions=conditions, time=time, cavitation=cavitation,
        bulk_modulus=moduli[0], biot_modulus=moduli[1],
        permeability=[float(tensor[i]) for i in ((0, 0), (1, 1), (0, 1))],
        joints=f'pore_joints = "finite"\njoint_factor = {joints}' if joints else ""))
    flow = Flow(mesh, Rock(tensor, POROSITY, moduli[1]), [LEVEL, fracture], VISCOSITY, DENSITY,
                moduli[0], gravity, joints)
    return flow, run_case(case, tmp_path / "results").results


def corner_values(mesh: Triangulation, frame, name: str) -> np.ndarray:
    """Values at the corners of the mesh, (triangles, 3), found by the places of the triangles."""
    grid = frame.matrix
    key = {tuple(np.round(p.mean(axis=0), 9)): t
           for t, p in enumerate(mesh.points[mesh.triangles])}
    values = np.full((len(mesh.triangles), 3), np.nan)
    for cell in grid.cells:
        t = key[tuple(np.round(grid.points[cell].mean(axis=0), 9))]
        for point in cell:
            distance = np.linalg.norm(mesh.points[mesh.triangles[t]] - grid.points[point], axis=1)
            values[t, distance.argmin()] = grid.point_data[name][point]
    return values


def crack_values(mesh: Triangulation, frame, name: str) -> dict[int, float]:
    """Values at the open crack nodes by vertex."""
    grid = frame.cracks
    found = {}
    for place, value in zip(grid.points, grid.point_data[name]):
        found[int(np.linalg.norm(mesh.points - place, axis=1).argmin())] = value
    return found


def assert_equal(flow: Flow, run, pressure, saturation=None) -> None:
    """Pressures (and saturations) at all corners and crack nodes agree."""
    frame = run.frame()
    scale = abs(pressure).max()
    corners = corner_values(flow.mesh, frame, "pressure_Pa").ravel()
    assert abs(corners - pressure[flow.of_corner]).max() <= AGREEMENT * scale
    cracks = crack_values(flow.mesh, frame, "pressure_Pa")
    assert sorted(cracks) == sorted(flow.of_crack)
    for vertex, value in cracks.items():
        assert abs(value - pressure[flow.of_crack[vertex]]) <= AGREEMENT * scale
    if saturation is not None:
        assert saturation.min() < 0.9, "the case must be partly saturated"
        corners = corner_values(flow.mesh, frame, "saturation").ravel()
        assert abs(corners - saturation[flow.of_corner]).max() <= AGREEMENT
        for vertex, value in crack_values(flow.mesh, frame, "saturation").items():
            assert abs(value - saturation[flow.of_crack[vertex]]) <= AGREEMENT


def fix(flow: Flow, curve: str, pressure: float) -> None:
    flow.fixed |= dict.fromkeys(flow.boundary_unknowns(curve), pressure)


@pytest.mark.parametrize("upright", ["finite", "infinite"])
@pytest.mark.parametrize("joints", [None, 40.0])
def test_steady(tmp_path, upright, joints):
    flow, run = build(tmp_path, upright=upright, joints=joints, gravity=9.81,
                      conditions=LEFT + FLUX, time='scheme = "steady"')
    fix(flow, "left", 2e5)
    flow.add_flux("right", 1e-6)
    pressure = flow.steady()
    assert_equal(flow, run, pressure)
    assert_fluxes_equal(flow, run, pressure)


def test_injection_where_the_fractures_cross(tmp_path):
    """A rate into the crack node at the crossing and one into the rock at a corner."""
    sources = ('[source.crossing]\npoint = [0.5, 0.5]\ninto = "crack"\nrate = 3e-6\n'
               '[source.corner]\npoint = [1.0, 1.0]\nrate = 2e-7\n')
    flow, run = build(tmp_path, upright="finite", joints=None, gravity=0.0,
                      conditions=LEFT + sources, time='scheme = "steady"')
    fix(flow, "left", 2e5)
    corner, crossing = (int(np.linalg.norm(flow.mesh.points - place, axis=1).argmin())
                        for place in ([1.0, 1.0], [0.5, 0.5]))
    flow.rate = {flow.of_crack[crossing]: 3e-6,
                 int(flow.of_corner[list(flow.mesh.triangles.ravel()).index(corner)]): 2e-7}
    assert_equal(flow, run, flow.steady())


def assert_fluxes_equal(flow: Flow, run, pressure) -> None:
    """Darcy flux of every triangle and flux along every segment of the cracks agree."""
    mesh, frame = flow.mesh, run.frame()
    key = {tuple(np.round(p.mean(axis=0), 9)): t
           for t, p in enumerate(mesh.points[mesh.triangles])}
    expected = np.zeros((len(mesh.triangles), 2))
    potential = pressure + flow.density * flow.gravity * flow.elevation
    for t, vertices in enumerate(mesh.triangles):
        x = np.column_stack([np.ones(3), mesh.points[vertices]])
        gradient = np.linalg.solve(x, potential[flow.of_corner[3 * t:3 * t + 3]])[1:]
        expected[t] = -flow.rock.permeability @ gradient / flow.viscosity
    grid = frame.matrix
    flux = grid.cell_data["darcy_flux_m_per_s"]
    for cell, q in zip(grid.cells, flux):
        t = key[tuple(np.round(grid.points[cell].mean(axis=0), 9))]
        assert abs(q - expected[t]).max() <= 1e-8 * abs(expected).max()
    cracks = frame.cracks
    for (start, stop), value in zip(cracks.cells, cracks.cell_data["flux_m2_per_s"]):
        i, j = (int(np.linalg.norm(mesh.points - cracks.points[v], axis=1).argmin())
                for v in (start, stop))
        drop = potential[flow.of_crack[i]] - potential[flow.of_crack[j]]
        conductance = flow.crack_conductance(tuple(sorted((i, j))))
        assert abs(value - conductance * drop) <= 1e-9 * conductance * abs(potential).max()


@pytest.mark.parametrize("upright", ["finite", "infinite"])
@pytest.mark.parametrize("joints", [None, 40.0])
def test_backward_euler(tmp_path, upright, joints):
    flow, run = build(tmp_path, upright=upright, joints=joints, gravity=9.81,
                      conditions=LEFT + FLUX + "[initial]\nhead = 5\n",
                      time='scheme = "implicit"\nstep = 0.5\nend = 4')
    fix(flow, "left", 2e5)
    flow.add_flux("right", 1e-6)
    start = DENSITY * 9.81 * (5 - flow.elevation)
    start[list(flow.fixed)] = 2e5
    assert_equal(flow, run, flow.backward_euler(start, 0.5, 8))


def test_explicit_with_empty_cracks(tmp_path):
    """Pores and cracks that are partly empty, by the explicit scheme, without gravity."""
    step, steps = 5e-4, 1000  # below the stability limit
    inlet = '[boundary.bottom]\ngroups = ["bottom"]\npressure = 1e5\n'
    initial = "[initial]\nsaturation = 0.7\ncrack_saturation = 0.2\n"
    isotropic = np.eye(2) * 1e-11
    flow, run = build(tmp_path, upright="finite", joints=None, gravity=0.0, shift=0.0,
                      tensor=isotropic, cavitation="cavitation_pressure = 0",
                      moduli=(1e6, 1e7), conditions=inlet + initial,
                      time=f'scheme = "explicit"\nstep = {step}\nend = {step * steps}')
    fix(flow, "bottom", 1e5)
    excess = np.zeros(flow.unknowns)
    excess[flow.of_corner] = -0.3
    excess[list(flow.of_crack.values())] = -0.8
    pressure, saturation = flow.forward_euler(excess * flow.void, step, steps)
    assert_equal(flow, run, pressure, saturation)
