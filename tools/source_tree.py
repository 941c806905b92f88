# SPDX-License-Identifier: BSD-3-Clause
"""Which files belong to the project: the ones git tracks or would track."""

import subprocess
from pathlib import Path

CPP = {".cpp", ".hpp"}
CODE = CPP | {".py", ".sh", ".cmake", ".js", ".css", ".jinja"}


def files(root: Path) -> list[Path]:
    """All files of the project under root, sorted, build results and git's own excluded."""
    listing = subprocess.run(
        ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        capture_output=True, check=True,
    ).stdout.decode()
    return sorted({root / name for name in listing.split("\0") if name and (root / name).is_file()})


def is_code(path: Path) -> bool:
    return path.suffix in CODE or path.name in {"CMakeLists.txt", "Makefile"}


def lines(path: Path) -> list[str]:
    """The lines of a text file; none of a binary one."""
    data = path.read_bytes()
    return [] if b"\0" in data else data.decode(errors="replace").splitlines()
