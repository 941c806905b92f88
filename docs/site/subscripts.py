# SPDX-License-Identifier: BSD-3-Clause
"""Symbols in running text, `K_w` or `ΔV_i`, with their subscripts lowered."""

from __future__ import annotations

import re

from markdown_text import outside, read_lines

SYMBOL = re.compile(r"(?<![\w\\])([A-Za-zα-ωΑ-Ω]|[Δ∂][A-Za-zα-ω])_(cav|min|max|ref|[A-Za-z0-9]{1,2})"
                    r"(?![A-Za-z0-9_])")


def lowered(text: str) -> str:
    """`text` with the symbols of its lines so, headings and code excepted."""
    made = []
    for line in read_lines(text):
        plain = line.code or line.text.startswith("#")
        made.append(line.text if plain else outside(line.text, _lower))
    return "\n".join(made) + "\n"


def _lower(part: str) -> str:
    return SYMBOL.sub(r"<i>\1</i><sub>\2</sub>", part)
