#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the Python package adds to a run: the loop of the example of three cracks, shortened, driven
by the command line, by Python in one piece, and by Python in steps of a hundred.

Usage: python_bindings.py PROGRAM [ROUNDS]. The package is the one on PYTHONPATH, built from the same
objects as PROGRAM. The three alternate, so that a machine whose speed drifts does not decide, and the
best time of each counts, since what others do on the machine only adds. Results go to memory, because
waiting for a disk takes as long as all else and differs from run to run. The loops are those of the
same objects and differ by themselves, from round to round, more than the hundredth that is allowed.
What Python adds lies outside of them, with reports, their formatting and output: that part is judged.
Exit code 1 when Python adds more to it than a hundredth of the run by the command line. Whole runs are
told beside, and so is what the import of the package takes before, once a program.
"""

import json
import os
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

import percolith

ROOT = Path(__file__).resolve().parent.parent
CASE = ROOT / "examples/three_cracks/case.toml"
# As often as the whole example of 7 ms, it writes fields and rows of the history.
OPTIONS = {"time.end": "0.6 ms", "output.interval": "0.2 ms", "output.history_interval": "7 us"}
MEMORY = Path("/dev/shm")
LIMIT = 0.01  # of a run, that Python adds outside the loops
IMPORT = ("import time; start = time.perf_counter(); import percolith; percolith.Case; "
          "print(time.perf_counter() - start)")
START = ("case file", "mesh file", "model")


def seconds(folder: Path) -> tuple[float, float]:
    """Time of a run once its model is there; and the part of it outside the loops of the
    simulator, with reports, their formatting and output."""
    phases = json.loads((folder / "summary.json").read_text())["wall_time_s"]
    total = phases.pop("total")
    start = sum(phases.pop(name) for name in START)
    return total - start, total - start - sum(phases.values()) + phases["output"]


def by_command_line(program: str, folder: Path) -> None:
    settings = [word for key, value in OPTIONS.items() for word in ("--set", f"{key}={value}")]
    subprocess.run([program, "run", CASE, "--output", folder, "--threads", "1", "--quiet",
                    *settings], check=True, stderr=subprocess.DEVNULL)


def by_python(folder: Path, steps: int | None) -> None:
    case = percolith.Case.load(CASE)
    for key, value in OPTIONS.items():
        case[key] = value
    with case.simulation(folder, threads=1) as simulation:
        while simulation.advance(steps=steps):
            pass


def import_seconds() -> float:
    """Time to import what runs a case, in a fresh interpreter."""
    done = subprocess.run([sys.executable, "-c", IMPORT], check=True, capture_output=True, text=True)
    return float(done.stdout)


def main() -> int:
    program, rounds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 12
    warnings.simplefilter("ignore", percolith.CaseWarning)
    os.environ["OMP_NUM_THREADS"] = "1"
    if not MEMORY.is_dir():
        print(f"{MEMORY}: no such folder; results would go to a disk", file=sys.stderr)
        return 1
    best, imported = [(float("inf"), float("inf"))] * 3, float("inf")
    for _ in range(rounds):
        with tempfile.TemporaryDirectory(dir=MEMORY) as scratch:
            folders = [Path(scratch) / name for name in ("program", "whole", "parts")]
            by_command_line(program, folders[0])
            by_python(folders[1], None)
            by_python(folders[2], 100)
            best = [tuple(map(min, zip(before, seconds(folder))))
                    for before, folder in zip(best, folders)]
        imported = min(imported, import_seconds())
    (reference, outside), *others = best
    ratios = [total / reference for total, _ in others]
    added = [(rest - outside) / reference for _, rest in others]
    kept = "within" if max(added) <= LIMIT else "ABOVE"
    print(f"{kept} the limit: outside the loops Python adds {added[0]:.2%} of a run, in steps of a "
          f"hundred {added[1]:.2%}, of at most {LIMIT:.0%}; not judged: whole runs, {reference:.3f} s "
          f"by the command line ({outside:.3f} s outside the loops), {ratios[0]:.4f} and "
          f"{ratios[1]:.4f} of it by Python; the import of the package, {imported:.3f} s")
    return 0 if max(added) <= LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
