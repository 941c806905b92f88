#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the comments of C++ structs as constants, for the docstrings of the extension.

Usage: member_docs.py OUTPUT HEADER STRUCT... [-- HEADER STRUCT...]... Each struct gives its own
comment as `docs::Struct` and those of its members as `docs::Struct_member`.
"""

import re
import sys
from pathlib import Path

_MEMBER = re.compile(r"^  [\w:<>, ]+?[\s>](\w+(?:\s*=\s*[^,;]+)?(?:, \w+(?:\s*=\s*[^,;]+)?)*)"
                     r"(?:\{\})?;(?:\s*///<\s*(.*))?$")


def comment_above(lines: list[str], number: int) -> str:
    """The block of `///` that ends before line `number`."""
    words: list[str] = []
    while number > 0 and lines[number - 1].strip().startswith("///"):
        number -= 1
        words.insert(0, lines[number].strip().removeprefix("///").strip())
    return " ".join(words)


def trailing_comment(lines: list[str], number: int, start: str) -> str:
    """A comment after a member, with the lines that carry it on."""
    words = [start]
    while number + 1 < len(lines) and lines[number + 1].strip().startswith("///<"):
        number += 1
        words.append(lines[number].strip().removeprefix("///<").strip())
    return " ".join(words)


def struct_docs(text: str, name: str) -> dict[str, str]:
    """The comments of one struct and its members; raises KeyError where there is no such struct."""
    lines = text.splitlines()
    starts = [i for i, line in enumerate(lines) if line.startswith(f"struct {name} {{")]
    if not starts:
        raise KeyError(name)
    docs = {name: comment_above(lines, starts[0])}
    for number in range(starts[0] + 1, len(lines)):
        if lines[number].startswith("};"):
            break
        member = _MEMBER.match(lines[number])
        if member:
            trailing = trailing_comment(lines, number, member[2]) if member[2] else ""
            for one in re.findall(r"(\w+)(?:\s*=[^,]+)?", member[1]):
                docs[f"{name}_{one}"] = trailing or comment_above(lines, number)
    return docs


def main(arguments: list[str]) -> int:
    output, rest = Path(arguments[0]), arguments[1:]
    docs: dict[str, str] = {}
    while rest:
        end = rest.index("--") if "--" in rest else len(rest)
        header, *structs = rest[:end]
        for struct in structs:
            docs |= struct_docs(Path(header).read_text(encoding="utf-8"), struct)
        rest = rest[end + 1:]
    lines = ["// SPDX-License-Identifier: BSD-3-Clause",
             "// Written by python/member_docs.py from the comments of the headers; do not edit.",
             "#pragma once", "", "namespace percolith::python::docs {", ""]
    for name, text in docs.items():
        quoted = text.replace("\\", "\\\\").replace('"', '\\"')
        lines.append(f'inline constexpr const char* {name} = "{quoted}";')
    lines += ["", "}  // namespace percolith::python::docs", ""]
    output.write_text("\n".join(lines), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
