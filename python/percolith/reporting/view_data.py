# SPDX-License-Identifier: BSD-3-Clause
"""What the interactive view of a page is given: places, displacements and fields of some frames."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from percolith.animation import default_field
from percolith.deformation import can_deform
from percolith.exaggeration import automatic_scale
from percolith.model_figure import moment
from percolith.reporting.frame_reader import FrameReader
from percolith.reporting.nodes import Nodes
from percolith.reporting.packed import Packed
from percolith.reporting.view_fields import (
    ViewField,
    crack_field,
    crack_fields,
    has_cracks,
    rock_field,
    rock_fields,
)
from percolith.reporting.view_frames import (
    FrameArrays,
    HeldArrays,
    NoRoom,
    has_mesh_of,
    nodes_over_time,
)
from percolith.run_directory import Frame, RunDirectory
from percolith.units import format_time
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

    def _has_cracks(self, number: int) -> bool:
        return bool(self.cracks) and has_cracks(self.shown[number])

    def pack(self, number: int, nodes: Nodes, held: HeldArrays, is_rounded: bool,
             has_mesh: bool = True) -> FrameArrays:
        """Packs the arrays of a frame into `held`; without its mesh those that may be others at
        other times."""
        frame, shown = self.frames[number], self.shown[number]
        arrays = FrameArrays(self.run, frame, shown.cracks, nodes, held, is_rounded)
        if has_mesh:
            arrays.add_mesh(self.origin)
        if can_deform(frame.matrix):
            arrays.add_motion()
        arrays.add_rock([one for one in self.rock if has_mesh or one.name != "region"])
        if self._has_cracks(number):
            arrays.add_cracks(self.cracks, self.origin)
        return arrays

    def about(self, number: int, arrays: FrameArrays) -> dict:
        """What describes a frame."""
        frame, shown = self.frames[number], self.shown[number]
        cracked = self._has_cracks(number)
        alone = [("rock", one, rock_field) for one in self.rock]
        alone += [("crack", one, crack_field) for one in self.cracks if cracked]
        ranges = {f"{kind}-{one.name}": _range_alone(one, field_of(self.run, [shown], one.name,
                                                                   self.scale))
                  for kind, one, field_of in alone if not one.names}
        return {"moment": moment(self.run, frame), "arrays": arrays.keys, "ranges": ranges,
                "segments": len(arrays.segment) if cracked else 0}


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


def _size_of_another(run: RunDirectory, reader: FrameReader, scale: float | None) -> int:
    """What a frame beside the one asked for adds to a page, about: the mean of the first and the
    last, as cracks grow and rock is dug out. The mesh counts where it is not the same throughout.
    More than LARGEST_SERIES where one of them alone has no room."""
    ends = reader.ends()
    is_same = all(has_mesh_of(end.matrix, reader.asked.matrix) for end in ends)
    nodes, sizes = nodes_over_time(ends), []
    for frame, of_frame in zip(ends, nodes):
        held = HeldArrays(most=LARGEST_SERIES)
        try:
            _series(run, [frame], 0, scale).pack(0, of_frame, held, True, not is_same)
        except NoRoom:
            return LARGEST_SERIES + 1
        sizes.append(held.letters)
    return sum(sizes) // len(sizes)


def _pack_all(series: _Series, asked: int) -> tuple[list[FrameArrays], HeldArrays, int]:
    """The arrays of the frames, and the letters of those that only frames beside the one asked for
    have."""
    nodes, held = nodes_over_time(series.frames), HeldArrays()
    # The frame asked for comes first, so that its arrays have the plain names.
    arrays = {asked: series.pack(asked, nodes[asked], held, False)}
    own = held.letters
    arrays |= {i: series.pack(i, of_frame, held, True)
               for i, of_frame in enumerate(nodes) if i != asked}
    return [arrays[i] for i in range(len(nodes))], held, held.letters - own


class _Filled(NamedTuple):
    """Frames that a page has room for, and their arrays."""

    series: _Series
    asked: int
    arrays: list[FrameArrays]
    held: HeldArrays


def _filled(run: RunDirectory, reader: FrameReader, scale: float | None) -> _Filled:
    """Packs as many frames as a page has room for."""
    most = min(MOST_FRAMES, len(run.times)) - 1
    beside = 0
    if most > 0:
        beside = min(most, LARGEST_SERIES // max(_size_of_another(run, reader, scale), 1))
    may_grow = True
    while True:
        frames = reader.chosen(1 + beside)
        asked = next(i for i, one in enumerate(frames) if one is reader.asked)
        series = _series(run, frames, asked, scale)
        arrays, held, letters = _pack_all(series, asked)
        # The ends of a run need not be like what is between them.
        measured = min(most, beside * LARGEST_SERIES // letters) if letters else beside
        if letters > LARGEST_SERIES:
            beside, may_grow = min(beside - 1, measured), False
        elif may_grow and beside < measured >= min(most, 2 * beside) and not reader.damaged:
            beside, may_grow = measured, False
        else:
            return _Filled(series, asked, arrays, held)


def view_data(run: RunDirectory, frame: Frame, scale: float | None = None) -> ViewData:
    """The view of a frame, and of others beside it as far as a page has room and their files are
    sound; `scale` multiplies the displacements, None chooses it as `percolith plot` does."""
    reader = FrameReader(run, frame)
    series, asked, arrays, held = _filled(run, reader, scale)
    packed = [series.about(i, one) for i, one in enumerate(arrays)]
    size = np.ptp(frame.matrix.points, axis=0)
    about = {"moment": moment(run, frame), "deforms": can_deform(frame.matrix),
             "scale": series.scale, "triangles": len(frame.matrix.cells),
             "origin": series.origin.tolist(), "size": size.tolist(),
             "first": default_field(run), "segments": packed[asked]["segments"],
             "rock": [_described(one, "rock") for one in series.rock],
             "cracks": [_described(one, "crack") for one in series.cracks],
             "firstOfCracks": _first_of_cracks(run, series.cracks),
             "frames": packed, "asked": asked, "allFrames": len(run.times),
             "damaged": [format_time(time) for time in sorted(reader.damaged)]}
    return ViewData(about, held.arrays)
