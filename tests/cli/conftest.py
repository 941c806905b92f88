# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program that the variable PERCOLITH names, else that of `make build`."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="session")
def program() -> Path:
    path = Path(os.environ.get("PERCOLITH", ROOT / "build/release/bin/percolith")).resolve()
    assert path.is_file(), f"{path}: no such program; run `make build` or set PERCOLITH"
    return path


@pytest.fixture
def percolith(program, tmp_path):
    """percolith(*arguments) -> the ended process, with its output as text."""

    def run(*arguments, cwd=tmp_path, env=None, **options):
        environment = {**os.environ, "OMP_WAIT_POLICY": "passive", **(env or {})}
        options = {"timeout": 120, **options}
        return subprocess.run([program, *map(str, arguments)], cwd=cwd, env=environment,
                              capture_output=True, text=True, check=False, **options)

    return run


def _copy(name: str, folder: Path) -> Path:
    shutil.copytree(ROOT / "examples" / name, folder, ignore=shutil.ignore_patterns("*.results"))
    return folder / "case.toml"


@pytest.fixture
def strip(tmp_path) -> Path:
    """Case file of a copy of the strip example."""
    return _copy("strip", tmp_path / "strip")


@pytest.fixture
def six_fractures(tmp_path) -> Path:
    """Case file of a copy of the example with six fractures."""
    return _copy("six_fractures", tmp_path / "six_fractures")


STEADY = ("--set", "time.scheme=steady", "--set", "time.step=", "--set", "time.end=",
          "--set", "output.times=")
"""Makes a short run of an example in time."""

SHORT = ("--set", "time.step=1 ms")
"""Makes the strip run in twenty steps."""

ENDLESS = ("--set", "time.scheme=explicit", "--set", "time.step=", "--set", "time.end=1e6 s")
"""Makes the strip take millions of steps."""


def line_of(case: Path, text: str) -> int:
    """Number of the first line of `case` that contains `text`."""
    for number, line in enumerate(case.read_text().splitlines(), start=1):
        if text in line:
            return number
    raise ValueError(text)


def files_of(folder: Path) -> dict[str, bytes]:
    """Every file in `folder` with its content."""
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in sorted(folder.rglob("*")) if path.is_file()}
