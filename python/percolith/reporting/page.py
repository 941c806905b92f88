# SPDX-License-Identifier: BSD-3-Clause
"""The page of a run as HTML that needs no other file and no network."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined

from percolith.reporting.outcome import outcome_of, read_log, step_table, warnings_of
from percolith.reporting.page_pictures import animations, drawn
from percolith.reporting.quantities import number_text, quantity_text
from percolith.reporting.resolved_text import ResolvedText, read_resolved
from percolith.reporting.results import result_tables
from percolith.reporting.tables import Table, option_tables
from percolith.reporting.view_data import LARGEST_SERIES, MOST_FRAMES, ViewData, view_data
from percolith.run_directory import RunDirectory

_PHYSICS = {"seepage": "flow through rock at rest", "mechanics": "motion of dry rock",
            "coupled": "fluid and rock, coupled"}
_SCRIPTS = ("arrays.js", "drawing.js", "finder.js", "model.js", "view.js", "controls.js",
            "player.js")
_LOG_LINES = 400  # of a long log the last ones


@cache
def _template():
    environment = Environment(loader=PackageLoader("percolith.reporting", "."), autoescape=True,
                              undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    return environment.get_template("page.html.jinja")


def _asset(name: str) -> str:
    return (Path(__file__).parent / name).read_text(encoding="utf-8")


def _physics(run: RunDirectory) -> str:
    scheme = run.resolved.get("time", {}).get("scheme", "")
    name = run.resolved.get("model", {}).get("physics", "seepage")
    return _PHYSICS.get(name, name) + (f"; {scheme.replace('_', ' ')}" if scheme else "")


def _overview(run: RunDirectory, given: ResolvedText) -> list[list[str]]:
    """What was run, in a few rows that are the same on any machine."""
    rows = [["physics", _physics(run)]]
    if not run.is_steady and "end" in run.resolved.get("time", {}):
        rows.append(["time asked for", quantity_text(run.resolved["time"]["end"], "s")])
    versions = [one.value for one in given.derived if "version" in one.name]
    if run.has_summary and "version" in run.summary:
        versions = [run.summary["version"]]
    rows += [["version of percolith", str(version)] for version in versions]
    if run.has_summary and "state_hash" in run.summary:
        rows.append(["hash of the final state", run.summary["state_hash"]])
    return rows


def _mesh(given: ResolvedText) -> Table | None:
    rows = [[one.name, one.value if isinstance(one.value, str)
             else quantity_text(one.value, one.unit)]
            for one in given.derived if "version" not in one.name]
    return Table("Mesh and what follows from it", rows) if rows else None


def _machine(run: RunDirectory) -> Table | None:
    """What depends on the machine: where the time went."""
    if not run.has_summary or "threads" not in run.summary:
        return None
    rows = [["case file", run.summary.get("case_file", "")],
            ["threads", number_text(run.summary["threads"])],
            ["processor", run.summary.get("processor", "")]]
    times = sorted(run.summary.get("wall_time_s", {}).items(), key=lambda entry: -entry[1])
    rows += [[f"time spent, {name}", f"{seconds:.3g} s"] for name, seconds in times]
    return Table("Machine and time spent", rows)


def _log(run: RunDirectory) -> str:
    lines = read_log(run)
    left_out = len(lines) - _LOG_LINES
    head = [f"({left_out} lines before these)"] if left_out > 0 else []
    return "\n".join(head + lines[-_LOG_LINES:])


def _view(run: RunDirectory, time: float | str | None, scale: float | None) -> ViewData | None:
    wanted = run.times or run.lost_frames
    return view_data(run, run.frame(time), scale) if wanted else None


def page_of(run: RunDirectory, time: float | str | None = None, scale: float | None = None) -> str:
    """The page of a run as HTML. `time` (s, or a text) chooses the frame that fields and view
    show, None the last one; `scale` multiplies the displacements, None chooses the factor. Raises
    RunDirectoryError where a file of a run that has ended is missing or damaged, VtuError where a
    field file of that frame is damaged, FileError where one cannot be read."""
    resolved = run.resolved_text
    given = read_resolved(resolved)
    tables = [table for table in (_mesh(given), step_table(run, given)) if table]
    return _template().render(
        title=run.title, outcome=outcome_of(run), overview=_overview(run, given),
        warnings=warnings_of(run), view=_view(run, time, scale), results=result_tables(run),
        pictures=drawn(run, time, scale) + animations(run), numbers=tables,
        options=option_tables(run.resolved, given), machine=_machine(run), resolved=resolved,
        log=_log(run), most_frames=MOST_FRAMES, largest_series=LARGEST_SERIES // 1_000_000,
        style=_asset("page.css"), scripts=[_asset(name) for name in _SCRIPTS])
