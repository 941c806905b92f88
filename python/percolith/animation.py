# SPDX-License-Identifier: BSD-3-Clause
"""Draws a field over time as one animated GIF or MP4. All its pictures have the same window, the
same colours and the same factor of the displacements."""

from __future__ import annotations

import io
from collections.abc import Iterator
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgb
from PIL import Image

from percolith.crack_picture import MODES
from percolith.map_picture import map_axes
from percolith.overlays import Overlays
from percolith.pictures import MapOptions, check_field
from percolith.run_directory import RunDirectory, RunDirectoryError
from percolith.saving import check_folder, writing
from percolith.video import require_encoder, write_video
from percolith.view import ANIMATED, STILL, View

FORMATS = (".gif", ".mp4")
MOST_FRAMES = 60  # of a GIF
LARGEST_FILE = 3_000_000  # bytes
_FEWEST_FRAMES = 24  # that a file which is too large is thinned to before its pictures shrink
_RESOLUTION, _VIDEO_RESOLUTION = 80, 120  # dots per inch
_DURATION = 8000  # ms that all pictures take together, where each then stays
_SHORTEST, _LONGEST = 80, 500  # ms
_SHORTEST_OF_VIDEO = 40  # ms
_SAMPLED = 5  # pictures that the set of colours is made from
_ALMOST_WHITE = 244
_LAST = 2000  # ms that the last picture stays


def default_field(run: RunDirectory) -> str:
    return "pressure" if run.has_flow else "principal_stress_1"


def thinned(entries: list, most: int) -> list:
    """At most so many of the entries, evenly among them, the first and the last included."""
    numbers = np.linspace(0, len(entries) - 1, min(len(entries), most)).round().astype(int)
    return [entries[i] for i in np.unique(numbers)]


def _image(run: RunDirectory, time: float, field: str, view: View, resolution: int) -> Image.Image:
    figure = map_axes(run, run.frame(time), field, view).figure
    figure.set_dpi(resolution)
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


def duration(count: int, shortest: int = _SHORTEST) -> int:
    """How long (ms) each of so many pictures stays."""
    return int(np.clip(_DURATION / count, shortest, _LONGEST))


def _encode(images: list[Image.Image]) -> bytes:
    palette = _palette(images)
    flat = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    file = io.BytesIO()
    flat[0].save(file, format="GIF", save_all=True, append_images=flat[1:], loop=0, optimize=False,
                 duration=[duration(len(flat))] * (len(flat) - 1) + [_LAST])
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


def _check(run: RunDirectory, options: MapOptions, path: Path) -> None:
    """Refuses what cannot be drawn before anything is."""
    if path.suffix.lower() not in FORMATS:
        raise RunDirectoryError(f"{path}: an animation is a GIF or an MP4; allowed: FILE.gif, "
                                "FILE.mp4")
    check_folder(path)
    if path.suffix.lower() == ".mp4":
        require_encoder()
    options.check(run)
    if len(run.times) < 2:
        raise RunDirectoryError(f"{run.path}: an animation needs two frames; the case can ask for "
                                "them by output.interval or output.times")


def draw_animation(run: RunDirectory, field: str | None = None, path: Path | None = None,
                   scale: float | None = None, window: np.ndarray | None = None,
                   overlays: Overlays | None = None) -> Path:
    """Writes the frames of `field` to `path`, a GIF or an MP4 by its ending, or to FIELD.gif in the
    run directory, and returns where. Without `field` it is the pressure of a run with flow, else
    the first principal stress. Without `overlays` cracks have the colours of their pressure in
    pictures of flow, and else of their mode. `scale` multiplies the displacements; None stands for
    one that suits all frames. `window` gives lower left and upper right end (2, 2) of what is
    shown, in m; None stands for all. Raises RunDirectoryError where the run has no such field,
    nothing in the window, or fewer than two frames, and where nothing encodes an MP4, and FileError
    where a file cannot be read or written."""
    field = check_field(run, field or default_field(run))
    options = MapOptions(scale, window, overlays or Overlays())
    path = Path(path) if path else run.path / f"{field}.gif"
    _check(run, options, path)
    if path.suffix.lower() == ".mp4":
        view = options.view_of_all(run, run.times, field, run.has_mechanics, STILL)
        pictures: Iterator[Image.Image] = (_image(run, time, field, view, _VIDEO_RESOLUTION)
                                           for time in run.times)
        write_video(path, pictures, duration(len(run.times), _SHORTEST_OF_VIDEO), _LAST)
        return path
    times = thinned(run.times, MOST_FRAMES)
    view = options.view_of_all(run, times, field, run.has_mechanics, ANIMATED)
    content = encode([_image(run, time, field, view, _RESOLUTION) for time in times])
    with writing(path):
        path.write_bytes(content)
    return path
