# SPDX-License-Identifier: BSD-3-Clause
"""Compression between platens: peak stress on the Mohr-Coulomb line, on three meshes."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import ROOT
from report import Chapter
from solid_formulas import mohr_coulomb
from studies import check_criteria, run_example

TITLE = "Compression, uniaxial and confined: strength and shear bands"
WIDTH, HEIGHT, COHESION, FRICTION = 0.05, 0.1, 10e6, np.radians(30)
CONFINEMENTS = (0.0, 5e6, 10e6)  # Pa
MESHES = {"2.5 mm": "compression.msh", "1.8 mm": "compression_medium.msh",
          "1.25 mm": "compression_fine.msh"}


def stress_and_strain(run):
    """Axial stress between the platens (Pa, compression positive) and axial strain."""
    history = run.history
    stress = 0.5 / WIDTH * (history["body.bottom_platen.reaction_y_N_per_m"]
                            - history["body.top_platen.reaction_y_N_per_m"])
    strain = (history["body.bottom_platen.displacement_y_m"]
              - history["body.top_platen.displacement_y_m"]) / HEIGHT
    return stress, strain


def run_at(work: Path, label: str, confinement: float, mesh: str):
    """The shipped case under another side pressure, on another mesh."""
    settings = {"mesh.file": str(ROOT / "examples/compression" / mesh),
                "boundary.sides.normal_pressure": {"times": [0, 0.5e-3],
                                                   "values": [0, confinement]}}
    return run_example("compression", work, label, settings).results


def check(chapter: Chapter, work: Path) -> None:
    shipped = check_criteria(chapter, "compression", work).results
    confined = {5e6: shipped}
    for pressure in (0.0, 10e6):
        label = f"at_{pressure / 1e6:.0f}_MPa"
        confined[pressure] = run_at(work, label, pressure, MESHES["2.5 mm"])
    meshes = {"2.5 mm": shipped}
    for name in ("1.8 mm", "1.25 mm"):
        meshes[name] = run_at(work, Path(MESHES[name]).stem, 5e6, MESHES[name])
    peaks = {}
    for pressure in CONFINEMENTS:
        peaks[pressure] = stress_and_strain(confined[pressure])[0].max()
        expected = mohr_coulomb(pressure, COHESION, FRICTION)
        chapter.at_most(f"at_{pressure / 1e6:.0f}_MPa.peak", f"side pressure {pressure / 1e6:.0f} "
                        f"MPa: peak stress over that of Mohr and Coulomb, {expected / 1e6:.1f} "
                        "MPa, less 1", abs(peaks[pressure] / expected - 1), 0.1)
        chapter.at_most(f"at_{pressure / 1e6:.0f}_MPa.balance", f"side pressure "
                        f"{pressure / 1e6:.0f} MPa: error of the energy balance",
                        solid.residual(confined[pressure]), 1e-3)
    expected = mohr_coulomb(5e6, COHESION, FRICTION)
    for name, run in meshes.items():
        peak = stress_and_strain(run)[0].max()
        chapter.at_most(f"mesh.{name.replace(' ', '_')}", f"elements of {name}: peak stress at 5 "
                        "MPa over that of Mohr and Coulomb, less 1", abs(peak / expected - 1), 0.1)
    curves(chapter, confined, meshes)
    pictures(chapter, confined, meshes)


def curves(chapter: Chapter, confined: dict, meshes: dict) -> None:
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(13, 4.2), layout="constrained")
    for pressure, colour in zip(CONFINEMENTS, plt.cm.viridis([0.1, 0.45, 0.8])):
        stress, strain = stress_and_strain(confined[pressure])
        left.plot(strain * 100, stress / 1e6, color=colour, label=f"{pressure / 1e6:.0f} MPa")
        middle.plot(pressure / 1e6, stress.max() / 1e6, "o", color=colour)
    line = np.linspace(0, 12e6, 20)
    middle.plot(line / 1e6, mohr_coulomb(line, COHESION, FRICTION) / 1e6, "k--", linewidth=1,
                label="Mohr and Coulomb")
    for (name, run), colour in zip(meshes.items(), plt.cm.viridis([0.1, 0.45, 0.8])):
        stress, strain = stress_and_strain(run)
        right.plot(strain * 100, stress / 1e6, color=colour, label=name)
    for axes, title in ((left, "By side pressure"), (right, "5 MPa, by element size")):
        axes.set_title(title, fontsize=10)
        axes.set_xlabel("Axial strain (%)")
    middle.set_title("Peaks", fontsize=10)
    middle.set_xlabel("Side pressure (MPa)")
    for axes in (left, middle, right):
        axes.set_ylabel("Axial stress (MPa)")
        axes.grid(alpha=0.3)
        axes.legend(frameon=False, fontsize="small")
    chapter.add_figure(figure, "Axial stress and its peak")


def pictures(chapter: Chapter, confined: dict, meshes: dict) -> None:
    shown = [(f"{p / 1e6:.0f} MPa, 2.5 mm", confined[p]) for p in CONFINEMENTS]
    shown += [(f"5 MPa, {name}", meshes[name]) for name in ("1.8 mm", "1.25 mm")]
    figure, row = plt.subplots(1, len(shown), figsize=(14, 5.5), layout="constrained", sharey=True)
    for (name, run), axes in zip(shown, row):
        solid.draw_rock(axes, run.frame(), edges="white")
        solid.draw_cracks(axes, run.frame())
        axes.set_title(name, fontsize=10)
    chapter.add_figure(figure, "Joints that broke at the end of the runs, by how they broke")
