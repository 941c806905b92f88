# SPDX-License-Identifier: BSD-3-Clause
"""How far a sweep is, and the ways of telling it while its runs are at work."""

from __future__ import annotations

import shutil
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TextIO

from percolith.errors import CaseError

_UNITS = ((2 * 86400.0, 86400.0, "days"), (2 * 3600.0, 3600.0, "h"), (90.0, 60.0, "min"),
          (0.0, 1.0, "s"))


@dataclass(frozen=True)
class SweepProgress:
    """How far a sweep is: how many of its `total` runs are `done`, those of earlier calls among
    them, have `failed` in this one, and are `running` now; `remaining`, the time (s) that the rest
    will take if it takes as long as those that finished in this call, None before one has. As a
    text: 7 of 24 runs done, 1 failed, 3 running, about 4 min left."""

    done: int
    failed: int
    running: int
    total: int
    remaining: float | None

    def __str__(self) -> str:
        parts = [f"{self.done} of {self.total} runs done"]
        parts += [f"{self.failed} failed"] * bool(self.failed)
        parts += [f"{self.running} running"] * bool(self.running)
        if self.running and self.remaining is not None:
            factor, unit = next((factor, unit) for least, factor, unit in _UNITS
                                if self.remaining >= least)
            parts.append(f"about {max(1, round(self.remaining / factor))} {unit} left")
        return ", ".join(parts)


class Tally:
    """Counts the runs of one call as they begin and end: of `total`, `done` had finished before,
    `left` are to be run, so many `processes` at once."""

    def __init__(self, total: int, done: int, left: int, processes: int):
        self._total, self._done, self._left, self._processes = total, done, left, processes
        self._failed = 0
        self._since: dict[int, float] = {}  # s on a clock, of those at work, by number
        self._spent: list[float] = []  # s, of those that finished

    def begin(self, number: int) -> None:
        """Run `number` begins; called by the thread that waits for it."""
        self._since[number] = time.monotonic()

    def end(self, number: int, failed: bool) -> None:
        """Run `number` has ended."""
        spent = time.monotonic() - self._since.pop(number)
        self._left -= 1
        if failed:
            self._failed += 1
        else:
            self._done += 1
            self._spent.append(spent)

    @property
    def progress(self) -> SweepProgress:
        """The present state."""
        running = min(self._processes, self._left)
        return SweepProgress(self._done, self._failed, running, self._total,
                             self._remaining(running))

    def _remaining(self, running: int) -> float | None:
        if not self._left:
            return 0.0
        if not self._spent:
            return None
        mean, now = sum(self._spent) / len(self._spent), time.monotonic()
        spent = sum(min(mean, now - since) for since in list(self._since.values()))
        return max(0.0, self._left * mean - spent) / running


class Quiet:
    """Tells nothing."""

    def tell(self, progress: SweepProgress, ended: str = "") -> None:
        """Shows how far the sweep is; `ended` says which run ended how, "" at the beginning."""

    def clear(self) -> None:
        """Makes room for what others print."""

    def close(self) -> None:
        """Tells no more."""


class _Lines(Quiet):
    def tell(self, progress: SweepProgress, ended: str = "") -> None:
        if ended:
            print(f"{ended}: {progress}", flush=True)


class _RenewedLine(Quiet):
    def __init__(self, stream: TextIO):
        self._stream = stream
        self._shown = ""

    def tell(self, progress: SweepProgress, ended: str = "") -> None:
        text = str(progress)[:max(1, shutil.get_terminal_size().columns - 1)]
        self._stream.write(f"\r{text:{len(self._shown)}}")
        self._stream.flush()
        self._shown = text

    def clear(self) -> None:
        if self._shown:
            self._stream.write(f"\r{' ' * len(self._shown)}\r")
            self._stream.flush()
        self._shown = ""

    def close(self) -> None:
        if self._shown:
            self._stream.write("\n")
            self._stream.flush()
        self._shown = ""


class _Call(Quiet):
    def __init__(self, function: Callable[[SweepProgress], object]):
        self._function = function

    def tell(self, progress: SweepProgress, ended: str = "") -> None:
        self._function(progress)


def display(progress: bool | Callable[[SweepProgress], object] | None) -> Quiet:
    """What tells how far a sweep is: a line that is renewed in place on a terminal or in a notebook
    and nothing elsewhere for None, a line a run that ended for True, nothing for False, or a
    function that is called. Raises CaseError for anything else."""
    if progress is None:
        if sys.stderr is not None and sys.stderr.isatty():
            return _RenewedLine(sys.stderr)
        return _RenewedLine(sys.stdout) if _in_notebook() else Quiet()
    if isinstance(progress, bool):
        return _Lines() if progress else Quiet()
    if not callable(progress):
        raise CaseError(f"error: progress = {progress!r}: allowed: True, False, None or a function")
    return _Call(progress)


def _in_notebook() -> bool:
    python = sys.modules.get("IPython")
    return python is not None and hasattr(python.get_ipython(), "kernel")
