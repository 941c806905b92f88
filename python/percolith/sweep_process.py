# SPDX-License-Identifier: BSD-3-Clause
"""A point of a sweep in a process of its own: how it is begun, what it tells, and how it ends."""

from __future__ import annotations

import ctypes
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import IO, Any

from percolith import errors
from percolith.errors import CaseError, CaseWarning, Error, Problem


def run_elsewhere(folder: Path, number: int, threads: int,
                   working: set[subprocess.Popen]) -> tuple[Error | None, list[str]]:
    """Runs a point in a process of its own; returns what went wrong, and what it warned of. The
    process does not import the program that asks for it."""
    package = str(Path(__file__).absolute().parent.parent)
    path = os.pathsep.join([package, *filter(None, [os.environ.get("PYTHONPATH")])])
    words = [sys.executable, "-W", "ignore", "-m", "percolith.sweeps", str(folder), "--point",
             str(number), "--threads", str(threads), "--errors", "json", "--parent",
             str(os.getpid())]
    # Files, not pipes: those break when this process is killed, just as the run tells of its end.
    with tempfile.TemporaryFile("w+") as out_file, tempfile.TemporaryFile("w+") as told_file:
        process = subprocess.Popen(words, stdout=out_file, stderr=told_file,
                                   env={**os.environ, "PYTHONPATH": path})
        working.add(process)
        process.wait()
        working.discard(process)
        out, told = (_written(file) for file in (out_file, told_file))
    lines = out.splitlines()
    texts = [json.loads(line)["warning"] for line in lines if line.startswith('{"warning"')]
    if process.returncode == 0:
        return None, texts
    try:
        return error_from(json.loads(lines[-1])), texts
    except (ValueError, LookupError, TypeError, AttributeError):
        return Error(f"point {number}: its process ended with exit code {process.returncode}: "
                     f"{told.strip()[-1000:]}"), texts


def _written(file: IO[str]) -> str:
    file.seek(0)
    return file.read()


def as_plain(error: Error) -> dict[str, Any]:
    """What another process needs to raise the error again, for JSON."""
    problems = [asdict(problem) for problem in getattr(error, "problems", ())]
    return {"error": type(error).__name__, "message": str(error), "problems": problems}


def error_from(told: Mapping[str, Any]) -> Error:
    """The error of another process that as_plain has told."""
    kind = getattr(errors, told["error"], Error)
    if issubclass(kind, CaseError):
        return kind(told["message"], [Problem(**problem) for problem in told["problems"]])
    return kind(told["message"])


@contextmanager
def warnings_to(tell: Callable[[str], object]) -> Iterator[None]:
    """What a case or a run warns of goes to `tell`, all of it; other warnings go nowhere."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        warnings.simplefilter("always", CaseWarning)
        warnings.showwarning = lambda message, *_, **__: tell(str(message))
        yield


class Terminated(KeyboardInterrupt):
    """SIGTERM asks for what Ctrl-C does."""

    signal_name = "SIGTERM"  # for the summary and the log of the run that it ends


@contextmanager
def heeding_sigterm() -> Iterator[None]:
    """SIGTERM raises Terminated within, once; only the main thread can heed it."""
    def end(number: int, frame: object) -> None:
        signal.signal(signal.SIGTERM, signal.SIG_IGN)  # Once is enough.
        raise Terminated

    if threading.current_thread() is not threading.main_thread():
        yield  # Signals are not for other threads.
        return
    former = signal.signal(signal.SIGTERM, end)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, former)


def end_with(parent: int) -> None:
    """Has this process get SIGTERM when its parent ends, however that comes about: a run that no
    one waits for would keep its folder from the next sweep. Nothing like it is elsewhere than on
    Linux."""
    if sys.platform == "linux":
        set_parent_death_signal = 1  # PR_SET_PDEATHSIG
        ctypes.CDLL(None).prctl(set_parent_death_signal, int(signal.SIGTERM), 0, 0, 0)
    if os.getppid() != parent:  # It has ended before it could be asked for.
        raise Terminated
