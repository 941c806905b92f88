# SPDX-License-Identifier: BSD-3-Clause
"""Formulas as MathML, which browsers set by themselves: nothing is loaded when a page is read."""

from __future__ import annotations

import re

from docutils.nodes import SkipNode
from latex2mathml.converter import convert
from sphinx.errors import ExtensionError


def mathml(latex: str, display: str = "inline") -> str:
    """MathML of a formula. Raises ExtensionError where a command is not known."""
    made = convert(latex, display=display)
    # What is not known comes out as its own name.
    unknown = re.search(r">(\\\w+)<", made)
    if unknown:
        raise ExtensionError(f"formula {latex}: {unknown[1]} is not known")
    return made


def visit_math(translator, node) -> None:
    translator.body.append(mathml(node.astext()))
    raise SkipNode


def visit_displaymath(translator, node) -> None:
    translator.body.append(f'<div class="formula">{mathml(node.astext(), "block")}</div>')
    raise SkipNode


def setup(app) -> dict:
    app.add_html_math_renderer("mathml", (visit_math, None), (visit_displaymath, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
