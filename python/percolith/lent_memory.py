# SPDX-License-Identifier: BSD-3-Clause
"""Memory of the simulator that may be written to for a while."""

from __future__ import annotations

import weakref
from typing import Any

import numpy as np


class LentArray(np.ndarray):
    """An array that knows the views numpy has made of it, so that all can be made read-only at
    once. What `np.asarray` or a `memoryview` makes of it is beyond its knowledge."""

    _views: dict[int, weakref.ref] | None = None

    def __array_finalize__(self, source: Any) -> None:
        self._views = views = getattr(source, "_views", None)
        if views is not None:
            key = id(self)
            views[key] = weakref.ref(self, lambda _: views.pop(key, None))

    def __array_wrap__(self, array: np.ndarray, context: Any = None,
                       return_scalar: bool = False) -> Any:
        # What is computed from it is an array of its own.
        return array[()] if return_scalar else array


def lend(memory: np.ndarray) -> LentArray:
    """The memory, to be written to until it is taken back."""
    lent = memory.view(LentArray)
    lent._views = {}
    return lent


def take_back(lent: LentArray, memory: np.ndarray) -> None:
    """Makes the memory and all views that are known of it read-only."""
    for known in list((lent._views or {}).values()):
        view = known()
        if view is not None and np.may_share_memory(view, memory):
            view.setflags(write=False)
    lent.setflags(write=False)
    memory.setflags(write=False)
