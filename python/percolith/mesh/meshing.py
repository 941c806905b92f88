# SPDX-License-Identifier: BSD-3-Clause
"""The mesh of any outline, and the options of it that all shapes take."""

from __future__ import annotations

import functools
import inspect
import os
import textwrap
from collections.abc import Callable, Sequence
from typing import Any, TypedDict, TypeVar, get_args, get_type_hints

from percolith.errors import MeshError
from percolith.mesh.arrangement import arrange
from percolith.mesh.fractures import Fracture
from percolith.mesh.gmsh_mesh import MadeMesh, Sizes, make_mesh
from percolith.mesh.left_out import warn_of_left_out, warn_of_run_together
from percolith.mesh.outline import Outline, require_number, require_positive

_Shape = TypeVar("_Shape", bound=Callable[..., MadeMesh])
# Arguments of all shapes by what they are, so that a wrong one is told before it is reckoned with.
_LENGTHS = {"size", "size_at_fractures", "size_at_fine_sides", "size_at_hole", "size_at_wall",
            "tolerance", "width", "height", "radius", "tunnel_width", "wall_height", "foot",
            "crest", "depth"}
_ANGLES = {"smallest_angle_deg", "flat_deg", "angle_deg"}
_MAY_BE_NONE = {"size_at_fractures", "size_at_fine_sides", "size_at_hole", "size_at_wall",
                "tolerance"}
_WIDTH = 96  # letters on a line of a docstring


class Meshing(TypedDict, total=False):
    """Options of `outline_mesh` that all shapes take."""

    fractures: Sequence[Fracture]
    size_at_fractures: float | None
    growth: float
    tolerance: float | None
    smallest_angle_deg: float
    irregular: bool


class SideMeshing(Meshing, total=False):
    """Those of shapes that leave it to the caller which sides are fine."""

    fine_sides: Sequence[str]
    size_at_fine_sides: float | None


_MEANINGS = {
    "size": "of the elements, m.",
    "fractures": "lines that the mesh follows.",
    "size_at_fractures": "of the elements there, m; `size` where it is not given.",
    "growth": "by how much elements grow per metre of distance from fractures and fine sides, 1.",
    "tolerance": "what is closer than this is merged, m; where it is not given half the size at "
                 "fractures, and at fine sides half of theirs; the size at fractures at most.",
    "smallest_angle_deg": "lines that meet at less run together until they are apart, degrees, 0 "
                          "to 45.",
    "irregular": "triangles in no order (Delaunay), which cracks that choose their way along edges "
                 "need; False lays them out as evenly as can be, for rock that does not break.",
    "fine_sides": "names of sides where elements are as small as at fractures.",
    "size_at_fine_sides": "of the elements there, m; that at fractures where it is not given.",
}


def with_options(shape: _Shape) -> _Shape:
    """Tells the options behind `**meshing` of a shape, with their defaults, to whoever asks for its
    signature, and all options of meshing in its docstring. Checkers of types read them in the
    dictionary that `meshing` is annotated with."""
    signature = inspect.signature(shape)
    own = dict(signature.parameters)
    if own.pop("meshing", None) is not None:
        (taken,) = get_args(get_type_hints(shape)["meshing"])
        of_outlines = inspect.signature(outline_mesh).parameters
        own |= {name: of_outlines[name] for name in of_outlines if name in taken.__annotations__}
    items = [textwrap.fill(f"- {name}: {meaning}", _WIDTH, subsequent_indent="  ")
             for name, meaning in _MEANINGS.items() if name in own]
    shape.__doc__ = "\n\n".join([
        inspect.cleandoc(shape.__doc__ or ""), "Options of meshing:", "\n".join(items),
        "Returns a `MadeMesh`. Raises MeshError and FileError."])

    @functools.wraps(shape)
    def asked(*arguments: Any, **options: Any) -> MadeMesh:
        if unknown := options.keys() - own.keys():
            raise TypeError(f"{shape.__name__}() takes no {min(unknown)!r}; it takes: "
                            f"{', '.join(own)}")
        _require_numbers({**dict(zip(own, arguments)), **options})
        return shape(*arguments, **options)

    asked.__signature__ = signature.replace(parameters=[
        parameter for parameter in own.values() if parameter.name != "meshing"])
    return asked


def _require_numbers(given: dict[str, Any]) -> None:
    """Raises MeshError for the first of the arguments that should be a number and is none, or a
    length that is not positive."""
    for name, value in given.items():
        if value is None and name in _MAY_BE_NONE:
            continue
        if name in _LENGTHS:
            require_positive(**{name: value})
        elif name in _ANGLES:
            require_number("degrees", **{name: value})
        elif name == "growth":
            require_positive("number", growth=value)


@with_options
def outline_mesh(path: str | os.PathLike, outline: Outline, *, size: float,
                 fractures: Sequence[Fracture] = (), size_at_fractures: float | None = None,
                 growth: float = 0.2, tolerance: float | None = None,
                 smallest_angle_deg: float = 20.0, irregular: bool = True,
                 fine_sides: Sequence[str] = (),
                 size_at_fine_sides: float | None = None) -> MadeMesh:
    """Meshes any outline. A fracture that is left out, as a whole or in part, is a CaseWarning, and
    so are those that follow others over more than 5 % of their length."""
    near = size if size_at_fractures is None else size_at_fractures
    fine = near if size_at_fine_sides is None else size_at_fine_sides
    near, fine = min(near, size), min(fine, size)
    gap = 0.5 * near if tolerance is None else tolerance
    if gap > near:
        raise MeshError(f"tolerance = {gap}: larger than the elements at fractures, which would "
                        f"merge what they can show; allowed: up to {near:g} m")
    if not 0.0 <= smallest_angle_deg <= 45.0:
        raise MeshError(f"smallest_angle_deg = {smallest_angle_deg}: allowed: 0 to 45 degrees")
    names = {*outline.sides, *(side for hole in outline.holes for side in hole.sides)}
    if unknown := set(fine_sides) - names:
        raise MeshError(f"fine_sides: no side {', '.join(sorted(unknown))}; there are: "
                        f"{', '.join(sorted(names))}")
    own = {} if tolerance is not None else dict.fromkeys(fine_sides, 0.5 * min(fine, near))
    for number, fracture in enumerate(fractures):
        if not isinstance(fracture, Fracture):
            raise MeshError(f"fractures[{number}] is a {type(fracture).__name__}; allowed: "
                            "percolith.mesh.Fracture(points)")
    lines = arrange(outline, fractures, gap, smallest_angle_deg, own)
    made = make_mesh(path, outline, fractures, lines,
                     Sizes(size, near, fine, growth, tuple(fine_sides), irregular))
    warn_of_left_out(made, fractures)
    warn_of_run_together(made, fractures, smallest_angle_deg)
    return made
