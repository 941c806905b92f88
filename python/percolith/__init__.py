# SPDX-License-Identifier: BSD-3-Clause
"""Reads and draws the results of Percolith, the simulator of fractured porous rock."""

from percolith.run_directory import Frame, RunDirectory, RunDirectoryError
from percolith.vtu import Grid, read_vtu

__all__ = ["Frame", "Grid", "RunDirectory", "RunDirectoryError", "read_vtu"]
