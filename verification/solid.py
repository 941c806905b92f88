# SPDX-License-Identifier: BSD-3-Clause
"""What verifications of solid mechanics share: sums over bodies, pictures of rock with its cracks,
energies over time."""

from __future__ import annotations

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from percolith import RunDirectory
from percolith.crack_picture import MODES
from percolith.run_directory import Frame

# Number, name and colour of the modes in which joints break during a run, as in other pictures.
BROKEN = tuple((number, *named) for number, named in MODES.items() if number > 0)
ENERGIES = ("kinetic", "elastic", "joint", "fracture", "contact", "friction", "damping", "absorbed",
            "gravity")


def centres(frame: Frame) -> np.ndarray:
    """Of the undeformed triangles, m."""
    return frame.matrix.points[frame.matrix.cells].mean(axis=1)


def areas(frame: Frame) -> np.ndarray:
    """Of the undeformed triangles, m2."""
    a, b, c = np.moveaxis(frame.matrix.points[frame.matrix.cells], 1, 0)
    return 0.5 * abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])


def mean_of(frame: Frame, quantity: str, chosen: np.ndarray | None = None) -> np.ndarray:
    """Mean over the mass of the chosen triangles of a quantity of the points."""
    weight = areas(frame) if chosen is None else areas(frame) * chosen
    values = frame.matrix.point_data[quantity][frame.matrix.cells].mean(axis=1)
    return weight @ values / weight.sum()


def recovered(frame: Frame, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Places of the vertices (m), and the mean at each of the values of its triangles, weighted by
    their areas."""
    places, vertex = np.unique(np.round(frame.matrix.points, 9), axis=0, return_inverse=True)
    cells = vertex.reshape(-1)[frame.matrix.cells].ravel()
    weight = np.repeat(areas(frame), 3)
    total = np.bincount(cells, weight)
    return places, np.bincount(cells, weight * np.repeat(values, 3)) / total


def polar_stress(frame: Frame) -> tuple[np.ndarray, np.ndarray]:
    """(radial, hoop) stress of the triangles about the origin, Pa."""
    x, y = (centres(frame) / np.hypot(*centres(frame).T)[:, None]).T
    xx, yy, xy = (frame.matrix.cell_data[f"stress_{axes}_Pa"] for axes in ("xx", "yy", "xy"))
    return (xx * x**2 + yy * y**2 + 2 * xy * x * y, xx * y**2 + yy * x**2 - 2 * xy * x * y)


def pore_pressure(frame: Frame) -> np.ndarray:
    """Mean of the corners of each triangle, Pa."""
    return frame.matrix.point_data["pressure_Pa"][frame.matrix.cells].mean(axis=1)


def residual(run: RunDirectory) -> float:
    """Largest residual of the energy balance at any time over the largest energy or work."""
    history = run.history
    names = [f"{name}_J_per_m" for name in (*ENERGIES, "external_work")]
    largest = max(abs(history[name]).max() for name in names)
    return float(abs(history["residual_J_per_m"]).max() / largest)


def broken_by_mode(frame: Frame) -> dict[str, np.ndarray]:
    """Middles (m) of the joints that broke during the run, by their mode."""
    if frame.cracks is None or not len(frame.cracks.cells):
        return {name: np.empty((0, 2)) for _, name, _ in BROKEN}
    middles = frame.cracks.points[frame.cracks.cells].mean(axis=1)
    mode = frame.cracks.cell_data["mode"]
    return {name: middles[mode == number] for number, name, _ in BROKEN}


def draw_rock(axes, frame: Frame, values: np.ndarray | None = None, limits=None,
              magnify: float = 0.0, colours: str = "viridis", edges: str = "face"):
    """Triangles, deformed `magnify` times, in the colours of `values`; returns the artist."""
    points = frame.matrix.points + magnify * frame.matrix.point_data["displacement_m"]
    shape = {"array": values, "cmap": colours} if values is not None else {"facecolor": "#e8e8e8"}
    rock = PolyCollection(points[frame.matrix.cells], edgecolor=edges, linewidth=0.2, **shape)
    if values is not None:
        rock.set_clim(*(limits if limits is not None else np.percentile(values, [1, 99])))
    axes.add_collection(rock)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")
    return rock


def draw_cracks(axes, frame: Frame) -> None:
    """Joints that broke during the run, on the undeformed rock, coloured by how they broke."""
    if frame.cracks is None or not len(frame.cracks.cells):
        return
    lines = frame.cracks.points[frame.cracks.cells]
    mode = frame.cracks.cell_data["mode"]
    for number, name, colour in BROKEN:
        chosen = lines[mode == number]
        axes.add_collection(LineCollection(chosen, colors=colour, linewidths=1.2,
                                           label=f"{name} ({len(chosen)})"))
    axes.legend(fontsize="small", loc="upper right", framealpha=0.9)


def colour_bar(figure, axes, rock, label: str) -> None:
    figure.colorbar(rock, ax=axes, label=label, shrink=0.8)


def energy_figure(run: RunDirectory):
    """All energies over time, with the work done on the rock and what is missing."""
    history = run.history
    figure, axes = plt.subplots(figsize=(7, 4.4), layout="constrained")
    colours = plt.cm.viridis(np.linspace(0, 0.9, len(ENERGIES)))
    for name, colour in zip(ENERGIES, colours):
        values = history[f"{name}_J_per_m"]
        if abs(values).max() > 0:
            axes.plot(history["time_s"] * 1e3, values, color=colour, label=name)
    axes.plot(history["time_s"] * 1e3, history["external_work_J_per_m"], "k--", label="work done")
    if "fluid_work_J_per_m" in history:
        axes.plot(history["time_s"] * 1e3, history["fluid_work_J_per_m"], "k:",
                  label="work of the fluid")
    axes.plot(history["time_s"] * 1e3, history["residual_J_per_m"], color="#d55e00", linewidth=1,
              label="missing")
    axes.set_xlabel("Time (ms)")
    axes.set_ylabel("Energy (J/m)")
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small", frameon=False)
    return figure
