# SPDX-License-Identifier: BSD-3-Clause
"""Writes pictures as an MP4 with video in H.264, by the package `av`."""

from __future__ import annotations

import importlib
from collections.abc import Iterable
from fractions import Fraction
from pathlib import Path

import numpy as np
from PIL import Image

from percolith.errors import FileError
from percolith.run_directory import RunDirectoryError
from percolith.saving import replacing

_CODECS = ("libx264", "libopenh264", "mpeg4")  # the best that there is
_RATE = 25  # pictures a second; players stumble over a few
_QUALITY = {"crf": "20", "preset": "medium"}  # lines and letters stay sharp


def require_encoder():
    """The package that encodes. Raises RunDirectoryError where it is not installed."""
    try:
        return importlib.import_module("av")
    except ImportError as error:
        raise RunDirectoryError("an MP4 needs the package av (PyAV), which is not installed: "
                                "`pip install av`, or the package with `pip install "
                                "percolith[animation]`; FILE.gif works without") from error


def _even(image: Image.Image) -> Image.Image:
    """With an even number of rows and columns, which the format needs: white is added."""
    width, height = (side + side % 2 for side in image.size)
    if image.size == (width, height):
        return image
    larger = Image.new("RGB", (width, height), "white")
    larger.paste(image)
    return larger


def write_video(path: Path, pictures: Iterable[Image.Image], each: int, last: int) -> None:
    """Writes pictures of one size to `path`; each stays `each` ms, the last one `last` ms. A file
    that was there stays until the new one is whole. Raises FileError where it cannot be written."""
    av = require_encoder()
    try:
        with replacing(path) as part, av.open(str(part), "w", format="mp4") as file:
            _encode(av, file, pictures, each, last)
    except av.FFmpegError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror or error}") from error


def _encode(av, file, pictures: Iterable[Image.Image], each: int, last: int) -> None:
    stream, frame, number = None, None, 0
    for picture in pictures:
        picture = _even(picture)
        if stream is None:
            codec = next(name for name in _CODECS if name in av.codecs_available)
            stream = file.add_stream(codec, rate=_RATE)
            stream.width, stream.height, stream.pix_fmt = *picture.size, "yuv420p"
            stream.options = _QUALITY if codec == "libx264" else {}
        frame = np.asarray(picture)
        number = _put(av, file, stream, frame, number, each)
    _put(av, file, stream, frame, number, last - each)
    file.mux(stream.encode())


def _put(av, file, stream, pixels: np.ndarray, number: int, time: int) -> int:
    """Shows pixels for a time (ms), from the picture with this number on; returns the next."""
    for _ in range(max(0, round(time * _RATE / 1000))):
        frame = av.VideoFrame.from_ndarray(pixels, format="rgb24")
        frame.pts, frame.time_base = number, Fraction(1, _RATE)
        file.mux(stream.encode(frame))
        number += 1
    return number
