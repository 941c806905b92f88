#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Adds up JUnit reports: prints 'PASSED FAILED SKIPPED' of all the files named.

A file that cannot be read counts as one failure: the program that should have written it stopped.
"""

import sys
import xml.etree.ElementTree as ElementTree


def count(path: str) -> tuple[int, int, int]:
    """Passed, failed and skipped tests of one report."""
    try:
        cases = list(ElementTree.parse(path).getroot().iter("testcase"))
    except (OSError, ElementTree.ParseError):
        return 0, 1, 0
    failed = sum(any(case.find(tag) is not None for tag in ("failure", "error"))
                 for case in cases)
    skipped = sum(case.find("skipped") is not None for case in cases)
    return len(cases) - failed - skipped, failed, skipped


if __name__ == "__main__":
    print(*(sum(column) for column in zip(*(count(path) for path in sys.argv[1:]))))
