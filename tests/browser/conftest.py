# SPDX-License-Identifier: BSD-3-Clause
"""Pages of runs that need no program, opened in a headless browser."""

import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests/python")]

SIZE = 4.0  # m, side of the square of the run of flow
PRESSURE = 2e6  # Pa, at its right side; it grows linearly from zero at the left one
APERTURE = 2e-4  # m


def _write_flow_run(folder: Path) -> Path:
    """A square of flow at rest with a fracture along the line y = 1 from x = 1 to 3."""
    from synthetic_run import write_grid, write_series

    folder.mkdir()
    (folder / "resolved.toml").write_text(
        'title = "Flow through a square"\n[time]\nscheme = "steady"\n')
    count = 8
    x, y = np.meshgrid(np.linspace(0, SIZE, count + 1), np.linspace(0, SIZE, count + 1))
    points = np.stack([x.ravel(), y.ravel()], axis=1)
    row, column = (part.ravel() for part in np.divmod(np.arange(count**2), count))
    a = row * (count + 1) + column
    cells = np.concatenate([np.stack([a, a + 1, a + count + 2], 1),
                            np.stack([a, a + count + 2, a + count + 1], 1)])
    centre = points[cells].mean(axis=1)
    write_grid(folder / "fields/matrix_000000.vtu", points, cells,
               {"pressure_Pa": PRESSURE * points[:, 0] / SIZE, "saturation": np.ones(len(points))},
               {"region": (centre[:, 1] > 2).astype("<i4"),
                "darcy_flux_m_per_s": 1e-6 * np.ones((len(cells), 2))})
    ends = np.stack([np.linspace(1, 3, 5), np.ones(5)], axis=1)
    write_grid(folder / "fields/cracks_000000.vtu", ends,
               np.stack([np.arange(4), np.arange(1, 5)], axis=1),
               {"pressure_Pa": np.full(5, PRESSURE / 4), "saturation": np.ones(5)},
               {"fracture": np.zeros(4, "<i4"), "aperture_m": np.full(4, APERTURE),
                "flux_m2_per_s": np.full(4, -3e-6)})
    write_series(folder, "matrix", {0: 0.0})
    write_series(folder, "cracks", {0: 0.0})
    return folder


@pytest.fixture(scope="session")
def pages(tmp_path_factory):
    """Addresses of the pages of a run of each physics."""
    from percolith import report
    from synthetic_coupled_run import write_coupled_run
    from synthetic_run import write_mechanics_run

    folder = tmp_path_factory.mktemp("runs")
    made = {"flow": _write_flow_run(folder / "flow"),
            "mechanics": write_mechanics_run(folder / "mechanics"),
            "coupled": write_coupled_run(folder / "coupled")}
    return {name: f"file://{report(run)}" for name, run in made.items()}


@pytest.fixture
def browser(tmp_path):
    from browser import Page

    page = Page(tmp_path)
    yield page
    page.close()
