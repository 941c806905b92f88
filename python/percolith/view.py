# SPDX-License-Identifier: BSD-3-Clause
"""What all pictures of one field have in common, so that those of a series can be compared."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from dataclasses import field as dataclass_field

import numpy as np

from percolith.colour_range import ColourRange
from percolith.crack_fields import CRACK_FIELDS, range_of_cracks, shown_values
from percolith.deformation import can_deform, deformed_points
from percolith.exaggeration import automatic_scale
from percolith.flow_fields import FIELDS, rock_and_crack_ranges, rock_values
from percolith.mechanics_fields import (
    is_category,
    other_fields,
    range_of_values,
    rock_and_bodies,
    values_of,
)
from percolith.overlays import Overlays, arrow_size, cross_size, stress_sizes
from percolith.run_directory import Frame, RunDirectory
from percolith.vtu import Grid
from percolith.window import check_shows, visible

STILL, ANIMATED = 256, 64  # colours of the map
_PIXELS = 700  # along the longer side of the window
_CUT = 1.05  # times the stress of the longest cross: a cut below is less than the eye can see


@dataclass(frozen=True)
class View:
    """Window, scale and colours of a picture, or of all pictures of a series."""

    window: np.ndarray  # lower left and upper right end of what is shown, (2, 2), m
    scale: float  # factor of the displacements
    rock: ColourRange | None  # None where a colour is no value, as of fragments
    cracks: ColourRange | None  # None where cracks have the colours of the rock, or none
    modes: tuple[int, ...]  # of the field `mode` that occur
    crack_colours: str  # what cracks are coloured by: `mode`, a quantity of theirs, `thin`, `none`
    colours: int  # number of different ones
    is_part: bool = False  # whether the window was asked for, and may cut the model
    cross: float | None = None  # stress (Pa) that the longest cross stands for; None without them
    arrow: float | None = None  # Darcy flux (m/s) of the longest arrow; None without them
    cuts_crosses: bool = False  # whether stresses go visibly beyond that of the longest cross

    @property
    def step(self) -> float:
        """Difference of values (SI) from one colour to the next."""
        return (self.rock.high - self.rock.low) / self.colours

    @property
    def pixel(self) -> float:
        """About the size of a pixel, m. A part below half of one would not be painted."""
        return float((self.window[1] - self.window[0]).max()) / _PIXELS


def split(run: RunDirectory, frame: Frame) -> tuple[Frame, Grid | None]:
    """The rock and the rigid bodies, of which rock at rest has none."""
    return rock_and_bodies(run, frame) if can_deform(frame.matrix) else (frame, None)


def _modes(frame: Frame) -> set[int]:
    if frame.cracks is None or "mode" not in frame.cracks.cell_data:
        return set()
    return set(np.unique(frame.cracks.cell_data["mode"]).tolist())


def shown_parts(run: RunDirectory, frame: Frame, view: View) -> tuple[Frame, Grid | None]:
    """The rock as far as the view shows it, and the rigid bodies."""
    frame, bodies = split(run, frame)
    return visible(frame, view.scale, view.window) if view.is_part else frame, bodies


def _scale(run: RunDirectory, frames: Sequence[Callable[[], Frame]],
           window: np.ndarray | None) -> float:
    """A factor of the displacements that shows those of the last frame and suits all."""
    last = frames[-1]().matrix
    if not can_deform(last):
        return 1.0
    return automatic_scale(last, (split(run, read())[0].matrix for read in frames), window)


@dataclass
class _Seen:
    """What the frames of a series have, as far as the window shows them."""

    field: str
    crack_colours: str
    overlays: Overlays
    ends: list[np.ndarray] = dataclass_field(default_factory=list)  # of the whole model, m
    rock: list[np.ndarray] = dataclass_field(default_factory=list)
    cracks: list[np.ndarray] = dataclass_field(default_factory=list)
    modes: set[int] = dataclass_field(default_factory=set)
    crosses: list[float] = dataclass_field(default_factory=list)
    arrows: list[float] = dataclass_field(default_factory=list)
    largest_stress: float = 0.0  # Pa
    triangles: int = 0
    deforms: bool = False
    array: str = ""  # that the field is in

    def add(self, frame: Frame) -> None:
        """Counts the rock of a frame in."""
        self.triangles += len(frame.matrix.cells)
        self.modes |= _modes(frame)
        of_flow = self.field in FIELDS
        self.rock.append((rock_values if of_flow else values_of)(frame, self.field))
        self.cracks.append(shown_values(frame, self.crack_colours))
        if self.overlays.has_crosses(self.field, self.crack_colours):
            self.crosses.append(cross_size(frame))
            self.largest_stress = max(self.largest_stress,
                                      float(np.nanmax(stress_sizes(frame), initial=0.0)))
        if self.overlays.has_arrows(self.field):
            self.arrows.append(arrow_size(frame))

    @property
    def longest_cross(self) -> float | None:
        """The stress (Pa) of the longest cross of all frames; None without crosses."""
        return max(self.crosses, default=None)

    @property
    def cuts_crosses(self) -> bool:
        """Whether lines of crosses are visibly shorter than their stress. Asked of the series, not
        of each picture, so that all have the same legend."""
        return bool(self.crosses) and self.largest_stress > _CUT * self.longest_cross

    @property
    def shares_colours(self) -> bool:
        """Whether cracks show what the rock does; the flux along them is of another kind."""
        return self.field in FIELDS and self.field == self.crack_colours != "flux"

    @property
    def extent(self) -> np.ndarray:
        """Lower left and upper right end (2, 2), m."""
        low, high = np.array(self.ends).transpose(1, 0, 2)
        return np.stack([low.min(axis=0), high.max(axis=0)])


def _ranges(seen: _Seen) -> tuple[ColourRange | None, ColourRange | None]:
    """The ends of the colours of the rock, and of the cracks where these have their own."""
    rock, cracks = np.concatenate(seen.rock), np.concatenate(seen.cracks)
    of_flow, colours = seen.field in FIELDS, seen.crack_colours
    if seen.shares_colours:
        return rock_and_crack_ranges(seen.field, rock, cracks, seen.deforms)
    second = range_of_cracks(colours, cracks) if colours in CRACK_FIELDS else None
    if of_flow:
        return rock_and_crack_ranges(seen.field, rock, np.empty(0), seen.deforms)[0], second
    if is_category(rock):
        return None, second
    return range_of_values(seen.field, rock, seen.array), second


def view_of(run: RunDirectory, frames: Sequence[Callable[[], Frame]], field: str,
            scale: float | None = None, shows_modes: bool = False, colours: int = STILL,
            window: np.ndarray | None = None, overlays: Overlays | None = None) -> View:
    """The view of a field that suits all frames, which `frames` read one after the other. `scale`
    multiplies the displacements; None stands for `automatic_scale`. `shows_modes` tells cracks
    apart by their mode where `overlays` leave that open. `window` (2, 2) is what is to be shown, in
    m; None stands for all. Raises RunDirectoryError where there is no such field, or nothing in the
    window."""
    scale = _scale(run, frames, window) if scale is None else scale
    overlays = overlays or Overlays()
    seen = _Seen(field, overlays.colours_of_cracks(field, shows_modes), overlays)
    for read in frames:
        frame = read()
        points = deformed_points(frame.matrix, scale)
        seen.ends.append(np.stack([points.min(axis=0), points.max(axis=0)]))
        seen.deforms = can_deform(frame.matrix)
        seen.array = other_fields(frame.matrix).get(field, field)
        frame, _ = split(run, frame)
        seen.add(frame if window is None else visible(frame, scale, window))
    if window is not None:
        check_shows(seen.triangles, window, seen.extent)
    rock, cracks = _ranges(seen)
    return View(seen.extent if window is None else window, scale, rock, cracks,
                tuple(sorted(seen.modes)), seen.crack_colours, colours, window is not None,
                seen.longest_cross, max(seen.arrows, default=None), seen.cuts_crosses)


def view_of_frame(run: RunDirectory, frame: Frame, field: str, scale: float | None = None,
                  shows_modes: bool = False, window: np.ndarray | None = None,
                  overlays: Overlays | None = None) -> View:
    """The view of one picture."""
    return view_of(run, [lambda: frame], field, scale, shows_modes, window=window,
                   overlays=overlays)


def view_of_times(run: RunDirectory, times: Sequence[float], field: str,
                  scale: float | None = None, shows_modes: bool = False,
                  colours: int = STILL, window: np.ndarray | None = None,
                  overlays: Overlays | None = None) -> View:
    """The view of the frames at these times (s)."""
    frames = [lambda time=time: run.frame(time) for time in times]
    return view_of(run, frames, field, scale, shows_modes, colours, window, overlays)
