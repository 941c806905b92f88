# SPDX-License-Identifier: BSD-3-Clause
"""Checks a built site: nothing is loaded from a network, and every link leads to a page and to a
place on it.

    python docs/site/offline.py FOLDER
"""

from __future__ import annotations

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

STYLE_URL = re.compile(r"(?:url\(|@import)\s*[\"']?((?:https?:)?//[^\"')\s]+)")
LOADED = {("script", "src"), ("img", "src"), ("iframe", "src"), ("source", "src"), ("video", "src"),
          ("audio", "src"), ("embed", "src"), ("object", "data"), ("link", "href"), ("use", "href")}


class Page(HTMLParser):
    """What a page loads, where it links to, which places it has."""

    def __init__(self, text: str):
        super().__init__()
        self.loads: list[str] = []
        self.links: list[str] = []
        self.places: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if value is None:
                continue
            if (tag, name) in LOADED:
                self.loads.append(value)
            elif tag == "a" and name == "href":
                self.links.append(value)
            elif name == "style":
                self.loads += STYLE_URL.findall(value)
            if name == "id" or (tag == "a" and name == "name"):
                self.places.add(value)


def is_remote(target: str) -> bool:
    return target.startswith("//") or urlsplit(target).scheme in {"http", "https", "ftp"}


def read(folder: Path) -> dict[Path, Page]:
    return {file.resolve(): Page(file.read_text(encoding="utf-8"))
            for file in sorted(folder.rglob("*.html"))}


def link_problem(file: Path, target: str, pages: dict[Path, Page]) -> str:
    parts = urlsplit(target)
    if parts.scheme or target.startswith("//"):
        return ""
    found = (file.parent / unquote(parts.path)).resolve() if parts.path else file
    if not found.is_file():
        return f'"{target}" leads to no file'
    if parts.fragment and found in pages and unquote(parts.fragment) not in pages[found].places:
        return f'"{target}" leads to no place on its page'
    return ""


def problems(folder: Path) -> list[str]:
    """What is wrong with the site in `folder`, a line each."""
    found = []
    pages = read(folder)
    for file, page in pages.items():
        name = file.relative_to(folder.resolve())
        found += [f"{name}: loads {target}" for target in page.loads if is_remote(target)]
        for target in sorted(set(page.links + page.loads)):
            problem = "" if target.startswith("data:") else link_problem(file, target, pages)
            if problem:
                found.append(f"{name}: {problem}")
    for style in sorted(folder.rglob("*.css")):
        found += [f"{style.relative_to(folder)}: loads {target}"
                  for target in STYLE_URL.findall(style.read_text(encoding="utf-8"))]
    if not pages:
        found.append(f"{folder}: no pages")
    return found


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    found = problems(Path(sys.argv[1]))
    for problem in found:
        print(problem, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
