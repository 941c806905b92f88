#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How long frames of 1e6 triangles take into numpy: of flow, and of mechanics with three points a
triangle.

Usage: read_frames.py PROGRAM [ROUNDS]. PROGRAM runs both for a few steps, from which no two triangles
have the same values. The package is the one on PYTHONPATH; its extension is not needed. Files come
from memory, since waiting for a disk is none of the reader. Of each round the wall time and the
processor time of all threads are told, as the best and the median. Judged are the points and cells of
the frame of mechanics together, without any of its fields: exit code 1 when they take more than 0.5 s
at best. Single fields and all arrays of a frame are told beside.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import percolith
from percolith.compressed_blocks import decompressor

COLUMNS, ROWS = 1000, 500  # squares of two triangles each
MEMORY = Path("/dev/shm")
LIMIT = 0.5  # s

HEAD = """format = 1
title = "A million triangles"
[mesh]
file = "grid.msh"
[boundary.bottom]
groups = ["bottom"]
{bottom}
[boundary.top]
groups = ["top"]
{top}
[material.rock]
regions = ["rock"]
"""

MECHANICS = HEAD.format(bottom="velocity_x = 0\nvelocity_y = 0", top="velocity_y = -0.1") + """
density = 2500
young_modulus = "10 GPa"
poisson_ratio = 0.25
tensile_strength = "5 MPa"
cohesion = "30 MPa"
friction_angle = "35 deg"
mode_1_energy = 14
mode_2_energy = 600
[model]
physics = "mechanics"
gravity = 9.81
[time]
end = "1 us"
"""

FLOW = HEAD.format(bottom="pressure = 0", top='pressure = "1 MPa"') + """
permeability = "1 mdarcy"
porosity = 0.1
[model]
gravity = 9.81
[initial]
pressure = 0
[time]
scheme = "explicit"
end = "1 ms"
"""


def write_mesh(path: Path) -> None:
    """A grid of 2 m by 1 m whose inner points are moved at random by a quarter of a square."""
    x, y = np.meshgrid(np.linspace(0, 2, COLUMNS + 1), np.linspace(0, 1, ROWS + 1))
    random = np.random.default_rng(1)
    for axis in (x, y):
        axis[1:-1, 1:-1] += random.uniform(-0.25, 0.25, (ROWS - 1, COLUMNS - 1)) / ROWS
    row, column = np.divmod(np.arange(COLUMNS * ROWS), COLUMNS)
    a = row * (COLUMNS + 1) + column + 1
    b, c, d = a + 1, a + COLUMNS + 2, a + COLUMNS + 1
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    bottom = np.arange(1, COLUMNS + 1)
    lines = [np.column_stack([np.full(COLUMNS, group), np.full(COLUMNS, group), start, start + 1])
             for group, start in ((2, bottom), (3, bottom + ROWS * (COLUMNS + 1)))]
    with open(path, "w", encoding="ascii") as file:
        file.write('$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 1 "rock"\n'
                   f'1 2 "bottom"\n1 3 "top"\n$EndPhysicalNames\n$Nodes\n{x.size}\n')
        np.savetxt(file, np.column_stack([np.arange(1, x.size + 1), x.ravel(), y.ravel()]),
                   fmt="%d %.17g %.17g 0")
        file.write(f"$EndNodes\n$Elements\n{len(triangles) + 2 * COLUMNS}\n")
        for first, group in ((1, lines[0]), (1 + COLUMNS, lines[1])):
            np.savetxt(file, np.column_stack([np.arange(first, first + COLUMNS), group]),
                       fmt="%d 1 2 %d %d %d %d")
        number = np.arange(len(triangles)) + 2 * COLUMNS + 1
        np.savetxt(file, np.column_stack([number, triangles]), fmt="%d 2 2 1 1 %d %d %d")
        file.write("$EndElements\n")


def frame_of(program: str, folder: Path, name: str, text: str) -> Path:
    """The file of the last frame of a run."""
    (folder / f"{name}.toml").write_text(text)
    results = folder / f"{name}.results"
    subprocess.run([program, "run", folder / f"{name}.toml", "--output", results, "--quiet"],
                   check=True, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    return sorted((results / "fields").glob("matrix_*.vtu"))[-1]


def mesh_alone(path: Path) -> None:
    grid = percolith.read_vtu(path)
    assert len(grid.cells) == 2 * COLUMNS * ROWS and len(grid.points)


def one_field(path: Path) -> None:
    """Pressure at the points, or a stress of the triangles."""
    grid = percolith.read_vtu(path)
    (grid.point_data["pressure_Pa"] if "pressure_Pa" in grid.point_data
     else grid.cell_data["principal_stress_1_Pa"]).max()


def everything(path: Path) -> None:
    grid = percolith.read_vtu(path)
    sizes = [len(values) for data in (grid.point_data, grid.cell_data) for values in data.values()]
    assert min(sizes) >= len(grid.cells) // 2 and len(grid.points)


def seconds(work: Callable[[Path], None], path: Path, rounds: int) -> list[tuple[float, float]]:
    """Wall time and processor time of each round."""
    taken = []
    for _ in range(rounds):
        wall, cpu = time.perf_counter(), time.process_time()
        work(path)
        taken.append((time.perf_counter() - wall, time.process_time() - cpu))
    return taken


def verdict(mesh: float, arrays: float) -> str:
    """What was judged, and what was not."""
    kept = "within" if mesh <= LIMIT else "ABOVE"
    return (f"{kept} the limit: points and cells of mechanics, {mesh:.3f} s of at most {LIMIT} s at "
            f"best; not judged: all arrays of that frame, {arrays:.3f} s")


def main() -> int:
    program, rounds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 15
    if not MEMORY.is_dir():
        print(f"{MEMORY}: no such folder; files would come from a disk", file=sys.stderr)
        return 1
    print(f"blocks by {decompressor()[0].__module__ or 'zlib'}, "
          f"{len(os.sched_getaffinity(0))} processors, load {os.getloadavg()[0]:.1f}")
    best = {}
    with tempfile.TemporaryDirectory(dir=MEMORY) as scratch:
        folder = Path(scratch)
        write_mesh(folder / "grid.msh")
        for name, text in (("flow", FLOW), ("mechanics", MECHANICS)):
            path = frame_of(program, folder, name, text)
            print(f"{name}, {path.stat().st_size / 1e6:.0f} MB:")
            for work in (mesh_alone, one_field, everything):
                wall, cpu = zip(*seconds(work, path, rounds))
                best[name, work] = min(wall)
                print(f"  {work.__name__.replace('_', ' '):12} wall {min(wall):.3f} s, median "
                      f"{statistics.median(wall):.3f}; processors {min(cpu):.3f} s, median "
                      f"{statistics.median(cpu):.3f}")
    print(verdict(best["mechanics", mesh_alone], best["mechanics", everything]))
    return 0 if best["mechanics", mesh_alone] <= LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
