# SPDX-License-Identifier: BSD-3-Clause
"""The numbers of equations: each row of a table that has one becomes a place to link to, and what
refers to a number leads there. An equation without a line of code that computes it is a problem."""

from __future__ import annotations

import re

from markdown_text import CELLS, outside, read_lines

THEORY, PAPER = "docs/theory.md", "docs/equations.md"
OF_PAPER = re.compile(r"\((\d+)\)")
OWN = re.compile(r"\b([PMC]\d+)\b")
RANGE = re.compile(r"\((\d+)\)–\((\d+)\)")
# An equation in running text is introduced as `P7:` or `**Step size**, P7`.
LOOSE = re.compile(r"\b([PMC]\d+)(?=:)|(?<=\*\*, )([PMC]\d+)")


def numbers(cell: str) -> list[str]:
    """The numbers in the first cell of a row: `P1`, `11`, and all of `(14)–(16)`."""
    cell = RANGE.sub(lambda r: " ".join(f"({n})" for n in range(int(r[1]), int(r[2]) + 1)), cell)
    return OWN.findall(cell) + OF_PAPER.findall(cell)


def is_numbered(cell: str) -> bool:
    return bool(numbers(cell)) and not re.sub(r"\(\d+\)|[PMC]\d+|[ ,–]", "", cell)


def rows(text: str) -> list[tuple[int, list[str]]]:
    """Line and cells of each row with a number."""
    found = []
    for line in read_lines(text):
        cells = CELLS.split(line.text)
        if not line.code and line.text.startswith("|") and is_numbered(cells[1]):
            found.append((line.number, cells))
    return found


def own_places(text: str) -> set[str]:
    """The numbers that have a row in a text or are introduced in it."""
    loose = {first or second for first, second in LOOSE.findall(text)}
    return loose | {number for _, cells in rows(text) for number in numbers(cells[1])}


def with_numbers(file: str, text: str, places: dict[str, set[str]], problems: list[str]) -> str:
    """`text` of the page on theory or on the paper with places and references; `places` are the
    numbers that have a row, by page."""
    numbered = dict(rows(text))
    code = ""
    made = []
    seen: set[str] = set()
    for line in read_lines(text):
        cells = numbered.get(line.number)
        if cells is None:
            code = code if line.text.startswith("|") else ""
            made.append(line.text if line.code else _prose(line.text, places, set()))
            continue
        if file == THEORY:
            # The code of the row above computes this one too where none is named.
            code = cells[-2] if cells[-2].strip() else code
            cells[-2] = code
            if 'class="line"' not in code:
                problems.append(f"{file}:{line.number}: no function is named for "
                                f"{cells[1].strip()}")
        own = set(numbers(cells[1]))
        marks = "".join(f'<span class="place" id="eq-{number}"></span>'
                        for number in sorted(own - seen))
        seen |= own
        first = _across(file, cells[1], places)
        rest = [_prose(cell, places, own) for cell in cells[2:]]
        made.append("|".join([cells[0], " " + marks + first.lstrip(), *rest]))
    whole = "\n".join(made) + "\n"
    return _with_loose_places(whole, seen) if file == THEORY else whole


def _with_loose_places(text: str, seen: set[str]) -> str:
    """Places for the equations that running text introduces, where references stand by now; `seen`
    are those that have a row."""
    reference = r'<a class="equation" href="theory\.html#eq-([PMC]\d+)">\1</a>'

    def introduce(match: re.Match[str]) -> str:
        number = match[1] or match[2]
        if number in seen:
            return match[0]
        return f'<span class="place" id="eq-{number}">{number}</span>'

    return re.sub(rf"{reference}(?=:)|(?<=\*\*, ){reference.replace('1<', '2<')}", introduce, text)


def _link(page: str, number: str, shown: str) -> str:
    return f'<a class="equation" href="{page}.html#eq-{number}">{shown}</a>'


def _across(file: str, cell: str, places: dict[str, set[str]]) -> str:
    """The first cell of a row, from where the paper's numbers lead to the other page."""
    page, other = ("equations", PAPER) if file == THEORY else ("theory", THEORY)
    return OF_PAPER.sub(
        lambda m: _link(page, m[1], m[0]) if m[1] in places[other] else m[0], cell)


def _prose(text: str, places: dict[str, set[str]], own: set[str]) -> str:
    """`text` with links from numbers to the theory, or to the paper's page where the theory has no
    such row; a row does not refer to its own numbers."""

    def refer(match: re.Match[str]) -> str:
        number = match[1]
        if number in own:
            return match[0]
        if number in places[THEORY]:
            return _link("theory", number, match[0])
        return _link("equations", number, match[0]) if number in places[PAPER] else match[0]

    return outside(text, lambda part: OWN.sub(refer, OF_PAPER.sub(refer, part)))
