# SPDX-License-Identifier: BSD-3-Clause
"""Sources as pages with an anchor for each line, so that what links to a line works offline."""

from __future__ import annotations

import json
from collections import defaultdict
from html import escape
from pathlib import Path
from posixpath import basename, dirname

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import CppLexer, TextLexer, get_lexer_for_filename
from pygments.util import ClassNotFound

ROOT = Path(__file__).resolve().parents[2]
FORMAT = HtmlFormatter(linenos="inline", lineanchors="L", anchorlinenos=True, cssclass="highlight")


def lexer_of(file: str):
    if file.endswith((".geo", ".cu")):
        return CppLexer()
    try:
        return get_lexer_for_filename(file)
    except ClassNotFound:
        return TextLexer()


def shown(file: str) -> str:
    """The text of a file in colours; of one that is no text, its size."""
    data = (ROOT / file).read_bytes()
    if b"\0" in data:
        return f"<p>A binary file of {len(data)} bytes.</p>"
    return highlight(data.decode("utf-8"), lexer_of(file), FORMAT)


def folders(files: list[str]) -> dict[str, set[str]]:
    """Each folder with the files and folders in it that are shown."""
    found: dict[str, set[str]] = defaultdict(set)
    for file in files:
        found[dirname(file)].add(basename(file))
        folder = dirname(file)
        while folder:
            found[dirname(folder)].add(f"{basename(folder)}/")
            folder = dirname(folder)
    return found


def listing(names: set[str]) -> str:
    rows = "".join(
        f'<li><a href="{name}{"index" if name.endswith("/") else ""}.html">{escape(name)}</a></li>'
        for name in sorted(names))
    return f"<ul>{rows}</ul>"


def collect(app):
    """A page for each source that the pages link to, and for each folder on the way to it."""
    files = json.loads((Path(app.srcdir) / "sources.json").read_text())
    for file in files:
        yield f"sources/{file}", page(file, shown(file)), "page.html"
    for folder, names in folders(files).items():
        name = f"sources/{folder}/index" if folder else "sources/index"
        yield name, page(f"{folder}/" if folder else "Sources", listing(names)), "page.html"


def page(title: str, body: str) -> dict:
    return {"title": title, "parents": [],
            "body": f'<h1><code class="path">{escape(title)}</code></h1>{body}'}


def setup(app) -> dict:
    app.connect("html-collect-pages", collect)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
