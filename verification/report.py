# SPDX-License-Identifier: BSD-3-Clause
"""What a verification finds: rows with a value and its limit, and figures."""

from __future__ import annotations

import base64
import html
import io
import json
from dataclasses import asdict, dataclass, field
from pathlib import Path

import matplotlib.pyplot as plt


@dataclass
class Row:
    """A quantity that must not exceed its limit (sense max) or not fall below it (sense min)."""

    id: str
    quantity: str
    value: float
    limit: float
    sense: str = "max"

    @property
    def passes(self) -> bool:
        return self.value <= self.limit if self.sense == "max" else self.value >= self.limit

    def as_json(self) -> dict:
        # A number is valid JSON only when finite.
        value = self.value if abs(self.value) < float("inf") else None
        return {**asdict(self), "value": value, "pass": bool(self.passes)}


@dataclass
class Chapter:
    """All that one verification has to show."""

    name: str
    title: str = ""
    rows: list[Row] = field(default_factory=list)
    figures: list[tuple[str, str]] = field(default_factory=list)  # caption, PNG in base64
    error: str = ""

    def at_most(self, name: str, quantity: str, value: float, limit: float) -> None:
        self.rows.append(Row(f"{self.name}.{name}", quantity, float(value), float(limit)))

    def at_least(self, name: str, quantity: str, value: float, limit: float) -> None:
        self.rows.append(Row(f"{self.name}.{name}", quantity, float(value), float(limit), "min"))

    def add_figure(self, figure, caption: str) -> None:
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png", dpi=90)
        plt.close(figure)
        self.figures.append((caption, base64.b64encode(buffer.getvalue()).decode()))

    def add_picture(self, path: Path, caption: str) -> None:
        self.figures.append((caption, base64.b64encode(path.read_bytes()).decode()))

    @property
    def passes(self) -> bool:
        return not self.error and bool(self.rows) and all(row.passes for row in self.rows)


_STYLE = """body{font-family:sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem;color:#222}
table{border-collapse:collapse;margin:1rem 0}td,th{border:1px solid #ccc;padding:.25rem .6rem;
text-align:left}td.number{text-align:right;font-family:monospace}.pass{background:#e3f3e3}
.fail{background:#f8d7d7}figure{margin:1.5rem 0}img{max-width:100%}figcaption{color:#444}
pre{background:#f8d7d7;padding:.6rem;white-space:pre-wrap}"""


def _row_html(row: Row) -> str:
    mark, sign = ("pass", "≤") if row.sense == "max" else ("pass", "≥")
    mark = mark if row.passes else "fail"
    return (f'<tr class="{mark}"><td>{html.escape(row.id)}</td><td>{html.escape(row.quantity)}</td>'
            f'<td class="number">{row.value:.4g}</td><td class="number">{sign} {row.limit:.4g}</td>'
            f"<td>{mark}</td></tr>")


def _chapter_html(chapter: Chapter) -> str:
    parts = [f'<h2 id="{chapter.name}">{html.escape(chapter.title)}</h2>']
    if chapter.error:
        parts.append(f"<pre>{html.escape(chapter.error)}</pre>")
    rows = "".join(_row_html(row) for row in chapter.rows)
    parts.append("<table><tr><th>id</th><th>quantity</th><th>value</th><th>limit</th><th></th></tr>"
                 f"{rows}</table>")
    for caption, picture in chapter.figures:
        caption = html.escape(caption)
        parts.append(f'<figure><img alt="{caption}" src="data:image/png;base64,{picture}">'
                     f"<figcaption>{caption}</figcaption></figure>")
    return "\n".join(parts)


def write(chapters: list[Chapter], folder: Path) -> None:
    """Writes report.json (the list of rows) and index.html (one page that needs no other file)."""
    folder.mkdir(parents=True, exist_ok=True)
    rows = [row for chapter in chapters for row in chapter.rows]
    failed = [chapter for chapter in chapters if chapter.error]
    entries = [row.as_json() for row in rows]
    entries += [{"id": f"{chapter.name}.error", "quantity": chapter.error, "value": None,
                 "limit": None, "sense": "max", "pass": False} for chapter in failed]
    (folder / "report.json").write_text(json.dumps(entries, indent=2) + "\n")
    links = "".join(f'<li class="{"pass" if c.passes else "fail"}"><a href="#{c.name}">'
                    f"{html.escape(c.title)}</a></li>" for c in chapters)
    passed = sum(entry["pass"] for entry in entries)
    (folder / "index.html").write_text(
        f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Percolith verification'
        f"</title><style>{_STYLE}</style></head><body><h1>Percolith: verification</h1>"
        f"<p>{passed} of {len(entries)} comparisons pass.</p><ul>{links}</ul>"
        + "\n".join(_chapter_html(chapter) for chapter in chapters) + "</body></html>\n",
        encoding="utf-8")
