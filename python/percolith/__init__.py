# SPDX-License-Identifier: BSD-3-Clause
"""Percolith, the simulator of fractured porous rock: cases, runs and their results.

Reading results needs numpy alone; what draws them or runs the simulator is loaded with its first
use.
"""

import importlib
import importlib.util
from typing import TYPE_CHECKING

from percolith.errors import (
    CaseError,
    CaseWarning,
    Error,
    FileError,
    MeshError,
    Problem,
    SolverError,
    UnknownNameError,
)
from percolith.processor import require_processor
from percolith.run_directory import (
    ArgumentError,
    Frame,
    RunDirectory,
    RunDirectoryError,
    Table,
    open_run,
)
from percolith.vtu import Grid, VtuError, read_vtu

if TYPE_CHECKING:
    from percolith import mesh
    from percolith.case import Case
    from percolith.options import Option, describe, option_names
    from percolith.reports import report
    from percolith.simulation import Simulation, quantity, resume
    from percolith.sweep_progress import SweepProgress
    from percolith.sweeps import Sweep, sweep

    __version__: str

# Where names that need the extension come from.
_LATER = {
    "Case": "case", "Simulation": "simulation", "resume": "simulation", "quantity": "simulation",
    "Option": "options", "describe": "options", "option_names": "options",
    "Sweep": "sweeps", "SweepProgress": "sweep_progress", "sweep": "sweeps",
}

__all__ = [
    "ArgumentError", "Case", "CaseError", "CaseWarning", "Error", "FileError", "Frame", "Grid",
    "MeshError", "Option", "Problem", "RunDirectory", "RunDirectoryError", "Simulation",
    "SolverError", "Sweep", "SweepProgress", "Table", "UnknownNameError", "VtuError", "__version__",
    "describe", "mesh", "open_run", "option_names", "quantity", "read_vtu", "report", "resume",
    "sweep",
]


def __getattr__(name: str) -> object:
    if name == "__version__":
        value = _extension("_core").version
    elif name == "mesh":
        value = importlib.import_module("percolith.mesh")
    elif name == "report":
        value = importlib.import_module("percolith.reports").report
    elif name in _LATER:
        value = getattr(_extension(_LATER[name]), name)
    else:
        raise AttributeError(f"module 'percolith' has no attribute {name!r}")
    globals()[name] = value
    return value


def _extension(module: str):
    require_processor()
    try:
        return importlib.import_module(f"percolith.{module}")
    except ImportError as error:
        # `from percolith import _core` blames the package in place of its missing part.
        if importlib.util.find_spec("percolith._core") is not None:
            raise
        raise ImportError("percolith was not built to run cases from Python: install it with "
                          "`pip install .` in its sources; reading and drawing results works "
                          "without") from error
