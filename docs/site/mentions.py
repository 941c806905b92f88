# SPDX-License-Identifier: BSD-3-Clause
"""What the documents name of the code - files, functions, types, tests - as links to the line.

A name in a column headed `code`, `where` or `covered by`, one right behind a link to a source, and
one with `::` must exist; in the documents that STRICT lists, every name must: it is in the code, or
an option, or a name of the results.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from functools import cache
from pathlib import PurePosixPath

import links
import site_map
from markdown_text import CELLS, Inline, read_lines, rewrite
from symbols import Symbols

COLUMNS = {"code", "where", "covered by"}
STRICT = {"docs/theory.md", "docs/equations.md"}
LINKED = STRICT | {"ARCHITECTURE.md"}
CODE = (".cpp", ".hpp", ".cu", ".py")
NAME = re.compile(r"[A-Za-z]\w*(?:(?:::|\.)\w+)?")
# What may stand between a link to a source and the names in it.
BETWEEN = re.compile(r"(?:,| and| with)? ")
FOREIGN = ("std::", "percolith::")
FOLDERS = ("src", "tests", "verification", "examples", "tools", "bench", "python", "docs")


@dataclass
class Names:
    """All that a document may name."""

    symbols: Symbols
    words: set[str]
    """Options and names of results, whole and the last part of dotted ones."""
    by_end: dict[str, list[str]]
    """Files by their last part and by what stands below `src/percolith/`."""


def collect(files: set[str]) -> Names:
    code = [file for file in files if file.endswith(CODE)]
    by_end: dict[str, list[str]] = {}
    for file in sorted(code + [file for file in files if file.endswith(".hpp.in")]):
        parts = PurePosixPath(file.removesuffix(".in")).parts
        below = file.removeprefix("src/percolith/")
        for end in {parts[-1], "/".join(parts[-2:]), below}:
            by_end.setdefault(end, []).append(file)
    return Names(Symbols(code), _words(), by_end)


@cache
def _words() -> set[str]:
    found = set()
    for page in ("options", "run-directory"):
        text = (site_map.ROOT / f"docs/{page}.md").read_text(encoding="utf-8")
        for span in re.findall(r"`\[*([^`]+?)\]*`", text):
            found |= {span, *re.findall(r"[A-Za-z]\w*", span)}
    return found


@dataclass
class Reader:
    """Goes through one document line by line."""

    site: links.Site
    names: Names
    file: str
    problems: list[str]
    source: str = ""
    """The source that was linked last in this section."""
    columns: list[str] = field(default_factory=list)
    adjoining: int = -1
    """Where a link to a source, or a name in it, has just ended."""
    number: int = 0

    def read(self, text: str) -> str:
        made = []
        for line in read_lines(text):
            self.number = line.number
            if line.code:
                made.append(line.text)
                continue
            if line.text.startswith("#"):
                self.source = ""
            if line.text.startswith("|"):
                made.append(self.row(line.text))
            else:
                self.columns = []
                made.append(self.prose(line.text, must=False))
        return "\n".join(made) + "\n"

    def row(self, text: str) -> str:
        cells = CELLS.split(text)
        if not self.columns:
            self.columns = [cell.strip() for cell in cells]
            return text
        return "|".join(
            self.prose(cell, must=i < len(self.columns) and self.columns[i] in COLUMNS)
            for i, cell in enumerate(cells))

    def prose(self, text: str, must: bool) -> str:
        self.adjoining = -1
        return rewrite(text, lambda part: self.change(part, must))

    def change(self, part: Inline, must: bool) -> str:
        if part["target"]:
            return self.link(part)
        if not part["code"]:
            return part[0]
        name = part["code"]
        behind = self.adjoining >= 0 and BETWEEN.fullmatch(part.string[self.adjoining:part.start()])
        made = self.of_file(name) or self.of_symbol(name, bool(behind) or must or "::" in name)
        if made and behind:
            self.adjoining = part.end()
        return made or part[0]

    def link(self, part: Inline) -> str:
        target = part["target"]
        if not re.match(r"\w+:", target) and not part["image"]:
            try:
                found, _ = links.resolve(self.site, self.file, target)
            except links.Missing:
                return part[0]  # which the links of the page report
            if found.endswith(CODE):
                self.source = found
                self.adjoining = part.end()
        return part[0]

    def of_file(self, name: str) -> str:
        """A link for the path of a file or folder; "" where `name` is none."""
        path = name.rstrip("/")
        if path.split("/")[0] in FOLDERS and "/" in path and re.fullmatch(r"[\w./-]+", path):
            if path in self.site.files:
                return self.linked(path, name)
            if not links.inside(path, self.site):
                self.problem(f"`{name}`: no such file")
            elif f"{path}/README.md" in self.site.pages:
                way = site_map.relative(path, self.file)
                return f"[`{name}`]({way})"
        elif path.endswith((".cpp", ".hpp")) and re.fullmatch(r"[\w./-]+", path):
            return self.of_source(path, name)
        return ""

    def of_source(self, path: str, name: str) -> str:
        found = self.names.by_end.get(path, [])
        if not found:
            self.problem(f"`{name}`: no such file")
        beside = [file for file in found if PurePosixPath(file).parent
                  == PurePosixPath(self.source).parent]
        for chosen in (found, beside):
            if len(chosen) == 1:
                self.source = chosen[0]
                return self.linked(chosen[0], name)
        if found and self.file in STRICT:
            self.problem(f"`{name}`: more than one such file")
        return ""

    def of_symbol(self, name: str, must: bool) -> str:
        """A link for a name in the code; "" where it is none, which is a problem if it must be."""
        if not NAME.fullmatch(name) or name.startswith(FOREIGN):
            return ""
        if self.source:
            line = self.names.symbols.line(self.source, name)
            if line and (must or name not in self.names.words):
                return self.linked(self.source, name, line)
        if self.file not in LINKED and not must:
            return ""
        place = None if name in self.names.words and not must else self.names.symbols.place(name)
        if place and ("::" in name or not must):
            return self.linked(place[0], name, place[1])
        if must or (self.file in STRICT and not self.is_word(name)):
            self.problem(f"`{name}`: not found in {self.source or 'the sources'}")
        return ""

    def is_word(self, name: str) -> bool:
        return (name in self.names.words or self.names.symbols.knows(name)
                or all(part in self.names.words for part in name.split(".")))

    def linked(self, file: str, name: str, line: int | None = None) -> str:
        if self.file in LINKED or line:
            return links.source_link(self.site, self.site.pages[self.file], file, f"`{name}`", line)
        return ""

    def problem(self, what: str) -> None:
        self.problems.append(f"{self.file}:{self.number}: {what}")


def with_places(site: links.Site, names: Names, file: str, text: str, problems: list[str]) -> str:
    """`text` of `file` with its mentions of the code as links to their lines."""
    return Reader(site, names, file, problems).read(text)
