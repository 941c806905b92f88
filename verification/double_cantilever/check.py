# SPDX-License-Identifier: BSD-3-Clause
"""Two arms pulled apart: load of the crack as it runs, on two meshes; energy per area of crack."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import ROOT
from report import Chapter
from solid_formulas import DoubleCantilever
from studies import check_criteria, run_example

TITLE = "Double cantilever: load and energy of a running crack"
BEAM = DoubleCantilever(10e9, 0.2, 100.0, 0.1)
NOTCH, RUN = 0.3, 0.15  # m: length of the notch, of the line that may break
MEASURED = (0.32, 0.37)  # m: lengths of the crack over which the load is compared


class Curve:
    """Opening of the ends (m), load (N/m), length of the crack by its broken joints (m) and
    energy spent in joints (J/m) over time."""

    def __init__(self, run, joints: int):
        history = run.history
        self.opening = (history["boundary.upper_end.displacement_y_m"]
                        - history["boundary.lower_end.displacement_y_m"])
        self.load = 0.5 * (history["boundary.upper_end.reaction_y_N_per_m"]
                           - history["boundary.lower_end.reaction_y_N_per_m"])
        broken = history["broken_joints"] - history["broken_joints"][0]
        self.length = NOTCH + broken * RUN / joints
        self.energy = history["fracture_J_per_m"]

    def measured(self) -> np.ndarray:
        return (self.length > MEASURED[0]) & (self.length < MEASURED[1])

    def load_error(self) -> float:
        """Mean over the measured lengths of the load over that of the beams, less 1."""
        chosen = self.measured()
        return float(np.mean(self.load[chosen] / BEAM.load(self.length[chosen])) - 1)

    def energy_per_area(self) -> float:
        chosen = self.measured()
        return float(np.polyfit(self.length[chosen], self.energy[chosen], 1)[0])


def check(chapter: Chapter, work: Path) -> None:
    run = check_criteria(chapter, "double_cantilever", work).results
    mesh = ROOT / "examples/double_cantilever/double_cantilever_fine.msh"
    fine = run_example("double_cantilever", work, "fine", {"mesh.file": str(mesh)}).results
    curves = {"2 mm": Curve(run, 75), "1 mm": Curve(fine, 150)}
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    for (name, curve), colour in zip(curves.items(), plt.cm.viridis([0.2, 0.65])):
        label = name.replace(" ", "_")
        chapter.at_most(f"{label}.load", f"elements of {name}: load of the running crack over that "
                        "of the beams for its length, less 1", abs(curve.load_error()), 0.05)
        chapter.at_most(f"{label}.peak", f"elements of {name}: largest load over that of the beams "
                        "for the notch, less 1",
                        abs(curve.load.max() / BEAM.load(NOTCH) - 1), 0.05)
        chapter.at_most(f"{label}.energy", f"elements of {name}: energy per area of crack over "
                        "G_I, less 1", abs(curve.energy_per_area() / 100 - 1), 0.05)
        left.plot(curve.opening * 1e3, curve.load / 1e3, color=colour, label=name)
        right.plot(curve.opening * 1e3, curve.length, color=colour, label=name)
    chapter.at_most("meshes", "load of the running crack, difference of both meshes",
                    abs(curves["2 mm"].load_error() - curves["1 mm"].load_error()), 0.01)
    chapter.at_most("balance", "error of the energy balance", solid.residual(run), 1e-3)
    opening = np.linspace(0, curves["2 mm"].opening[-1], 200)
    running = BEAM.length(opening) > NOTCH
    length = np.maximum(BEAM.length(opening), NOTCH)
    load = np.where(running, BEAM.load(length), BEAM.elastic_load(opening, NOTCH))
    left.plot(opening * 1e3, load / 1e3, "k--", linewidth=1, label="beams")
    right.plot(opening * 1e3, length, "k--", linewidth=1,
               label="beams")
    left.set_ylabel("Load (kN/m)")
    right.set_ylabel("Length of the crack (m)")
    for axes in (left, right):
        axes.set_xlabel("Opening of the ends (mm)")
        axes.grid(alpha=0.3)
        axes.legend(frameon=False)
    chapter.add_figure(figure, "Load and length of the crack over the opening of the ends")
    picture(chapter, run)


def picture(chapter: Chapter, run) -> None:
    frame = run.frame()
    figure, axes = plt.subplots(figsize=(9, 4), layout="constrained")
    stress = frame.matrix.cell_data["stress_yy_Pa"] / 1e6
    rock = solid.draw_rock(axes, frame, stress, (-10, 10), magnify=20, colours="RdBu_r")
    solid.colour_bar(figure, axes, rock, "Stress across the crack (MPa)")
    axes.set_title("Deformed 20 times", fontsize=10)
    chapter.add_figure(figure, "The crack at the end of the run")
