# SPDX-License-Identifier: BSD-3-Clause
"""The page that lists the decisions, by their titles."""

from __future__ import annotations

import markdown_text
import site_map


def page(files: list[str]) -> str:
    rows = []
    for file in sorted(file for file in files if file.startswith("docs/decisions/")):
        text = (site_map.ROOT / file).read_text(encoding="utf-8")
        rows.append(f"- [{markdown_text.title(text)}]({file.split('/')[-1]})\n")
    return ("# Decisions\n\nChoices that others could have made differently, each with its "
            "reasons.\n\n" + "".join(rows))
