# SPDX-License-Identifier: BSD-3-Clause
"""Reads the frames of a view, and goes without those whose files are damaged."""

from __future__ import annotations

from percolith.animation import thinned
from percolith.errors import FileError
from percolith.run_directory import Frame, RunDirectory
from percolith.vtu import Grid, VtuError


def _unpack(grid: Grid | None) -> None:
    """Asks for all arrays, as damage of some shows only then."""
    if grid is not None:
        _ = grid.points, grid.cells, [*grid.point_data.values()], [*grid.cell_data.values()]


class FrameReader:
    """Frames of a run, each read once. A page of one frame must not fail by the file of another:
    `damaged` has the times (s) of those that cannot be read."""

    def __init__(self, run: RunDirectory, asked: Frame):
        self.run, self.asked = run, asked
        self.damaged: set[float] = set()
        self._frames = {asked.time: asked}

    def _at(self, time: float) -> Frame | None:
        if time not in self._frames and time not in self.damaged:
            try:
                frame = self.run.frame(time)
                _unpack(frame.matrix)
                _unpack(frame.cracks)
                self._frames[time] = frame
            except (VtuError, FileError):
                self.damaged.add(time)
        return self._frames.get(time)

    def ends(self) -> list[Frame]:
        """The first and the last frame that can be read."""
        first = next(filter(None, map(self._at, self.run.times)), self.asked)
        last = next(filter(None, map(self._at, reversed(self.run.times))), self.asked)
        return [first] if first is last else [first, last]

    def chosen(self, count: int) -> list[Frame]:
        """At most so many frames, evenly among all, the first and the last included, and the one
        asked for in place of the one next to it."""
        asked = self.asked.time
        if count < 2:
            return [self.asked]
        times = thinned([time for time in self.run.times if time not in self.damaged], count)
        if asked not in times:
            inner = times[1:-1] or times
            times[times.index(min(inner, key=lambda time: abs(time - asked)))] = asked
        return [frame for frame in map(self._at, times) if frame is not None]
