# SPDX-License-Identifier: BSD-3-Clause
"""The version stands in CMakeLists.txt; files that cannot ask it there repeat it."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def test_the_citation_has_the_version_of_the_program():
    project = (ROOT / "CMakeLists.txt").read_text()
    (version,) = re.findall(r"^project\(percolith VERSION ([0-9.]+)", project, re.MULTILINE)
    cited = re.findall(r"^version: (\S+)$", (ROOT / "CITATION.cff").read_text(), re.MULTILINE)
    assert cited == [version]
