# SPDX-License-Identifier: BSD-3-Clause
"""Ground water between two crossing faults: heads on three levels, tied and finite."""

from pathlib import Path

import numpy as np
from percolith.plot import draw
from percolith.run_directory import read_table
from report import Chapter
from set_ups import mesh_figure
from studies import check_example, compare_figure, run_example

TITLE = "Double fracture: HYDROCOIN level 1, case 2"
HERE = Path(__file__).parent


def curve(result, level: int):
    """Places, computed heads and reference heads on y = level."""
    reference = read_table(HERE / "double_fracture_head.csv")
    rows = result.results.probe(f"y{level}").at_time()
    expected = np.interp(rows["x_m"], reference["x_m"], reference[f"h_m_md_Y{level}"])
    return rows["x_m"], rows["head_m"], expected


def check(chapter: Chapter, work: Path) -> None:
    tied = check_example(chapter, "double_fracture", work)
    finite = run_example("double_fracture", work, "finite", {"model.pore_joints": "finite"})
    fine = run_example("double_fracture", work, "fine",
                       {"mesh.file": "double_fracture_fine.msh"})
    for level in (1000, 800):
        curves = []
        for label, result, limit in (("tied", tied, 0.05), ("finite, n = 100", finite, 0.1),
                                     ("tied, half the size", fine, 0.02)):
            x, head, expected = curve(result, level)
            chapter.at_most(f"{label.split(',')[0]}.{level}" + (".fine" if result is fine else ""),
                            f"{label}: head on y = {level} m, root mean square error, m",
                            np.sqrt(np.mean((head - expected) ** 2)), limit)
            curves.append((label, x, head, expected))
        chapter.add_figure(compare_figure(curves, "x (m)", "Head (m)"),
                           f"Head on y = {level} m; circles: faults without width",
                           f"y{level}")
    lowest_level(chapter, tied, fine)
    published(chapter, fine)
    for label, result in (("tied", tied), ("finite", finite)):
        net = abs(sum(result.results.summary["rate_m2_per_s"].values()))
        chapter.at_most(f"{label}.balance", f"{label}: what enters minus what leaves through the "
                        "ground, over the throughput", net / throughput(result), 1e-10)
    draw(tied.results, "head", output=work / "head.png")
    chapter.add_picture(work / "head.png", "Hydraulic head as `percolith plot` draws it", "head")
    notes = [(800, 1100, "head y − 1000 m on the ground")]
    chapter.add_figure(mesh_figure([("", tied.results.frame())], notes),
                       "The mesh with the two faults; the sides and the bottom are sealed", "mesh")
    extremes(chapter, tied)


def lowest_level(chapter: Chapter, coarse, fine) -> None:
    """On y = 600 m, where no reference is at hand, two meshes must agree."""
    rows, finer = (result.results.probe("y600").at_time() for result in (coarse, fine))
    head = np.interp(rows["x_m"], finer["x_m"], finer["head_m"])
    chapter.at_most("mesh.600", "head on y = 600 m on both meshes, root mean square difference, m",
                    np.sqrt(np.mean((rows["head_m"] - head) ** 2)), 0.05)
    chapter.add_figure(compare_figure([("tied", rows["x_m"], rows["head_m"], head)], "x (m)",
                                      "Head (m)"),
                       "Head on y = 600 m; circles: on half the element size", "y600")


def extremes(chapter: Chapter, result) -> None:
    """Where the head is highest and lowest; of the tops and of the valleys there are several, all
    at the height of the ground there."""
    grid = result.results.frame().matrix
    head, ground = grid.point_data["head_m"], grid.points[:, 1].max() - 1000
    chapter.at_most("peak", "highest head less the height of the tops over 1000 m, m",
                    abs(head.max() - ground), 1e-6)
    lowest = grid.points[head <= head.min() + 1e-6]
    outcrops = np.array([[400.0, 1100.0], [1200.0, 1100.0]])
    apart = np.hypot(*np.moveaxis(lowest[:, None] - outcrops[None], 2, 0)).min(axis=1).max()
    chapter.at_most("valley", "way from where the head is lowest to where a fault crops out, m",
                    apart, 1.0)


def throughput(result) -> float:
    """What enters the rock through the ground, m2/s, from the Darcy flux; all other sides are
    sealed."""
    grid = result.results.frame().matrix
    place = np.unique(np.round(grid.points, 6), axis=0, return_inverse=True)[1][grid.cells]
    edges = np.concatenate([place[:, [i, (i + 1) % 3]] for i in range(3)])
    ends = np.concatenate([grid.cells[:, [i, (i + 1) % 3]] for i in range(3)])
    _, first, count = np.unique(np.sort(edges, axis=1), axis=0, return_index=True,
                                return_counts=True)
    outer = first[count == 1]
    along = grid.points[ends[outer, 1]] - grid.points[ends[outer, 0]]
    flux = grid.cell_data["darcy_flux_m_per_s"][outer % len(grid.cells)]
    # The boundary runs counter-clockwise, so its outward normal is (dy, -dx).
    outward = flux[:, 0] * along[:, 1] - flux[:, 1] * along[:, 0]
    return float(-outward[outward < 0].sum())


def published(chapter: Chapter, result) -> None:
    """Against the published solution, whose faults have width: the heads may differ by 0.45 m
    near them."""
    reference = read_table(HERE / "hydrocoin_head_Y800.csv")
    x, head, _ = curve(result, 800)
    expected = np.interp(x, reference["x_m"], reference["h_m"])
    chapter.at_most("published", "head on y = 800 m against faults with width, largest "
                    "difference, m", abs(head - expected).max(), 0.5)
    figure = compare_figure([("y = 800 m", x, head, expected)], "x (m)", "Head (m)")
    chapter.add_figure(figure, "Head on y = 800 m; circles: published solution with faults of "
                       "their real width", "published")
