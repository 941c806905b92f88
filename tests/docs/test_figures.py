# SPDX-License-Identifier: BSD-3-Clause
"""The figures of the documents are what their script draws, and all are shown."""

import re
import subprocess
import sys

import pytest

from conftest import ROOT

FOLDER = ROOT / "docs/figures"
NUMBER = re.compile(r"-?\d+\.\d+|-?\d+")
# Names that follow from the digits of what they name.
HASH = re.compile(r"\b[mp][0-9a-f]{10}\b")


def parts(text: str) -> tuple[str, list[float]]:
    """A picture without its numbers, and these."""
    text = HASH.sub("name", text)
    return NUMBER.sub("0", text), [float(number) for number in NUMBER.findall(text)]


def test_the_script_draws_what_is_there(tmp_path):
    subprocess.run([sys.executable, FOLDER / "draw.py", tmp_path], check=True)
    assert sorted(file.name for file in tmp_path.glob("*.svg")) == sorted(
        file.name for file in FOLDER.glob("*.svg"))
    for file in tmp_path.glob("*.svg"):
        drawn, kept = (parts(path.read_text()) for path in (file, FOLDER / file.name))
        assert drawn[0] == kept[0], f"run .venv/bin/python docs/figures/draw.py: {file.name}"
        assert drawn[1] == pytest.approx(kept[1], abs=0.01), file.name


def test_each_figure_is_shown_and_described():
    page = (ROOT / "docs/concepts.md").read_text(encoding="utf-8")
    shown = {name: words for words, name in re.findall(r"!\[(.*)\]\(figures/(.*)\)", page)}
    assert sorted(shown) == sorted(file.name for file in FOLDER.glob("*.svg"))
    assert all(len(words) > 40 for words in shown.values())
