#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that hold for every file of the project.

Usage: check_sources.py RULE [ROOT], RULE one of: licence, length, unfinished, machine-paths.
Prints one line a violation; exit code 1 if there is any.
"""

import re
import sys
from pathlib import Path

from source_tree import files, is_code, lines

LONGEST_FILE = 800
LICENCE = "SPDX-License-Identifier: BSD-3-Clause"
# Written so that this file does not find itself.
UNFINISHED = re.compile(r"\b(?:TO[D]O|FIX[M]E|XX[X])\b")
MACHINE_PATH = re.compile(r"(?<![\w.~<}$)-])/(?:work|root|home|tmp)/[\w.]")


def licence(path: Path, text: list[str]) -> list[str]:
    """Code starts with the licence line, after the line that names its interpreter if any."""
    if not is_code(path):
        return []
    first = text[1:2] if text and text[0].startswith("#!") else text[:1]
    return [] if first and LICENCE in first[0] else [f"{path}:1: no line '{LICENCE}'"]


def length(path: Path, text: list[str]) -> list[str]:
    if is_code(path) and len(text) > LONGEST_FILE:
        return [f"{path}: {len(text)} lines; allowed: {LONGEST_FILE}"]
    return []


def unfinished(path: Path, text: list[str]) -> list[str]:
    return [f"{path}:{number}: unfinished: {line.strip()}"
            for number, line in enumerate(text, 1) if UNFINISHED.search(line)]


def machine_paths(path: Path, text: list[str]) -> list[str]:
    return [f"{path}:{number}: path of one machine: {line.strip()}"
            for number, line in enumerate(text, 1) if MACHINE_PATH.search(line)]


RULES = {"licence": licence, "length": length, "unfinished": unfinished,
         "machine-paths": machine_paths}


def main() -> int:
    if len(sys.argv) < 2 or sys.argv[1] not in RULES:
        print(__doc__, file=sys.stderr)
        return 2
    rule = RULES[sys.argv[1]]
    root = Path(sys.argv[2]) if len(sys.argv) > 2 else Path(__file__).resolve().parent.parent
    problems = [problem for path in files(root) for problem in rule(path, lines(path))]
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
