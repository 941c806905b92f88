# SPDX-License-Identifier: BSD-3-Clause
"""Tells rigid bodies, such as platens, from the rock that deforms: they have neither stress nor
damage, and their motion is prescribed."""

from __future__ import annotations

import numpy as np

from percolith.deformation import FROM_THE_START, crack_faces
from percolith.run_directory import Frame, RunDirectory
from percolith.vtu import Grid


def rigid_triangles(run: RunDirectory, matrix: Grid) -> np.ndarray:
    """True (n,) for each triangle of a body with `rigid = true`. None is, while a run goes on: the
    numbers of the regions stand in its summary."""
    names = {region for body in run.resolved.get("body", {}).values() if body.get("rigid")
             for region in body["regions"]}
    if not names or not run.has_summary:
        return np.zeros(len(matrix.cells), bool)
    numbers = [i for i, name in enumerate(run.summary["regions"]) if name in names]
    return np.isin(matrix.cell_data["region"], numbers)


def part_of(matrix: Grid, chosen: np.ndarray) -> Grid:
    """The chosen triangles and their points alone."""
    kept, cells = np.unique(matrix.cells[chosen], return_inverse=True)
    return Grid(matrix.points[kept], cells.reshape(-1, 3),
                {name: values[kept] for name, values in matrix.point_data.items()},
                {name: values[chosen] for name, values in matrix.cell_data.items()}, matrix.time)


def split_off_rigid_bodies(frame: Frame, rigid: np.ndarray) -> tuple[Frame, Grid]:
    """The frame without its rigid triangles, and these. Where a rigid body lay loose on the rock
    from the start, nothing broke: such joints are left out of the cracks."""
    bodies, rock = part_of(frame.matrix, rigid), part_of(frame.matrix, ~rigid)
    cracks = frame.cracks
    if cracks is not None and rigid.any():
        beside = np.zeros(len(cracks.cells), bool)
        beside[crack_faces(Frame(frame.time, bodies, cracks)).segment] = True
        kept = ~(beside & (cracks.cell_data["mode"] == FROM_THE_START))
        cracks = Grid(cracks.points, cracks.cells[kept], cracks.point_data,
                      {name: values[kept] for name, values in cracks.cell_data.items()},
                      cracks.time)
    return Frame(frame.time, rock, cracks), bodies
