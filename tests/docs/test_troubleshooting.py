# SPDX-License-Identifier: BSD-3-Clause
"""Each message that the page on troubleshooting quotes is still in the sources."""

import re
from functools import cache

import markdown_text
import pytest

from conftest import ROOT

PAGE = (ROOT / "docs/troubleshooting.md").read_text(encoding="utf-8")
MESSAGES = [heading.strip("`") for level, heading in markdown_text.headings(PAGE) if level == 3]
LITERALS = re.compile(r'"((?:[^"\\\n]|\\.)*)"')


def spoken(text: str) -> str:
    """What a source says to its user: its literals, with `…` for the places of values."""
    text = re.sub(r"^\s*(?://|#).*$", "", text, flags=re.MULTILINE)
    said = "".join(piece for piece in LITERALS.findall(text))
    said = said.replace('\\"', '"').replace("{{", "\1").replace("}}", "\2")
    return re.sub(r"\{[^{}]*\}", "…", said).replace("\1", "{").replace("\2", "}")


@cache
def sources() -> dict[str, str]:
    folders = [*ROOT.glob("src/percolith/**/*.[ch]pp"), *ROOT.glob("python/percolith/**/*.py")]
    said = {str(file.relative_to(ROOT)): spoken(file.read_text(encoding="utf-8"))
            for file in folders}
    # A script of the shell says what stands in it.
    said["tools/setup.sh"] = (ROOT / "tools/setup.sh").read_text(encoding="utf-8")
    return said


def is_said(message: str, said: str) -> bool:
    """Whether a source says all parts of a message, in their order."""
    at = 0
    for part in (part.strip() for part in message.split("…")):
        at = said.find(part, at)
        if at < 0:
            return False
        at += len(part)
    return True


@pytest.mark.parametrize("message", MESSAGES)
def test_the_program_says_so(message):
    assert max(len(part) for part in message.split("…")) >= 10, "too little to be recognised"
    assert any(is_said(message, said) for said in sources().values())


def test_there_are_many_and_each_is_explained():
    assert len(MESSAGES) > 45
    parts = re.split(r"^### .*$", PAGE, flags=re.MULTILINE)[1:]
    for message, part in zip(MESSAGES, parts, strict=True):
        assert len(re.sub(r"^## .*$", "", part, flags=re.MULTILINE).split()) >= 8, message


def test_what_is_not_said_is_found():
    said = spoken('fail("the mesh has {} triangles" " of {:g} m");  // the mesh is fine\n'
                  '  // "a comment"\n')
    assert said == "the mesh has … triangles of … m"
    assert is_said("the mesh has … triangles of … m", said)
    assert not is_said("the mesh has … corners", said)
    assert not is_said("triangles … the mesh", said)
