# SPDX-License-Identifier: BSD-3-Clause
"""Three stages along a well, one after another: the stress that a shut-in crack leaves at the next
stage, and the pressure which that needs more, against Sneddon; where cracks go; on two meshes."""

from pathlib import Path

import coupled
import matplotlib.pyplot as plt
import numpy as np
import solid
from crack_paths import branches, broken_lines
from fracture_formulas import PressedCrack
from program import ROOT, run_case
from report import Chapter
from set_ups import mesh_figure
from solid_formulas import plane_modulus
from studies import check_criteria, run_example

TITLE = "Stages along a well: stress shadow and pressure"
EXAMPLE = ROOT / "examples/multi_stage"
PLACES = {1: -0.4, 2: 0.0, 3: 0.4}  # m, of the stages along the well
NOTCH, FAR, BIOT = 0.1, 2e6, 0.5  # m, Pa across the cracks, Biot coefficient
MODULUS = plane_modulus(20e9, 0.2)  # Pa
PERIOD = 12e-3  # s, from the start of one stage to that of the next
BEFORE = (1e-3, 1.5e-3, 2e-3)  # s after that, when a notch is open and not yet longer
BRIDGE = 0.05  # m, a crack may go on beside its tip, one element away
WINDOW = ((-0.9, 0.9), (-0.95, 0.95))
NOTES = [(0, 1.6, "in-situ stress, absorbing"), (0, -0.25, "stages 1, 2 and 3")]
COARSE = {"mesh.file": str(EXAMPLE / "multi_stage_coarse.msh")}


def cracks(frame) -> dict[int, np.ndarray]:
    """Points (m) of the crack of each stage."""
    roots = {stage: [(x, y) for y in (-NOTCH, 0.0, NOTCH)] for stage, x in PLACES.items()}
    return branches(broken_lines(frame), roots, BRIDGE)


def pressure_at(run, stage: int, time):
    """Pressure (Pa) in the source of a stage."""
    return np.interp(time, run.history["time_s"], run.history[f"source.stage_{stage}.pressure_Pa"])


def pressed(run, stage: int, time: float) -> tuple[PressedCrack, float, float]:
    """The crack of a stage as a straight one of the same ends; its middle (y, m), and the pressure
    (Pa) above the far stress."""
    y = cracks(run.frame(time))[stage][:, 1]
    return (PressedCrack(0.5 * np.ptp(y), MODULUS), 0.5 * (y.min() + y.max()),
            pressure_at(run, stage, time) - FAR)


def shadow(run, stage: int, x, y):
    """Stress (Pa) along the well that the cracks of the stages before have added at (x, y), by
    Sneddon, one after the other."""
    total = 0.0
    for earlier in range(1, stage):
        crack, middle, pressure = pressed(run, earlier, (stage - 1) * PERIOD)
        total = total + crack.normal_stress(y - middle, x - PLACES[earlier], pressure)
    return total


def rise(run, stage: int) -> float:
    """Pressure (Pa) that a stage needs more than the first, at equal volumes pumped, until its
    notch grows."""
    after = np.array(BEFORE)
    return float(np.mean(pressure_at(run, stage, (stage - 1) * PERIOD + after)
                         - pressure_at(run, 1, after)))


def added_stress(run, time: float) -> tuple[np.ndarray, np.ndarray]:
    """Places along the well, and the growth there of the total stress along it (Pa)."""
    first, now = (run.probe("well").at_time(moment) for moment in (0.0, time))
    total = [rows["stress_xx_Pa"] - BIOT * rows["pressure_Pa"] for rows in (first, now)]
    return now["x_m"], total[1] - total[0]


def stress_shadow(chapter: Chapter, mesh: str, run) -> None:
    key = mesh.replace(" ", "").replace(",", "_")
    x, stress = added_stress(run, PERIOD)
    profile = shadow(run, 2, x, 0.0)
    chapter.at_most(f"{key}.profile", f"{mesh}: rms difference of the stress that stage 1 adds "
                    "along the well from Sneddon's, over the largest",
                    np.sqrt(np.mean((stress - profile) ** 2)) / abs(profile).max(), 0.1)
    for stage in (2, 3):
        expected = shadow(run, 2, PLACES[stage], 0.0)
        chapter.at_most(f"{key}.stress_{stage}", f"{mesh}: stress that stage 1 adds where stage "
                        f"{stage} will be over Sneddon's, {expected / 1e6:.2f} MPa, less 1",
                        abs(np.interp(PLACES[stage], x, stress) / expected - 1), 0.3)
    y = np.linspace(-NOTCH, NOTCH, 21)
    for stage in (2, 3):
        expected = -float(np.mean(shadow(run, stage, PLACES[stage], y)))
        found = rise(run, stage)
        chapter.at_most(f"{key}.rise_{stage}", f"{mesh}: pressure that stage {stage} needs more "
                        f"than stage 1, {found / 1e6:.2f} MPa, over Sneddon's stress on its notch, "
                        f"{expected / 1e6:.2f} MPa, less 1", abs(found / expected - 1), 0.3)


def turn(frame, stage: int) -> float:
    """Angle (degree) by which the longer wing of a crack turns away from the first stage."""
    points = cracks(frame)[stage]
    tip = points[np.argmax(abs(points[:, 1]))]
    return float(np.degrees(np.arctan2(tip[0] - PLACES[stage], abs(tip[1]) - NOTCH)))


def uneven(frame, stage: int) -> float:
    """How much of a crack lies in its longer wing; a half where both are as long."""
    y = cracks(frame)[stage][:, 1]
    return float(max(y.max(), -y.min()) / np.ptp(y))


def check(chapter: Chapter, work: Path) -> None:
    shipped = check_criteria(chapter, "multi_stage", work).results
    coarse = run_example("multi_stage", work, "coarse", COARSE).results
    case = EXAMPLE / "no_contrast.toml"
    even = run_case(case, work / "no_contrast").results
    coarse_even = run_case(case, work / "coarse_no_contrast", COARSE).results
    for name, run in (("coarse", coarse), ("no_contrast", even),
                      ("coarse_no_contrast", coarse_even)):
        coupled.balances(chapter, name, run)
    coupled.break_modes(chapter, shipped)
    for mesh, run, alike in (("0.03 m", shipped, even), ("0.04 m", coarse, coarse_even)):
        stress_shadow(chapter, mesh, run)
        stress_shadow(chapter, f"{mesh}, no contrast", alike)
        key = mesh.replace(" ", "")
        chapter.at_most(f"{key}.straight", f"{mesh}: angle by which stage 3 turns, degree",
                        abs(turn(run.frame(), 3)), 10)
        chapter.at_least(f"{key}.turns", f"{mesh}, no contrast: angle by which stage 3 turns away, "
                         "degree", turn(alike.frame(), 3), 12)
        chapter.at_least(f"{key}.one_sided", f"{mesh}: share of stage 3 in its longer wing",
                         uneven(run.frame(), 3), 0.6)
    pictures(chapter, {"0.03 m": shipped, "0.04 m": coarse, "0.03 m, no contrast": even,
                       "0.04 m, no contrast": coarse_even})


def pictures(chapter: Chapter, runs: dict) -> None:
    shipped = runs["0.03 m"]
    frames = coupled.at_times(shipped, [0.012, 0.024, 0.036])
    chapter.add_figure(coupled.stress_series(frames, (-6, 2), WINDOW),
                       "Effective principal stress and cracks after each stage")
    frames = [(name, run.frame()) for name, run in runs.items()]
    chapter.add_figure(coupled.crack_pressure_series(frames, 5, WINDOW),
                       "Pressure in the cracks: two meshes, and stress alike from all sides")
    figure, row = plt.subplots(1, 2, figsize=(12, 4), layout="constrained")
    for stage in PLACES:
        row[0].plot(shipped.history["time_s"] * 1e3,
                    shipped.history[f"source.stage_{stage}.pressure_Pa"] / 1e6,
                    label=f"stage {stage}")
    x, stress = added_stress(shipped, PERIOD)
    row[1].plot(x, stress / 1e6, label="computed")
    row[1].plot(x, shadow(shipped, 2, x, 0.0) / 1e6, "k--", label="Sneddon")
    for axes, labels in zip(row, (("Time (ms)", "Pressure (MPa)"),
                                  ("x (m)", "Stress added along the well (MPa)"))):
        axes.set_xlabel(labels[0])
        axes.set_ylabel(labels[1])
        axes.grid(alpha=0.3)
        axes.legend(frameon=False)
    chapter.add_figure(figure, "Pressure of the stages; stress along the well after stage 1")
    chapter.add_figure(mesh_figure([("", shipped.frame(0.0))], NOTES), "The mesh and the notches")
    chapter.add_figure(solid.energy_figure(shipped), "Energies")
