# SPDX-License-Identifier: BSD-3-Clause
"""The page of all results as HTML that needs no other file: rows, pictures, chapters."""

from __future__ import annotations

import html
from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from report import Chapter, Picture, Row

STYLE = """body{font-family:sans-serif;max-width:76rem;margin:2rem auto;padding:0 1rem;color:#222}
table{border-collapse:collapse;margin:1rem 0}td,th{border:1px solid #ccc;padding:.25rem .6rem;
text-align:left}td.number{text-align:right;font-family:monospace;white-space:nowrap}
.pass{background:#e3f3e3}
.fail{background:#f8d7d7}figure{margin:1.5rem 0}img{max-width:100%}figcaption{color:#444}
pre{background:#f8d7d7;padding:.6rem;white-space:pre-wrap}
.idle{background:#eee}.links a,.mark{display:inline-block;padding:.15rem .45rem;margin:.1rem}
.mark{font-size:.8rem;font-weight:normal;border-radius:.3rem}
.paper{border-top:1px solid #ccc;margin-top:1.5rem}
.beside{display:grid;grid-template-columns:minmax(0,13fr) minmax(0,9fr);gap:0 1.5rem}
.beside figure{margin:.5rem 0}.beside table{font-size:.8rem}.beside td{padding:.15rem .35rem}
.differs{border-left:4px solid #d55e00;padding-left:.6rem}
@media(max-width:56rem){.beside{grid-template-columns:minmax(0,1fr)}}"""


def row_table(rows: list[Row]) -> str:
    return ("<table><tr><th>id</th><th>quantity</th><th>value</th><th>limit</th><th></th></tr>"
            + "".join(_row(row) for row in rows) + "</table>")


def _row(row: Row) -> str:
    sign = "≤" if row.sense == "max" else "≥"
    mark = "pass" if row.passes else "fail"
    name = html.escape(row.id).replace(".", ".<wbr>").replace("_", "_<wbr>")
    return (f'<tr class="{mark}"><td>{name}</td><td>{html.escape(row.quantity)}</td>'
            f'<td class="number">{row.value:.4g}</td><td class="number">{sign} {row.limit:.4g}</td>'
            f"<td>{mark}</td></tr>")


def image(picture: Picture) -> str:
    caption = html.escape(picture.caption)
    return f'<img alt="{caption}" src="data:image/png;base64,{picture.png}">'


def anchor(chapter: Chapter, picture: Picture) -> str:
    """The id of a picture in its chapter; only pictures with a name have one."""
    return html.escape(f"{chapter.name}.{picture.name}")


def _figure(chapter: Chapter, picture: Picture, note: str) -> str:
    place = f' id="{anchor(chapter, picture)}"' if picture.name else ""
    return (f"<figure{place}>{image(picture)}<figcaption>{html.escape(picture.caption)}{note}"
            "</figcaption></figure>")


def chapter_html(chapter: Chapter, notes: Mapping[tuple[str, str], str]) -> str:
    """A chapter; `notes` holds what to say under a picture, by the names of chapter and picture."""
    parts = [f'<h2 id="{chapter.name}">{html.escape(chapter.title)}</h2>']
    if chapter.error:
        parts.append(f"<pre>{html.escape(chapter.error)}</pre>")
    parts.append(row_table(chapter.rows))
    parts += [_figure(chapter, picture, notes.get((chapter.name, picture.name), ""))
              for picture in chapter.pictures]
    return "\n".join(parts)


def contents(chapters: list[Chapter]) -> str:
    links = "".join(f'<li class="{"pass" if c.passes else "fail"}"><a href="#{c.name}">'
                    f"{html.escape(c.title)}</a></li>" for c in chapters)
    return f"<ul>{links}</ul>"


def page(summary: str, parts: list[str]) -> str:
    return (f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Percolith '
            f"verification</title><style>{STYLE}</style></head><body>"
            f"<h1>Percolith: verification</h1><p>{html.escape(summary)}</p>" + "\n".join(parts)
            + "</body></html>\n")
