# SPDX-License-Identifier: BSD-3-Clause
"""Cases for the tests of the package. The package is the one on PYTHONPATH with its extension, the
program the one that the variable PERCOLITH names."""

import os
import subprocess
from pathlib import Path

import percolith
import pytest

ROOT = Path(__file__).resolve().parents[2]
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

SHORT = {
    "strip": {"time": {"scheme": "implicit", "step": "1 ms", "end": "0.02 s"},
              "output.times": [0.005, 0.01]},
    "three_cracks": {"time.end": "20 us", "output": {"interval": "5 us"},
                     "probe.tip": {"point": [0.2, 0.1]}},
    "brazilian": {"time.end": "20 us", "output": {"interval": "10 us"}},
}
"""Options that make an example of flow, of both and of mechanics run for a few steps."""


def short_case(name: str) -> percolith.Case:
    case = percolith.Case.load(ROOT / "examples" / name / "case.toml")
    for key, value in SHORT[name].items():
        case[key] = value
    return case


@pytest.fixture
def strip() -> percolith.Case:
    """Water through a strip, twenty steps."""
    return short_case("strip")


@pytest.fixture
def coupled() -> percolith.Case:
    """Three cracks that are driven, for some steps."""
    return short_case("three_cracks")


@pytest.fixture
def mechanics() -> percolith.Case:
    """A disc under load, for some steps."""
    return short_case("brazilian")


@pytest.fixture
def program():
    """program(*arguments) runs the command line; returns the ended process."""
    path = os.environ.get("PERCOLITH", ROOT / "build/release/bin/percolith")

    def run(*arguments):
        return subprocess.run([path, *map(str, arguments)], capture_output=True, text=True,
                              check=False, timeout=120)

    return run
