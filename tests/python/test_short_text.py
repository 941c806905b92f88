# SPDX-License-Identifier: BSD-3-Clause
"""What `print` shows of tables, grids and frames."""

import sys

import numpy as np
import pytest
from percolith import Grid, Table, VtuError
from percolith.short_text import listed, table_text


def test_a_short_table_is_printed_whole():
    table = Table({"point": np.array([0, 1]), "state": np.array(["finished", "lost"]),
                   "end_time_s": np.array([1234.56789, np.nan])})
    assert str(table) == ("Table of 2 rows, 3 columns\n"
                          "point  state     end_time_s\n"
                          "    0  finished     1234.57\n"
                          "    1  lost             nan")
    assert repr(table) == "Table(2 rows; columns: point, state, end_time_s)"


def test_of_a_long_table_the_ends_are_printed():
    lines = str(Table({"a": np.arange(1000)})).splitlines()
    assert lines[0] == "Table of 1000 rows, 1 column"
    assert [line.strip() for line in lines[1:]] == ["a", "0", "1", "2", "3", "...", "996", "997",
                                                    "998", "999"]
    lines = str(Table({"a": np.arange(9)})).splitlines()  # nothing is saved by dots for one row
    assert [line.strip() for line in lines[2:]] == list("012345678")


@pytest.mark.parametrize("columns", [
    {f"boundary.left_{i}.displacement_x_m": np.full(50, -1.23456789e-15) for i in range(40)},
    {"x" * 300: np.zeros(50), "b": np.ones(50)}, {"a": np.zeros(50), "x" * 300: np.ones(50)},
    {"options": np.array(["long\nvalue " * 40] * 50)}, {"flux": np.full((50, 2), 1.0 / 3.0)}])
def test_a_wide_table_fits_a_screen(columns):
    lines = table_text(columns).splitlines()
    assert len(lines) == 11 and max(map(len, lines)) <= 100
    assert len(repr(Table(columns))) <= 100


def test_columns_without_room_are_told():
    columns = {name * 30: np.zeros(1) for name in "abcdef"}
    head, names, _ = table_text(columns).splitlines()
    assert head == f"Table of 1 row, 6 columns; not shown: {'d' * 30} and 2 more"
    assert names.split() == [name * 30 for name in "abc"]


def test_tables_without_rows_or_columns():
    assert str(Table({})) == "Table of 0 rows, 0 columns"
    assert repr(Table({})) == "Table(0 rows; columns: none)"
    assert str(Table({"a": np.empty(0)})) == "Table of 0 rows, 1 column\na"


def test_tables_are_printed_without_pandas(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    assert "0.5" in str(Table({"a": np.array([0.5])}))


def test_names_are_listed_as_far_as_there_is_room():
    assert listed(["one", "two", "three"], 8) == "one, two and 1 more"
    assert listed(["one", "two", "three"], 15) == "one, two, three"
    assert listed([]) == "none"


def test_frames_and_grids_tell_their_size(block):
    frame = block.frame()
    points, cells = len(frame.matrix.points), len(frame.matrix.cells)
    assert repr(frame).startswith(f"Frame(time=0.002 s, matrix of {points} points and {cells} "
                                  "cells, cracks of ")
    assert repr(frame.matrix).startswith(f"Grid(time=0.002 s, {points} points and {cells} cells; "
                                         "of points: displacement_m, ")
    frame.cracks = None
    assert repr(frame).endswith(", no cracks)") and "\n" not in repr(frame) + repr(frame.matrix)
    grid = Grid(np.zeros((3, 2)), np.array([[0, 1, 2]]), cell_data={"a_m": np.zeros(1)})
    assert repr(grid) == "Grid(time=0 s, 3 points and 1 cell; of points: none; of cells: a_m)"


def test_a_damaged_grid_can_be_printed():
    def damaged() -> np.ndarray:
        raise VtuError("matrix.vtu: damaged")

    assert repr(Grid(damaged, damaged)).startswith("Grid(time=0 s, damaged points or cells; ")
