# SPDX-License-Identifier: BSD-3-Clause
"""A hydraulic fracture meets a natural one: it crosses, stops, or turns into it and leaves at its
ends; the friction from which on it crosses, against Renshaw and Pollard; on two meshes."""

from pathlib import Path

import coupled
import matplotlib.pyplot as plt
import numpy as np
import solid
from crack_paths import branches, broken_lines
from fracture_formulas import crossing_friction
from program import ROOT, run_case
from report import Chapter
from set_ups import mesh_figure
from studies import check_criteria, run_example

TITLE = "Hydraulic fracture against a natural one: crossing, arrest, offset"
EXAMPLE = ROOT / "examples/natural_fractures"
DISTANCE, UP, DOWN = 0.6, 0.3, 0.45  # m, of the natural fracture from the well, and of its ends
STRENGTH, SMALLER = 2e6, 1e6  # Pa, in tension; compression across the hydraulic fracture
BRIDGE = 0.05  # m, a crack may go on beside its tip, one element away
WINDOW = ((0, 1.4), (-0.8, 0.6))
NOTES = [(1.2, 1.1, "in-situ stress, absorbing"), (0.35, -0.9, "on rollers"),
         (0.25, 0.12, "pump"), (0.85, 0.25, "natural fracture")]
COARSE = {"mesh.file": str(EXAMPLE / "natural_fractures_coarse.msh")}
LATE = 14e-3  # s, by when a crack that crosses is across
COMPRESSIONS = (2.5e6, 5e6)  # Pa, on the natural fracture
BELOW, ABOVE = 0.4, 1.3  # friction over that of the formula: it stops, it crosses


def reach(frame) -> dict[str, float]:
    """How far (m) beyond the natural fracture cracks that hang together with the well have come:
    near the place where both met, and near each end."""
    points = branches(broken_lines(frame), {"well": [(0.0, 0.0)]}, BRIDGE)["well"]
    beyond, y = points[:, 0] - DISTANCE, points[:, 1]
    places = {"middle": abs(y) < 0.2, "upper": y > UP - 0.1, "lower": y < -DOWN + 0.1}
    return {name: float(max(0.0, *beyond[chosen], 0.0)) for name, chosen in places.items()}


def natural(frame, quantity: str) -> np.ndarray:
    """Values of the joints of the natural fracture."""
    lines = frame.cracks.points[frame.cracks.cells]
    return frame.cracks.cell_data[quantity][(abs(lines[..., 0] - DISTANCE) < 1e-6).all(axis=1)]


def outcomes(chapter: Chapter, mesh: str, runs: dict) -> None:
    """The three outcomes on one mesh."""
    found = {name: reach(run.frame()) for name, run in runs.items()}
    key = mesh.replace(" ", "")
    chapter.at_least(f"{key}.crosses", f"{mesh}, crossing: way beyond the natural fracture, m",
                     found["crossing"]["middle"], 0.15)
    chapter.at_most(f"{key}.crosses_alone", f"{mesh}, crossing: longest crack from its ends, m",
                    max(found["crossing"]["upper"], found["crossing"]["lower"]), 0)
    chapter.at_most(f"{key}.stops", f"{mesh}, arrest: way beyond the natural fracture, m",
                    max(found["arrest"].values()), 0.04)
    slip = [abs(natural(runs[name].frame(), "slip_m")).max() for name in ("arrest", "crossing")]
    chapter.at_least(f"{key}.slips", f"{mesh}, arrest: largest slip of the natural fracture over "
                     "that where the crack crosses", slip[0] / slip[1], 20)
    opening = {name: natural(run.frame(), "opening_m").mean() for name, run in runs.items()}
    chapter.at_least(f"{key}.leaves", f"{mesh}, offset: way of the cracks from both ends, m",
                     found["offset"]["upper"] + found["offset"]["lower"], 0.2)
    chapter.at_most(f"{key}.offset", f"{mesh}, offset: way beyond where both met over that from "
                    "the ends", found["offset"]["middle"]
                    / max(found["offset"]["upper"] + found["offset"]["lower"], 1e-9), 0.5)
    chapter.at_least(f"{key}.opens", f"{mesh}, offset: mean opening of the natural fracture over "
                     "that where the crack stops", opening["offset"] / opening["arrest"], 20)


def threshold(chapter: Chapter, work: Path) -> list[tuple[float, float, float]]:
    """Runs with less and more friction than the formula asks for; (compression, friction, way)."""
    found = []
    for compression in COMPRESSIONS:
        asked = float(crossing_friction(compression / (STRENGTH + SMALLER)))
        for share in (BELOW, ABOVE):
            label = f"{compression / 1e6:g}_MPa_{share:g}"
            settings = {"in_situ.stress_xx": -compression, "time.end": LATE,
                        "fracture.natural.friction_angle": float(np.arctan(share * asked))}
            run = run_example("natural_fractures", work, label, settings).results
            way = reach(run.frame())["middle"]
            found.append((compression, share * asked, way))
            where = f"{compression / 1e6:g} MPa, friction {share * asked:.2f}"
            if share < 1:
                chapter.at_most(f"stops_{label}", f"{where}, {BELOW:g} times that of Renshaw and "
                                "Pollard: way beyond the natural fracture, m", way, 0)
            else:
                chapter.at_least(f"crosses_{label}", f"{where}, {ABOVE:g} times that of Renshaw "
                                 "and Pollard: way beyond the natural fracture, m", way, 0.02)
    return found


def check(chapter: Chapter, work: Path) -> None:
    runs = {"crossing": check_criteria(chapter, "natural_fractures", work).results}
    coarse = {"crossing": run_example("natural_fractures", work, "coarse", COARSE).results}
    for name in ("arrest", "offset"):
        case = EXAMPLE / f"{name}.toml"
        runs[name] = run_case(case, work / name).results
        coarse[name] = run_case(case, work / f"coarse_{name}", COARSE).results
    for label, results in (("", runs), ("coarse_", coarse)):
        for name, run in results.items():
            coupled.balances(chapter, f"{label}{name}", run)
    outcomes(chapter, "0.03 m", runs)
    outcomes(chapter, "0.04 m", coarse)
    points = threshold(chapter, work)
    for label, results in (("0.03 m", runs), ("0.04 m", coarse)):
        frames = [(f"{name}, {run.frame().time * 1e3:.0f} ms", run.frame())
                  for name, run in results.items()]
        chapter.add_figure(coupled.stress_series(frames, (-2, 2), WINDOW),
                           f"Elements of {label}: effective principal stress and cracks")
        chapter.add_figure(coupled.crack_pressure_series(frames, 3, WINDOW),
                           f"Elements of {label}: pressure in the cracks")
    chapter.add_figure(mesh_figure([("", runs["crossing"].frame(0.0))], NOTES),
                       "The mesh, the notch and the natural fracture")
    curves(chapter, runs, points)
    chapter.add_figure(solid.energy_figure(runs["offset"]), "Energies, offset")


def curves(chapter: Chapter, runs: dict, points: list) -> None:
    figure, row = plt.subplots(1, 3, figsize=(13, 4), layout="constrained")
    for name, run in runs.items():
        history = run.history
        row[0].plot(history["time_s"] * 1e3, history["source.pump.pressure_Pa"] / 1e6, label=name)
        row[1].plot(history["time_s"] * 1e3, history["crack_length_m"], label=name)
    compression = np.linspace(1.3e6, 6e6, 200)
    row[2].plot(compression / 1e6, crossing_friction(compression / (STRENGTH + SMALLER)), "k",
                label="Renshaw and Pollard")
    for label, mark, across in (("crosses", "^", True), ("stops", "v", False)):
        some = np.array([(c / 1e6, f) for c, f, way in points if (way > 0) == across])
        row[2].plot(*some.reshape(-1, 2).T, mark, label=label)
    row[2].set_ylim(0, 1.5)
    labels = (("Time (ms)", "Pressure at the pump (MPa)"), ("Time (ms)", "Length of cracks (m)"),
              ("Compression of the natural fracture (MPa)", "Its coefficient of friction"))
    for axes, (x, y) in zip(row, labels):
        axes.set_xlabel(x)
        axes.set_ylabel(y)
        axes.grid(alpha=0.3)
        axes.legend(frameon=False, fontsize="small")
    chapter.add_figure(figure, "Pressure and length over time; friction from which on a crack "
                       "crosses")
