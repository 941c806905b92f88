# SPDX-License-Identifier: BSD-3-Clause
"""Compares the program with every reference, or with one, and writes the page of all results.

    python verification/run.py [NAME | --case NAME]...

Each folder here with a `check.py` is one verification. Exit code 1 when any comparison fails, or
when a figure of the paper lacks a picture or a row that its chapter should have.
"""

from __future__ import annotations

import argparse
import importlib.util
import sys
import time
import traceback
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import report  # noqa: E402
from program import ROOT, ProgramError, program  # noqa: E402

OUTPUT = ROOT / "build/verify"


def available() -> list[str]:
    return sorted(file.parent.name for file in HERE.glob("*/check.py"))


def load(name: str):
    """The module verification/NAME/check.py: a TITLE and a function check(chapter, work)."""
    spec = importlib.util.spec_from_file_location(f"check_{name}", HERE / name / "check.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def verify(name: str) -> report.Chapter:
    """Runs one verification; an error in it becomes part of its chapter."""
    chapter = report.Chapter(name)
    module = load(name)
    chapter.title = module.TITLE
    try:
        module.check(chapter, OUTPUT / "runs" / name)
    except Exception:  # the other verifications still have something to say
        chapter.error = traceback.format_exc()
    return chapter


def say(chapter: report.Chapter, seconds: float) -> None:
    print(f"\n{chapter.title} ({seconds:.0f} s)")
    for row in chapter.rows:
        sign = "<=" if row.sense == "max" else ">="
        mark = "pass" if row.passes else "FAIL"
        print(f"  {mark}  {row.id}: {row.quantity}: {row.value:.4g} {sign} {row.limit:.4g}")
    if chapter.error:
        print(f"  FAIL  {chapter.error}")
    sys.stdout.flush()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(available()))
    parser.add_argument("--case", action="append", default=[], metavar="NAME", help="same as NAME")
    arguments = parser.parse_args()
    names = [name for name in arguments.names + arguments.case if name] or available()
    for name in names:
        if name not in available():
            parser.error(f"{name}: no such verification; allowed: {', '.join(available())}")
    try:
        print(f"program: {program()}")
    except ProgramError as error:
        parser.error(str(error))
    chapters = []
    for name in names:
        start = time.perf_counter()
        chapters.append(verify(name))
        say(chapters[-1], time.perf_counter() - start)
    lacking = report.write(chapters, OUTPUT)
    for what in lacking:
        print(f"FAIL  the paper's {what}")
    passed = sum(chapter.passes for chapter in chapters)
    print(f"\n{passed} of {len(chapters)} verifications pass; {OUTPUT / 'index.html'}")
    return 0 if passed == len(chapters) and not lacking else 1


if __name__ == "__main__":
    sys.exit(main())
