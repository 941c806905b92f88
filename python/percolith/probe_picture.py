# SPDX-License-Identifier: BSD-3-Clause
"""Draws the probes of a run: profiles over distance for lines, series over time for points."""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from percolith.run_directory import RunDirectory, Table
from percolith.units import Scale, format_time, power_scale, pressure_scale, time_scale

_COLUMN = {"pressure": "pressure_Pa", "head": "head_m", "saturation": "saturation",
           "flux": "flux_x_m_per_s"}
_LABEL = {"pressure_Pa": "Pressure", "head_m": "Hydraulic head", "saturation": "Saturation",
          "flux_x_m_per_s": "Darcy flux along x",
          "flux_x_m2_per_s": "Flux in the crack along x",
          "displacement_x_m": "Displacement along x", "displacement_y_m": "Displacement along y",
          "velocity_x_m_per_s": "Velocity along x", "velocity_y_m_per_s": "Velocity along y",
          "stress_xx_Pa": "Stress xx", "stress_yy_Pa": "Stress yy", "stress_xy_Pa": "Stress xy"}
_MECHANICS = ("displacement_x_m", "displacement_y_m", "velocity_x_m_per_s", "velocity_y_m_per_s",
              "stress_xx_Pa", "stress_yy_Pa", "stress_xy_Pa")


def _column(table: Table, field: str) -> str:
    """The column of `field`; the pressure where the probe has none, or the field is none of flow.
    """
    wanted = _COLUMN.get(field, "pressure_Pa")
    if field == "flux" and wanted not in table:
        wanted = "flux_x_m2_per_s"
    return wanted if wanted in table else "pressure_Pa"


def _scale(column: str, values: np.ndarray) -> Scale:
    if column.endswith("_Pa"):
        return pressure_scale(values)
    for ending, unit in (("_m_per_s", "m/s"), ("_m2_per_s", "m²/s"), ("_m", "m")):
        if column.endswith(ending):
            return power_scale(values, unit)
    return Scale(1.0, "")


def _draw_line(axes, table: Table, column: str, is_steady: bool) -> None:
    times = np.unique(table["time_s"])
    scale, unit = _scale(column, table[column]), time_scale(times)
    colours = plt.cm.viridis(np.linspace(0, 0.92, len(times)))
    for time, colour in zip(times, colours):
        rows = table.at_time(time)
        distance = np.hypot(rows["x_m"] - rows["x_m"][0], rows["y_m"] - rows["y_m"][0])
        label = "steady state" if is_steady else format_time(time, unit)
        axes.plot(distance, rows[column] / scale.factor, color=colour, label=label, linewidth=1.4)
    ends = table.at_time(times[-1])
    start, stop = ((ends["x_m"][i], ends["y_m"][i]) for i in (0, -1))
    axes.set_xlabel(f"Distance from ({start[0]:g}, {start[1]:g}) to "
                    f"({stop[0]:g}, {stop[1]:g}) (m)")
    axes.set_ylabel(scale.label(_LABEL[column]))
    if len(times) <= 12:
        axes.legend(fontsize="small", frameon=False)
    else:
        colour_map = plt.cm.ScalarMappable(plt.Normalize(times[0] / unit.factor,
                                                         times[-1] / unit.factor), "viridis")
        axes.figure.colorbar(colour_map, ax=axes, label=unit.label("Time"))


def _draw_point(axes, table: Table, column: str) -> None:
    scale, unit = _scale(column, table[column]), time_scale(table["time_s"])
    axes.plot(table["time_s"] / unit.factor, table[column] / scale.factor, marker=".",
              color=plt.cm.viridis(0.3))
    axes.set_xlabel(unit.label("Time"))
    axes.set_ylabel(scale.label(_LABEL[column]))


def _panels(run: RunDirectory, field: str) -> list[tuple[str, Table, str]]:
    """Probe, its table and column of each panel: of flow `field` of every probe, of mechanics every
    component of displacement, velocity and stress."""
    panels = []
    for name in run.probe_names:
        table = run.probe(name)
        columns = [_column(table, field)] if "pressure_Pa" in table else []
        columns += [column for column in _MECHANICS if column in table]
        panels += [(name, table, column) for column in columns]
    return panels


def draw_probes(run: RunDirectory, field: str, path: Path) -> Path:
    """Writes one panel a probe to `path` and returns it, of mechanics one a probe and component,
    whatever the field."""
    panels = _panels(run, field)
    columns = 1 if len(panels) == 1 else 2
    rows = -(-len(panels) // columns)
    size = (7 if columns == 1 else 11, 3.6 * rows + 0.4)
    figure, grid = plt.subplots(rows, columns, figsize=size, layout="constrained", squeeze=False)
    for axes, (name, table, column) in zip(grid.flat, panels):
        is_line = len(table.at_time()) > 1
        if is_line:
            _draw_line(axes, table, column, run.is_steady)
        else:
            _draw_point(axes, table, column)
        axes.set_title(f"Probe {name}", fontsize=10)
        axes.grid(alpha=0.3)
    for axes in grid.flat[len(panels):]:
        axes.set_visible(False)
    figure.suptitle(run.title, fontsize=11)
    figure.savefig(path, dpi=120)
    plt.close(figure)
    return path
