# SPDX-License-Identifier: BSD-3-Clause
"""A crack under a given pressure: opening, volume, order in the element size; with and without
stress in the rock."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from fracture_formulas import PressedCrack
from program import run_case
from report import Chapter
from solid_formulas import plane_modulus

TITLE = "Crack under pressure: opening and volume"
HERE = Path(__file__).parent
PRESSURE = 1e6  # Pa, above the stress across the crack
CRACK = PressedCrack(1.0, plane_modulus(10e9, 0.25))
PER_LENGTH = (20, 40, 80)  # elements along half of the crack
STRESSED = {"in_situ.stress_xx": -5e6, "in_situ.stress_yy": -5e6,
            "boundary.outer.groups": ["outer"], "boundary.outer.in_situ": True,
            "initial.crack_pressure": 5e6,
            "source.pump.pressure": {"times": [0, 10e-3], "values": [5e6, 6e6]},
            "time.stop_ratio": 1e-6}


def opening(frame) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Middles of the segments of the crack (m) from its middle on, their opening and length (m)."""
    ends = frame.cracks.points[frame.cracks.cells][:, :, 0]
    order = np.argsort(ends.mean(axis=1))
    return (ends.mean(axis=1)[order], frame.cracks.cell_data["opening_m"][order],
            abs(np.diff(ends, axis=1)).ravel()[order])


def errors(frame) -> tuple[float, float]:
    """Relative, of the opening in the middle and of the volume."""
    x, width, length = opening(frame)
    return (width[0] / CRACK.opening(x[0], PRESSURE) - 1,
            width @ length / (0.5 * CRACK.compliance * PRESSURE) - 1)


def check(chapter: Chapter, work: Path) -> None:
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    volumes = []
    for number, colour in zip(PER_LENGTH, plt.cm.viridis([0.75, 0.45, 0.15])):
        mesh = HERE / f"sneddon_{number}.msh"
        run = run_case(HERE / "case.toml", work / mesh.stem, {"mesh.file": str(mesh)}).results
        x, width, _ = opening(run.frame())
        left.plot(x, width * 1e3, ".", markersize=4, color=colour, label=f"L/{number}")
        middle, volume = errors(run.frame())
        volumes.append(volume)
    line = np.linspace(0, 1, 200)
    left.plot(line, CRACK.opening(line, PRESSURE) * 1e3, "k", linewidth=1, label="exact")
    chapter.at_most("opening", "opening in the middle, elements of L/80: relative error",
                    abs(middle), 0.02)
    chapter.at_most("volume", "volume, elements of L/80: relative error", abs(volume), 0.02)
    coarse, fine = volumes[0] - volumes[1], volumes[1] - volumes[2]
    chapter.at_least("order", "order of the volume in the element size over three meshes",
                     np.log2(coarse / fine), 0.8)
    chapter.at_most("rest", "unbalanced force over internal forces at the end",
                    run.history["unbalanced_ratio"][-1], 1e-4)
    chapter.at_most("energy", "error of the energy balance", solid.residual(run), 1e-3)
    stressed = run_case(HERE / "case.toml", work / "stressed", STRESSED).results
    unstressed = volumes[PER_LENGTH.index(40)]
    chapter.at_most("stressed", "rock under 5 MPa, pressure rises from 5 to 6 MPa: difference of "
                    "the volume from that without stress",
                    abs(errors(stressed.frame())[1] - unstressed), 2e-3)
    right.loglog(1 / np.array(PER_LENGTH), np.abs(volumes), "o-", color=plt.cm.viridis(0.3),
                 label="computed")
    right.loglog(1 / np.array(PER_LENGTH), abs(volumes[0]) * PER_LENGTH[0] / np.array(PER_LENGTH),
                 "k:", label="order 1")
    left.set_xlabel("Distance from the middle (m)")
    left.set_ylabel("Opening (mm)")
    right.set_xlabel("Element size over half-length")
    right.set_ylabel("Relative error of the volume")
    for axes in (left, right):
        axes.grid(alpha=0.3, which="both")
        axes.legend(frameon=False)
    chapter.add_figure(figure, "Opening of the crack, and the error of its volume")
