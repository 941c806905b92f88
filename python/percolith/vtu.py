# SPDX-License-Identifier: BSD-3-Clause
"""Reader of the field files (`.vtu`): VTK XML unstructured grids with one shape of cell, whose
arrays are appended in raw binary, compressed by zlib, with UInt64 headers."""

from __future__ import annotations

import mmap
import os
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator, Mapping, MutableMapping
from functools import partial
from typing import Any, TypeVar

import numpy as np

from percolith.compressed_blocks import unpack
from percolith.errors import Error, FileError, unknown_name
from percolith.short_text import counted, listed

_TYPES = {"Float64": "<f8", "Float32": "<f4", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1"}

_DAMAGE = (LookupError, ValueError, TypeError, AttributeError, ElementTree.ParseError)
_Found = TypeVar("_Found")
_SMALL = 2**24  # bytes of a file that is read whole; each larger one keeps a file open
_END = b"</VTKFile>"


class VtuError(Error, ValueError):
    """The file is no field file of Percolith, or it is damaged."""


class _Arrays(dict[str, np.ndarray]):
    """Arrays by name, where a name that is not there tells those that are."""

    def __missing__(self, name: object) -> np.ndarray:
        raise unknown_name("array", name, self)


class LazyArrays(MutableMapping[str, np.ndarray]):
    """Arrays by name, unpacked when first asked for. A name that is not there tells those that
    are."""

    def __init__(self, makers: dict[str, Callable[[], np.ndarray]]):
        self._makers = makers
        self._made: dict[str, np.ndarray] = {}

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self._makers:
            raise unknown_name("array", name, self)
        if name not in self._made:
            self._made[name] = self._makers[name]()
        return self._made[name]

    def __setitem__(self, name: str, values: np.ndarray) -> None:
        self._makers[name] = lambda: values
        self._made[name] = values

    def __delitem__(self, name: str) -> None:
        del self._makers[name]
        self._made.pop(name, None)

    def __contains__(self, name: object) -> bool:
        return name in self._makers

    def __iter__(self) -> Iterator[str]:
        return iter(self._makers)

    def __len__(self) -> int:
        return len(self._makers)

    def __repr__(self) -> str:
        return f"<arrays {', '.join(self)}>"


class Grid:
    """A mesh of one shape of cell with its quantities.

    points: (n, 2) coordinates in m. cells: (m, 2) or (m, 3) indices of points. point_data and
    cell_data: arrays of n or m rows by name, which carries the unit; vectors have two columns.
    time: s. Of a file all arrays are unpacked when first asked for.
    """

    def __init__(self, points: np.ndarray | Callable[[], np.ndarray],
                 cells: np.ndarray | Callable[[], np.ndarray],
                 point_data: Mapping[str, np.ndarray] | None = None,
                 cell_data: Mapping[str, np.ndarray] | None = None, time: float = 0.0):
        self._mesh = {"points": points, "cells": cells}
        self.point_data = _named(point_data)
        self.cell_data = _named(cell_data)
        self.time = time
        self._found: dict[tuple[Grid, Callable[[Grid, Grid], Any]], Any] = {}

    @property
    def points(self) -> np.ndarray:
        """Coordinates (n, 2), m."""
        return self._made("points")

    @property
    def cells(self) -> np.ndarray:
        """Numbers (m, 2) or (m, 3) of the points of each cell."""
        return self._made("cells")

    @property
    def size_text(self) -> str:
        """Its numbers of points and cells in words, or that its file is damaged."""
        try:
            return f"{counted(len(self.points), 'point')} and {counted(len(self.cells), 'cell')}"
        except VtuError:  # To look at a grid must not fail.
            return "damaged points or cells"

    def __repr__(self) -> str:
        return (f"Grid(time={self.time:g} s, {self.size_text}; of points: "
                f"{listed(self.point_data)}; of cells: {listed(self.cell_data)})")

    def found_with(self, other: Grid, find: Callable[[Grid, Grid], _Found]) -> _Found:
        """What `find` makes of this grid and another, found once for as long as this one is in
        use."""
        asked = other, find
        if asked not in self._found:
            self._found[asked] = find(self, other)
        return self._found[asked]

    def _made(self, name: str) -> np.ndarray:
        if callable(self._mesh[name]):
            self._mesh[name] = self._mesh[name]()
        return self._mesh[name]


def _named(data: Mapping[str, np.ndarray] | None) -> MutableMapping[str, np.ndarray]:
    return data if isinstance(data, LazyArrays | _Arrays) else _Arrays(data or {})


def read_vtu(path: str | os.PathLike) -> Grid:
    """Reads one field file. Raises FileError where it cannot be read, and VtuError where it is
    damaged, both with its name; what is damaged within an array shows when that is asked for."""
    try:
        with open(path, "rb") as file:
            small = os.fstat(file.fileno()).st_size <= _SMALL
            # Of a large file only what is asked for is fetched.
            return _read(file.read() if small else mmap.mmap(file.fileno(), 0,
                                                             access=mmap.ACCESS_READ), path)
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {error.strerror or error}") from error
    except _DAMAGE as error:
        raise _damaged(path, error) from error


def _damaged(path: str | os.PathLike, error: Exception) -> VtuError:
    return VtuError(f"{path}: not a field file of Percolith, or damaged: {error}")


def _read(content: bytes | mmap.mmap, path: str | os.PathLike) -> Grid:
    root, data = _split(content)
    if root.get("type") != "UnstructuredGrid" or root.get("header_type") != "UInt64":
        raise ValueError("no unstructured grid with UInt64 headers")
    if root.get("compressor") != "vtkZLibDataCompressor":
        raise ValueError("arrays are not compressed by zlib")
    piece = root.find("UnstructuredGrid/Piece")
    points = _arrays(piece.find("Points"), data, path)
    cells = _arrays(piece.find("Cells"), data, path)
    if "Points" not in points or "connectivity" not in cells:
        raise ValueError("no points or no cells")
    cell_count = int(piece.get("NumberOfCells"))
    times = root.find("UnstructuredGrid/FieldData")
    return Grid(
        points=lambda: points["Points"],
        cells=lambda: _cells(cells["connectivity"], cell_count, path),
        point_data=_arrays(piece.find("PointData"), data, path),
        cell_data=_arrays(piece.find("CellData"), data, path),
        time=float(_arrays(times, data, path)["TimeValue"][0]) if times is not None else 0.0,
    )


def _split(content: bytes | mmap.mmap) -> tuple[ElementTree.Element, memoryview]:
    """The XML part of a file and the appended bytes."""
    tag = content.find(b"<AppendedData")
    start = content.find(b"_", tag)
    if tag < 0 or start < 0:
        raise ValueError("no appended data")
    if not content[-2 * len(_END):].rstrip().endswith(_END):
        raise ValueError("it ends early")
    return ElementTree.fromstring(content[:tag] + _END), memoryview(content)[start + 1 :]


def _arrays(element: ElementTree.Element | None, data: memoryview,
            path: str | os.PathLike) -> LazyArrays:
    return LazyArrays({entry.get("Name"): partial(_array, dict(entry.items()), data, path)
                       for entry in (element if element is not None else ())})


def _array(entry: dict[str, str], data: memoryview, path: str | os.PathLike) -> np.ndarray:
    try:
        values = unpack(data, int(entry["offset"])).view(_TYPES[entry["type"]])
        components = int(entry.get("NumberOfComponents", "1"))
        if components == 1:
            return values
        return values.reshape(-1, components)[:, :2]
    except _DAMAGE as error:
        raise _damaged(path, error) from error


def _cells(connectivity: np.ndarray, count: int, path: str | os.PathLike) -> np.ndarray:
    """Rows of numbers of points; three where there is no cell."""
    try:
        return connectivity.reshape(count, connectivity.size // count if count else 3)
    except ValueError as error:
        raise _damaged(path, error) from error
