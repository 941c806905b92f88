# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program that the variable PERCOLITH names, else that of `make build`."""

import os
import re
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


def _copy(name: str, folder: Path, stepping: str) -> Path:
    """Copies an example, with `stepping` in place of its tables `time` and `output`, so that the
    tests do not depend on how the example is tuned."""
    shutil.copytree(ROOT / "examples" / name, folder, ignore=shutil.ignore_patterns("*.results"))
    case = folder / "case.toml"
    text = re.sub(r"^\[(time|output)\]\n(?:(?!\[).*\n)*", "", case.read_text(), flags=re.MULTILINE)
    case.write_text(text.rstrip("\n") + "\n\n" + stepping)
    return case


@pytest.fixture
def strip(tmp_path) -> Path:
    """Case file of a strip from 100 kPa to 0, at most 20 us a step up to 0.02 s."""
    return _copy("strip", tmp_path / "strip",
                 '[time]\nscheme = "implicit"\nstep = "20 us"\nend = "0.02 s"\n'
                 "[output]\ntimes = [0.001, 0.005, 0.01]\n")


@pytest.fixture
def six_fractures(tmp_path) -> Path:
    """Case file of a block with six fractures, up to 3 h."""
    return _copy("six_fractures", tmp_path / "six_fractures",
                 '[time]\nscheme = "implicit"\nend = "3 hour"\n'
                 '[output]\ntimes = ["1 hour"]\n')


STEADY = ("--set", "time.scheme=steady", "--set", "time.step=", "--set", "time.end=",
          "--set", "output.times=", "--set", "initial=")
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
