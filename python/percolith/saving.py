# SPDX-License-Identifier: BSD-3-Clause
"""Writes figures as files."""

from __future__ import annotations

import io
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import matplotlib.pyplot as plt

from percolith.errors import FileError

FORMATS = (".png", ".pdf", ".svg")
_RESOLUTION = 120  # dots per inch


def png_of(figure) -> bytes:
    """A figure as a PNG file would hold it; closes it."""
    file = io.BytesIO()
    try:
        figure.savefig(file, format="png", dpi=_RESOLUTION, pil_kwargs={"optimize": True})
    finally:
        plt.close(figure)
    return file.getvalue()


def save(figure, path: Path) -> Path:
    """Writes a figure to `path`, in the format that its ending names, closes it and returns the
    path. Raises FileError where it cannot be written."""
    smaller = {"pil_kwargs": {"optimize": True}} if path.suffix.lower() == ".png" else {}
    try:
        with writing(path):
            figure.savefig(path, dpi=_RESOLUTION, **smaller)
    finally:
        plt.close(figure)
    return path


@contextmanager
def writing(path: Path) -> Iterator[None]:
    """Turns an OSError while `path` is written into a FileError that names it."""
    try:
        yield
    except FileError:
        raise
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror or error}") from error


def check_folder(path: Path) -> None:
    """Raises FileError where the folder that `path` is to be written into is missing."""
    if not path.parent.is_dir():
        raise FileError(f"{path}: cannot be written: no folder {path.parent}")


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """A file beside `path` to be written, which takes its place once it is whole; otherwise what
    was there stays. Raises FileError at once where the folder is missing."""
    check_folder(path)
    part = path.with_name(f".{path.name}.part")
    try:
        yield part
        with writing(path):
            os.replace(part, path)
    finally:
        with suppress(OSError):
            part.unlink()
