# SPDX-License-Identifier: BSD-3-Clause
"""What all pictures of one field have in common, so that those of a series can be compared."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from percolith.colour_range import ColourRange
from percolith.deformation import can_deform, deformed_points
from percolith.exaggeration import automatic_scale
from percolith.flow_fields import FIELDS, crack_values, rock_and_crack_ranges, rock_values
from percolith.mechanics_fields import range_of_values, rock_and_bodies, values_of
from percolith.run_directory import Frame, RunDirectory
from percolith.vtu import Grid
from percolith.window import check_shows, visible

STILL, ANIMATED = 256, 64  # colours of the map
_PIXELS = 700  # along the longer side of the window


@dataclass(frozen=True)
class View:
    """Window, scale and colours of a picture, or of all pictures of a series."""

    window: np.ndarray  # lower left and upper right end of what is shown, (2, 2), m
    scale: float  # factor of the displacements
    rock: ColourRange | None  # None where a colour is no value, as of fragments
    cracks: ColourRange | None  # None where cracks have the colours of the rock, or none
    modes: tuple[int, ...]  # of the field `mode` that occur
    shows_modes: bool  # whether cracks are told apart by their mode whatever the field
    colours: int  # number of different ones
    is_part: bool = False  # whether the window was asked for, and may cut the model

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


def _ranges(field: str, rock: list[np.ndarray], cracks: list[np.ndarray],
            deforms: bool) -> tuple[ColourRange | None, ColourRange | None]:
    if field == "fragments":
        return None, None
    joined = np.concatenate(rock)
    if field in FIELDS:
        return rock_and_crack_ranges(field, joined, np.concatenate(cracks), deforms)
    return range_of_values(field, joined), None


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


def view_of(run: RunDirectory, frames: Sequence[Callable[[], Frame]], field: str,
            scale: float | None = None, shows_modes: bool = False, colours: int = STILL,
            window: np.ndarray | None = None) -> View:
    """The view of a field that suits all frames, which `frames` read one after the other. `scale`
    multiplies the displacements; None stands for `automatic_scale`. `window` (2, 2) is what is to
    be shown, in m; None stands for all. Raises RunDirectoryError where there is no such field, or
    nothing in the window."""
    if scale is None:
        scale = _scale(run, frames, window)
    ends, rock, cracks, modes, count = [], [], [], set(), 0
    for read in frames:
        frame = read()
        points = deformed_points(frame.matrix, scale)
        ends.append([points.min(axis=0), points.max(axis=0)])
        deforms = can_deform(frame.matrix)
        frame, _ = split(run, frame)
        frame = frame if window is None else visible(frame, scale, window)
        count += len(frame.matrix.cells)
        modes |= _modes(frame)
        if field in FIELDS:
            rock.append(rock_values(frame, field))
            cracks.append(crack_values(frame, field))
        else:
            rock.append(values_of(frame, field))
    low, high = np.array(ends).transpose(1, 0, 2)
    whole = np.stack([low.min(axis=0), high.max(axis=0)])
    if window is not None:
        check_shows(count, window, whole)
    of_rock, of_cracks = _ranges(field, rock, cracks, deforms)
    return View(whole if window is None else window, scale, of_rock, of_cracks,
                tuple(sorted(modes)), shows_modes, colours, window is not None)


def view_of_frame(run: RunDirectory, frame: Frame, field: str, scale: float | None = None,
                  shows_modes: bool = False, window: np.ndarray | None = None) -> View:
    """The view of one picture."""
    return view_of(run, [lambda: frame], field, scale, shows_modes, window=window)


def view_of_times(run: RunDirectory, times: Sequence[float], field: str,
                  scale: float | None = None, shows_modes: bool = False,
                  colours: int = STILL, window: np.ndarray | None = None) -> View:
    """The view of the frames at these times (s)."""
    frames = [lambda time=time: run.frame(time) for time in times]
    return view_of(run, frames, field, scale, shows_modes, colours, window)
