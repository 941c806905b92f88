# SPDX-License-Identifier: BSD-3-Clause
"""Meshes for cases, made through the `gmsh` package: simple shapes with fractures and graded sizes,
and random networks of fractures. Lengths are in m.

    from percolith import mesh

    network = mesh.fracture_network(mesh.box(2.0, 4.0), [mesh.FractureSet(density=2.0)], seed=1)
    made = mesh.rectangle("wall.msh", 2.0, 4.0, size=0.1, fractures=network)
    case["mesh.file"] = made.file
    print(made.report())
"""

from percolith.mesh.arrangement import Change, arrange
from percolith.mesh.fractures import Fracture, FractureSet, fracture_network
from percolith.mesh.gmsh_mesh import MadeMesh
from percolith.mesh.meshing import outline_mesh
from percolith.mesh.outline import Outline, box, circle
from percolith.mesh.shapes import borehole, disc, rectangle, slope, tunnel

__all__ = [
    "Change", "Fracture", "FractureSet", "MadeMesh", "Outline", "arrange", "borehole", "box",
    "circle", "disc", "fracture_network", "outline_mesh", "rectangle", "slope", "tunnel",
]
