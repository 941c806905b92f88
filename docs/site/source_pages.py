# SPDX-License-Identifier: BSD-3-Clause
"""Sources as pages with an anchor for each line, so that what links to a line works offline."""

from __future__ import annotations

import json
from collections import defaultdict
from html import escape
from pathlib import Path
from posixpath import basename, dirname, relpath

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import CppLexer, TextLexer, get_lexer_for_filename
from pygments.util import ClassNotFound

ROOT = Path(__file__).resolve().parents[2]
LIGHT, DARK = "a11y-high-contrast-light", "a11y-high-contrast-dark"
FORMAT = HtmlFormatter(linenos="inline", lineanchors="L", anchorlinenos=True, cssclass="highlight",
                       style=LIGHT)
PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} - Percolith</title><link rel="stylesheet" href="{top}/_static/source.css"></head>
<body><nav><a href="{top}/index.html">Percolith</a> {way}</nav>
{body}
</body></html>
"""
STYLE = """/* SPDX-License-Identifier: BSD-3-Clause */
body { margin: 0 auto; max-width: 70rem; padding: 0 1rem 4rem; font-family: sans-serif;
       background: #fff; color: #222; }
nav { padding: 0.8rem 0; border-bottom: 1px solid #ccc; margin-bottom: 0.8rem; }
nav a, li a { color: #0060a0; }
pre { overflow-x: auto; font-size: 0.86rem; line-height: 1.45; padding: 0.8rem 0; margin: 0; }
pre a { text-decoration: none; color: inherit; }
.linenos { opacity: 0.55; user-select: none; margin-right: 0.6rem; }
a[id]:target { outline: 0.5rem solid #e69f00; outline-offset: -0.1rem; scroll-margin-top: 30vh; }
@media (prefers-color-scheme: dark) {
body { background: #15181a; color: #ddd; }
nav a, li a { color: #6cb6ff; }
%s
}
"""


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


def page(path: str, body: str) -> str:
    """The page at `sources/PATH.html`; the way to it leads to the folders above."""
    place = dirname(f"sources/{path}")
    parts = path.removesuffix("index").rstrip("/").split("/")
    steps = ["/".join(["sources", *parts[:i], "index.html"]) for i in range(len(parts))]
    names = ["sources", *parts[:-1]]
    way = " / ".join(f'<a href="{relpath(step, place)}">{escape(name)}</a>'
                     for step, name in zip(steps, names, strict=True))
    return PAGE.format(title=escape(parts[-1]), top=relpath(".", place),
                       way=f"{way} / {escape(parts[-1])}", body=body)


def write(app, error) -> None:
    """A page for each source that the pages link to, and for each folder on the way to it."""
    if error:
        return
    out = Path(app.outdir)
    files = json.loads((Path(app.srcdir) / "sources.json").read_text())
    made = {file: shown(file) for file in files}
    for folder, names in folders(files).items():
        made[f"{folder}/index" if folder else "index"] = listing(names)
    for path, body in made.items():
        target = out / f"sources/{path}.html"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(page(path, body), encoding="utf-8")
    dark = HtmlFormatter(cssclass="highlight", style=DARK).get_style_defs(".highlight")
    (out / "_static/source.css").write_text(
        FORMAT.get_style_defs(".highlight") + "\n" + STYLE % dark, encoding="utf-8")


def setup(app) -> dict:
    app.connect("build-finished", write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
