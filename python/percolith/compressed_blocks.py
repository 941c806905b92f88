# SPDX-License-Identifier: BSD-3-Clause
"""Unpacks the arrays of field files: blocks that zlib has packed one by one."""

from __future__ import annotations

import os
import zlib
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache

import numpy as np

try:
    import deflate
except ImportError:
    deflate = None  # files are read without it too, in twice the time

_FEW_BLOCKS = 4  # that are not worth threads
_PARTS = 4  # a thread, so that one which others on the machine hold up leaves its work to the rest


def decompressor() -> tuple[Callable[[memoryview, int], bytes], tuple[type[Exception], ...]]:
    """Unpacks a block into so many bytes, and what it raises where that is damaged."""
    if deflate is None:
        return (lambda packed, size: zlib.decompress(packed, bufsize=size)), (zlib.error,)
    return deflate.zlib_decompress, (deflate.DeflateError,)


def unpack(data: memoryview, offset: int) -> np.ndarray:
    """The bytes of the array at an offset, stored as number of blocks, their size, size of a
    partial last one, compressed sizes, and the blocks. Both decompressors leave the interpreter's
    lock, so that blocks go in parallel. Raises ValueError where the array is damaged."""
    blocks, size, rest = (int(n) for n in np.frombuffer(data, "<u8", 3, offset))
    packed = np.frombuffer(data, "<u8", blocks, offset + 24).astype(np.int64)
    start = offset + 24 + 8 * blocks
    ends = [start, *(start + np.cumsum(packed)).tolist()]
    if not blocks:
        return np.empty(0, "u1")
    if len(data) < ends[-1] or (packed < 0).any():
        raise ValueError("it ends within an array")
    result = np.empty((blocks - 1) * size + (rest or size), "u1")
    bytes_of = decompressor()[0]

    def run(first: int, last: int) -> None:
        for block in range(first, last):
            part = result[block * size:(block + 1) * size]
            unpacked = bytes_of(data[ends[block]:ends[block + 1]], len(part))
            if len(unpacked) != len(part):
                raise ValueError(f"a block of {len(unpacked)} bytes in place of {len(part)}")
            part[:] = np.frombuffer(unpacked, "u1")  # numpy copies without the lock, bytes with it

    try:
        if blocks < _FEW_BLOCKS:
            run(0, blocks)
        else:
            pool, threads = _pool()
            cuts = np.linspace(0, blocks, min(blocks, _PARTS * threads) + 1).astype(int).tolist()
            list(pool.map(run, cuts[:-1], cuts[1:]))
    except decompressor()[1] as error:
        raise ValueError(str(error)) from error
    return result


@cache
def _pool() -> tuple[ThreadPoolExecutor, int]:
    threads = len(os.sched_getaffinity(0))
    return ThreadPoolExecutor(threads), threads
