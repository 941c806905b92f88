#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the Python package adds to a run: the loop of the example of three cracks, shortened, driven
by the command line, by Python in one piece, and by Python in steps of a hundred.

Usage: python_bindings.py PROGRAM [ROUNDS]. The package is the one on PYTHONPATH, built from the same
objects as PROGRAM. The three alternate, so that a machine whose speed drifts does not decide, and the
best time of each counts, since what others do on the machine only adds. Exit code 1 when Python takes
more than 1.01 of the time of the command line.
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
OPTIONS = {"time.end": "0.3 ms", "output.interval": "0.15 ms"}
LIMIT = 1.01


def loop_seconds(folder: Path) -> float:
    """Time in the loops of a run and its output: what neither starts a process nor reads a case."""
    summary = json.loads((folder / "summary.json").read_text())
    phases = summary["wall_time_s"]
    return phases["total"] - sum(phases[name] for name in ("case file", "mesh file", "model"))


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


def main() -> int:
    program, rounds = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 12
    warnings.simplefilter("ignore", percolith.CaseWarning)
    os.environ["OMP_NUM_THREADS"] = "1"
    best = [float("inf")] * 3
    for _ in range(rounds):
        with tempfile.TemporaryDirectory() as scratch:
            folders = [Path(scratch) / name for name in ("program", "whole", "parts")]
            by_command_line(program, folders[0])
            by_python(folders[1], None)
            by_python(folders[2], 100)
            best = [min(pair) for pair in zip(best, map(loop_seconds, folders))]
    ratios = best[1] / best[0], best[2] / best[0]
    print(f"command line {best[0]:.3f} s; of it Python takes {ratios[0]:.4f}, in steps of a hundred "
          f"{ratios[1]:.4f}; at most {LIMIT}")
    return 0 if max(ratios) <= LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
