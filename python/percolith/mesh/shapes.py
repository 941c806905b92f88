# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of common shapes; what `meshing` of all takes is told by `with_options`."""

from __future__ import annotations

import math
import os
from typing import Unpack

import numpy as np

from percolith.errors import MeshError
from percolith.mesh.gmsh_mesh import MadeMesh
from percolith.mesh.meshing import Meshing, SideMeshing, outline_mesh, with_options
from percolith.mesh.outline import Outline, as_place, box, circle


@with_options
def rectangle(path: str | os.PathLike, width: float, height: float, *, size: float,
              centre: tuple[float, float] | None = None, region: str = "rock",
              **meshing: Unpack[SideMeshing]) -> MadeMesh:
    """A rectangle with the sides left, right, bottom and top; its lower left corner is the origin
    where no centre is given."""
    return outline_mesh(path, box(width, height, centre, region), size=size, **meshing)


@with_options
def disc(path: str | os.PathLike, radius: float, *, size: float,
         centre: tuple[float, float] = (0.0, 0.0), flat_deg: float = 0.0, region: str = "rock",
         **meshing: Unpack[SideMeshing]) -> MadeMesh:
    """A disc with the side edge. Where flat_deg is positive, arcs of that angle at its top and its
    bottom are sides of their own, top and bottom, to be loaded."""
    outline = circle(radius, size, "edge", centre, region)
    if not 0.0 <= flat_deg < 90.0:
        raise MeshError(f"flat_deg = {flat_deg}: allowed: 0 to 90 degrees")
    if flat_deg > 0.0:
        outline = _with_flats(outline, np.asarray(centre), math.radians(flat_deg))
    return outline_mesh(path, outline, size=size, **meshing)


def _with_flats(outline: Outline, centre: np.ndarray, arc: float) -> Outline:
    """Sides whose ends lie in the arcs at the top and bottom get their names; the arcs end at
    corners."""
    radius = float(np.hypot(*(outline.corners[0] - centre)))
    angles = np.arctan2(*(outline.corners - centre).T[::-1])
    ends = [sign * 0.5 * math.pi + half for sign in (1, -1) for half in (-0.5 * arc, 0.5 * arc)]
    spacing = 2.0 * math.pi / len(angles)
    far = [min(abs(math.remainder(a - e, 2.0 * math.pi)) for e in ends) > 0.5 * spacing
           for a in angles]
    angles = np.sort(np.concatenate([angles[far], [math.remainder(e, 2 * math.pi) for e in ends]]))
    middle = angles + 0.5 * ((np.roll(angles, -1) - angles) % (2.0 * math.pi))
    sides = ["edge"] * len(angles)
    for name, sign in (("top", 1), ("bottom", -1)):
        for i, m in enumerate(middle):
            if abs(math.remainder(m - sign * 0.5 * math.pi, 2.0 * math.pi)) < 0.5 * arc:
                sides[i] = name
    corners = radius * np.stack([np.cos(angles), np.sin(angles)], axis=1) + centre
    return Outline(corners, sides, region=outline.region)


@with_options
def borehole(path: str | os.PathLike, width: float, height: float, radius: float, *,
             size: float, size_at_hole: float | None = None,
             centre: tuple[float, float] = (0.0, 0.0), region: str = "rock",
             **meshing: Unpack[Meshing]) -> MadeMesh:
    """A rectangle round the origin with a hole in it: sides left, right, bottom, top and hole.
    centre: (x, y) of the hole, m, the origin where it is not given; the hole lies within the
    rectangle and does not touch its sides. size_at_hole: of the elements there, m; an eighth of the
    radius where it is not given."""
    middle = as_place(centre, "centre")
    fine = min(size, radius / 8.0) if size_at_hole is None else size_at_hole
    outline = box(width, height, (0.0, 0.0), region)
    outline.holes = [circle(radius, fine, "hole", middle)]
    _require_inside(outline, middle)
    return outline_mesh(path, outline, size=size, fine_sides=["hole"], size_at_fine_sides=fine,
                        **meshing)


@with_options
def tunnel(path: str | os.PathLike, width: float, height: float, tunnel_width: float,
           wall_height: float, *, size: float, size_at_wall: float | None = None,
           centre: tuple[float, float] = (0.0, 0.0), excavated: bool = False, region: str = "rock",
           **meshing: Unpack[Meshing]) -> MadeMesh:
    """A rectangle round the origin with a tunnel in it: walls of wall_height and a round roof
    above; sides left, right, bottom, top and wall. centre: (x, y) of the middle of the tunnel, m,
    half its width from the walls and half its height above the floor, the origin where it is not
    given; the tunnel lies within the rectangle and does not touch its sides. excavated: the tunnel
    is a region of its own, tunnel, that the case takes out later; its wall lies within the rock until then, and is no side
    that a boundary could refer to. size_at_wall: of the elements there, m; a twelfth of the
    width of the tunnel where it is not given. Fractures within the tunnel are left out."""
    fine = min(size, tunnel_width / 12.0) if size_at_wall is None else size_at_wall
    middle = as_place(centre, "centre")
    radius = 0.5 * tunnel_width
    steps = max(8, math.ceil(math.pi * radius / fine))
    angle = np.linspace(0.0, math.pi, steps + 1)
    floor = -0.5 * (wall_height + radius)
    roof = np.stack([radius * np.cos(angle), floor + wall_height + radius * np.sin(angle)], axis=1)
    corners = np.vstack([[-radius, floor], [radius, floor], roof]) + middle
    outline = box(width, height, (0.0, 0.0), region)
    outline.holes = [Outline(corners, ["wall"] * len(corners))]
    outline.filling = "tunnel" if excavated else ""
    _require_inside(outline, middle)
    return outline_mesh(path, outline, size=size, fine_sides=["wall"], size_at_fine_sides=fine,
                        **meshing)


def _require_inside(outline: Outline, centre: tuple[float, float]) -> None:
    low, high = outline.corners.min(axis=0), outline.corners.max(axis=0)
    for hole in outline.holes:
        if (hole.corners <= low).any() or (hole.corners >= high).any():
            (left, bottom), (right, top) = low, high
            raise MeshError(
                f"centre = ({centre[0]:g}, {centre[1]:g}): the hole does not lie within the "
                f"rectangle, from ({left:g}, {bottom:g}) to ({right:g}, {top:g}), or touches it")


@with_options
def slope(path: str | os.PathLike, height: float, angle_deg: float, *, foot: float, crest: float,
          depth: float, size: float, region: str = "rock",
          **meshing: Unpack[SideMeshing]) -> MadeMesh:
    """A slope whose toe is the origin: it rises by height at angle_deg to the right, before it lies
    ground of the length foot, behind its edge ground of the length crest, and all reaches down to
    depth below the toe. Sides left, right, bottom, ground, face and crest."""
    if not 0.0 < angle_deg <= 90.0:
        raise MeshError(f"angle_deg = {angle_deg}: allowed: more than 0, up to 90 degrees")
    back = height / math.tan(math.radians(angle_deg)) if angle_deg < 90.0 else 0.0
    corners = [[-foot, -depth], [back + crest, -depth], [back + crest, height], [back, height],
               [0.0, 0.0], [-foot, 0.0]]
    outline = Outline(np.array(corners), ["bottom", "right", "crest", "face", "ground", "left"],
                      region=region)
    return outline_mesh(path, outline, size=size, **meshing)
