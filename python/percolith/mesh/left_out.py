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
_SHARE_TOLD = 0.05  # of the length of a fracture that follows others


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


def warn_of_run_together(made: MadeMesh, fractures: Sequence[Fracture],
                         smallest_angle_deg: float) -> None:
    """One CaseWarning where fractures follow others, or sides, over a share of their length worth
    telling, since they meet at less than smallest_angle_deg: of one with what it follows, of
    several with their number and the worst. Of random networks, many of whose fractures meet at
    small angles, nothing is told."""
    followed = _followed(made)
    shares = {number: min(1.0, sum(others.values()) / fractures[number].length)
              for number, others in followed.items()
              if number not in made.left_out and not fractures[number].is_random}
    told = [number for number, share in shares.items() if share > _SHARE_TOLD]
    if not told:
        return
    worst = max(told, key=lambda number: shares[number])
    length = fractures[worst].length
    text = (f"fracture {worst} of group {fractures[worst].group} follows "
            f"{_names(worst, followed[worst], fractures)} over {shares[worst] * length:.3g} m of "
            f"its {length:.3g} m")
    since = f"since they meet at less than smallest_angle_deg = {smallest_angle_deg:g}"
    advice = ("a smaller one keeps them as drawn where they are further apart than the tolerance, "
              "with thin triangles between them")
    if len(told) > 1:
        text = (f"{len(told)} of {len(fractures)} fractures follow others or sides over more than "
                f"{100 * _SHARE_TOLD:g} % of their length, {since}; the worst: {text}; {advice}; "
                "report() of the mesh tells of each")
    else:
        text = f"{text}, {since}; {advice}"
    warnings.warn(text, CaseWarning, stacklevel=_level_of_the_caller())


def _followed(made: MadeMesh) -> dict[int, dict[int | str, float]]:
    """Of each fracture that follows others: over which length, m, it does, by their number or the
    name of a side."""
    followed: dict[int, dict[int | str, float]] = {}
    for change in made.changes:
        if change.kind == "run together":
            others = followed.setdefault(change.fractures[-1], {})
            other = change.side or change.fractures[0]
            others[other] = others.get(other, 0.0) + change.distance
    return followed


def _names(number: int, others: dict[int | str, float], fractures: Sequence[Fracture]) -> str:
    """Those that a fracture follows, the longest first."""
    names = [f"side {other}" if isinstance(other, str) else "itself" if other == number
             else f"fracture {other} of group {fractures[other].group}"
             for other in sorted(others, key=lambda other: -others[other])]
    if len(names) > _MOST_TOLD:
        names[_MOST_TOLD - 1:] = [f"{len(names) - _MOST_TOLD + 1} more"]
    return " and ".join(names)


def _level_of_the_caller() -> int:
    """What `stacklevel` of `warnings.warn` is in the function that asks, to name the line that
    called this package."""
    level, frame = 0, sys._getframe(1)
    while frame is not None and frame.f_globals.get("__name__", "").startswith("percolith.mesh"):
        level, frame = level + 1, frame.f_back
    return level + 1
