# SPDX-License-Identifier: BSD-3-Clause
"""What the interactive view of a page is given: places, displacements and fields of some frames."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from percolith.animation import default_field, thinned
from percolith.deformation import can_deform
from percolith.exaggeration import automatic_scale
from percolith.model_figure import moment
from percolith.reporting.packed import Packed
from percolith.reporting.view_fields import (
    ViewField,
    crack_field,
    crack_fields,
    has_cracks,
    rock_field,
    rock_fields,
)
from percolith.reporting.view_frames import FrameArrays, HeldArrays, nodes_over_time
from percolith.run_directory import Frame, RunDirectory
from percolith.view import split

MOST_FRAMES = 16
LARGEST_SERIES = 6_000_000  # bytes of a page that the frames beside the one asked for may take


@dataclass(frozen=True)
class ViewData:
    """`about` is plain numbers and words; `arrays` holds the rest by names that it uses."""

    about: dict
    arrays: dict[str, Packed]


def _range_alone(of_all: ViewField, of_one: ViewField) -> dict:
    """The ends of the colours of one time; those of all times where its field is the same
    everywhere, so that the ends of its colours say nothing."""
    says_more = np.ptp(of_one.ends) <= np.ptp(of_all.ends)
    return {"ends": of_one.ends if says_more else of_all.ends,
            "beyond": of_one.beyond if says_more else of_all.beyond}


@dataclass(frozen=True)
class _Series:
    """Frames with what they have in common. Joints that only part a rigid body from the rock are
    no cracks of `shown`, as in the pictures."""

    run: RunDirectory
    frames: Sequence[Frame]
    shown: Sequence[Frame]
    rock: Sequence[ViewField]
    cracks: Sequence[ViewField]
    scale: float
    origin: np.ndarray

    def pack(self, number: int, nodes, held: HeldArrays, is_rounded: bool) -> dict:
        """Packs the arrays of a frame into `held` and describes it."""
        frame, shown = self.frames[number], self.shown[number]
        arrays = FrameArrays(self.run, frame, nodes, held, is_rounded)
        arrays.add_mesh(self.origin)
        if can_deform(frame.matrix):
            arrays.add_motion(shown.cracks)
        arrays.add_rock(self.rock)
        cracked = bool(self.cracks) and has_cracks(shown)
        segments = arrays.add_cracks(self.cracks, shown.cracks, self.origin) if cracked else 0
        alone = [("rock", one, rock_field) for one in self.rock]
        alone += [("crack", one, crack_field) for one in self.cracks if cracked]
        ranges = {f"{kind}-{one.name}": _range_alone(one, field_of(self.run, [shown], one.name,
                                                                   self.scale))
                  for kind, one, field_of in alone if not one.names}
        return {"moment": moment(self.run, frame), "segments": segments, "arrays": arrays.keys,
                "triangles": len(frame.matrix.cells),
                "ranges": ranges}


def _series(run: RunDirectory, frames: Sequence[Frame], asked: int,
            scale: float | None) -> _Series:
    rocks = [split(run, frame)[0] for frame in frames]
    matrix = frames[asked].matrix
    if scale is None:
        scale = (automatic_scale(matrix, [rock.matrix for rock in rocks]) if can_deform(matrix)
                 else 1.0)
    shown = [Frame(frame.time, frame.matrix, rock.cracks) for frame, rock in zip(frames, rocks)]
    origin = 0.5 * (matrix.points.min(axis=0) + matrix.points.max(axis=0))
    return _Series(run, frames, shown, rock_fields(run, shown, scale),
                   crack_fields(run, shown, scale), scale, origin)


def _described(one: ViewField, kind: str) -> dict:
    return {"name": one.name, "label": one.label, "atPoints": one.at_points,
            "colours": one.colours, "ends": one.ends, "factor": one.scale.factor,
            "unit": one.unit, "beyond": one.beyond, "names": one.names,
            "values": f"{kind}-{one.name}"}


def _first_of_cracks(run: RunDirectory, fields: Sequence[ViewField]) -> str:
    return "pressure" if run.has_flow or not fields else fields[0].name


def _size_of_last(run: RunDirectory, scale: float | None) -> int:
    """What a rounded frame takes of a page, at most, as what is in it grows with time."""
    held, frames = HeldArrays(), [run.frame()]
    series = _series(run, frames, 0, scale)
    series.pack(0, nodes_over_time(frames)[0], held, True)
    return held.letters


def chosen_times(run: RunDirectory, asked: float, scale: float | None) -> list[float]:
    """The times (s) of the frames that a page has room for, evenly among all, the first and the
    last included, and the frame asked for in place of the one next to it."""
    if len(run.times) < 2:
        return [asked]
    room = LARGEST_SERIES // max(_size_of_last(run, scale), 1)
    if not room:
        return [asked]
    times = thinned(run.times, min(MOST_FRAMES, 1 + room))
    if asked not in times:
        inner = times[1:-1] or times
        nearest = min(inner, key=lambda time: abs(time - asked))
        times[times.index(nearest)] = asked
    return times


def view_data(run: RunDirectory, frame: Frame, scale: float | None = None) -> ViewData:
    """The view of a frame, and of others beside it as far as a page has room; `scale` multiplies
    the displacements, None chooses it as `percolith plot` does."""
    times = chosen_times(run, frame.time, scale)
    asked = times.index(frame.time)
    frames = [frame if time == frame.time else run.frame(time) for time in times]
    series, nodes, held = _series(run, frames, asked, scale), nodes_over_time(frames), HeldArrays()
    # The frame asked for comes first, so that its arrays have the plain names.
    order = [asked, *(i for i in range(len(frames)) if i != asked)]
    packed = {i: series.pack(i, nodes[i], held, i != asked) for i in order}
    size = np.ptp(frame.matrix.points, axis=0)
    about = {"moment": moment(run, frame), "deforms": can_deform(frame.matrix),
             "scale": series.scale, "triangles": len(frame.matrix.cells),
             "origin": series.origin.tolist(), "size": size.tolist(),
             "first": default_field(run), "segments": packed[asked]["segments"],
             "rock": [_described(one, "rock") for one in series.rock],
             "cracks": [_described(one, "crack") for one in series.cracks],
             "firstOfCracks": _first_of_cracks(run, series.cracks),
             "frames": [packed[i] for i in range(len(frames))], "asked": asked,
             "allFrames": len(run.times)}
    return ViewData(about, held.arrays)
