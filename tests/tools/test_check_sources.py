# SPDX-License-Identifier: BSD-3-Clause
"""The checks that hold for every file find what they must find, and nothing else."""

from pathlib import Path

import check_sources
import pytest

LICENCE = "// SPDX-License-Identifier: BSD-3-Clause"


@pytest.mark.parametrize("name, text, problems", [
    ("a.cpp", [LICENCE, "int a;"], 0),
    ("a.cpp", ["int a;", LICENCE], 1),
    ("a.cpp", [], 1),
    ("a.sh", ["#!/bin/sh", LICENCE.replace("//", "#")], 0),
    ("a.sh", ["#!/bin/sh"], 1),
    ("Makefile", ["all:"], 1),
    ("notes.md", ["all"], 0),
])
def test_licence(name, text, problems):
    assert len(check_sources.licence(Path(name), text)) == problems


def test_length():
    assert check_sources.length(Path("a.cpp"), [""] * 800) == []
    assert check_sources.length(Path("a.cpp"), [""] * 801) == ["a.cpp: 801 lines; allowed: 800"]
    assert check_sources.length(Path("table.csv"), [""] * 801) == []


def test_unfinished():
    marker = "TO" + "DO"
    found = check_sources.unfinished(Path("a.cpp"), ["int a;", f"// {marker}: more"])
    assert found == [f"a.cpp:2: unfinished: // {marker}: more"]
    assert check_sources.unfinished(Path("a.cpp"), ["// a mastodon"]) == []


@pytest.mark.parametrize("folder", ["work", "root", "home", "tmp"])
def test_machine_paths_are_found(folder):
    assert len(check_sources.machine_paths(Path("a.md"), [f"see /{folder}/percolith"])) == 1


@pytest.mark.parametrize("start, folder, rest", [
    ("see build", "work", "/percolith"), ("${scratch}", "tmp", "/a"), ("", "usr", "/bin/python3"),
    ("p", "root", "/q"), ("a ", " root", ""),
])
def test_other_paths_are_not(start, folder, rest):
    assert check_sources.machine_paths(Path("a.md"), [f"{start}/{folder}{rest}"]) == []
