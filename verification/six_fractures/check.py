# SPDX-License-Identifier: BSD-3-Clause
"""Six fractures: pressure on y = 5 m over time, tied and finite, on two meshes; the field at the
times of the paper, with the storage that follows from the data and with ten times as much."""

from pathlib import Path

import coupled
import numpy as np
from percolith.run_directory import Frame, read_table
from report import Chapter
from set_ups import mesh_figure
from studies import check_example, compare_figure, run_example

TITLE = "Six fractures: transient flow through a network"
HERE = Path(__file__).parent
HOURS = ("0.01", "0.02", "0.05", "0.1", "3")
PRINTED = (0.1, 0.3, 0.5, 1.0)  # hours, of the pictures in the paper
TENTH = (0.01, 0.03, 0.05, 0.1)
SLOW = {"material.rock.porosity": 1}  # ten times the storage
ENDS = {"A": (-10, 15), "B": (10, 7.5), "C": (5, 15), "D": (-10, -10), "E": (-10, -5),
        "F": (7.5, -12.5), "G": (-2.5, -2.5), "H": (2.5, -5), "I": (12.5, 10), "J": (10, 15),
        "K": (10, 2.5), "L": (0, -15)}  # m


def curve_of(result, hours: str, expected_hours: str = ""):
    """Places, computed pressure and that of the reference, by default of the same time."""
    reference = read_table(HERE / "six_fractures_y5.csv")
    rows = result.results.probe("y5").at_time(float(hours) * 3600)
    expected = np.interp(rows["x_m"], reference["x_m"],
                         reference[f"p_MPa_t{expected_hours or hours}h"]) * 1e6
    return f"{hours} h", rows["x_m"], rows["pressure_Pa"], expected


def curves_of(result):
    return [curve_of(result, hours) for hours in HOURS]


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
                       {"mesh.file": "six_fractures_fine.msh",
                        "output.times": [hour * 3600 for hour in sorted((*TENTH, 0.02))]})
    add_rows(chapter, "fine", "tied nodes, half the element size", fine, 0.03, 0.2)
    chapter.at_most("fine.balance", "half the element size: mass balance error", fine.balance,
                    1e-12)
    chapter.add_figure(compare_figure(curves_of(fine), "x (m)", "Pressure (MPa)", 1e6),
                       "Pressure on y = 5 m, tied nodes, half the element size; circles: reference",
                       "fine")
    at_rest(chapter, {"tied": tied, "finite, n = 100": finite, "tied, half the size": fine})
    fields(chapter, work, fine)


def at_rest(chapter: Chapter, results: dict) -> None:
    """The line after 3 h; between the fractures that enclose rock its slope is small."""
    curves = [(label, *curve_of(result, "3")[1:]) for label, result in results.items()]
    chapter.add_figure(compare_figure(curves, "x (m)", "Pressure (MPa)", 1e6),
                       "Pressure on y = 5 m at 3 h; circles: reference", "final")
    _, x, pressure, _ = curves[0]
    inside = (x >= -1) & (x <= 10)
    slope = np.ptp(pressure[inside]) / 11.0 / (np.ptp(pressure) / np.ptp(x))
    chapter.at_most("plateau", "3 h: slope of the pressure from x = -1 to 10 m over that of the "
                    "whole line", slope, 0.5)


def ahead(frame: Frame, end: tuple[float, float]) -> float:
    """Pressure (Pa) in the fracture at its end less the mean in the pores up to 1.5 m from it."""
    cracks, pores = frame.cracks, frame.matrix
    at_end = np.argmin(np.hypot(*(cracks.points - end).T))
    near = np.hypot(*(pores.points - end).T) < 1.5
    return float(cracks.point_data["pressure_Pa"][at_end]
                 - pores.point_data["pressure_Pa"][near].mean())


def fields(chapter: Chapter, work: Path, fine) -> None:
    """The field at four times, and which ends of the fractures lag behind the rock or lead."""
    def times(hours):
        return {"output.times": [hour * 3600 for hour in hours], "time.end": hours[-1] * 3600}

    slow = run_example("six_fractures", work, "slow", {**SLOW, **times(PRINTED)})
    printed = run_example("six_fractures", work, "printed", times(PRINTED))
    for end in "ADE":
        chapter.at_most(f"tips.{end}", f"ten times the storage, 0.1 h: pressure at {end} in the "
                        "fracture less that in the rock round it, MPa",
                        ahead(slow.results.frame(360), ENDS[end]) / 1e6, 0)
    for end in "BFK":
        chapter.at_least(f"tips.{end}", f"ten times the storage, 0.3 h: pressure at {end} in the "
                         "fracture less that in the rock round it, MPa",
                         ahead(slow.results.frame(1080), ENDS[end]) / 1e6, 0)
    for hours, tenth in (("0.1", "0.01"), ("0.5", "0.05"), ("1", "0.1")):
        _, _, computed, expected = curve_of(slow, hours, tenth)
        chapter.at_most(f"slow.{hours}", f"ten times the storage, {hours} h: root mean square "
                        f"difference from the reference at {tenth} h, MPa",
                        np.sqrt(np.mean((computed - expected) ** 2)) / 1e6, 0.08)
    for result, hours, name, caption in (
            (slow, PRINTED, "slow_times", "ten times the storage, that of porosity 1"),
            (printed, PRINTED, "printed_times", "the storage of porosity 0.1"),
            (fine, TENTH, "fine_times", "half the element size, the storage of porosity 0.1")):
        frames = coupled.at_times(result.results, [hour * 3600 for hour in hours], 3600, "h")
        chapter.add_figure(coupled.pressure_series(frames, largest=20),
                           f"Pressure in rock and fractures: {caption}", name)
    names = [(x * 1.06, y * 1.06, end) for end, (x, y) in ENDS.items()]
    chapter.add_figure(mesh_figure([("", printed.results.frame())], names),
                       "The mesh and the six fractures: 20 MPa on the left, none on the right, top "
                       "and bottom sealed", "mesh")
