# SPDX-License-Identifier: BSD-3-Clause
"""Every link of every Markdown file leads to a file that belongs to the project, and to a heading
that is there."""

import posixpath
import re

import links
import markdown_text
import pytest
import site_map

SITE = links.open_site()
PAGES = sorted(SITE.pages)


def problems(file: str, text: str) -> list[str]:
    found = []
    for line, target in markdown_text.links(text):
        if re.match(r"\w+:", target):
            continue
        try:
            where, anchor = links.resolve(SITE, file, target)
        except links.Missing as missing:
            found.append(f"{file}:{line}: {missing}")
            continue
        if anchor and (where not in SITE.pages
                       or anchor not in markdown_text.anchors(site_map.text_of(where))):
            found.append(f'{file}:{line}: link to "{target}": no such heading')
    return found


@pytest.mark.parametrize("file", PAGES)
def test_links_and_anchors_resolve(file):
    assert problems(file, site_map.text_of(file)) == []


def test_what_leads_nowhere_is_found():
    text = ("# A\n[a](theory.md#8-triangles) [b](theory.md#none) [c](none.md) [d](#a)\n"
            "`[e](none.md)`\n\n```\n[f](none.md)\n```\n![g](figures/none.svg)\n")
    found = problems("docs/python.md", text.replace("[d](#a)", "[d](#many-runs)"))
    assert [re.search(r'"(.*)"', problem)[1] for problem in found] == [
        "theory.md#none", "none.md", "figures/none.svg"]


def test_anchors_are_those_of_code_hosts():
    text = "# A `code` of *it*: 1.5 m\n## Twice\n## Twice\n```\n# no heading\n```\n"
    assert markdown_text.anchors(text) == {"a-code-of-it-15-m", "twice", "twice-1"}


def test_the_guide_on_the_site_has_every_page_of_the_documents():
    shown = {name for names in site_map.groups(sorted(SITE.files)).values() for name in names}
    for file in PAGES:
        folder = posixpath.dirname(file)
        if folder in ("docs", ""):
            assert SITE.pages[file] in shown | {"index"}, file
