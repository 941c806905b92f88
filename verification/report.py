# SPDX-License-Identifier: BSD-3-Clause
"""What a verification finds: rows with a value and its limit, and pictures."""

from __future__ import annotations

import base64
import io
import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path

import matplotlib.pyplot as plt
import page
import paper_section
from paper_figures import FIGURES, PaperFigure


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
class Picture:
    """A PNG in base64; `name` is what paper_figures.py knows it by, empty where it does not."""

    name: str
    caption: str
    png: str


@dataclass
class Chapter:
    """All that one verification has to show."""

    name: str
    title: str = ""
    rows: list[Row] = field(default_factory=list)
    pictures: list[Picture] = field(default_factory=list)
    error: str = ""

    def at_most(self, name: str, quantity: str, value: float, limit: float) -> None:
        self.rows.append(Row(f"{self.name}.{name}", quantity, float(value), float(limit)))

    def at_least(self, name: str, quantity: str, value: float, limit: float) -> None:
        self.rows.append(Row(f"{self.name}.{name}", quantity, float(value), float(limit), "min"))

    def add_figure(self, figure, caption: str, name: str = "") -> None:
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png", dpi=90)
        plt.close(figure)
        self._add(buffer.getvalue(), caption, name)

    def add_picture(self, path: Path, caption: str, name: str = "") -> None:
        self._add(path.read_bytes(), caption, name)

    def _add(self, png: bytes, caption: str, name: str) -> None:
        self.pictures.append(Picture(name, caption, base64.b64encode(png).decode()))

    @property
    def passes(self) -> bool:
        return not self.error and bool(self.rows) and all(row.passes for row in self.rows)


def _failure(name: str, reason: str) -> dict:
    """An entry of report.json for what has no value."""
    return {"id": name, "quantity": reason, "value": None, "limit": None, "sense": "max",
            "pass": False}


def write(chapters: list[Chapter], folder: Path,
          figures: Sequence[PaperFigure] = FIGURES) -> list[str]:
    """Writes report.json (the list of rows) and index.html (one page that needs no other file).
    Returns what figures of the paper lack although their chapter ran."""
    folder.mkdir(parents=True, exist_ok=True)
    found = paper_section.find(figures, chapters)
    lacking = [(entry.key, what) for entry in found for what in entry.lacking]
    entries = [row.as_json() for chapter in chapters for row in chapter.rows]
    entries += [_failure(f"{c.name}.error", c.error) for c in chapters if c.error]
    entries += [_failure(key, what) for key, what in lacking]
    (folder / "report.json").write_text(json.dumps(entries, indent=2) + "\n")
    passed = sum(entry["pass"] for entry in entries)
    notes = paper_section.notes(figures)
    (folder / "index.html").write_text(
        page.page(f"{passed} of {len(entries)} comparisons pass.",
                  [page.contents(chapters), paper_section.section(found),
                   *(page.chapter_html(chapter, notes) for chapter in chapters)]),
        encoding="utf-8")
    return [f"{key}: {what}" for key, what in lacking]
