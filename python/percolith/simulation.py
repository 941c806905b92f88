# SPDX-License-Identifier: BSD-3-Clause
"""A case while it runs: advance it, look at its state, write pressures."""

from __future__ import annotations

import io
import json
import math
import os
import sys
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, NamedTuple

import numpy as np

from percolith import _core
from percolith.arguments import in_python, numbers, python_words, whole_number
from percolith.errors import CaseError, CaseWarning
from percolith.lent_memory import lend, take_back
from percolith.options import describe
from percolith.run_directory import (
    EVENT_WORDS,
    Frame,
    RunDirectory,
    RunDirectoryError,
    Table,
    parse_table,
)
from percolith.vtu import Grid

def _print(text: str) -> None:
    sys.stdout.write(text)
    sys.stdout.flush()


def _alert(line: str) -> None:
    """Warnings become warnings of Python; why a run stopped is for the one who waits."""
    if "warning: " in line:
        warnings.warn(in_python(line), CaseWarning, stacklevel=4)
    else:
        print(line, file=sys.stderr)


def start_run(source: Mapping[str, Any], output: str | os.PathLike | None = None, *,
              force: bool = False, threads: int | None = None,
              progress: bool = False) -> _core.Run:
    """Builds the model of a case."""
    _require_threads(threads)
    with python_words():
        return _core.Run.start(**source, output=None if output is None else os.fspath(output),
                               force=force, threads=threads, quiet=not progress, print=_print,
                               alert=_alert)


def reopen_run(folder: str | os.PathLike, threads: int | None = None,
               progress: bool = False) -> _core.Run | None:
    """The run in a folder, at its last checkpoint; None where it has finished."""
    _require_threads(threads)
    with python_words():
        return _core.Run.reopen(os.fspath(folder), threads=threads, quiet=not progress,
                                print=_print, alert=_alert)


def _require_threads(threads: int | None) -> None:
    # None: as many as OpenMP takes.
    if threads is not None:
        whole_number("threads", threads, "number of threads")


class Pressures(NamedTuple):
    """Pressures in place, Pa: of the pores, (blocks, 8, 3), and of the cracks, (vertices,)."""

    pressure: np.ndarray
    crack_pressure: np.ndarray


class Simulation:
    """A model that is advanced step by step. `Case.simulation` makes one.

        with case.simulation() as simulation:
            while simulation.advance(steps=100):
                print(simulation.time, simulation.flow.pressure.max())

    Steps are those that a run in one would make: pauses change nothing, not a bit. Leaving the
    `with` block before the end leaves results and a checkpoint, as Ctrl-C does.

    `mesh`, `flow` and `motion` show the arrays of the simulator without copying them: they change
    as the simulation advances, and are read-only. Values per corner have the shape (blocks, 8, 3):
    corner k of triangle t is at [t // 8, t % 8, k], and the last block may be padded;
    `triangle_values` gives a copy of shape (triangles, 3).
    """

    def __init__(self, run: _core.Run, output: str | os.PathLike | None):
        self._run = run
        self._output = output
        self._is_writing = False
        self._since = 0.0  # times from here on have been reached by the last step at the earliest

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, kind, error, trace) -> None:
        self.close("the end of the program's use" if kind is None else kind.__name__)

    def close(self, reason: str = "close()") -> None:
        """Ends the run where it is. Results that are not complete say so, with the reason, and
        `percolith.resume` goes on with them."""
        self._run.close(reason)

    def advance(self, *, until: float | str | None = None, steps: int | None = None,
                output: bool = False) -> bool:
        """Makes steps; returns whether it made any and the run can go on, so that it is False in
        the end whatever a loop waits for.

        until: to the first step that ends at this time (s, or a text such as "2 ms") or later; no
        step where the last one has reached it. steps: at most so many. output: to the next time of
        output. Whichever comes first; all to the end of the run where none is given. Raises
        CaseError for a time that has passed before, and SolverError, after which the results up to
        the last output are kept.
        """
        if self._is_writing:
            raise CaseError("error: advance: its pressures are being written to; allowed: after the "
                            "block of writing()")
        time = math.inf if until is None else _seconds(until)
        if time < self._since and not math.isclose(time, self._since, rel_tol=1e-9):
            raise CaseError(f"error: until = {until}: the simulation is at {self.time:.9g} s "
                            "already; allowed: a later time")
        most = 2**62 if steps is None else whole_number("steps", steps, "number of steps")
        return self._go(time, most, output)

    def _go(self, until: float, steps: int, output: bool) -> bool:
        before = self.steps, self.time
        try:
            with python_words():
                more = self._run.advance(until, steps, output)
        finally:
            has_moved = (self.steps, self.time) != before
            if has_moved:
                self._since = min(until, self.time)
        return more and has_moved

    def run(self, *, on_output: Callable[[Simulation], object] | None = None,
            on_step: Callable[[Simulation], object] | None = None) -> None:
        """Advances to the end. on_step is called after every step, on_output at time zero and after
        every time of output, each with the simulation; what they raise ends the run, with its
        results kept."""
        try:
            seen = self._run.outputs
            self._run.begin()
            more = not self.is_over
            while True:
                if on_output and self._run.outputs > seen:
                    on_output(self)
                seen = self._run.outputs
                if not more:
                    return
                steps = self.steps
                self._go(math.inf, 1 if on_step else 2**62, on_output is not None)
                more = not self.is_over
                if on_step and self.steps > steps:
                    on_step(self)
        except BaseException as error:
            self.close(type(error).__name__)
            raise

    @property
    def time(self) -> float:
        """Present time, s."""
        return self._run.time

    @property
    def end(self) -> float:
        """Time at which the run ends, s."""
        return self._run.end

    @property
    def steps(self) -> int:
        """Steps made since time zero."""
        return self._run.steps

    @property
    def is_over(self) -> bool:
        """Whether the end was reached, or the run was closed."""
        return self._run.is_over

    @property
    def mesh(self) -> _core.Mesh:
        """Vertices, triangles and joints."""
        return self._run.mesh

    @property
    def flow(self) -> _core.Flow | None:
        """Pressures, saturations and contents of pores and cracks; None without flow."""
        return self._run.flow

    @property
    def motion(self) -> _core.Motion | None:
        """Displacements, velocities and joints; None in a run of flow alone."""
        return self._run.motion

    def triangle_values(self, corners: np.ndarray) -> np.ndarray:
        """A copy of values per corner, (blocks, 8, 3), as (triangles, 3): row t has the values of
        the corners at `mesh.triangles[t]`."""
        return np.array(corners).reshape(-1, 3)[:len(self.mesh.triangles)]

    def check(self) -> _core.CheckReport:
        """Counts, mesh quality and limits of the time step."""
        return self._run.check()

    def frame(self) -> Frame:
        """The present fields of rock and cracks, as the field files have them."""
        matrix, cracks = self._run.frame()
        return Frame(self.time, Grid(**matrix, time=self.time),
                     Grid(**cracks, time=self.time) if len(cracks["cells"]) else None)

    def summary(self) -> dict[str, Any]:
        """The present state as `summary.json` tells it: mass balance, energies and counts with
        units in their names, and the hash of the state."""
        return json.loads(self._run.summary())

    @property
    def state_hash(self) -> str:
        """Hash of all that the state consists of: equal for equal bits."""
        return self.summary()["state_hash"]

    @property
    def mass_balance(self) -> dict[str, Any]:
        """Volumes of fluid since time zero, m2 (m3 per metre of thickness): `in_m2`, `out_m2`,
        `stored_m2`, `error_m2` and so on. Raises RunDirectoryError without flow."""
        summary = self.summary()
        if "mass_balance" not in summary:
            raise RunDirectoryError("mechanics of dry rock has no mass balance")
        return summary["mass_balance"]

    @property
    def energies(self) -> dict[str, float]:
        """Energies and works now, J per metre of thickness, by the names of the history. Raises
        RunDirectoryError in a run of flow."""
        energies = {name: value for name, value in self.values().items()
                    if name.endswith("_J_per_m")}
        if not energies:
            raise RunDirectoryError("a run of flow has no energies")
        return energies

    def values(self) -> dict[str, float]:
        """The present state as a row of the history."""
        row = parse_table(io.StringIO(self._run.present_tables()["history"]), "history")
        return {name: float(column[0]) for name, column in row.columns.items()}

    def probe(self, name: str) -> Table:
        """The probe of this name now: a row a place, with time_s, x_m, y_m and its quantities."""
        tables, folder = self._run.present_tables(), "probes/"
        known = [one.removeprefix(folder) for one in tables if one.startswith(folder)]
        return self._table(tables, folder + name,
                           f"no probe {name}; there are: {', '.join(sorted(known)) or 'none'}")

    @property
    def history(self) -> Table:
        """What history.csv holds so far: a row a reported time."""
        return self._table(self._run.tables, "history", "nothing has been reported yet")

    @property
    def events(self) -> Table:
        """Joints that broke so far, in the order of time; `mode` and `material` are text."""
        return self._table(self._run.tables, "events", self._why_no("events"))

    @property
    def fragments(self) -> Table:
        """Pieces of rock at the times of output so far."""
        return self._table(self._run.tables, "fragments", self._why_no("fragments"))

    def _why_no(self, pieces: str) -> str:
        if self.motion is None:
            return f"a run of flow has no {pieces}"
        return f"there are no {pieces} before the run starts; advance it first"

    def probe_history(self, name: str) -> Table:
        """Rows of a probe at all times of output so far."""
        return self._table(self._run.tables, f"probes/{name}", f"no rows of a probe {name} yet")

    @staticmethod
    def _table(tables: Mapping[str, str], name: str, absent: str) -> Table:
        if name not in tables:
            raise RunDirectoryError(absent)
        return parse_table(io.StringIO(tables[name]), name, words=EVENT_WORDS)

    def set_motion(self, displacement: Any = None, velocity: Any = None) -> None:
        """Gives a dry rock displacements (m) and velocities (m/s) at time zero, each an array
        (vertices, 2), before its first step; the strains they mean store energy from the start.
        Arrays that were taken before show the model without them. Raises CaseError for values
        that are not finite or turn a triangle over, once the run has begun, for a rock with flow,
        and for a run that writes results, since its checkpoints would not tell of such a start."""
        self._require_going("set_motion")
        self._run.start_from(self._vertex_vectors("displacement", displacement),
                             self._vertex_vectors("velocity", velocity))

    def _vertex_vectors(self, name: str, given: Any) -> np.ndarray:
        shape = self.mesh.vertices.shape
        values = np.zeros(0) if given is None else np.ascontiguousarray(
            numbers(name, given, f"an array {shape}"))
        if given is not None and values.shape != shape:
            raise CaseError(f"error: {name}: an array of shape {values.shape}; allowed: {shape}")
        return values.ravel()

    def set_condition(self, option: str, value: float | str) -> None:
        """Changes a condition of the flow while the simulation waits: `option`, such as
        "source.well.rate" or "boundary.left.pressure", has this value from now on at all times,
        whatever table over time the case gives. value: in SI, or a text with a unit. Checkpoints
        know of it and the log tells it; `resolved.toml` keeps what the run began with. Raises
        CaseError for another option, a value that cannot be, and a condition that presses on the
        rock as well (`pressurised`, excavations)."""
        self._require_going("set_condition")
        if not isinstance(option, str):
            raise CaseError(f"error: {option!r}: no option; allowed: its dotted path as a text")
        unit = describe(option).unit if isinstance(value, str) else "the unit of the option"
        self._run.set_condition(option, quantity(value, unit))

    def set_pressure(self, pressure: Any) -> None:
        """Gives the pores pressures, Pa: one number, or a text with a unit, an array (vertices,),
        or one (triangles, 3) where the pressure jumps across cracks. Nodes become full. Contents
        follow; the fluid that comes or goes is no part of the mass balance. The rock of a coupled
        run feels the change from the next step on. Raises CaseError for values that are not finite
        or below the cavitation pressure, that differ within a pore node, or where the run takes
        none: mechanics of dry rock, a quasi-static run once it has begun, and one that is over or
        closed."""
        self._require_going("set_pressure")
        self._run.set_pore_pressure(self._slots(pressure))

    def set_crack_pressure(self, pressure: Any) -> None:
        """Gives the open crack nodes pressures, Pa: one number, or a text with a unit, or an array
        (vertices,), of which those of other vertices have no effect. Raises as `set_pressure`
        does."""
        self._require_going("set_crack_pressure")
        count = len(self.mesh.vertices)
        values = _pressures(pressure)
        if values.shape not in ((), (count,)):
            raise CaseError(f"error: pressure: an array of shape {values.shape}; allowed: a "
                            f"number, or ({count},), one for each vertex")
        self._run.set_crack_pressure(np.ascontiguousarray(np.broadcast_to(values, (count,))))

    @contextmanager
    def writing(self) -> Iterator[Pressures]:
        """The pressures of the simulator itself, to be written to in place:

            with simulation.writing() as fluid:
                fluid.pressure[...] += 1e5
                fluid.crack_pressure[simulation.flow.crack_nodes] = 2e6

        Read-only again after the block: both arrays, and what slicing, reshaping or transposing
        makes of them; not what `np.asarray` or a memoryview does, which is not to be kept.

        At the end of the block what has changed becomes the state: all corners of a pore node must
        have the same pressure, nodes that changed become full, and contents follow as for
        `set_pressure`. Where that cannot be, or the block raises, all is as it was before. Raises
        as `set_pressure` does."""
        self._require_going("writing")
        pores, cracks = self._run.pressure_memory()
        before = pores.copy(), cracks.copy()
        lent = lend(pores), lend(cracks)
        self._is_writing = True
        try:
            yield Pressures(lent[0].reshape(-1, 3, 8).transpose(0, 2, 1), lent[1])
        finally:
            self._is_writing = False
            wanted = pores.copy(), cracks.copy()
            pores[:], cracks[:] = before
            take_back(lent[0], pores)
            take_back(lent[1], cracks)
        self._run.change_pressures(wanted[0], before[0], wanted[1], before[1])

    def _require_going(self, what: str) -> None:
        if self.is_over:
            raise CaseError(f"error: {what}: the run is over or closed; allowed: before its end")

    def _slots(self, given: Any) -> np.ndarray:
        triangles = self.mesh.triangles
        vertices = len(self.mesh.vertices)
        values = _pressures(given)
        if values.shape == (vertices,):
            values = values[triangles]
        elif values.shape not in ((), triangles.shape):
            raise CaseError(f"error: pressure: an array of shape {values.shape}; allowed: a "
                            f"number, ({vertices},) or {triangles.shape}")
        blocks = -(-len(triangles) // 8)
        slots = np.zeros((blocks * 8, 3))
        slots[:len(triangles)] = values
        return np.ascontiguousarray(slots.reshape(blocks, 8, 3).transpose(0, 2, 1)).ravel()

    def results(self) -> RunDirectory:
        """Opens the folder with the results. Raises RunDirectoryError where none is written."""
        if self._output is None:
            raise RunDirectoryError("the simulation writes no results; give `output` to have them")
        return RunDirectory(self._output)

    def __repr__(self) -> str:
        return f"Simulation(time={self.time:g} s of {self.end:g} s, steps={self.steps})"


def quantity(value: float | str, unit: str) -> float:
    """A number, or a text with a unit, in the SI unit named: `quantity("20 GPa", "Pa")` is 2e10.
    Raises CaseError where the unit does not fit, and for what is no number."""
    if isinstance(value, str):
        return _core.quantity(value, unit)
    try:
        return float(value)
    except (TypeError, ValueError):
        raise CaseError(f"error: {value!r}: no number; allowed: a number in {unit}, or a text with "
                        "a unit") from None


def _pressures(given: Any) -> np.ndarray:
    if isinstance(given, str):
        return np.asarray(quantity(given, "Pa"))
    return numbers("pressure", given, "a number in Pa, a text such as \"2 MPa\", or an array")


def _seconds(time: float | str) -> float:
    seconds = quantity(time, "s")
    if math.isnan(seconds):
        raise CaseError("error: until = nan: no time; allowed: seconds, or a text with a unit")
    return seconds


def resume(folder: str | os.PathLike, *, threads: int | None = None,
           progress: bool = False) -> RunDirectory:
    """Goes on with a run that was stopped or killed, from its last checkpoint to its end, and opens
    its results; opens them at once where it has finished. They are those of a run in one, bit for
    bit. Raises CaseError, SolverError and FileError."""
    run = reopen_run(folder, threads, progress)
    if run is not None:
        with Simulation(run, folder) as simulation:
            simulation.run()
    return RunDirectory(folder)
