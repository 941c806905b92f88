# SPDX-License-Identifier: BSD-3-Clause
"""Every equation of the paper is on the page that maps equations to code, and what the page names
exists."""

import re
from pathlib import Path

import pytest

DOCS = Path(__file__).resolve().parents[2] / "docs"
ROWS = [re.split(r"(?<!\\)\|", line)[1:-1]
        for line in (DOCS / "equations.md").read_text(encoding="utf-8").splitlines()
        if re.match(r"\| \(\d+\) \|", line)]
LINK_OR_NAME = re.compile(r"\[`[^`]+`\]\(([^)#]+)\)|`([^`]+)`")


def places(cell: str) -> list[tuple[Path, list[str]]]:
    """Linked files of a cell, each with the names that follow its link."""
    found: list[tuple[Path, list[str]]] = []
    for link, name in LINK_OR_NAME.findall(cell):
        if link:
            found.append(((DOCS / link).resolve(), []))
        else:
            found[-1][1].append(name)
    return found


def is_named(name: str, text: str) -> bool:
    """Whether a source defines or uses a name; a unit test is named as `Suite.Test`."""
    if "." in name:
        suite, test = name.split(".")
        return re.search(rf"^TEST(_P|_F)?\({suite},\s*{test}\)", text, re.MULTILINE) is not None
    return re.search(rf"\b{name}\b", text) is not None


def test_every_equation_has_one_row():
    numbers = [int(row[0].strip(" ()")) for row in ROWS]
    assert numbers == list(range(1, 46))


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[0].strip())
def test_code_and_tests_of_a_row_exist(row):
    for cell in (row[2], row[3]):
        found = places(cell)
        assert found, cell
        for file, names in found:
            assert file.is_file(), file
            text = file.read_text(encoding="utf-8")
            assert [name for name in names if not is_named(name, text)] == [], file


def test_what_is_missing_is_found():
    assert not is_named("Suite.Test", "TEST(Suite, Tests) {}")
    assert is_named("Suite.Test", "TEST_P(Suite,\n       Test) {}")
    assert not is_named("flow", "pore_flow(1);")
