# SPDX-License-Identifier: BSD-3-Clause
"""The package without its extension, as it lies in the sources."""

import os
import subprocess
import sys

import pytest

from conftest import ROOT


@pytest.mark.parametrize("name", ["Case", "sweep", "__version__"])
def test_what_needs_the_build_says_so(name):
    code = f"import percolith; percolith.{name}"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False,
                          env={**os.environ, "PYTHONPATH": str(ROOT / "python")})
    assert done.returncode == 1
    assert "percolith was not built to run cases from Python: install it with" in done.stderr
