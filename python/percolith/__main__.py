# SPDX-License-Identifier: BSD-3-Clause
"""`python -m percolith`: the command line for the Python at hand, wherever its programs lie."""

from __future__ import annotations

import importlib.metadata
import os
import shutil
import signal
import sys
from pathlib import Path

import percolith

_USAGE = """Usage: python -m percolith COMMAND ...

Does what the program percolith does, with the same arguments, messages and exit codes:
  run CASE.toml      runs a case and writes its results
  check CASE.toml    checks a case without running it: mesh, model, limits of the time step
  schema             prints the JSON Schema of case files
  new EXAMPLE DIR    copies a worked example to start from
  plot DIR           draws the results of a run
  report DIR         puts all results of a run into one page for a browser

python -m percolith COMMAND --help tells the options of each; python -m percolith.sweeps --help those
of sweeps."""


def _version() -> str:
    try:
        return f"percolith {percolith.__version__}"
    except ImportError:  # In the sources nothing is built.
        return "percolith"


def find_program() -> Path | None:
    """The program percolith: that of the build or the installation this package belongs to, or else
    the one on the PATH; None where there is none."""
    beside = [Path(__file__).absolute().parents[2] / "bin/percolith"]  # in a build folder
    try:
        installed = importlib.metadata.files("percolith") or []
    except importlib.metadata.PackageNotFoundError:
        installed = []
    beside += [Path(str(file.locate())) for file in installed if file.name == "percolith"]
    on_path = shutil.which("percolith")
    candidates = [*beside, *([Path(on_path)] if on_path else [])]
    return next((file for file in candidates if file.is_file() and os.access(file, os.X_OK)), None)


def main(words: list[str] | None = None) -> int:
    """Runs the command, most of them in place of this process; returns the exit code of `plot` and
    `report`, 0 for help and the version, and 4 where there is no program percolith."""
    words = sys.argv[1:] if words is None else words
    if not words:
        print(f"{_version()}; python -m percolith --help tells what it can do")
        return 0
    if words[0] in ("-h", "--help"):
        print(f"{_version()}, the simulator of fractured porous rock\n{_USAGE}")
        return 0
    # These are Python themselves; the package at hand is the one to draw with.
    if words[0] == "plot":
        from percolith.plot import main as plot

        return plot(words[1:])
    if words[0] == "report":
        from percolith.reports import main as report

        return report(words[1:])
    program = find_program()
    if program is not None:
        sys.stdout.flush()
        # Python ignores these two; the program is to have them as from a shell.
        for number in (signal.SIGPIPE, signal.SIGXFSZ):
            signal.signal(number, signal.SIG_DFL)
        os.execv(program, [str(program), *words])
    if words == ["--version"]:
        print(_version())
        return 0
    print("error: there is no program percolith beside this package, nor on the PATH; install both "
          "with `pip install .` in the sources of Percolith", file=sys.stderr)
    return 4


if __name__ == "__main__":
    sys.exit(main())
