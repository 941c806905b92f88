# SPDX-License-Identifier: BSD-3-Clause
"""The reference of the Python package, from its docstrings."""

from __future__ import annotations

import ast

from site_map import ROOT

# Classes whose members stand in a base class of their own.
WITH_BASES = {"RunDirectory"}
GROUPS = {
    "Cases": ["Case", "describe", "option_names", "Option", "quantity"],
    "Runs": ["Simulation", "resume", "sweep", "Sweep", "SweepProgress"],
    "Results": ["open_run", "RunDirectory", "Frame", "Table", "Grid", "read_vtu", "report"],
    "Errors": ["Error", "CaseError", "CaseWarning", "Problem", "SolverError", "FileError",
               "MeshError", "RunDirectoryError", "ArgumentError", "UnknownNameError", "VtuError"],
}
# Classes of the extension that no one makes but a simulation hands out, by the attributes that do.
HANDED_OUT = {"Mesh": "mesh", "Flow": "flow", "Motion": "motion", "CheckReport": "check()",
              "StepLimit": "check().limits"}


def exported(file: str) -> list[str]:
    """What `__all__` of a module lists, read without importing it."""
    for part in ast.parse((ROOT / file).read_text(encoding="utf-8")).body:
        if isinstance(part, ast.Assign) and getattr(part.targets[0], "id", "") == "__all__":
            return [name for name in ast.literal_eval(part.value) if not name.startswith("__")]
    raise ValueError(f"{file}: no __all__")


def entry(module: str, name: str) -> str:
    kind = "autoclass" if name[0].isupper() else "autofunction"
    members = "\n   :members:\n   :undoc-members:" if kind == "autoclass" else ""
    if name in WITH_BASES:
        members += "\n   :inherited-members:"
    return f"```{{eval-rst}}\n.. {kind}:: {module}.{name}{members}\n```\n\n"


def handed_out() -> str:
    """What `mesh`, `flow`, `motion` and `check` of a simulation are."""
    parts = ["## State of a simulation\n\nWhat a `Simulation` hands out. Arrays are those of the "
             "simulator, without copies: read-only, and as they are after the last step.\n\n"]
    for name, attribute in HANDED_OUT.items():
        parts.append(f"`simulation.{attribute}`:\n\n" + entry("percolith._core", name))
    return "".join(parts)


def page() -> str:
    """All that the package exports; what stands in no group comes behind them."""
    listed = {name for names in GROUPS.values() for name in names}
    others = sorted(set(exported("python/percolith/__init__.py")) - listed - {"mesh"})
    groups = {**GROUPS, "More": others} if others else GROUPS
    parts = ["# Reference of the Python package\n\n[Percolith from Python](python.md) tells how to use it; "
             "this page is made from its docstrings.\n\n"]
    for group, names in groups.items():
        parts.append(f"## {group}\n\n" + "".join(entry("percolith", name) for name in names))
        if group == "Runs":
            parts.append(handed_out())
    parts.append("## Meshes\n\n" + "".join(
        entry("percolith.mesh", name) for name in exported("python/percolith/mesh/__init__.py")))
    return "".join(parts)
