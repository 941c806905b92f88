# SPDX-License-Identifier: BSD-3-Clause
"""The gallery of examples, and what the page of an example has beside its README."""

from __future__ import annotations

import re
from dataclasses import dataclass

import criteria_text
import links
import markdown_text
from site_map import ROOT

TIME = re.compile(r"\bThe run takes (.*?)\.(?:\s|$)", re.DOTALL)


@dataclass(frozen=True)
class Example:
    """What the README of an example says at its beginning."""

    name: str
    title: str
    summary: str
    time: str


def names(files: set[str]) -> list[str]:
    return sorted(file.split("/")[1] for file in files
                  if re.fullmatch(r"examples/[^/]+/expected\.toml", file))


def read(name: str) -> Example:
    """Raises links.Missing where the README lacks what the gallery shows."""
    file = f"examples/{name}/README.md"
    text = (ROOT / file).read_text(encoding="utf-8")
    time = TIME.search(text)
    if not time:
        raise links.Missing(f'{file}: no sentence "The run takes ..."')
    paragraphs = [part for part in re.split(r"\n\s*\n", text) if not part.startswith(("#", "!"))]
    summary = " ".join(markdown_text.plain(paragraphs[0]).split())
    return Example(name, markdown_text.title(text), summary, " ".join(time[1].split()))


def card(example: Example, criteria: int) -> str:
    page = f"{example.name}/index.md"
    number = f"{criteria} pass criteria" if criteria > 1 else "one pass criterion"
    return f"""```{{container}} card

[![{example.title}]({example.name}/picture.png)]({page})

**[{example.title}]({page})**

{example.summary}

{example.time}; {number}
```
"""


def gallery(site: links.Site) -> str:
    """A card for each example, with its picture."""
    cards = []
    for name in names(site.files):
        site.pictures.add(f"examples/{name}/picture.png")
        cards.append(card(read(name), len(criteria_text.read(name))))
    return "\n## Gallery\n\n````{container} gallery\n\n" + "\n".join(cards) + "````\n"


def appendix(site: links.Site, name: str) -> str:
    """Criteria, case file and other files of an example, for the end of its page."""
    page, folder = f"examples/{name}/index", f"examples/{name}"
    case = (ROOT / folder / "case.toml").read_text(encoding="utf-8")
    others = [file for file in links.inside(folder, site)
              if file.endswith((".toml", ".geo", ".csv", ".py"))]
    listed = "".join(f"- {links.source_link(site, page, file, file.split('/')[-1])}\n"
                     for file in others)
    return (f"\n## Pass criteria\n\n{criteria_text.table(criteria_text.read(name))}"
            f"\n## The case file\n\n```toml\n{case}```\n\n## Files\n\n{listed}")
