# SPDX-License-Identifier: BSD-3-Clause
"""Draws a field over time as one animated GIF. All its pictures have the same window, the same
colours and the same factor of the displacements."""

from __future__ import annotations

import io
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgb
from PIL import Image

from percolith.crack_picture import MODES
from percolith.field_picture import field_figure
from percolith.flow_fields import FIELDS
from percolith.mechanics_picture import mechanics_figure
from percolith.pictures import check_field, check_scale
from percolith.run_directory import RunDirectory, RunDirectoryError
from percolith.view import ANIMATED, View, view_of_times

MOST_FRAMES = 60
LARGEST_FILE = 3_000_000  # bytes
_FEWEST_FRAMES = 24  # that a file which is too large is thinned to before its pictures shrink
_RESOLUTION = 80  # dots per inch
_DURATION = 8000  # ms that all pictures take together, where each then stays
_SHORTEST, _LONGEST = 80, 500  # ms
_SAMPLED = 5  # pictures that the set of colours is made from
_ALMOST_WHITE = 244
_LAST = 2000  # ms that the last picture stays


def default_field(run: RunDirectory) -> str:
    return "pressure" if run.has_flow else "principal_stress_1"


def thinned(entries: list, most: int) -> list:
    """At most so many of the entries, evenly among them, the first and the last included."""
    numbers = np.linspace(0, len(entries) - 1, min(len(entries), most)).round().astype(int)
    return [entries[i] for i in np.unique(numbers)]


def _image(run: RunDirectory, time: float, field: str, view: View) -> Image.Image:
    frame = run.frame(time)
    draw = field_figure if field in FIELDS else mechanics_figure
    figure = draw(run, frame, field, view)
    figure.set_dpi(_RESOLUTION)
    figure.canvas.draw()
    pixels = np.asarray(figure.canvas.buffer_rgba())[:, :, :3]
    plt.close(figure)
    return Image.fromarray(np.ascontiguousarray(pixels))


def _palette(images: list[Image.Image]) -> Image.Image:
    """One set of 256 colours for all pictures, so that none flickers. Colours of modes count as if
    they covered a part of each picture: their lines are thin."""
    parts = [np.asarray(image)[::2, ::2].reshape(-1, 3) for image in thinned(images, _SAMPLED)]
    swatch = len(parts[0]) // 50
    for _, colour in MODES.values():
        parts.append(np.full((swatch, 3), np.round(255 * np.array(to_rgb(colour))), np.uint8))
    pixels = np.concatenate(parts)
    width = len(parts[0])
    pixels = np.resize(pixels, (-(-len(pixels) // width), width, 3))
    palette = Image.fromarray(pixels).quantize(256, method=Image.Quantize.MEDIANCUT)
    colours = np.array(palette.getpalette()).reshape(-1, 3)
    colours[colours.min(axis=1) > _ALMOST_WHITE] = 255  # means of the paper and of what is near it
    palette.putpalette(colours.astype(np.uint8).tobytes())
    return palette


def _encode(images: list[Image.Image]) -> bytes:
    palette = _palette(images)
    flat = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    each = int(np.clip(_DURATION / len(flat), _SHORTEST, _LONGEST))
    file = io.BytesIO()
    flat[0].save(file, format="GIF", save_all=True, append_images=flat[1:], loop=0, optimize=False,
                 duration=[each] * (len(flat) - 1) + [_LAST])
    return file.getvalue()


def _shrink(images: list[Image.Image], factor: float) -> list[Image.Image]:
    size = [round(side * factor) for side in images[0].size]
    return [image.resize(size, Image.Resampling.LANCZOS) for image in images]


def encode(images: list[Image.Image], largest: int = LARGEST_FILE) -> bytes:
    """A GIF of at most `largest` bytes: of fewer pictures where it would be larger, and then of
    smaller ones."""
    content = _encode(images)
    while len(content) > largest and len(images) > _FEWEST_FRAMES:
        fitting = int(0.95 * len(images) * largest / len(content))
        images = thinned(images, max(_FEWEST_FRAMES, fitting))
        content = _encode(images)
    while len(content) > largest and min(images[0].size) > 100:
        images = _shrink(images, min(0.9, 0.95 * (largest / len(content)) ** 0.5))
        content = _encode(images)
    return content


def draw_animation(run: RunDirectory, field: str | None = None, path: Path | None = None,
                   scale: float | None = None, window: np.ndarray | None = None) -> Path:
    """Writes the frames of `field` as a GIF to `path`, or to FIELD.gif in the run directory, and
    returns where. Without `field` it is the pressure of a run with flow, else the first principal
    stress. Cracks have the colours of their pressure in pictures of flow, and else of their mode.
    `scale` multiplies the displacements; None stands for one that suits all frames. `window`
    gives lower left and upper right end (2, 2) of what is shown, in m; None stands for all. Raises
    RunDirectoryError where the run has no such field, nothing in the window, or fewer than two
    frames."""
    field = field or default_field(run)
    check_field(run, field)
    check_scale(run, scale)
    if len(run.times) < 2:
        raise RunDirectoryError(f"{run.path}: an animation needs two frames; the case can ask for "
                                "them by output.interval or output.times")
    times = thinned(run.times, MOST_FRAMES)
    view = view_of_times(run, times, field, scale, run.has_mechanics, ANIMATED, window)
    path = path or run.path / f"{field}.gif"
    path.write_bytes(encode([_image(run, time, field, view) for time in times]))
    return path
