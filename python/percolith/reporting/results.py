# SPDX-License-Identifier: BSD-3-Clause
"""What came out of a run in tables: balances, breakage, cracks, extremes. Of a run that has not
ended it is the last row of its history."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from percolith.b_value import b_value, reason_for_none
from percolith.crack_words import open_to_fluid
from percolith.history_columns import HELD, INPUT
from percolith.reporting.outcome import history_of
from percolith.reporting.quantities import number_text, quantity_text
from percolith.reporting.tables import Table, result_rows
from percolith.run_directory import RunDirectory

_LOST = ("fracture_J_per_m", "friction_J_per_m", "damping_J_per_m", "absorbed_J_per_m")
_ENERGY = {"external_work_J_per_m": "work of loads and supports",
           "gravity_J_per_m": "work of gravity", "fluid_work_J_per_m": "work of the fluid",
           "kinetic_J_per_m": "held: motion", "elastic_J_per_m": "held: strain of the rock",
           "joint_J_per_m": "held: joints", "contact_J_per_m": "held: contact",
           "fracture_J_per_m": "lost: fracture", "friction_J_per_m": "lost: friction",
           "damping_J_per_m": "lost: damping",
           "absorbed_J_per_m": "lost: absorbed at boundaries, or taken out"}
_BROKEN = {"broken_joints_tensile": "joints that broke in tension",
           "broken_joints_shear": "in shear", "broken_joints_mixed": "in both",
           "broken_joints": "joints that broke, in all",
           "closed_joints": "broken from the start, faces still together",
           "fragments": "fragments", "fragment_area_m2": "area of all fragments",
           "largest_fragment_area_m2": "area of the largest fragment"}
_CRACKS = {"filled_crack_length_m": "of it full of fluid",
           "mean_aperture_m": "mean hydraulic aperture",
           "crack_volume_m2": "room in the cracks", "crack_fluid_m2": "fluid in the cracks",
           "leaked_m2": "leaked from cracks into the rock"}
_MOTION = {"deepest_overlap_m": "deepest overlap of contacts",
           "unbalanced_ratio": "unbalanced force over internal forces",
           "added_mass_share": "mass added over the mass there was"}
_EXTREMES = {"minimum_pressure_Pa": "lowest pressure in pores",
             "maximum_pressure_Pa": "highest pressure in pores",
             "minimum_crack_pressure_Pa": "lowest pressure in cracks",
             "maximum_crack_pressure_Pa": "highest pressure in cracks",
             "minimum_saturation": "lowest saturation"}
_MASS = {"in_m2": "came in", "out_m2": "went out", "stored_m2": "stored",
         "in_place_m2": "in place", "error_m2": "error: in − out − stored"}
_VOLUMES = {*_MASS, "crack_volume_m2", "crack_fluid_m2", "leaked_m2"}
_NOISE = 1e-12  # of the energies: rounding
_DENSITY = "Volumes are at reference density, of a slice of one metre."


def _last_row(run: RunDirectory) -> dict[str, Any]:
    history = history_of(run)
    return {name: float(history[name][-1]) for name in history} if history else {}


def _chosen(results: dict[str, Any], labels: dict[str, str]) -> list[list[str]]:
    """Rows of the results that `labels` names, in its order; what is no number is left out."""
    found = {name: results[name] for name in labels
             if name in results and math.isfinite(results[name])}
    return result_rows(found, labels, _VOLUMES)


def _mass(run: RunDirectory, last: dict[str, Any]) -> list[Table]:
    """Balance of the fluid, and what each condition let in; in a steady run these are rates."""
    balance = run.summary.get("mass_balance", {}) if run.has_summary else last
    if run.is_steady:
        rows = [[label, quantity_text(balance[name], "m2/s")] for name, label in
                (("in_m2", "comes in"), ("out_m2", "goes out")) if name in balance]
    else:
        rows = _chosen(balance, _MASS)
    if "relative_error" in balance:
        rows.append(["relative error", number_text(balance["relative_error"])])
    rates = run.summary.get("rate_m2_per_s", {}) if run.has_summary else {}
    volumes = {} if run.is_steady else balance.get("by_condition_m2", {})
    if not run.has_summary:
        ending = ".volume_m2"
        volumes = {name.removesuffix(ending): value for name, value in last.items()
                   if name.endswith(ending)}
    tables = [Table("Balance of the fluid", rows, note="" if run.is_steady else _DENSITY)]
    names = list(dict.fromkeys([*volumes, *rates]))
    if names:
        head = ["", *["let in, negative: out"] * bool(volumes), *["rate at the end"] * bool(rates)]
        tables.append(Table("By condition", [
            [name, *([quantity_text(volumes.get(name, 0.0), "m3/m")] if volumes else []),
             *([quantity_text(rates.get(name, 0.0), "m2/s")] if rates else [])]
            for name in names], head))
    return tables


def _held_at_the_start(run: RunDirectory) -> float:
    """What the rock holds before anything happens (J/m), as under stress in place: the first row of
    the history."""
    history = history_of(run)
    if not history:
        return 0.0
    return sum(float(history[name][0]) for name in HELD if name in history)


def _energy(results: dict[str, Any], at_start: float) -> Table:
    """The balance. What was held at the start and what came in is what is held and lost at the end,
    but for what the balance lacks."""
    rows = _chosen(results, _ENERGY)
    given, held, lost = (sum(results.get(name, 0.0) for name in names)
                         for names in (INPUT, HELD, _LOST))
    if rows:
        if at_start > _NOISE * max(map(abs, (given, held, lost))):
            rows.append(["held at the start", quantity_text(at_start, "J/m")])
        rows.append(["given in all", quantity_text(given, "J/m")])
        rows.append(["held and lost in all", quantity_text(held + lost, "J/m")])
    if "residual_J_per_m" in results:
        rows.append(["what the balance lacks", quantity_text(results["residual_J_per_m"], "J/m")])
    if "energy_error" in results:
        rows.append(["relative error", number_text(results["energy_error"])])
    return Table("Balance of energy", rows)


def _modes_by_events(run: RunDirectory) -> dict[str, int]:
    """Numbers of broken joints by mode, of a run without a summary."""
    if not (run.path / "events.csv").is_file():
        return {}
    modes = run.events["mode"]
    return {f"broken_joints_{mode}": int(np.sum(modes == mode))
            for mode in ("tensile", "shear", "mixed")}


def _breakage(run: RunDirectory, results: dict[str, Any]) -> Table:
    rows = _chosen(results, _BROKEN)
    if run.has_summary or (run.path / "events.csv").is_file():
        magnitudes = run.events["magnitude"]
        fit, why = b_value(magnitudes), reason_for_none(magnitudes)
        shown = f"{fit.value:.2f} ± {fit.error:.2f}" if fit else f"none: {why}"
        rows += [["b-value of the events", shown]] if len(magnitudes) else []
    return Table("Breakage", rows)


def _peaks(results: dict[str, Any]) -> list[Table]:
    tables = []
    if peaks := results.get("peak_pressures"):
        tables.append(Table("Highest pressure at sources", [
            [name, quantity_text(peak["pressure_Pa"], "Pa"), quantity_text(peak["time_s"], "s")]
            for name, peak in peaks.items()], ["", "pressure", "at"]))
    if peaks := results.get("peak_reactions"):
        tables.append(Table("Largest reactions, over all rows of the history", [
            [name, *(text for axis in "xy" for text in (
                quantity_text(peak[f"{axis}_N_per_m"], "N/m"),
                quantity_text(peak[f"{axis}_time_s"], "s")))]
            for name, peak in peaks.items()], ["", "along x", "at", "along y", "at"]))
    return tables


def result_tables(run: RunDirectory) -> list[Table]:
    """All tables of results that this run has."""
    last = _last_row(run)
    tables: list[Table] = []
    if run.has_flow:
        tables += _mass(run, last)
    if run.has_mechanics:
        results = run.summary.get("mechanics", {}) if run.has_summary else {
            **last, **_modes_by_events(run)}
        counts = {name: int(results[name]) for name in (
            "broken_joints", "closed_joints", "fragments") if name in results}
        results = {**results, **counts}
        tables += [_energy(results, _held_at_the_start(run)), _breakage(run, results),
                   Table("Cracks", _chosen(results, {
                       "crack_length_m": f"length {open_to_fluid(run)}", **_CRACKS})), *_peaks(results),
                   Table("Motion", _chosen(results, _MOTION))]
    if run.has_flow:
        extremes = run.summary.get("extremes", {}) if run.has_summary else last
        tables.append(Table("Extremes at the last time", _chosen(extremes, _EXTREMES)))
    return [table for table in tables if table.rows]
