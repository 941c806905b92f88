# SPDX-License-Identifier: BSD-3-Clause
"""Six fractures: pressure on y = 5 m over time, tied and finite, on two meshes."""

from pathlib import Path

import numpy as np
from percolith.plot import draw
from percolith.run_directory import read_table
from report import Chapter
from studies import check_example, compare_figure, run_example

TITLE = "Six fractures: transient flow through a network"
HERE = Path(__file__).parent
HOURS = ("0.01", "0.02", "0.05", "0.1", "3")


def curves_of(result):
    reference = read_table(HERE / "six_fractures_y5.csv")
    curves = []
    for hours in HOURS:
        rows = result.results.probe("y5").at_time(float(hours) * 3600)
        expected = np.interp(rows["x_m"], reference["x_m"], reference[f"p_MPa_t{hours}h"]) * 1e6
        curves.append((f"{hours} h", rows["x_m"], rows["pressure_Pa"], expected))
    return curves


def add_rows(chapter: Chapter, name: str, title: str, result, rms: float, largest: float) -> None:
    for label, _, computed, expected in curves_of(result):
        error = (computed - expected) / 1e6
        chapter.at_most(f"{name}.rms.{label[:-2]}", f"{title}, {label}: root mean square "
                        "error, MPa",
                        np.sqrt(np.mean(error**2)), rms)
        chapter.at_most(f"{name}.max.{label[:-2]}", f"{title}, {label}: largest error, MPa",
                        abs(error).max(), largest)


def check(chapter: Chapter, work: Path) -> None:
    tied = check_example(chapter, "six_fractures", work)
    chapter.add_figure(compare_figure(curves_of(tied), "x (m)", "Pressure (MPa)", 1e6),
                       "Pressure on y = 5 m, tied nodes; circles: reference")
    finite = run_example("six_fractures", work, "finite", {"model.pore_joints": "finite"})
    add_rows(chapter, "finite", "finite joints, n = 100", finite, 0.08, 0.2)
    chapter.add_figure(compare_figure(curves_of(finite), "x (m)", "Pressure (MPa)", 1e6),
                       "Pressure on y = 5 m, finite joints, n = 100; circles: reference")
    chapter.at_most("finite.balance", "finite joints: mass balance error", finite.balance, 1e-12)
    fine = run_example("six_fractures", work, "fine",
                       {"mesh.file": "six_fractures_fine.msh"})
    add_rows(chapter, "fine", "tied nodes, half the element size", fine, 0.03, 0.2)
    chapter.at_most("fine.balance", "half the element size: mass balance error", fine.balance,
                    1e-12)
    chapter.add_figure(compare_figure(curves_of(fine), "x (m)", "Pressure (MPa)", 1e6),
                       "Pressure on y = 5 m, tied nodes, half the element size; circles: reference")
    for hours in (0.1, 0.3):
        picture = work / f"field_{hours}.png"
        draw(tied.results, time=hours * 3600, output=picture)
        chapter.add_picture(picture, f"Pressure at {hours} h as `percolith plot` draws it")
