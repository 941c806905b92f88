# SPDX-License-Identifier: BSD-3-Clause
"""Meshes an arrangement of lines with the `gmsh` package."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from percolith.errors import FileError, MeshError
from percolith.mesh.arrangement import BOUNDARY, Arrangement, Change
from percolith.mesh.fractures import Fracture
from percolith.mesh.outline import Outline
from percolith.short_text import counted, listed

_DELAUNAY, _FRONTAL = 5, 6  # algorithms of Gmsh; the second likes lattices of equilateral triangles


@dataclass(frozen=True)
class Sizes:
    """Sizes of elements, m: far from fractures and fine sides; at fractures; at fine sides; by how
    much they grow with the distance, 1; and whether they lie in no order."""

    far: float
    fractures: float
    sides: float
    growth: float
    fine_sides: tuple[str, ...]
    irregular: bool = True


@dataclass(frozen=True)
class MadeMesh:
    """A mesh that was made: its absolute `file`; the names of its `regions`, of its `sides`, which
    boundaries of a case can refer to, and of the groups of its `fractures`; its numbers of `points`
    and `triangles`; the `changes` that were made to fractures. Of the fractures that were asked
    for: their number, `asked_count`, and length, `asked_length`, m; the `meshed_length` of lines
    that the mesh follows, m; the numbers, from 0, of those `left_out` as a whole, and the
    `lost_groups` of which none is left."""

    file: Path
    regions: tuple[str, ...]
    sides: tuple[str, ...]
    fractures: tuple[str, ...]
    points: int
    triangles: int
    changes: tuple[Change, ...]
    asked_count: int = 0
    asked_length: float = 0.0
    meshed_length: float = 0.0
    left_out: tuple[int, ...] = ()
    lost_groups: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return (f"MadeMesh({self.file}: {counted(self.triangles, 'triangle')}, "
                f"{counted(self.points, 'point')}; regions: {listed(self.regions)}; sides: "
                f"{listed(self.sides)}; fractures: {listed(self.fractures)}; "
                f"{counted(len(self.changes), 'change')})")

    def report(self) -> str:
        """What was asked for and what was made in the first line; then a line for each group of
        fractures that is lost, and for each change, those that are left out as a whole first."""
        made = f"{self.triangles} triangles, {self.points} points in {self.file}"
        if self.asked_count:
            made = (f"asked {self.asked_length:.4g} m, meshed {self.meshed_length:.4g} m, "
                    f"{len(self.left_out)} of {self.asked_count} fractures left out; {made}")
        lost = [f"group {name}: none of its fractures is left" for name in self.lost_groups]
        # Of what is gone as a whole its parts are no news.
        told = [change for change in self.changes
                if change.kind != "left out" or not set(change.fractures) <= set(self.left_out)]
        return "\n".join([made, *lost, *map(str, told)])


@contextmanager
def _model(gmsh: Any) -> Iterator[None]:
    """A model of Gmsh of its own; one that the caller has is left as it is."""
    was_ready = bool(gmsh.isInitialized())
    before = gmsh.model.getCurrent() if was_ready else ""
    if not was_ready:
        gmsh.initialize(interruptible=False)
    gmsh.model.add("percolith")
    try:
        yield
    finally:
        gmsh.model.remove()
        if was_ready:
            if before:
                gmsh.model.setCurrent(before)
        else:
            gmsh.finalize()


def _import_gmsh() -> Any:
    try:
        import gmsh
    except ImportError as error:
        raise ImportError("meshes are made through the package gmsh: pip install gmsh") from error
    return gmsh


def make_mesh(path: str | os.PathLike, outline: Outline, fractures: Sequence[Fracture],
              lines: Arrangement, sizes: Sizes) -> MadeMesh:
    """Writes the mesh (binary, format 4.1). Raises MeshError with what Gmsh says, and FileError."""
    gmsh = _import_gmsh()
    file = Path(path).absolute()
    if file.suffix != ".msh":
        raise MeshError(f"{path}: a mesh is written to a file .msh")
    if not file.parent.is_dir():
        raise FileError(f"{path}: cannot write the mesh: no folder {file.parent}")
    with _model(gmsh):
        gmsh.option.setNumber("General.Terminal", 0)
        try:
            curves = _add_curves(gmsh, lines, sizes)
            surfaces = _add_surfaces(gmsh, outline, lines, curves)
            sides, groups = _name_curves(gmsh, outline, fractures, lines, curves)
            _set_sizes(gmsh, lines, curves, sizes)
            gmsh.option.setNumber("Mesh.Algorithm", _DELAUNAY if sizes.irregular else _FRONTAL)
            gmsh.model.mesh.generate(2)
            gmsh.option.setNumber("Mesh.Binary", 1)
            gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
        except MeshError:
            raise
        except Exception as error:
            raise MeshError(f"{path}: gmsh: {error}") from error
        try:
            gmsh.write(str(file))
        except Exception as error:
            raise FileError(f"{path}: cannot write the mesh: {error}") from error
        points = len(gmsh.model.mesh.getNodes()[0])
        triangles = sum(len(tags) for tags in gmsh.model.mesh.getElements(2)[1])
    asked = dict.fromkeys(fracture.group for fracture in fractures)
    return MadeMesh(file, surfaces, sides, groups, points, triangles, tuple(lines.changes),
                    len(fractures), sum(fracture.length for fracture in fractures),
                    lines.fracture_length, lines.left_out,
                    tuple(name for name in asked if name not in groups))


def _add_curves(gmsh: Any, lines: Arrangement, sizes: Sizes) -> list[int]:
    points: dict[int, int] = {}
    for edge in lines.edges:
        for node in (edge.a, edge.b):
            if node not in points:
                points[node] = gmsh.model.geo.addPoint(*lines.nodes[node], 0.0, sizes.far)
    return [gmsh.model.geo.addLine(points[edge.a], points[edge.b]) for edge in lines.edges]


def _loops(lines: Arrangement) -> list[list[tuple[int, int]]]:
    """The closed loops of the outline, as edges by number and sense (1 or -1)."""
    at: dict[int, list[int]] = {}
    for number, edge in enumerate(lines.edges):
        if edge.owner == BOUNDARY:
            for node in (edge.a, edge.b):
                at.setdefault(node, []).append(number)
    loops, seen = [], set()
    for first, edge in enumerate(lines.edges):
        if edge.owner != BOUNDARY or first in seen:
            continue
        loop, number, node = [], first, edge.a
        while number not in seen:
            seen.add(number)
            one = lines.edges[number]
            loop.append((number, 1 if one.a == node else -1))
            node = one.b if one.a == node else one.a
            number = next((other for other in at[node] if other not in seen), first)
        loops.append(loop)
    return loops


def _add_surfaces(gmsh: Any, outline: Outline, lines: Arrangement,
                  curves: list[int]) -> tuple[str, ...]:
    loops = sorted(_loops(lines), key=lambda loop: -_extent(lines, loop))
    tags = [gmsh.model.geo.addCurveLoop([sense * curves[number] for number, sense in loop])
            for loop in loops]
    rock = gmsh.model.geo.addPlaneSurface(tags)
    fills = [gmsh.model.geo.addPlaneSurface([tag]) for tag in tags[1:]] if outline.filling else []
    gmsh.model.geo.synchronize()
    inner = [curve for curve, edge in zip(curves, lines.edges) if edge.owner != BOUNDARY]
    gmsh.model.mesh.embed(1, inner, 2, rock)
    gmsh.model.addPhysicalGroup(2, [rock], name=outline.region)
    if fills:
        gmsh.model.addPhysicalGroup(2, fills, name=outline.filling)
    return (outline.region, outline.filling) if fills else (outline.region,)


def _extent(lines: Arrangement, loop: list[tuple[int, int]]) -> float:
    places = np.array([lines.nodes[lines.edges[number].a] for number, _ in loop])
    return float(np.prod(places.max(axis=0) - places.min(axis=0)))


def _name_curves(gmsh: Any, outline: Outline, fractures: Sequence[Fracture], lines: Arrangement,
                 curves: list[int]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names sides and groups in the mesh; returns the sides where the rock ends, and the groups."""
    named: dict[str, list[int]] = {}
    sides = {edge.side for edge in lines.edges if edge.owner == BOUNDARY}
    for curve, edge in zip(curves, lines.edges):
        name = edge.side if edge.owner == BOUNDARY else fractures[edge.owner].group
        if edge.owner != BOUNDARY and name in sides:
            raise MeshError(f"{name}: the name of a side and of a group of fractures")
        named.setdefault(name, []).append(curve)
    for name, members in named.items():
        gmsh.model.addPhysicalGroup(1, members, name=name)
    ends = sides & set(outline.sides) if outline.filling else sides
    return tuple(sorted(ends)), tuple(name for name in named if name not in sides)


def _set_sizes(gmsh: Any, lines: Arrangement, curves: list[int], sizes: Sizes) -> None:
    for option in ("ExtendFromBoundary", "FromPoints", "FromCurvature"):
        gmsh.option.setNumber(f"Mesh.MeshSize{option}", 0)
    gmsh.option.setNumber("Mesh.MeshSizeMax", sizes.far)
    owned = list(zip(curves, lines.edges))
    inner = [curve for curve, edge in owned if edge.owner != BOUNDARY]
    outer = [curve for curve, edge in owned
             if edge.owner == BOUNDARY and edge.side in sizes.fine_sides]
    longest = max(lines.length(edge) for edge in lines.edges)
    grown = [_add_size(gmsh, members, size, sizes.growth, longest)
             for members, size in ((inner, sizes.fractures), (outer, sizes.sides))
             if members and size < sizes.far]
    if not grown:
        return
    smallest = gmsh.model.mesh.field.add("Min")
    gmsh.model.mesh.field.setNumbers(smallest, "FieldsList", grown)
    gmsh.model.mesh.field.setAsBackgroundMesh(smallest)


def _add_size(gmsh: Any, curves: list[int], size: float, growth: float, longest: float) -> int:
    """A field of sizes that grow with the distance from curves, of which none is longer than
    `longest`, m."""
    field = gmsh.model.mesh.field
    distance = field.add("Distance")
    field.setNumbers(distance, "CurvesList", curves)
    field.setNumber(distance, "Sampling", min(2000, 2 + int(2.0 * longest / size)))
    grown = field.add("MathEval")
    field.setString(grown, "F", f"{size!r} + {growth!r} * F{distance}")
    return grown
