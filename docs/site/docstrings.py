# SPDX-License-Identifier: BSD-3-Clause
"""Docstrings are plain text with `names` in backticks and indented code; Sphinx gets them as it
writes both."""

from __future__ import annotations

import re

NAME = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")


def as_sphinx(lines: list[str]) -> list[str]:
    """The lines of a docstring with its names and its blocks of code marked."""
    made = [line if line.startswith("    ") else NAME.sub(r"``\1``", line) for line in lines]
    for i in range(len(made) - 2):
        is_code = made[i + 2].startswith("    ") and not made[i].startswith(" ")
        if made[i].endswith(":") and not made[i].endswith("::") and not made[i + 1] and is_code:
            made[i] += ":"
    return made


def process(app, what, name, thing, options, lines) -> None:
    lines[:] = as_sphinx(lines)


def setup(app) -> dict:
    app.connect("autodoc-process-docstring", process)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
