# SPDX-License-Identifier: BSD-3-Clause
"""Writes what Sphinx builds the site from: each Markdown file with the links of the site, and the
pages that are made from folders and sources. Lines keep their numbers.

    python docs/site/staging.py FOLDER
"""

from __future__ import annotations

import json
import re
import shutil
import sys
from pathlib import Path

import decisions
import equations
import gallery
import links
import markdown_text
import mentions
import notebook_pages
import python_page
import site_map
import subscripts
import verification_table
from markdown_text import Line

ROOT = site_map.ROOT


def with_links(site: links.Site, file: str, text: str, problems: list[str]) -> str:
    """`text` of `file` with every link as the site has it."""

    def change_of(line: Line):
        def change(part: markdown_text.Inline) -> str:
            if not part["target"]:
                return part[0]
            try:
                return links.convert(site, file, part["image"], part["text"], part["target"])
            except links.Missing as missing:
                problems.append(f"{file}:{line.number}: {missing}")
                return part[0]

        return change

    return "".join(
        (line.text if line.code else markdown_text.rewrite(line.text, change_of(line))) + "\n"
        for line in markdown_text.read_lines(text))


def one_title(text: str) -> str:
    """Where a text has more than one heading of the first level, all but the first go one down, and
    with each what is below it."""
    lines, seen, deeper = [], 0, ""
    for line in markdown_text.read_lines(text):
        heading = None if line.code else markdown_text.HEADING.match(line.text)
        if heading and heading[1] == "#":
            seen += 1
            deeper = "#" if seen > 1 else ""
        lines.append((deeper if heading else "") + line.text + "\n")
    return "".join(lines)


def contents(captions: dict[str, list[str]]) -> str:
    """The table of contents, which the start page carries unseen."""
    parts = []
    for caption, names in captions.items():
        body = "\n".join(names)
        parts.append(f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{body}\n```\n")
    return "".join(parts)


def children(names: list[str]) -> str:
    body = "\n".join("/" + name for name in names)
    return f"\n```{{toctree}}\n:hidden:\n\n{body}\n```\n"


def stage(folder: Path) -> list[str]:
    """Writes all pages into `folder`; returns what is wrong, a line each with file and line."""
    site = links.open_site()
    files = sorted(site.files)
    problems: list[str] = []
    made: dict[str, str] = {}
    names = mentions.collect(site.files)
    texts = {file: site_map.text_of(file) for file in site.pages}
    numbered = {file: equations.own_places(texts[file])
                for file in (equations.THEORY, equations.PAPER)}
    for file, page in site.pages.items():
        text = mentions.with_places(site, names, file, texts[file], problems)
        if file in numbered:
            text = equations.with_numbers(file, text, numbered, problems)
        made[page] = one_title(subscripts.lowered(with_links(site, file, text, problems)))
    made["decisions/index"] = decisions.page(files)
    made["python-reference"] = python_page.page()
    try:
        for name in gallery.names(site.files):
            made[f"examples/{name}/index"] += gallery.appendix(site, name)
        made["examples/index"] += gallery.gallery(site)
        made["verification/index"] += verification_table.page(site)
    except links.Missing as missing:
        problems.append(str(missing))
    made["index"] += contents(site_map.groups(files))
    for name in ("examples", "verification"):
        made[f"{name}/index"] += children(site_map.below(name, files))
    made["decisions/index"] += children(site_map.below("docs/decisions", files))
    write(folder, made, site)
    return problems


def write(folder: Path, made: dict[str, str], site: links.Site) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    for page, text in made.items():
        target = folder / f"{page}.md"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    for file, page in site.pages.items():
        if file.endswith(notebook_pages.SUFFIX):
            for name, data in notebook_pages.pictures(file).items():
                (folder / page).with_name(name).write_bytes(data)
    for picture in sorted(site.pictures):
        target = folder / picture.removeprefix("docs/")
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / picture, target)
    shown = {file for source in site.sources
             for file in ([source] if source in site.files else links.inside(source, site))}
    extra = folder / "_extra/verification"
    extra.mkdir(parents=True)
    if verification_table.measured():
        shutil.copyfile(verification_table.RESULTS / "index.html", extra / "report.html")
    (folder / "sources.json").write_text(json.dumps(sorted(shown)) + "\n")


def version() -> str:
    """The version of the program, which stands in CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(percolith VERSION ([0-9.]+)", text)[1]


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    problems = stage(Path(sys.argv[1]))
    for problem in problems:
        print(problem, file=sys.stderr)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
