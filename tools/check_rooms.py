#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares the include lines of every room with the rooms it declares to depend on.

Usage: check_rooms.py [ROOT]. Prints one line a violation; exit code 1 if there is any.
"""

import re
import sys
from pathlib import Path

# The physics never knows how it is described or written, and its two halves meet in coupling only.
PHYSICS = {"core", "time", "mesh", "material", "mechanics", "seepage", "coupling", "simulation"}
OUTSIDE = {"io", "case", "runner", "cli"}
APART = [("mechanics", "seepage"), ("seepage", "mechanics")]
GENERATED = {"version.hpp"}


def declared_rooms(cmake_text: str) -> dict[str, set[str]]:
    """The DEPENDS of each percolith_room(...) call, by room, in the order of the calls."""
    rooms = {}
    text = re.sub(r"#.*", "", cmake_text)
    for call in re.findall(r"percolith_room\(([^)]*)\)", text):
        words = call.split()
        rooms[words[0]] = set()
        collecting = False
        for word in words[1:]:
            if word.isupper():
                collecting = word == "DEPENDS"
            elif collecting:
                rooms[words[0]].add(word)
    return rooms


def order_problems(rooms: dict[str, set[str]]) -> list[str]:
    """What is wrong with the declarations themselves."""
    problems = []
    seen = set()
    for room, depends in rooms.items():
        for other in sorted(depends - seen):
            problems.append(f"room {room} depends on {other}, which is not declared before it")
        if room in PHYSICS:
            for other in sorted(depends & OUTSIDE):
                problems.append(f"physics room {room} depends on {other}")
        for other in sorted(depends):
            if (room, other) in APART:
                problems.append(f"room {room} depends on {other}; they meet in coupling only")
        seen.add(room)
    return problems


def include_problems(source: Path, rooms: dict[str, set[str]]) -> list[str]:
    """Includes in src/percolith/ROOM/... of a room that ROOM does not declare."""
    problems = []
    for folder in sorted(path for path in source.iterdir() if path.is_dir()):
        room = folder.name
        if room not in rooms:
            problems.append(f"{folder}: no percolith_room({room} ...) in {source}/CMakeLists.txt")
            continue
        for file in sorted(folder.rglob("*.[ch]pp")):
            for number, line in enumerate(file.read_text().splitlines(), 1):
                found = re.match(r'\s*#\s*include\s*["<]percolith/([^">]+)[">]', line)
                if not found or found[1] in GENERATED:
                    continue
                other = found[1].split("/")[0]
                if other != room and other not in rooms[room]:
                    allowed = ", ".join(sorted(rooms[room])) or "none"
                    problems.append(f"{file}:{number}: room {room} includes {found[1]}; "
                                    f"allowed: {allowed}")
    return problems


def main() -> int:
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    source = root / "src" / "percolith"
    rooms = declared_rooms((source / "CMakeLists.txt").read_text())
    problems = order_problems(rooms) + include_problems(source, rooms)
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
