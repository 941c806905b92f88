# SPDX-License-Identifier: BSD-3-Clause
"""Makes the package and the helpers of the verification importable; runs examples once."""

import sys
from pathlib import Path

import matplotlib.pyplot as plt
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "verification")]


@pytest.fixture(autouse=True)
def closed_figures():
    """pyplot keeps every figure until it is closed."""
    yield
    plt.close("all")


@pytest.fixture(scope="module")
def block(tmp_path_factory):
    """A run of mechanics that no program has made."""
    from percolith import RunDirectory
    from synthetic_run import write_mechanics_run

    return RunDirectory(write_mechanics_run(tmp_path_factory.mktemp("block") / "results"))


@pytest.fixture(scope="module")
def coupled(tmp_path_factory):
    """The same of fluid that breaks rock."""
    from percolith import RunDirectory
    from synthetic_coupled_run import write_coupled_run

    return RunDirectory(write_coupled_run(tmp_path_factory.mktemp("coupled") / "results"))


@pytest.fixture(scope="session")
def run_example(tmp_path_factory):
    """run(name, **settings) -> Result of an example as shipped, or with replaced options; each is
    run once a session. In a name of an option write `__` for the dot."""
    from program import run_case

    done = {}

    def run(name: str, **settings):
        key = (name, repr(sorted(settings.items())))
        if key not in done:
            options = {option.replace("__", "."): value for option, value in settings.items()}
            case = ROOT / "examples" / name / "case.toml"
            done[key] = run_case(case, tmp_path_factory.mktemp(name) / "results", options)
        return done[key]

    return run
