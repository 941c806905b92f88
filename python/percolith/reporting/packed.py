# SPDX-License-Identifier: BSD-3-Clause
"""Arrays as text for a page: what `arrays.js` unpacks."""

from __future__ import annotations

import base64
import zlib
from dataclasses import dataclass

import numpy as np

KINDS = {"float32": "<f4", "uint32": "<u4"}


@dataclass(frozen=True)
class Packed:
    """An array as base64 of zlib of its bytes, the first bytes of all numbers first, then the
    second ones, and so on: neighbours in that order are alike and shrink. Whole numbers are stored
    as differences from the one before."""

    kind: str  # a key of KINDS
    length: int  # numbers, all rows together
    text: str


def pack(values: np.ndarray, kind: str = "float32") -> Packed:
    """Packs the numbers of an array, row after row."""
    flat = np.ascontiguousarray(values, dtype=KINDS[kind]).ravel()
    stored = np.diff(flat, prepend=flat.dtype.type(0)) if kind == "uint32" else flat
    planes = stored.view(np.uint8).reshape(-1, 4).T
    content = zlib.compress(np.ascontiguousarray(planes).tobytes(), 6)
    return Packed(kind, flat.size, base64.b64encode(content).decode())


def unpack(packed: Packed) -> np.ndarray:
    """The numbers of a packed array, in one row."""
    planes = np.frombuffer(zlib.decompress(base64.b64decode(packed.text)), np.uint8)
    stored = np.ascontiguousarray(planes.reshape(4, -1).T).view(KINDS[packed.kind]).ravel()
    if packed.kind == "uint32":
        return np.cumsum(stored, dtype=np.uint32)
    return stored
