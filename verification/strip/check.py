# SPDX-License-Identifier: BSD-3-Clause
"""Transient flow through a strip: the error of finite joints over n, for permeabilities,
viscosities, element sizes and shapes, and the tied scheme."""

from pathlib import Path

import formulas
import matplotlib.pyplot as plt
import numpy as np
from percolith.run_directory import read_table
from report import Chapter
from set_ups import mesh_figure
from studies import check_example, compare_figure, observed_order, run_example

TITLE = "Strip: transient flow, finite and tied joints"
FACTORS = [1, 2, 5, 10, 20, 50, 100, 200]
REFERENCE = Path(__file__).with_name("strip_error_vs_n.csv")


def centre_line(result) -> tuple[np.ndarray, np.ndarray]:
    """Places x and pressures of all pore nodes on the centre line at the end of a run."""
    grid = result.results.frame().matrix
    on_line = abs(grid.points[:, 1] - 0.1) < 1e-9
    return grid.points[on_line, 0], grid.point_data["pressure_Pa"][on_line]


def relative_error(x: np.ndarray, pressure: np.ndarray) -> float:
    """Sum of errors over sum of pressures, (42), at the time of 0.02 s."""
    exact = formulas.strip(x, 0.02)
    return abs(pressure - exact).sum() / exact.sum()


def run_at(work: Path, label: str, factor, mesh="strip_05.msh", k=2e-13, mu=1e-3, steps=1000):
    """A run to the dimensionless time of 0.02 s at k = 2e-13 m2 and mu = 1e-3 Pa s; `factor` is n
    of finite joints, None means tied."""
    end = 0.02 * (2e-13 / k) * (mu / 1e-3)
    settings = {"mesh.file": mesh, "material.rock.permeability": k,
                "fluid.viscosity": mu, "time.end": end, "time.step": end / steps,
                "output.times": []}
    if factor is not None:
        settings |= {"model.pore_joints": "finite", "model.joint_factor": factor}
    return run_example("strip", work, label, settings)


def error_curve(work: Path, label: str, **variant) -> np.ndarray:
    errors = []
    for n in FACTORS:
        errors.append(relative_error(*centre_line(run_at(work, f"{label}_n{n}", n, **variant))))
    return np.array(errors)


def study(chapter: Chapter, work: Path, name: str, title: str, label_of: str,
          variants: dict[str, dict]) -> None:
    """One figure of error over n, with the reference for the same element size. `variants` maps
    the value that varies to the arguments of a run, `label_of` is its label with {} for the
    value."""
    reference = read_table(REFERENCE)
    figure, axes = plt.subplots(figsize=(7, 4.6), layout="constrained")
    colours = plt.cm.viridis(np.linspace(0, 0.85, len(variants)))
    for (value, variant), colour, mark in zip(variants.items(), colours, "osd"):
        key, label = f"{name}.{value}", label_of.format(value)
        errors = error_curve(work, key, **variant)
        axes.loglog(FACTORS, errors, color=colour, marker=mark, label=label, markerfacecolor="none")
        size = float("0." + variant.get("mesh", "strip_05.msh")[6:8])
        rows = reference.where(np.isclose(reference["Le_m"], size) & (reference["n"] <= 200))
        axes.loglog(rows["n"], rows["RE_t0.02s"], color=colour, linestyle=":")
        expected = np.interp(np.log(FACTORS), np.log(rows["n"]), np.log(rows["RE_t0.02s"]))
        chapter.at_most(f"{key}.level", f"{title}, {label}: error at n = 100",
                        errors[FACTORS.index(100)], 0.01)
        slope = observed_order(FACTORS[3:7], errors[3:7])
        chapter.at_most(f"{key}.slope", f"{title}, {label}: slope from n = 10 to 100, "
                        "difference from -1", abs(slope + 1), 0.1)
        chapter.at_most(f"{key}.reference", f"{title}, {label}: largest ratio to the "
                        "reference (other mesh) for n up to 100",
                        np.exp(abs(np.log(errors) - expected)[:7].max()), 1.35)
    axes.plot([], [], "k:", label="reference, other mesh")
    axes.set_xlabel("n")
    axes.set_ylabel("Relative error")
    axes.grid(alpha=0.3, which="both")
    axes.legend(fontsize="small", frameon=False)
    chapter.add_figure(figure, f"Relative error over the joint factor n: {title}", name)


def shapes(chapter: Chapter, work: Path) -> None:
    curves, meshes = [], []
    for shape in ("irregular", "right", "crossed"):
        result = run_at(work, f"shape_{shape}", 100, mesh=f"strip_{shape}.msh")
        frame = result.results.frame()
        meshes.append((f"{shape}: ", frame))
        grid = frame.matrix
        exact = formulas.strip(grid.points[:, 0], 0.02)
        error = abs(grid.point_data["pressure_Pa"] - exact).max() / 1e5
        chapter.at_most(f"shape.{shape}", f"{shape} triangles of 0.1 m, n = 100: largest error at "
                        "any node over the pressure range", error, 0.006)
        order = np.argsort(grid.points[:, 0], kind="stable")
        curves.append((f"{shape} triangles", grid.points[order, 0],
                       grid.point_data["pressure_Pa"][order], exact[order]))
    chapter.add_figure(compare_figure(curves, "x (m)", "Pressure (kPa)", 1e3, style="."),
                       "Three element shapes at 0.02 s, all nodes; circles: analytic", "shapes")
    chapter.add_figure(mesh_figure(meshes), "The three shapes of triangles, 0.1 m", "shape_meshes")


def tied(chapter: Chapter, work: Path) -> None:
    """The error in time, of first order, is removed by extrapolation from two steps."""
    sizes, errors, meshes = [0.05, 0.03, 0.01], [], []
    for size in sizes:
        mesh = f"strip_{str(size)[2:]}.msh"
        first = run_at(work, f"tied_{size}_1000", None, mesh=mesh)
        meshes.append((f"{size} m: ", first.results.frame()))
        x, coarse = centre_line(first)
        _, fine = centre_line(run_at(work, f"tied_{size}_2000", None, mesh=mesh, steps=2000))
        errors.append(relative_error(x, 2 * fine - coarse))
    chapter.at_most("tied.level", "tied nodes, 0.05 m: relative error at 0.02 s", errors[0], 1e-3)
    chapter.at_least("tied.order", "tied nodes: order in the element size, from 0.05 to 0.01 m",
                     observed_order(sizes, errors), 1.8)
    figure, axes = plt.subplots(figsize=(6, 4.2), layout="constrained")
    axes.loglog(sizes, errors, "o-", color=plt.cm.viridis(0.3), label="tied nodes")
    axes.loglog(sizes, errors[0] * (np.array(sizes) / sizes[0]) ** 2, "k:", label="order 2")
    axes.set_xlabel("Element size (m)")
    axes.set_ylabel("Relative error")
    axes.grid(alpha=0.3, which="both")
    axes.legend(frameon=False)
    chapter.add_figure(figure, "Relative error at 0.02 s over the element size, tied nodes")
    chapter.add_figure(mesh_figure(meshes), "The three element sizes", "meshes")


def check(chapter: Chapter, work: Path) -> None:
    result = check_example(chapter, "strip", work)
    curves = []
    for time in (0.001, 0.005, 0.01, 0.02):
        rows = result.results.probe("centre").at_time(time)
        curves.append((f"{time} s", rows["x_m"], rows["pressure_Pa"],
                       formulas.strip(rows["x_m"], time)))
    chapter.add_figure(compare_figure(curves, "x (m)", "Pressure (kPa)", 1e3),
                       "Pressure on the centre line, tied nodes, 0.05 m; circles: analytic")
    study(chapter, work, "permeability", "three permeabilities", "k = {} m²",
          {f"{k:g}": {"k": k} for k in (2e-13, 2e-12, 2e-11)})
    study(chapter, work, "viscosity", "three viscosities", "µ = {} Pa s",
          {f"{mu:g}": {"mu": mu} for mu in (1e-2, 1e-3, 1e-4)})
    study(chapter, work, "size", "three element sizes", "{} m",
          {size: {"mesh": f"strip_{size[2:]}.msh"} for size in ("0.05", "0.03", "0.01")})
    shapes(chapter, work)
    tied(chapter, work)
