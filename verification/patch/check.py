# SPDX-License-Identifier: BSD-3-Clause
"""Patch test: uniform stress on irregular triangles, layered rock too; how much joints soften it."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import solid
from program import run_case
from report import Chapter
from solid_formulas import lame, plane_modulus

TITLE = "Patch test: uniform stress, and the apparent modulus of rock with joints"
HERE = Path(__file__).parent
YOUNG, POISSON = 10e9, 0.25
# Strains in x and y, so small that the rotation and stretch they cause do not count.
STRETCH, PRESSED = 1e-10, -0.5e-10


def expected_stresses() -> dict[str, tuple[float, float, float]]:
    """xx, yy, xy of each case."""
    first, shear = lame(YOUNG, POISSON)
    volume = first * (STRETCH + PRESSED)
    return {"stretch": (volume + 2 * shear * STRETCH, volume + 2 * shear * PRESSED, 0.0),
            "pull": (1.0, -0.2, 0.0),
            "shear": (0.0, 0.0, shear * STRETCH)}


def uniform(chapter: Chapter, work: Path) -> None:
    for name, expected in expected_stresses().items():
        run = run_case(HERE / f"{name}.toml", work / name).results
        cells = run.frame().matrix.cell_data
        found = np.array([cells[f"stress_{axes}_Pa"] for axes in ("xx", "yy", "xy")])
        size = max(abs(value) for value in expected)
        spread = abs(found - found.mean(axis=1, keepdims=True)).max() / size
        chapter.at_most(f"{name}.uniform", f"{name}: largest difference of the stress from its "
                        "mean, over the stress", spread, 1e-9)
        error = abs(found.mean(axis=1) - expected).max() / size
        chapter.at_most(f"{name}.value", f"{name}: error of the mean stress over the stress", error,
                        1e-8)


def layered_stress(strain: np.ndarray, across: float, ratio: float, shear: float,
                   bedding: float) -> np.ndarray:
    """Stress in rock with layers at the angle `bedding`: the compliance in the axes along, across
    and along the strike, inverted and turned. YOUNG and POISSON hold within the layers."""
    compliance = np.array([[1 / YOUNG, -ratio / across, -POISSON / YOUNG],
                           [-ratio / across, 1 / across, -ratio / across],
                           [-POISSON / YOUNG, -ratio / across, 1 / YOUNG]])
    stiffness = np.linalg.inv(compliance)[:2, :2]
    turn = np.array([[np.cos(bedding), np.sin(bedding)], [-np.sin(bedding), np.cos(bedding)]])
    turned = turn @ strain @ turn.T
    along, normal = stiffness @ np.diag(turned)
    sheared = 2 * shear * turned[0, 1]
    return turn.T @ np.array([[along, sheared], [sheared, normal]]) @ turn


def layered(chapter: Chapter, work: Path) -> None:
    across, ratio, shear = 4e9, 0.15, 2.5e9
    # The top moves along and down, the sides carry what belongs to that.
    strain = np.array([[0.0, 0.5 * STRETCH], [0.5 * STRETCH, PRESSED]])
    for degrees in (0, 30, 75):
        stress = layered_stress(strain, across, ratio, shear, np.radians(degrees))
        settings = {"material.rock.normal_young_modulus": across,
                    "material.rock.normal_poisson_ratio": ratio,
                    "material.rock.normal_shear_modulus": shear,
                    "material.rock.bedding_angle": f"{degrees} deg",
                    "boundary.top.displacement_y": {"times": [0, 1e-3], "values": [0, PRESSED]}}
        for side, sign in (("left", -1), ("right", 1)):
            for row, axis in enumerate("xy"):
                settings[f"boundary.{side}.traction_{axis}"] = float(sign * stress[0, row])
        run = run_case(HERE / "shear.toml", work / f"layered_{degrees}", settings).results
        cells = run.frame().matrix.cell_data
        found = np.array([cells[f"stress_{axes}_Pa"] for axes in ("xx", "yy", "xy")])
        expected = np.array([stress[0, 0], stress[1, 1], stress[0, 1]])
        error = abs(found - expected[:, None]).max() / abs(expected).max()
        chapter.at_most(f"layered.{degrees}", f"layers at {degrees} degrees: largest error of the "
                        "stress in any triangle over the stress", error, 1e-8)


def joints(chapter: Chapter, work: Path) -> None:
    modulus = plane_modulus(YOUNG, POISSON)
    factors, found = [10, 100, 1000], []
    for factor in factors:
        run = run_case(HERE / "joints.toml", work / f"joints_{factor}",
                       {"material.rock.joint_penalty": factor * YOUNG}).results
        frame = run.frame()
        weight = solid.areas(frame)
        stress = weight @ frame.matrix.cell_data["stress_xx_Pa"] / weight.sum()
        found.append(stress / STRETCH / modulus)
        expected = 1 / (1 + 1.73 * modulus / (factor * YOUNG))
        chapter.at_most(f"joints.{factor}", f"joints of {factor} E: apparent modulus over E', "
                        f"relative difference from {expected:.4f}", abs(found[-1] / expected - 1),
                        0.02)
    figure, axes = plt.subplots(figsize=(6, 4.2), layout="constrained")
    line = np.geomspace(5, 2000, 100)
    axes.semilogx(line, 1 / (1 + 1.73 * modulus / (line * YOUNG)), "k", linewidth=1,
                  label="1/(1 + 1.73 E'/p_f)")
    axes.semilogx(factors, found, "o", color=plt.cm.viridis(0.3), label="computed")
    axes.set_xlabel("Joint penalty p_f over E")
    axes.set_ylabel("Apparent modulus over E'")
    axes.grid(alpha=0.3, which="both")
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Joints soften the rock")


def check(chapter: Chapter, work: Path) -> None:
    uniform(chapter, work)
    layered(chapter, work)
    joints(chapter, work)
