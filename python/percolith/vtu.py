# SPDX-License-Identifier: BSD-3-Clause
"""Reader of the field files (`.vtu`): VTK XML unstructured grids with one shape of cell, whose
arrays are appended in raw binary, compressed by zlib, with UInt64 headers."""

from __future__ import annotations

import os
import xml.etree.ElementTree as ElementTree
import zlib
from collections.abc import Callable, Iterator, Mapping, MutableMapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cache, partial

import numpy as np

from percolith.errors import Error

_TYPES = {"Float64": "<f8", "Float32": "<f4", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1"}

_DAMAGE = (KeyError, ValueError, AttributeError, zlib.error, ElementTree.ParseError)
_FEW_BLOCKS = 16  # that are not worth threads


class VtuError(Error, ValueError):
    """The file is no field file of Percolith, or it is damaged."""


class LazyArrays(MutableMapping[str, np.ndarray]):
    """Arrays by name, unpacked when first asked for."""

    def __init__(self, makers: dict[str, Callable[[], np.ndarray]]):
        self._makers = makers
        self._made: dict[str, np.ndarray] = {}

    def __getitem__(self, name: str) -> np.ndarray:
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


@dataclass
class Grid:
    """A mesh of one shape of cell with its quantities.

    points: (n, 2) coordinates in m. cells: (m, 2) or (m, 3) indices of points. point_data and
    cell_data: arrays of n or m rows by name, which carries the unit; vectors have two columns. Of a
    file they are unpacked when first asked for. time: s.
    """

    points: np.ndarray
    cells: np.ndarray
    point_data: Mapping[str, np.ndarray] = field(default_factory=dict)
    cell_data: Mapping[str, np.ndarray] = field(default_factory=dict)
    time: float = 0.0


def read_vtu(path: str | os.PathLike) -> Grid:
    """Reads one field file. Raises VtuError with the name of the file where it cannot be read; what
    is damaged within an array shows when that is asked for."""
    try:
        with open(path, "rb") as file:
            return _read(file.read(), path)
    except _DAMAGE as error:
        raise _damaged(path, error) from error


def _damaged(path: str | os.PathLike, error: Exception) -> VtuError:
    return VtuError(f"{path}: not a field file of Percolith, or damaged: {error}")


def _read(content: bytes, path: str | os.PathLike) -> Grid:
    root, data = _split(content)
    if root.get("type") != "UnstructuredGrid" or root.get("header_type") != "UInt64":
        raise ValueError("no unstructured grid with UInt64 headers")
    if root.get("compressor") != "vtkZLibDataCompressor":
        raise ValueError("arrays are not compressed by zlib")
    piece = root.find("UnstructuredGrid/Piece")
    points = _arrays(piece.find("Points"), data, path)["Points"]
    cells = _arrays(piece.find("Cells"), data, path)["connectivity"]
    cell_count = int(piece.get("NumberOfCells"))
    corners = cells.size // cell_count if cell_count else 3
    times = root.find("UnstructuredGrid/FieldData")
    return Grid(
        points=points[:, :2],
        cells=cells.reshape(cell_count, corners),
        point_data=_arrays(piece.find("PointData"), data, path),
        cell_data=_arrays(piece.find("CellData"), data, path),
        time=float(_arrays(times, data, path)["TimeValue"][0]) if times is not None else 0.0,
    )


def _split(content: bytes) -> tuple[ElementTree.Element, memoryview]:
    """The XML part of a file and the appended bytes."""
    tag = content.find(b"<AppendedData")
    start = content.find(b"_", tag)
    if tag < 0 or start < 0:
        raise ValueError("no appended data")
    return ElementTree.fromstring(content[:tag] + b"</VTKFile>"), memoryview(content)[start + 1 :]


def _arrays(element: ElementTree.Element | None, data: memoryview,
            path: str | os.PathLike) -> LazyArrays:
    return LazyArrays({entry.get("Name"): partial(_unpack, dict(entry.items()), data, path)
                       for entry in (element if element is not None else ())})


def _unpack(entry: dict[str, str], data: memoryview, path: str | os.PathLike) -> np.ndarray:
    try:
        values = _decompress(data, int(entry["offset"])).view(_TYPES[entry["type"]])
        components = int(entry.get("NumberOfComponents", "1"))
    except _DAMAGE as error:
        raise _damaged(path, error) from error
    if components == 1:
        return values
    values = values.reshape(-1, components)
    return values if entry["Name"] == "Points" else values[:, :2]


def _decompress(data: memoryview, offset: int) -> np.ndarray:
    """The bytes of one array, stored as number of blocks, their size, size of a partial last one,
    compressed sizes, and the blocks. zlib leaves the interpreter's lock: blocks go in parallel."""
    blocks, size, rest = (int(n) for n in np.frombuffer(data, "<u8", 3, offset))
    packed = np.frombuffer(data, "<u8", blocks, offset + 24).astype(np.int64)
    ends = offset + 24 + 8 * blocks + np.cumsum(packed)
    if blocks == 0:
        return np.empty(0, "u1")
    result = np.empty((blocks - 1) * size + (rest or size), "u1")
    if len(data) < ends[-1]:
        raise ValueError("it ends within an array")

    def unpack(block: int) -> None:
        part = result[block * size:(block + 1) * size]
        end = int(ends[block])
        part[:] = np.frombuffer(zlib.decompress(data[end - int(packed[block]):end],
                                                bufsize=len(part)), "u1")

    if blocks < _FEW_BLOCKS:
        for block in range(blocks):
            unpack(block)
    else:
        list(_pool().map(unpack, range(blocks)))
    return result


@cache
def _pool() -> ThreadPoolExecutor:
    return ThreadPoolExecutor(len(os.sched_getaffinity(0)))
