# SPDX-License-Identifier: BSD-3-Clause
"""The parts of a Markdown text that the site and its tests look at: code, headings, links."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass

CELLS = re.compile(r"(?<!\\)\|")  # between the cells of a row of a table
FENCE = re.compile(r"^(\s*)(```+)\s*(\w*)")
HEADING = re.compile(r"^(#{1,6}) +(.*?)\s*$")
INLINE = re.compile(r"(?P<image>!?)\[(?P<text>(?:`[^`]*`|[^\[\]`])*)\]\((?P<target>[^()\s]+)\)"
                    r"|``(?P<quoted>(?:[^`]|`(?!`))+)``|`(?P<code>[^`]+)`"
                    r"|\$(?P<math>[^$\n]+)\$|<(?P<html>[^<> ][^<>]*)>")
Inline = re.Match[str]


@dataclass(frozen=True)
class Line:
    """A line of a text, from 1 on, and whether it is (part of) a block of code."""

    number: int
    text: str
    code: bool


@dataclass(frozen=True)
class Block:
    """A fenced block: its language, its text, its first line, and the last prose before it."""

    language: str
    text: str
    line: int
    before: str


def read_lines(text: str) -> Iterator[Line]:
    """The lines with what is code marked: fences, and what is indented by four after a blank."""
    fence = ""
    blank, indented = True, False
    for number, line in enumerate(text.splitlines(), 1):
        opening = FENCE.match(line)
        if fence:
            yield Line(number, line, True)
            if opening and opening[2] == fence and not opening[3]:
                fence = ""
            continue
        if opening:
            fence = opening[2]
            yield Line(number, line, True)
            continue
        indented = line.startswith("    ") and (blank or indented)
        yield Line(number, line, indented)
        blank = not line.strip()


def blocks(text: str) -> list[Block]:
    """The fenced blocks of a text."""
    found, inside, language, start, before = [], None, "", 0, ""
    for line in read_lines(text):
        opening = FENCE.match(line.text)
        if inside is None:
            if line.code and opening:
                inside, language, start = [], opening[3], line.number
            elif line.text.strip():
                before = line.text
        elif opening and not opening[3]:
            found.append(Block(language, "".join(inside), start, before))
            inside = None
        else:
            inside.append(line.text + "\n")
    return found


def plain(text: str) -> str:
    """A heading or a sentence without marks of code, links and emphasis."""
    text = INLINE.sub(_words, text)
    return re.sub(r"[`*]", "", text)


def _words(part: Inline) -> str:
    return part["text"] or part["quoted"] or part["code"] or part["math"] or ""


def headings(text: str) -> list[tuple[int, str]]:
    """Level and text of each heading."""
    return [(len(match[1]), match[2]) for line in read_lines(text) if not line.code
            for match in [HEADING.match(line.text)] if match]


def title(text: str) -> str:
    """The text of the first heading."""
    return plain(headings(text)[0][1])


def anchors(text: str) -> set[str]:
    """What a link may have after `#`, by the rule of code hosts: small letters and hyphens."""
    seen: Counter[str] = Counter()
    found = set()
    for _, heading in headings(text):
        slug = re.sub(r"[^\w\- ]", "", plain(heading).lower()).replace(" ", "-")
        found.add(f"{slug}-{seen[slug]}" if seen[slug] else slug)
        seen[slug] += 1
    return found


def links(text: str) -> Iterator[tuple[int, str]]:
    """Line and target of each link and picture outside code."""
    for line in read_lines(text):
        if not line.code:
            yield from ((line.number, match["target"]) for match in INLINE.finditer(line.text)
                        if match["target"])


def rewrite(text: str, change: Callable[[Inline], str]) -> str:
    """A line with each link, span of code and formula replaced by what `change` makes of it."""
    return INLINE.sub(change, text)


def outside(text: str, change: Callable[[str], str]) -> str:
    """A line in which `change` has been applied to what is no link, code, formula or HTML."""
    pieces, end = [], 0
    for match in INLINE.finditer(text):
        pieces += [change(text[end:match.start()]), match[0]]
        end = match.end()
    return "".join([*pieces, change(text[end:])])
