# SPDX-License-Identifier: BSD-3-Clause
"""A case: the options of a run, read from a file or given as Python values."""

from __future__ import annotations

import copy
import os
import tomllib
import warnings
from collections.abc import Iterator, Mapping, MutableMapping
from pathlib import Path
from typing import Any

from percolith import _core
from percolith.arguments import in_python, python_words
from percolith.errors import CaseError, CaseWarning, FileError, unknown_name
from percolith.run_directory import RunDirectory
from percolith.simulation import Simulation, start_run
from percolith.toml_text import document, inline, plain

# Stands for the file of a case that comes from none, in messages, in the log and in the summary.
_MADE_HERE = "case built in Python"


class Options(MutableMapping[str, Any]):
    """Options by name, or by dotted path from here. What is set goes into the case."""

    def __init__(self, case: Case, path: str):
        self._case = case
        self._path = path

    def _full(self, key: str) -> str:
        if not isinstance(key, str) or not key:
            raise KeyError(key)
        return f"{self._path}.{key}" if self._path else key

    def _values(self) -> dict[str, Any]:
        return self._case._find(self._path)

    def __getitem__(self, key: str) -> Any:
        value = self._case._find(self._full(key))
        if isinstance(value, dict):
            return Options(self._case, self._full(key))
        return tuple(value) if isinstance(value, list) else value

    def __setitem__(self, key: str, value: Any) -> None:
        self._case._set(self._full(key), value)

    def __delitem__(self, key: str) -> None:
        self._case._find(self._full(key))
        self._case._erase(self._full(key))

    def __iter__(self) -> Iterator[str]:
        return iter(self._values())

    def __len__(self) -> int:
        return len(self._values())

    def to_dict(self) -> dict[str, Any]:
        """A copy as nested dictionaries."""
        return copy.deepcopy(self._values())

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self._values()!r})"


class Case(Options):
    """The options of a run, as a dictionary whose keys may be dotted paths:

        case = Case.load("case.toml")
        case["material.rock.young_modulus"] = "20 GPa"
        case["probe.middle"] = {"point": [1.0, 1.0]}
        del case["source.well"]

    Values are numbers in SI units, texts with a unit, and whatever else a case file may hold;
    `percolith.describe("material.*.young_modulus")` tells what an option means. Options are
    checked where a case is used, all mistakes at once: CaseError then carries the messages of the
    command line, but for options of it that are arguments here. What is set here is what `--set`
    sets there.
    """

    def __init__(self, options: Mapping[str, Any] | None = None, *,
                 directory: str | os.PathLike = "."):
        """A case of the options given, with nothing else; `format` need not be among them. Files
        that options name are relative to `directory`."""
        self._start(Path(directory) / _MADE_HERE, "format = 1\n")
        for key, value in (options or {}).items():
            self[key] = value

    @classmethod
    def load(cls, path: str | os.PathLike) -> Case:
        """Reads a case file. Raises CaseError with line and column where it is not TOML, and
        FileError where it cannot be read."""
        try:
            text = Path(path).read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as error:
            _core.case_warnings(os.fspath(path))
            raise FileError(f"cannot read the case file {path}: {error}") from error
        case = cls.__new__(cls)
        case._start(Path(path), text)
        return case

    @classmethod
    def from_toml(cls, text: str, *, directory: str | os.PathLike = ".") -> Case:
        """A case from the text of a case file. Files that it names are relative to `directory`."""
        case = cls.__new__(cls)
        case._start(Path(directory) / _MADE_HERE, text)
        return case

    def _start(self, file: Path, text: str) -> None:
        super().__init__(self, "")
        self._file = file
        self._text = text
        self._overrides: list[tuple[str, str]] = []
        try:
            self._tree: dict[str, Any] = tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            _core.case_warnings(str(file), text)
            raise CaseError(f"{file}: error: not valid TOML: {error}") from error

    @property
    def file(self) -> Path:
        """The file that messages name, `case built in Python` where there is none; files that
        options name are relative to its folder."""
        return self._file

    def copy(self) -> Case:
        """A case of its own with the same options."""
        other = Case.__new__(Case)
        other._start(self._file, self._text)
        other._overrides = list(self._overrides)
        other._tree = copy.deepcopy(self._tree)
        return other

    def _find(self, path: str) -> Any:
        value: Any = self._tree
        above: list[str] = []
        for name in path.split(".") if path else ():
            if not isinstance(value, dict) or name not in value:
                names = value if isinstance(value, dict) else ()
                raise unknown_name("option", ".".join([*above, name]),
                                   [".".join([*above, other]) for other in names])
            value = value[name]
            above.append(name)
        return value

    def _set(self, path: str, value: Any) -> None:
        value = plain(value, path)
        names = path.split(".")
        table = self._tree
        for name in names[:-1]:
            table = table.setdefault(name, {})
            if not isinstance(table, dict):
                raise CaseError(f"error: {path} = {inline(value)}: \"{name}\" is not a table")
        table[names[-1]] = value
        self._note(path, inline(value))

    def _erase(self, path: str) -> None:
        *tables, name = path.split(".")
        table = self._tree
        for above in tables:
            table = table[above]
        del table[name]
        self._note(path, "")

    def _note(self, path: str, text: str) -> None:
        # What stood at this path or below it is void.
        self._overrides = [(other, value) for other, value in self._overrides
                           if other != path and not other.startswith(path + ".")]
        self._overrides.append((path, text))

    @property
    def source(self) -> dict[str, Any]:
        """What the simulator is given: `file`, `text` and `overrides`."""
        return {"file": str(self._file), "text": self._text,
                "overrides": [f"{path}={text}" for path, text in self._overrides]}

    def resolved(self) -> dict[str, Any]:
        """Every option with its value in SI, defaults included; texts in place of numbers stand
        only where a text is meant. Raises CaseError."""
        with python_words():
            return tomllib.loads(_core.resolved(**self.source))

    def validate(self) -> None:
        """Checks the options without mesh and model. Raises CaseError with all mistakes."""
        with python_words():
            told = _core.case_warnings(**self.source)
        for warning in told:
            warnings.warn(in_python(warning), CaseWarning, stacklevel=2)

    def check(self) -> _core.CheckReport:
        """Builds the model and tells its counts, mesh quality and limits of the time step, and
        warns of what may be wrong with it. Raises CaseError and FileError."""
        run = start_run(self.source)  # which warns of what the options alone tell
        report = run.check()
        for warning in report.warnings[len(run.case_warnings):]:
            warnings.warn(in_python(f"warning: {warning}"), CaseWarning, stacklevel=2)
        return report

    def to_toml(self) -> str:
        """The options as the text of a case file, without comments."""
        return document(self._tree)

    def save(self, path: str | os.PathLike) -> None:
        """Writes the case as a case file, without comments. Files that it names relative to
        another folder are named from the new one. Raises FileError."""
        tree = copy.deepcopy(self._tree)
        mesh = tree.get("mesh")
        if isinstance(mesh, dict) and isinstance(mesh.get("file"), str):
            here = Path(path).absolute().parent
            mesh["file"] = os.path.relpath(self._file.absolute().parent / mesh["file"], here)
        try:
            Path(path).write_text(document(tree), encoding="utf-8")
        except OSError as error:
            raise FileError(f"{path}: cannot write the case: {error}") from error

    def simulation(self, output: str | os.PathLike | None = None, *, force: bool = False,
                   threads: int | None = None, progress: bool = False) -> Simulation:
        """Builds the model, ready to be advanced; see `Simulation`.

        output: the folder for results, as `percolith run --output` leaves them; none are written
        when None. force: replaces results that are there. threads: as many as OpenMP takes when
        None. progress: prints lines about it. Raises CaseError and FileError.
        """
        run = start_run(self.source, output, force=force, threads=threads, progress=progress)
        return Simulation(run, output)

    def run(self, output: str | os.PathLike | None = None, *, force: bool = False,
            threads: int | None = None, progress: bool = False) -> RunDirectory:
        """Runs the case to its end and opens its results.

        output: the folder for them; when None `CASE.results` in the present folder, as the command
        line has it, or `case.results` for a case that comes from no file. The files are those that
        the command line writes, bit for bit. Ctrl-C stops the run after its present step: results
        and a checkpoint stay, and `percolith.resume` goes on. Other arguments as for `simulation`. Raises CaseError, SolverError and FileError.
        """
        name = "case" if self._file.name == _MADE_HERE else self._file.stem
        folder = Path(f"{name}.results") if output is None else output
        with self.simulation(folder, force=force, threads=threads, progress=progress) as simulation:
            simulation.run()
        return simulation.results()
