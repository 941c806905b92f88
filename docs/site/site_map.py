# SPDX-License-Identifier: BSD-3-Clause
"""Which files become pages of the site, under which name, in which order."""

from __future__ import annotations

import posixpath
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import notebook_pages  # noqa: E402
import source_tree  # noqa: E402

# Pages that are made when the site is built have no file in the repository.
GUIDE = ["docs/start.md", "docs/concepts.md", "docs/case-file.md", "docs/choosing.md",
         "docs/options.md", "docs/run-directory.md", "docs/pictures.md", "docs/python.md",
         "docs/notebooks/first_steps.ipynb", "docs/notebooks/stepping.ipynb",
         "docs/notebooks/study.ipynb", "python-reference", "docs/troubleshooting.md"]
THEORY = ["docs/theory.md", "docs/equations.md"]
PROJECT = ["docs/performance.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "decisions/index",
           "CHANGELOG.md", "BASELINES.md"]


def tracked(root: Path = ROOT) -> list[str]:
    """All files of the project, relative to its root."""
    return [path.relative_to(root).as_posix() for path in source_tree.files(root)]


def page_name(file: str) -> str:
    """Name of the page of a Markdown file or a notebook: `index` of its folder for a README, and
    what lies in `docs/` at the top."""
    name = file.removeprefix("docs/").removesuffix(".md").removesuffix(notebook_pages.SUFFIX)
    folder, last = posixpath.split(name)
    return posixpath.join(folder, "index" if last == "README" else last.lower())


def pages(files: list[str]) -> dict[str, str]:
    """The page of each Markdown file and notebook."""
    return {file: page_name(file) for file in files
            if file.endswith((".md", notebook_pages.SUFFIX))}


def text_of(file: str) -> str:
    """The Markdown of a page."""
    if file.endswith(notebook_pages.SUFFIX):
        return notebook_pages.markdown(file)
    return (ROOT / file).read_text(encoding="utf-8")


def relative(target: str, page: str) -> str:
    """`target`, a path in the site, as seen from a page."""
    return posixpath.relpath(target, posixpath.dirname(page) or ".")


def groups(files: list[str]) -> dict[str, list[str]]:
    """The pages below each caption of the table of contents; a page of `docs/` that none of them
    lists stands at the end of the guide."""
    names = pages(files)
    others = [file for file in names if posixpath.dirname(file) == "docs"
              and file not in GUIDE + THEORY + PROJECT]

    def of(wanted: list[str]) -> list[str]:
        return [names.get(file, file) for file in wanted]

    return {
        "Guide": of(GUIDE + sorted(others)),
        "Theory": of(THEORY),
        "Examples and verification": ["examples/index", "verification/index"],
        "Project": of(PROJECT),
    }


def below(prefix: str, files: list[str]) -> list[str]:
    """The pages in the folders below one, sorted, without the page of the folder itself."""
    return sorted(name for file, name in pages(files).items()
                  if file.startswith(f"{prefix}/") and name != f"{page_name(prefix)}/index")
