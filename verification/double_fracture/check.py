# SPDX-License-Identifier: BSD-3-Clause
"""Ground water between two crossing faults: heads on three levels, tied and finite."""

from pathlib import Path

import numpy as np
from percolith.plot import draw
from percolith.run_directory import read_table
from report import Chapter
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
                           f"Head on y = {level} m; circles: faults without width")
    published(chapter, fine)
    for label, result in (("tied", tied), ("finite", finite)):
        net = abs(sum(result.results.summary["rate_m2_per_s"].values()))
        chapter.at_most(f"{label}.balance", f"{label}: what enters minus what leaves through the "
                        "ground, over the throughput", net / throughput(result), 1e-10)
    draw(tied.results, "head", output=work / "head.png")
    chapter.add_picture(work / "head.png", "Hydraulic head as `percolith plot` draws it")


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
    rows = result.results.probe("y600").at_time()
    chapter.at_most("published", "head on y = 800 m against faults with width, largest "
                    "difference, m", abs(head - expected).max(), 0.5)
    figure = compare_figure([("y = 800 m", x, head, expected)], "x (m)", "Head (m)")
    figure.axes[0].plot(rows["x_m"], rows["head_m"], color="gray", label="y = 600 m, computed")
    figure.axes[0].legend(fontsize="small", frameon=False)
    chapter.add_figure(figure, "Head on y = 800 m; circles: published solution with faults of "
                       "their real width")
