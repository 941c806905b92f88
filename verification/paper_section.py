# SPDX-License-Identifier: BSD-3-Clause
"""The section of the page that goes through the figures of the paper: of each the pictures that
stand for it, its reference, and the rows that judge it, as the chapters have them."""

from __future__ import annotations

import html
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

import page
from paper_figures import PaperFigure

if TYPE_CHECKING:
    from report import Chapter, Picture, Row


@dataclass
class Found:
    """A figure of the paper with what its chapter, None where that did not run, has for it."""

    figure: PaperFigure
    chapter: Chapter | None
    pictures: list[Picture] = field(default_factory=list)
    rows: list[Row] = field(default_factory=list)
    lacking: list[str] = field(default_factory=list)

    @property
    def key(self) -> str:
        return f"figure_{self.figure.number}"

    @property
    def state(self) -> str:
        """pass, fail, not run, or set-up where nothing judges."""
        if self.chapter is None:
            return "not run"
        if self.lacking or not all(row.passes for row in self.rows):
            return "fail"
        return "pass" if self.rows else "set-up"


def find(figures: Sequence[PaperFigure], chapters: list[Chapter]) -> list[Found]:
    """The figures in order with their pictures and rows. What a figure names and its chapter does
    not have is lacking; so is a picture or a row where it names none."""
    by_name = {chapter.name: chapter for chapter in chapters}
    return [_find(figure, by_name.get(figure.chapter)) for figure in figures]


def _find(figure: PaperFigure, chapter: Chapter | None) -> Found:
    found = Found(figure, chapter)
    if chapter is None:
        return found
    for name in figure.pictures:
        chosen = [picture for picture in chapter.pictures if picture.name == name]
        found.pictures += chosen
        if not chosen:
            found.lacking.append(f"{figure.chapter} has no picture {name}")
    for pattern in figure.rows:
        if not any(_matches(row, chapter, pattern) for row in chapter.rows):
            found.lacking.append(f"{figure.chapter} has no row {pattern}")
    found.rows = [row for row in chapter.rows
                  if any(_matches(row, chapter, pattern) for pattern in figure.rows)]
    if not figure.pictures:
        found.lacking.append("it names no picture")
    if not figure.rows and not figure.is_set_up:
        found.lacking.append("it names no row")
    return found


def _matches(row: Row, chapter: Chapter, pattern: str) -> bool:
    return fnmatchcase(row.id, f"{chapter.name}.{pattern}")


def notes(figures: Sequence[PaperFigure]) -> dict[tuple[str, str], str]:
    """What the chapters say under their pictures: the figures of the paper they stand for."""
    numbers = defaultdict(list)
    for figure in figures:
        for name in figure.pictures:
            numbers[figure.chapter, name].append(figure.number)
    return {key: " (for the paper's " + ", ".join(f'<a href="#figure_{number}">figure {number}</a>'
                                                for number in found) + ")"
            for key, found in numbers.items()}


_COLOURS = {"pass": "pass", "fail": "fail", "not run": "idle", "set-up": "idle"}
_INTRODUCTION = """The paper is <i>A 2D mixed fracture–pore seepage model and hydromechanical
coupling for fractured porous media</i>. Its figures 1 to 12 are sketches of the method, a flow
chart and the sketch of the first example. Each later one is here in its order: left what the
program gives, right what it is compared with and how. A picture leads to its full size in the
chapter it is from. Green: all comparisons pass; grey: a set-up, which nothing judges, or not run
this time."""


def section(found: list[Found]) -> str:
    links = "".join(f'<a class="{_COLOURS[entry.state]}" href="#{entry.key}" '
                    f'title="{entry.state}">{entry.figure.number}</a>' for entry in found)
    return (f'<h2 id="figures">The figures of the paper</h2><p>{_INTRODUCTION}</p>'
            f'<p class="links">Figure {links}</p>' + "\n".join(_entry(entry) for entry in found))


def _entry(found: Found) -> str:
    figure = found.figure
    mark = f'<span class="mark {_COLOURS[found.state]}">{found.state}</span>'
    return (f'<article class="paper" id="{found.key}"><h3>Figure {figure.number}: '
            f"{html.escape(figure.shows)} {mark}</h3>{_body(found)}</article>")


def _body(found: Found) -> str:
    figure = found.figure
    if found.chapter is None:
        pictures = (f"<p>Not run this time: <code>python verification/run.py {figure.chapter}"
                    "</code></p>")
        judged = ""
    else:
        pictures = "".join(_picture(found.chapter, picture) for picture in found.pictures)
        judged = page.row_table(found.rows) if found.rows else ""
        judged += (f'<p>From the chapter <a href="#{figure.chapter}">'
                   f"{html.escape(found.chapter.title)}</a>.</p>")
    lacking = "".join(f"<pre>Missing: {html.escape(what)}</pre>" for what in found.lacking)
    name = "Set-up" if figure.is_set_up else "Reference"
    told = f"<p><b>{name}.</b> {html.escape(figure.set_up or figure.reference)}</p>"
    if figure.differs:
        told += f'<p class="differs"><b>Not as in the paper.</b> {html.escape(figure.differs)}</p>'
    return (f'<div class="beside"><div>{lacking}{pictures}</div><div>{told}{judged}</div></div>')


def _picture(chapter: Chapter, picture: Picture) -> str:
    return (f'<figure><a href="#{page.anchor(chapter, picture)}">{page.image(picture)}</a>'
            f"<figcaption>{html.escape(picture.caption)}</figcaption></figure>")
