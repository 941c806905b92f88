# SPDX-License-Identifier: BSD-3-Clause
"""What is verified and by which criteria, read from verification/*/check.py, with the values of the
last `make verify` where there are any."""

from __future__ import annotations

import ast
import html
import json
import math
import time
from dataclasses import dataclass
from pathlib import Path

import criteria_text
import links
from site_map import ROOT

RESULTS = ROOT / "build/verify"
SENSE = {"at_most": "≤", "at_least": "≥"}
OF_EXAMPLE = {"check_criteria", "check_example"}


@dataclass(frozen=True)
class Row:
    quantity: str
    limit: str
    line: int


def title_of(module: ast.Module) -> str:
    for part in module.body:
        if isinstance(part, ast.Assign) and getattr(part.targets[0], "id", "") == "TITLE":
            return ast.literal_eval(part.value)
    raise links.Missing("a check.py has no TITLE")


def constants(module: ast.Module) -> dict[str, object]:
    """The numbers that a module names at its top."""
    return {part.targets[0].id: part.value.value for part in module.body
            if isinstance(part, ast.Assign) and isinstance(part.targets[0], ast.Name)
            and isinstance(part.value, ast.Constant)}


def words(node: ast.expr, known: dict[str, object]) -> str:
    """A text of the source, with `…` where it takes in a value."""
    if isinstance(node, ast.JoinedStr):
        return "".join(words(part, known) for part in node.values)
    if isinstance(node, ast.FormattedValue):
        return "…"
    if isinstance(node, ast.Name) and node.id in known:
        node = ast.Constant(known[node.id])
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return "-" + words(node.operand, known)
    if isinstance(node, ast.Constant):
        return f"{node.value:g}" if isinstance(node.value, float | int) else str(node.value)
    return "…"


def rows_of(module: ast.Module, helpers: dict[str, ast.Module]) -> list[Row]:
    """The comparisons that a check makes, in the order of its lines."""
    known = constants(module)
    found = []
    for call in ast.walk(module):
        if not isinstance(call, ast.Call):
            continue
        name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
        if name in SENSE:
            limit = f"{SENSE[name]} {words(call.args[3], known)}"
            found.append(Row(words(call.args[1], known), limit, call.lineno))
        elif name in OF_EXAMPLE and isinstance(call.args[1], ast.Constant):
            found += [Row(one.quantity, f"≤ {one.limit:g}", call.lineno)
                      for one in criteria_text.read(call.args[1].value)]
        elif name in helpers:
            found += [Row(row.quantity, row.limit, call.lineno)
                      for row in rows_of(helpers[name], {})]
    return sorted(found, key=lambda row: row.line)


def shared_checks() -> dict[str, ast.Module]:
    """Functions beside the folders that add rows of their own, by name."""
    found = {}
    for file in sorted((ROOT / "verification").glob("*.py")):
        for part in ast.parse(file.read_text(encoding="utf-8")).body:
            if isinstance(part, ast.FunctionDef) and part.name not in OF_EXAMPLE:
                module = ast.Module([part], [])
                if rows_of(module, {}):
                    found[part.name] = module
    return found


def measured(folder: Path = RESULTS) -> dict[str, list[dict]]:
    """The rows of the last `make verify` by chapter; none where it has not run."""
    file = folder / "report.json"
    if not file.is_file():
        return {}
    chapters: dict[str, list[dict]] = {}
    for row in json.loads(file.read_text()):
        chapters.setdefault(row["id"].split(".")[0], []).append(row)
    return chapters


def text(value: float | None) -> str:
    return "no number" if value is None or math.isnan(value) else f"{value:.3g}"


def measured_table(rows: list[dict]) -> str:
    lines = []
    for row in rows:
        sign = "≤" if row["sense"] == "max" else "≥"
        mark = "pass" if row["pass"] else "**FAIL**"
        lines.append(f"| {html.escape(row['quantity'], quote=False)} | {text(row['value'])} "
                     f"| {sign} {text(row['limit'])} | {mark} |\n")
    return "| quantity | value | limit | |\n|---|---|---|---|\n" + "".join(lines)


def declared_table(site: links.Site, file: str, rows: list[Row]) -> str:
    lines = []
    for row in rows:
        place = links.source_link(site, "verification/index", file, "check.py", row.line)
        lines.append(f"| {row.quantity} | {row.limit} | {place} |\n")
    return "| quantity | limit | where |\n|---|---|---|\n" + "".join(lines)


def introduction(values: dict[str, list[dict]]) -> str:
    if not values:
        return ("The tables below hold every comparison with its limit; `…` stands for what a loop fills "
                "in. `make verify` computes the values and draws the figures: run it before `make "
                "docs`, and they stand here.")
    date = time.strftime("%Y-%m-%d", time.gmtime((RESULTS / "report.json").stat().st_mtime))
    count = sum(len(rows) for rows in values.values())
    passed = sum(row["pass"] for rows in values.values() for row in rows)
    return (f"The last `make verify`, of {date}: {passed} of {count} comparisons pass. "
            '<a href="report.html">Its page has every figure</a>, those of the paper first. What it did '
            "not run stands below with its limits alone.")


def page(site: links.Site) -> str:
    """Every comparison, for the end of the page on verification."""
    values = measured()
    helpers = shared_checks()
    parts = ["\n## All comparisons\n\n", introduction(values), "\n"]
    for check in sorted((ROOT / "verification").glob("*/check.py")):
        name, file = check.parent.name, check.relative_to(ROOT).as_posix()
        module = ast.parse(check.read_text(encoding="utf-8"))
        parts.append(f"\n### {title_of(module)}\n\n")
        if f"verification/{name}/README.md" in site.pages:
            parts.append(f"[How it is set up, and what was seen]({name}/index.md)\n\n")
        if name in values:
            parts.append(f'<a href="report.html#{name}">Figures</a>\n\n'
                         + measured_table(values[name]))
        else:
            parts.append(declared_table(site, file, rows_of(module, helpers)))
    return "".join(parts)
