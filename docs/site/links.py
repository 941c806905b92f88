# SPDX-License-Identifier: BSD-3-Clause
"""Links of a Markdown file turned into links of the site."""

from __future__ import annotations

import html
import posixpath
import re
from dataclasses import dataclass, field
from functools import cache

import markdown_text
import site_map

PICTURES = (".png", ".gif", ".svg")


class Missing(Exception):
    """A link or a mention that leads nowhere."""


@dataclass
class Site:
    """What links may lead to, and what they led to."""

    files: set[str]
    pages: dict[str, str]
    sources: set[str] = field(default_factory=set)
    """Files and folders that are shown as sources because something links to them."""
    pictures: set[str] = field(default_factory=set)


def open_site() -> Site:
    files = site_map.tracked()
    return Site(set(files), site_map.pages(files))


def inside(folder: str, site: Site) -> list[str]:
    return sorted(file for file in site.files if file.startswith(f"{folder}/"))


def _code(span: re.Match[str]) -> str:
    """A name as code that may be broken between its words where a column is narrow."""
    return f"<code>{re.sub(r'(?<=[a-z.])(?=[A-Z])|(?<=[_/])(?=.)', '<wbr>', span[1])}</code>"


def source_link(site: Site, page: str, file: str, shown: str, line: int | None = None) -> str:
    """HTML that leads from `page` to a line of `file`; `shown` is Markdown of text and code."""
    site.sources.add(file)
    target = f"sources/{file}.html" if file in site.files else f"sources/{file}/index.html"
    place = f"#L-{line}" if line else ""
    words = re.sub(r"`([^`]+)`", _code, html.escape(shown, quote=False))
    where = f' title="{file}, line {line}"' if line else f' title="{file}"'
    number = f'<span class="line">:{line}</span>' if line else ""
    return (f'<a class="source reference internal" href="{site_map.relative(target, page)}{place}"'
            f"{where}>{words}{number}</a>")


@cache
def title_of(file: str) -> str:
    return markdown_text.title((site_map.ROOT / file).read_text(encoding="utf-8"))


def resolve(site: Site, file: str, target: str) -> tuple[str, str]:
    """The file or folder that a link in `file` names, and what follows `#`."""
    path, _, fragment = target.partition("#")
    found = posixpath.normpath(posixpath.join(posixpath.dirname(file), path)) if path else file
    if found not in site.files and not inside(found, site):
        raise Missing(f'link to "{target}": no such file')
    return found, fragment


def convert(site: Site, file: str, mark: str, text: str, target: str) -> str:
    """A link or picture of `file` as its page on the site has it; `mark` is `!` for a picture."""
    if re.match(r"\w+:", target):
        return f"{mark}[{text}]({target})"
    page = site.pages[file]
    found, fragment = resolve(site, file, target)
    if found not in site.files and f"{found}/README.md" in site.pages:
        found += "/README.md"
    if found in site.pages:
        anchor = f"#{fragment}" if fragment else ""
        if text.endswith(".md"):
            text = title_of(found)
        return f"[{text}]({site_map.relative(site.pages[found] + '.md', page)}{anchor})"
    if found.endswith(PICTURES):
        site.pictures.add(found)
        place = site_map.relative(found.removeprefix("docs/"), page)
        return f"{mark}[{text}]({place})"
    return source_link(site, page, found, text)
