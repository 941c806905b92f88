# SPDX-License-Identifier: BSD-3-Clause
"""How a run ended, what it warned of, and what ruled its steps."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from percolith.reporting.quantities import number_text, quantity_text
from percolith.reporting.resolved_text import ResolvedText
from percolith.reporting.tables import Table
from percolith.run_directory import RunDirectory, read_file
from percolith.run_directory import Table as Columns

UNFINISHED = "unfinished"


@dataclass(frozen=True)
class Outcome:
    """status: finished, interrupted, failed or unfinished; text: a sentence on it."""

    status: str
    text: str


def read_log(run: RunDirectory) -> list[str]:
    """The lines of run.log; none where there is no such file."""
    path = run.path / "run.log"
    return read_file(path, str.splitlines) if path.is_file() else []


def history_of(run: RunDirectory) -> Columns | None:
    """The history; None where a run that has not ended has not written any, or a case that wants
    none. Raises RunDirectoryError where a run that ended lacks the file."""
    if not run.has_summary and not (run.path / "history.csv").is_file():
        return None
    return run.history if len(run.history) else None


def _reached(run: RunDirectory) -> float | None:
    """The time (s) the results come to."""
    if run.has_summary:
        return run.summary.get("end_time_s")
    history = history_of(run)
    return float(history["time_s"][-1]) if history else None


def _errors(log: list[str]) -> list[str]:
    return [line.split(" error: ", 1)[1] for line in log if " error: " in line]


def outcome_of(run: RunDirectory) -> Outcome:
    """How the run ended, or that it has not."""
    reached = _reached(run)
    at = f" at {quantity_text(reached, 's')}" if reached is not None else ""
    if not run.has_summary:
        going_on = (f"; percolith run --resume {run.path} goes on with one that was"
                    if (run.path / "checkpoint.bin").is_file() else "")
        last = f" What there is comes to {quantity_text(reached, 's')}." if at else ""
        errors = _errors(read_log(run))
        said = f" Its log ends with the error: {errors[-1]}." if errors else ""
        return Outcome(UNFINISHED, "The run has not ended, or was killed: there is no summary.json"
                                   f"{going_on}.{last}{said}")
    status = run.summary.get("outcome", "finished")
    reason = run.summary.get("reason", "")
    if status == "finished":
        rested = "settled" if "change_over_throughput" in run.summary else "came to rest"
        how = rested if run.summary.get("reached_rest") else "came to its end"
        how = "found the steady state" if run.is_steady else how + at
        return Outcome(status, f"The run {how}.")
    if status == "interrupted":
        return Outcome(status, f"The run was stopped by {reason}{at}; percolith run --resume "
                               f"{run.path} goes on with it.")
    return Outcome(status, f"The run failed{at}: {reason}")


def warnings_of(run: RunDirectory) -> list[str]:
    """What the run warned of, by its summary, or else by its log."""
    if run.has_summary:
        return run.summary.get("warnings", [])
    return [line.split(" warning: ", 1)[1] for line in read_log(run) if " warning: " in line]


def _ruled_by(run: RunDirectory, text: ResolvedText) -> str:
    time = run.resolved.get("time", {})
    scheme, step = time.get("scheme"), time.get("step")
    if scheme == "steady":
        return ("A steady state takes no step of time; the limits are those an explicit run would "
                "have.")
    given = step is not None and not isinstance(step, dict)
    if scheme == "implicit" and not run.has_mechanics:
        return (f"The step was given: time.step = {quantity_text(step, 's')}." if given else
                "The error of each step ruled (time.tolerance), not these limits of explicit "
                "steps.")
    if scheme == "quasi_static":
        return "The run was quasi-static: none of these limits of motion bound its steps."
    if not text.single_limits:
        return ""
    ruling = next(iter(text.single_limits))
    together = text.together or min(text.single_limits.values())
    if given and step < together * time.get("safety", 1.0):
        return (f"The step was given, time.step = {quantity_text(step, 's')}, and is below all "
                "limits.")
    return (f"By the limits at the start, {ruling} ruled; together the mechanisms allow "
            f"{quantity_text(together, 's')}.")


def step_table(run: RunDirectory, text: ResolvedText) -> Table | None:
    """The limits of the explicit step, the one that ruled, and the steps that were taken."""
    rows = [[f"limit by {name}", quantity_text(limit, "s")]
            for name, limit in text.single_limits.items()]
    if text.together is not None:
        rows.append(["limit by all together", quantity_text(text.together, "s")])
    history = history_of(run)
    if history and "step_size_s" in history and not run.is_steady:
        sizes = history["step_size_s"][history["step_size_s"] > 0]
        if len(sizes):
            ends = [quantity_text(float(end), "s") for end in
                    (np.min(sizes), np.median(sizes), np.max(sizes))]
            rows.append(["steps in the history: smallest, median, largest", ", ".join(ends)])
    for name, key in (("steps", "steps"), ("rejected steps", "rejected_steps"),
                      ("iterations", "iterations")):
        if run.has_summary and key in run.summary:
            rows.append([name, number_text(run.summary[key])])
    return Table("Steps of time", rows, note=_ruled_by(run, text)) if rows else None
