# SPDX-License-Identifier: BSD-3-Clause
"""What the lengths of cracks in a history stand for."""

from __future__ import annotations

from percolith.run_directory import RunDirectory


def open_to_fluid(run: RunDirectory) -> str:
    """The joints that `crack_length_m` counts: all that fluid can be in. Where fluid enters those
    that soften these need not have broken, so that there may be cracks and no broken joint."""
    softening = run.resolved.get("model", {}).get("fluid_enters") == "softening"
    return f"open to fluid ({'broken or softening' if softening else 'broken'} joints)"
