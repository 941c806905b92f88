# SPDX-License-Identifier: BSD-3-Clause
"""Whether this machine's processor can run the extension, which may have been built on another."""

from __future__ import annotations

import importlib
from pathlib import Path

# What the level x86-64-v3 has beyond older processors, as Linux calls it.
_NEEDED = {"x86-64-v3": ("avx2", "bmi1", "bmi2", "f16c", "fma", "movbe")}


def missing_features(architecture: str, information: str) -> list[str]:
    """Features of the architecture that the text of /proc/cpuinfo does not name; none where it does
    not tell of features at all."""
    lines = [line.split(":", 1)[1].split() for line in information.splitlines()
             if line.startswith("flags") and ":" in line]
    return [name for name in _NEEDED.get(architecture, ()) if lines and name not in lines[0]]


def require_processor() -> None:
    """Raises ImportError where the extension would end the program with an illegal instruction."""
    try:
        architecture = importlib.import_module("percolith._built_for").architecture
        information = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    except (ImportError, OSError):
        return
    if missing := missing_features(architecture, information):
        raise ImportError(f"percolith was built for processors of the level {architecture}; this one "
                          f"lacks {', '.join(missing)}. Build it for this machine: pip install . "
                          "-C cmake.define.PERCOLITH_NATIVE=ON "
                          "-C cmake.define.PERCOLITH_ARCHITECTURE=")
