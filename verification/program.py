# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program on a case file."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "python"))

from percolith import RunDirectory  # noqa: E402


class ProgramError(RuntimeError):
    """The program cannot be found, or a run failed."""


@dataclass
class Result:
    """A finished run: its results and the seconds the program took."""

    results: RunDirectory
    wall_time: float

    @property
    def balance(self) -> float:
        """Error of the mass balance over fluid in place and throughput."""
        return self.results.summary["mass_balance"]["relative_error"]

    @property
    def energy_error(self) -> float:
        """Error of the energy balance over the largest energy or work."""
        return self.results.summary["mechanics"]["energy_error"]


def program() -> Path:
    """The program that the variable PERCOLITH names, else that of `make build`."""
    path = Path(os.environ.get("PERCOLITH", ROOT / "build/release/bin/percolith"))
    if not path.is_file():
        raise ProgramError(f"{path}: no such program; run `make build` or set PERCOLITH")
    return path


def in_toml(value) -> str:
    """A value as `--set` reads it: a number, text, list or table; empty for None."""
    if value is None:
        return ""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {in_toml(entry)}" for key, entry in value.items()) + " }"
    # JSON writes numbers, texts and lists of them as TOML reads them.
    return json.dumps(value)


def run_case(case: Path, output: Path, settings: dict | None = None, threads: int = 2) -> Result:
    """Runs `case` into the directory `output`, replacing earlier results. `settings` replaces
    options of the case by their dotted path; values are numbers, texts, lists or tables of them, in
    SI units, or None to take an option out.
    Raises ProgramError with what the program said when it fails."""
    command = [str(program()), "run", str(case), "--output", str(output), "--force", "--quiet",
               "--threads", str(threads)]
    for key, value in (settings or {}).items():
        command += ["--set", f"{key}={in_toml(value)}"]
    environment = {**os.environ, "OMP_WAIT_POLICY": "passive"}
    output.parent.mkdir(parents=True, exist_ok=True)
    start = time.perf_counter()
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    elapsed = time.perf_counter() - start
    if done.returncode != 0:
        raise ProgramError(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}")
    return Result(RunDirectory(output), elapsed)
