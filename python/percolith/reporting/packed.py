# SPDX-License-Identifier: BSD-3-Clause
"""Arrays as text for a page: what `arrays.js` unpacks."""

from __future__ import annotations

import base64
import zlib
from dataclasses import dataclass

import numpy as np

KINDS = {"float32": "<f4", "uint32": "<u4", "uint16": "<u2"}
STEPS = 65534  # between the least and the largest value that 16 bits hold
_ABSENT = 65535  # stands for NaN


@dataclass(frozen=True)
class Packed:
    """An array as base64 of zlib of its bytes, the first bytes of all numbers first, then the
    second ones, and so on: neighbours in that order are alike and shrink. Whole numbers of 32 bits
    are stored as differences from the one before; those of 16 bits stand for the values `low` plus
    so many times `step`."""

    kind: str  # a key of KINDS
    length: int  # numbers, all rows together
    text: str
    low: float = 0.0
    step: float = 1.0


def _text(numbers: np.ndarray) -> str:
    planes = numbers.view(np.uint8).reshape(-1, numbers.itemsize).T
    return base64.b64encode(zlib.compress(np.ascontiguousarray(planes).tobytes(), 6)).decode()


def pack(values: np.ndarray, kind: str = "float32") -> Packed:
    """Packs the numbers of an array, row after row."""
    flat = np.ascontiguousarray(values, dtype=KINDS[kind]).ravel()
    stored = np.diff(flat, prepend=flat.dtype.type(0)) if kind == "uint32" else flat
    return Packed(kind, flat.size, _text(stored))


def pack_rounded(values: np.ndarray) -> Packed:
    """Packs the values of an array, row after row, rounded to a whole number of STEPS between the
    least and the largest."""
    flat = np.asarray(values, float).ravel()
    finite = flat[np.isfinite(flat)]
    low, high = (float(finite.min()), float(finite.max())) if len(finite) else (0.0, 0.0)
    step = (high - low) / STEPS or 1.0
    numbers = np.where(np.isfinite(flat), np.round((flat - low) / step), _ABSENT)
    return Packed("uint16", flat.size, _text(numbers.astype(KINDS["uint16"])), low, step)


def unpack(packed: Packed) -> np.ndarray:
    """The numbers of a packed array, in one row."""
    planes = np.frombuffer(zlib.decompress(base64.b64decode(packed.text)), np.uint8)
    kind = np.dtype(KINDS[packed.kind])
    stored = np.ascontiguousarray(planes.reshape(kind.itemsize, -1).T).view(kind).ravel()
    if packed.kind == "uint32":
        return np.cumsum(stored, dtype=np.uint32)
    if packed.kind == "uint16":
        values = np.float32(packed.low) + np.float32(packed.step) * stored.astype(np.float32)
        return np.where(stored == _ABSENT, np.float32(np.nan), values)
    return stored
