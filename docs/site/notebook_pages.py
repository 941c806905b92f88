# SPDX-License-Identifier: BSD-3-Clause
"""Notebooks as pages: their text, their code, and what they were committed with as their output."""

from __future__ import annotations

import base64
import json
import posixpath
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SUFFIX = ".ipynb"
PICTURE = "image/png"


def _cells(file: str) -> list[dict]:
    return json.loads((ROOT / file).read_text(encoding="utf-8"))["cells"]


def _joined(lines: list[str] | str) -> str:
    return lines if isinstance(lines, str) else "".join(lines)


def _block(kind: str, text: str) -> str:
    return f"```{kind}\n{text.rstrip()}\n```\n"


def _picture_name(file: str, number: int, place: int) -> str:
    stem = posixpath.basename(file).removesuffix(SUFFIX)
    return f"{stem}-{number}{f'-{place}' if place else ''}.png"


def _shown(file: str, number: int, place: int, output: dict) -> str:
    """One output of cell `number`, the `place`-th of it."""
    data = output.get("data", {})
    if PICTURE in data:
        return _block(f"{{image}} {_picture_name(file, number, place)}",
                      ":alt: What this cell of the notebook draws")
    if "text/html" in data:
        table = _joined(data["text/html"]).replace('border="1" class="dataframe"', 'class="docutils"')
        return _block("{raw} html", f'<div class="table-wrapper">\n{table}\n</div>')
    printed = _joined(output.get("text") or data.get("text/plain", ""))
    return _block("{code-block} text", f":class: printed\n\n{printed}")


def markdown(file: str) -> str:
    """The notebook as Markdown; its pictures lie beside it under the names of `pictures`."""
    parts = []
    for number, cell in enumerate(_cells(file), 1):
        source = _joined(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(source + "\n")
            continue
        parts.append(_block("python", source))
        parts += [_shown(file, number, place, output)
                  for place, output in enumerate(cell["outputs"])]
    return "\n".join(parts)


def pictures(file: str) -> dict[str, bytes]:
    """The pictures of a notebook by their names."""
    return {_picture_name(file, number, place): base64.b64decode(_joined(output["data"][PICTURE]))
            for number, cell in enumerate(_cells(file), 1)
            for place, output in enumerate(cell.get("outputs", []))
            if PICTURE in output.get("data", {})}
