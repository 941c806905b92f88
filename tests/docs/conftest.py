# SPDX-License-Identifier: BSD-3-Clause
"""Makes the scripts of docs/site importable, and runs the program that the variable PERCOLITH names,
else that of `make build`."""

import os
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))


@pytest.fixture(scope="session")
def program() -> Path:
    path = Path(os.environ.get("PERCOLITH", ROOT / "build/release/bin/percolith")).resolve()
    assert path.is_file(), f"{path}: no such program; run `make build` or set PERCOLITH"
    return path
