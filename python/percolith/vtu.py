# SPDX-License-Identifier: BSD-3-Clause
"""Reader of the field files (`.vtu`): VTK XML unstructured grids with one shape of cell, whose
arrays are appended in raw binary, compressed by zlib, with UInt64 headers."""

from __future__ import annotations

import os
import xml.etree.ElementTree as ElementTree
import zlib
from dataclasses import dataclass, field

import numpy as np

from percolith.errors import Error

_TYPES = {"Float64": "<f8", "Float32": "<f4", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1"}


class VtuError(Error, ValueError):
    """The file is no field file of Percolith, or it is damaged."""


@dataclass
class Grid:
    """A mesh of one shape of cell with its quantities.

    points: (n, 2) coordinates in m. cells: (m, 2) or (m, 3) indices of points. point_data and
    cell_data: arrays of n or m rows by name; vectors have two columns. time: s.
    """

    points: np.ndarray
    cells: np.ndarray
    point_data: dict[str, np.ndarray] = field(default_factory=dict)
    cell_data: dict[str, np.ndarray] = field(default_factory=dict)
    time: float = 0.0


def read_vtu(path: str | os.PathLike) -> Grid:
    """Reads one field file. Raises VtuError with the name of the file where it cannot be read."""
    try:
        with open(path, "rb") as file:
            return _read(file.read())
    except (KeyError, ValueError, AttributeError, zlib.error, ElementTree.ParseError) as error:
        raise VtuError(f"{path}: not a field file of Percolith, or damaged: {error}") from error


def _read(content: bytes) -> Grid:
    root, data = _split(content)
    if root.get("type") != "UnstructuredGrid" or root.get("header_type") != "UInt64":
        raise ValueError("no unstructured grid with UInt64 headers")
    if root.get("compressor") != "vtkZLibDataCompressor":
        raise ValueError("arrays are not compressed by zlib")
    piece = root.find("UnstructuredGrid/Piece")
    points = _arrays(piece.find("Points"), data)["Points"]
    cells = _arrays(piece.find("Cells"), data)
    cell_count = int(piece.get("NumberOfCells"))
    corners = cells["connectivity"].size // cell_count if cell_count else 3
    times = root.find("UnstructuredGrid/FieldData")
    return Grid(
        points=points[:, :2],
        cells=cells["connectivity"].reshape(cell_count, corners),
        point_data=_arrays(piece.find("PointData"), data),
        cell_data=_arrays(piece.find("CellData"), data),
        time=float(_arrays(times, data)["TimeValue"][0]) if times is not None else 0.0,
    )


def _split(content: bytes) -> tuple[ElementTree.Element, memoryview]:
    """The XML part of a file and the appended bytes."""
    tag = content.find(b"<AppendedData")
    start = content.find(b"_", tag)
    if tag < 0 or start < 0:
        raise ValueError("no appended data")
    return ElementTree.fromstring(content[:tag] + b"</VTKFile>"), memoryview(content)[start + 1 :]


def _arrays(element: ElementTree.Element | None, data: memoryview) -> dict[str, np.ndarray]:
    arrays = {}
    for entry in element if element is not None else ():
        values = np.frombuffer(
            _decompress(data, int(entry.get("offset"))), dtype=_TYPES[entry.get("type")]
        )
        components = int(entry.get("NumberOfComponents", "1"))
        if components > 1:
            values = values.reshape(-1, components)
            if entry.get("Name") != "Points":
                values = values[:, :2]
        arrays[entry.get("Name")] = values
    return arrays


def _decompress(data: memoryview, offset: int) -> bytes:
    """One array: number of blocks, their size, size of a partial last one, compressed sizes."""
    blocks = int(np.frombuffer(data, "<u8", 1, offset)[0])
    sizes = np.frombuffer(data, "<u8", blocks, offset + 24)
    position = offset + 24 + 8 * blocks
    parts = []
    for size in sizes:
        parts.append(zlib.decompress(data[position : position + int(size)]))
        position += int(size)
    return b"".join(parts)
