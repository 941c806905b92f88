# SPDX-License-Identifier: BSD-3-Clause
"""Draws the figures of docs/concepts.md as SVG.

    python docs/figures/draw.py [FOLDER]      # default: docs/figures
"""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import curves  # noqa: E402
import mesh  # noqa: E402
import steps  # noqa: E402
import style  # noqa: E402

FIGURES = {**mesh.FIGURES, **curves.FIGURES, **steps.FIGURES}


def draw(folder: Path) -> None:
    """Draws all figures into `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, make in FIGURES.items():
        style.save(make(), folder / f"{name}.svg")


if __name__ == "__main__":
    draw(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)
