# SPDX-License-Identifier: BSD-3-Clause
"""What the interactive view of a page is given: places, displacements and fields of a frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from percolith.animation import default_field
from percolith.deformation import can_deform, crack_gaps
from percolith.exaggeration import automatic_scale
from percolith.model_figure import moment
from percolith.reporting.packed import Packed, pack
from percolith.reporting.view_fields import ViewField, crack_fields, rock_fields
from percolith.rigid_bodies import rigid_triangles
from percolith.run_directory import Frame, RunDirectory
from percolith.view import split


@dataclass(frozen=True)
class ViewData:
    """`about` is plain numbers and words; `arrays` holds the rest by names that it uses."""

    about: dict
    arrays: dict[str, Packed]


def _distinct(places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The different ones of places (n, 2), in the order in which they first come, and which of
    them each is (n,): neighbours stay neighbours, which packs well."""
    _, first, inverse = np.unique(places @ [1.0, 1.0j], return_index=True, return_inverse=True)
    order = np.argsort(first, kind="stable")
    rank = np.empty(len(order), np.uint32)
    rank[order] = np.arange(len(order))
    return places[first[order]], rank[inverse.ravel()]


def _described(field: ViewField, key: str) -> dict:
    return {"name": field.name, "label": field.label, "atPoints": field.at_points,
            "colours": field.colours, "ends": field.ends, "factor": field.scale.factor,
            "unit": field.unit, "beyond": field.beyond, "names": field.names, "values": key}


def _without_bodies(values: np.ndarray, at_points: bool, cells: np.ndarray,
                    rigid: np.ndarray) -> np.ndarray:
    """NaN for rigid bodies, which no field of the rock describes."""
    if not rigid.any():
        return values
    values = np.array(values, float)
    values[cells[rigid].ravel() if at_points else rigid] = np.nan
    return values


def _add_rock(run: RunDirectory, frame: Frame, origin: np.ndarray, scale: float, about: dict,
              arrays: dict[str, Packed]) -> None:
    matrix = frame.matrix
    places, place = _distinct(matrix.points)
    arrays["places"] = pack(places - origin)
    arrays["place"] = pack(place, "uint32")
    arrays["cells"] = pack(matrix.cells, "uint32")
    if about["deforms"]:
        arrays["displacement"] = pack(matrix.point_data["displacement_m"])
    body = rigid_triangles(run, matrix)
    # A model of rigid bodies alone is shown as rock.
    rigid = body & ~body.all()
    for field in rock_fields(run, frame, scale):
        key = f"rock-{field.name}"
        values = field.values if field.names else _without_bodies(
            field.values, field.at_points, matrix.cells, rigid)
        arrays[key] = pack(values)
        about["rock"].append(_described(field, key))


def _add_cracks(run: RunDirectory, frame: Frame, origin: np.ndarray, scale: float, about: dict,
                arrays: dict[str, Packed]) -> None:
    """Of rock that deforms the four corners of each gap, two on either face, by their points; of
    rock at rest both ends of each segment."""
    fields = crack_fields(run, frame, scale)
    if not fields:
        return
    segment = np.arange(len(frame.cracks.cells))
    if about["deforms"]:
        gaps = crack_gaps(frame)
        segment = gaps.segment
        arrays["gaps"] = pack(gaps.corners, "uint32")
    else:
        arrays["ends"] = pack(frame.cracks.points[frame.cracks.cells] - origin)
    about["segments"] = len(segment)
    about["firstOfCracks"] = "pressure" if run.has_flow else fields[0].name
    for field in fields:
        key = f"crack-{field.name}"
        arrays[key] = pack(field.values[segment])
        about["cracks"].append(_described(field, key))


def view_data(run: RunDirectory, frame: Frame, scale: float | None = None) -> ViewData:
    """The view of a frame; `scale` multiplies the displacements, None chooses it as `percolith
    plot` does."""
    deforms = can_deform(frame.matrix)
    rock, _ = split(run, frame)
    if scale is None:
        scale = automatic_scale(frame.matrix, [rock.matrix]) if deforms else 1.0
    low, high = frame.matrix.points.min(axis=0), frame.matrix.points.max(axis=0)
    origin = 0.5 * (low + high)
    about = {"moment": moment(run, frame), "deforms": deforms, "scale": scale,
             "triangles": len(frame.matrix.cells), "origin": origin.tolist(),
             "size": (high - low).tolist(), "first": default_field(run), "rock": [],
             "cracks": [], "segments": 0}
    arrays: dict[str, Packed] = {}
    _add_rock(run, frame, origin, scale, about, arrays)
    # Joints that only part a rigid body from the rock are left out, as in the pictures.
    shown = Frame(frame.time, frame.matrix, rock.cracks)
    _add_cracks(run, shown, origin, scale, about, arrays)
    return ViewData(about, arrays)
