# SPDX-License-Identifier: BSD-3-Clause
"""`pip install .` leaves no file that git would list."""

import shutil
import subprocess
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def test_git_ignores_where_the_wheel_is_built():
    if shutil.which("git") is None or not (ROOT / ".git").exists():
        pytest.skip("no checkout")
    folder = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["scikit-build"]["build-dir"]
    done = subprocess.run(["git", "check-ignore", f"{folder}/CMakeCache.txt"], cwd=ROOT,
                          capture_output=True, check=False)
    assert done.returncode == 0
    assert f"`{folder}`" in (ROOT / "docs/python.md").read_text()
