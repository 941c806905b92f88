# SPDX-License-Identifier: BSD-3-Clause
"""Where the sources define what the documents name: files, functions, types, tests."""

from __future__ import annotations

import subprocess
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# GoogleTest names its tests by a macro; its two arguments make the name `Suite.Test`, and the first
# test of a suite stands for the suite.
_GOOGLE_TEST = (r"/TEST(_[PF])?\(\s*([A-Za-z0-9_]+),\s*([A-Za-z0-9_]+)\)/\2.\3/"
                r"t,gtest,a test/{mgroup=3}")
# Later in this list is better: a definition beats a declaration, and a thing of its own what is inside.
_WORTH = ("local", "header", "macro", "member", "variable", "prototype", "enumerator", "alias",
          "typedef", "enum", "gtest", "function", "struct", "class")
Place = tuple[str, int]
"""A file relative to the root, and a line of it from 1 on."""


class Symbols:
    """The names that files define, found by Universal Ctags."""

    def __init__(self, files: Iterable[str], root: Path = ROOT):
        """Reads `files`, C++ and Python, given relative to `root`."""
        self._by_file: dict[str, dict[str, tuple[int, int]]] = defaultdict(dict)
        self._files_of: dict[str, set[str]] = defaultdict(set)
        for name, kind, line, scope, file in _tags(files, root):
            self._add(name, kind, line, file)
            if scope:
                self._add(f"{scope.split('::')[-1].split('.')[-1]}::{name}", kind, line, file)
            if kind == "gtest":
                self._add(name.split(".")[0], kind, line, file)

    def _add(self, name: str, kind: str, line: int, file: str) -> None:
        worth = _WORTH.index(kind) if kind in _WORTH else 0
        known = self._by_file[file].get(name)
        if known is None or (worth, -line) > (known[0], -known[1]):
            self._by_file[file][name] = (worth, line)
        self._files_of[name].add(file)

    def line(self, file: str, name: str) -> int | None:
        """The line on which `file` defines `name`, plain or as `Type::name`, or None."""
        found = self._by_file.get(file, {}).get(name)
        return found[1] if found else None

    def place(self, name: str) -> Place | None:
        """The one place that defines `name`: the best of all files; None where there is no such
        name, or where several unrelated files define it equally well."""
        files = self._files_of.get(name)
        if not files:
            return None
        best = max(self._by_file[file][name][0] for file in files)
        places = sorted(file for file in files if self._by_file[file][name][0] == best)
        if len(places) > 1:
            return None
        return places[0], self._by_file[places[0]][name][1]

    def knows(self, name: str) -> bool:
        return name in self._files_of


def _tags(files: Iterable[str], root: Path):
    done = subprocess.run(
        ["ctags", "--options=NONE", "-x", "--quiet=yes", "--map-C++=+.cu",
         "--kinds-C++=+p", "--_xformat=%N\t%K\t%n\t%s\t%F",
         "--kinds-Python=+v", f"--mline-regex-C++={_GOOGLE_TEST}", "-L", "-"],
        cwd=root, input="\n".join(sorted(files)), capture_output=True, text=True, check=True)
    for row in done.stdout.splitlines():
        name, kind, line, scope, file = row.split("\t")
        yield name.strip(), kind.strip(), int(line), scope.strip(), file.strip()
