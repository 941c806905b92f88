# SPDX-License-Identifier: BSD-3-Clause
"""Warnings of fractures that a mesh does not follow although they were asked for."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterator, Sequence

from percolith.errors import CaseWarning
from percolith.mesh.fractures import Fracture
from percolith.mesh.gmsh_mesh import MadeMesh

_MOST_TOLD = 5  # fractures


def warn_of_left_out(made: MadeMesh, fractures: Sequence[Fracture]) -> None:
    """A CaseWarning for each fracture that is left out of the mesh, as a whole or in part, with the
    reason. Of random networks, which lose some by design, only groups of which nothing is left are
    told."""
    texts = list(_of_fractures(made, fractures))
    if len(texts) > _MOST_TOLD:
        more = len(texts) - _MOST_TOLD
        texts[_MOST_TOLD:] = [f"{more} more fracture{'s are' if more > 1 else ' is'} left out of the "
                              "mesh, as a whole or in part; report() of the mesh tells of each"]
    given = {fracture.group for fracture in fractures if not fracture.is_random}
    texts += [f"group {name}: none of its fractures is left in the mesh; report() of the mesh tells "
              "why" for name in made.lost_groups if name not in given]
    for text in texts:
        warnings.warn(text, CaseWarning, stacklevel=_level_of_the_caller())


def _of_fractures(made: MadeMesh, fractures: Sequence[Fracture]) -> Iterator[str]:
    wholly = {change.fractures[0]: change.reason for change in made.changes
              if change.kind == "left out as a whole"}
    parts: dict[int, list[str]] = {}
    for change in made.changes:
        if change.kind == "left out":
            x, y = (round(value, 9) + 0.0 for value in change.place)
            parts.setdefault(change.fractures[0], []).append(
                f"{change.distance:.3g} m at ({x:.4g}, {y:.4g})")
    for number in sorted(wholly.keys() | parts.keys()):
        if fractures[number].is_random:
            continue
        name = f"fracture {number} of group {fractures[number].group}"
        if number in wholly:
            yield f"{name} is left out of the mesh: {wholly[number]}"
        else:
            yield f"{name} is left out of the mesh over {', '.join(parts[number])}: outside the rock"


def _level_of_the_caller() -> int:
    """What `stacklevel` of `warnings.warn` is in the function that asks, to name the line that
    called this package."""
    level, frame = 0, sys._getframe(1)
    while frame is not None and frame.f_globals.get("__name__", "").startswith("percolith.mesh"):
        level, frame = level + 1, frame.f_back
    return level + 1
