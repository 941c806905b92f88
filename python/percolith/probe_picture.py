# SPDX-License-Identifier: BSD-3-Clause
"""Draws the probes of a run: profiles over distance for lines, series over time for points, with
reference values as markers over them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.lines import Line2D

from percolith.colours import BLACK
from percolith.panels import panels_of
from percolith.reference_curves import ReferenceCurve
from percolith.run_directory import RunDirectory, RunDirectoryError, Table
from percolith.saving import save
from percolith.units import format_time, scale_of, time_scale, without_unit

_COLUMN = {"pressure": "pressure_Pa", "head": "head_m", "saturation": "saturation",
           "flux": "flux_x_m_per_s"}
_LABEL = {"pressure_Pa": "Pressure", "head_m": "Hydraulic head", "saturation": "Saturation",
          "flux_x_m_per_s": "Darcy flux along x",
          "flux_x_m2_per_s": "Flux in the crack along x",
          "displacement_x_m": "Displacement along x", "displacement_y_m": "Displacement along y",
          "velocity_x_m_per_s": "Velocity along x", "velocity_y_m_per_s": "Velocity along y",
          "stress_xx_Pa": "Stress xx", "stress_yy_Pa": "Stress yy", "stress_xy_Pa": "Stress xy"}
_MARKERS = "os^Dv*"  # one a file of references
_MOST_NAMES = 12  # of times in a legend; more have a colour bar
_MECHANICS = ("displacement_x_m", "displacement_y_m", "velocity_x_m_per_s", "velocity_y_m_per_s",
              "stress_xx_Pa", "stress_yy_Pa", "stress_xy_Pa")


def _column(table: Table, field: str) -> str:
    """The column of `field`; the pressure where the probe has none, or the field is none of flow.
    """
    wanted = _COLUMN.get(field, "pressure_Pa")
    if field == "flux" and wanted not in table:
        wanted = "flux_x_m2_per_s"
    return wanted if wanted in table else "pressure_Pa"


def _label(table: Table, column: str) -> str:
    """What an axis calls a column; stress is effective where there is fluid."""
    label = _LABEL.get(column) or without_unit(column).replace("_", " ").capitalize()
    is_effective = column.startswith("stress") and "pressure_Pa" in table
    return f"Effective {label[0].lower()}{label[1:]}" if is_effective else label


def _draw_references(axes, references: list[ReferenceCurve], across: float, up: float,
                     colours: dict[float | None, object]) -> list[Line2D]:
    """Hollow markers, one shape a file, in the colour of each time; returns entries of a legend."""
    for curve in references:
        axes.plot(curve.x / across, curve.values / up, linestyle="none", markersize=5.0,
                  marker=_MARKERS[curve.number % len(_MARKERS)], markerfacecolor="none",
                  markeredgecolor=colours[curve.time], zorder=3.0)
    names = {curve.number: curve.name for curve in references}
    return [Line2D([], [], linestyle="none", marker=_MARKERS[number % len(_MARKERS)],
                   markersize=5.0, markerfacecolor="none", markeredgecolor=BLACK, label=name)
            for number, name in sorted(names.items())]


def _draw_line(axes, table: Table, column: str, is_steady: bool,
               references: list[ReferenceCurve]) -> None:
    times = np.unique(table["time_s"])
    scale, unit = scale_of(column, table[column]), time_scale(times)
    colours = plt.cm.viridis(np.linspace(0, 0.92, len(times)))
    for time, colour in zip(times, colours):
        rows = table.at_time(time)
        distance = np.hypot(rows["x_m"] - rows["x_m"][0], rows["y_m"] - rows["y_m"][0])
        label = "steady state" if is_steady else format_time(time, unit)
        axes.plot(distance, rows[column] / scale.factor, color=colour, label=label, linewidth=1.4)
    of_time = dict(zip(times.tolist(), colours))
    handles = _draw_references(axes, references, 1.0, scale.factor, of_time)
    ends = table.at_time(times[-1])
    start, stop = ((ends["x_m"][i], ends["y_m"][i]) for i in (0, -1))
    axes.set_xlabel(f"Distance from ({start[0]:g}, {start[1]:g}) to "
                    f"({stop[0]:g}, {stop[1]:g}) (m)")
    axes.set_ylabel(scale.label(_label(table, column)))
    if len(times) <= _MOST_NAMES:
        handles = [*axes.get_legend_handles_labels()[0], *handles]
    else:
        colour_map = plt.cm.ScalarMappable(plt.Normalize(times[0] / unit.factor,
                                                         times[-1] / unit.factor), "viridis")
        axes.figure.colorbar(colour_map, ax=axes, label=unit.label("Time"))
    if handles:
        axes.legend(handles=handles, fontsize="small", frameon=False)


def _draw_point(axes, table: Table, column: str, references: list[ReferenceCurve]) -> None:
    scale, unit = scale_of(column, table[column]), time_scale(table["time_s"])
    axes.plot(table["time_s"] / unit.factor, table[column] / scale.factor, marker=".",
              color=plt.cm.viridis(0.3), label="simulation")
    handles = _draw_references(axes, references, unit.factor, scale.factor, {None: BLACK})
    if handles:
        axes.legend(handles=[*axes.lines[:1], *handles], fontsize="small", frameon=False)
    axes.set_xlabel(unit.label("Time"))
    axes.set_ylabel(scale.label(_label(table, column)))


def _panels(run: RunDirectory, field: str,
            references: Sequence[ReferenceCurve]) -> list[tuple[str, Table, str]]:
    """Probe, its table and column of each panel: of flow `field` of every probe, of mechanics every
    component of displacement, velocity and stress, and whatever there are references of."""
    panels = []
    for name in run.probe_names:
        table = run.probe(name)
        columns = [_column(table, field)] if "pressure_Pa" in table else []
        columns += [column for column in _MECHANICS if column in table]
        columns += [curve.column for curve in references if curve.probe == name]
        panels += [(name, table, column) for column in dict.fromkeys(columns)]
    return panels


def probes_figure(run: RunDirectory, field: str = "pressure",
                  references: Sequence[ReferenceCurve] = ()):
    """A figure of one panel a probe, of mechanics one a probe and component, whatever the field.
    References are markers, of profiles in the colour of the time they belong to. Raises
    RunDirectoryError in a run without probes."""
    if not run.probe_names:
        raise RunDirectoryError(f"{run.path}: this run has no probes; the case asks for them by "
                                "[probe.NAME]")
    panels = _panels(run, field, references)
    figure, all_axes = panels_of(run, len(panels), 3.6, alone=7.0)
    for axes, (name, table, column) in zip(all_axes, panels):
        over = [curve for curve in references if (curve.probe, curve.column) == (name, column)]
        if len(table.at_time()) > 1:
            _draw_line(axes, table, column, run.is_steady, over)
        else:
            _draw_point(axes, table, column, over)
        axes.set_title(f"probe.{name}", fontsize=10)
        axes.grid(alpha=0.3)
    return figure


def draw_probes(run: RunDirectory, field: str, path: Path,
                references: Sequence[ReferenceCurve] = ()) -> Path:
    """Writes the figure to `path` and returns it."""
    return save(probes_figure(run, field, references), path)
