# SPDX-License-Identifier: BSD-3-Clause
"""Reading a run directory that the program wrote."""

import sys

import numpy as np
import pytest
import vtk
from percolith import (
    Error,
    Grid,
    RunDirectory,
    RunDirectoryError,
    Table,
    UnknownNameError,
    read_vtu,
)
from percolith.run_directory import read_table
from percolith.vtu import VtuError
from vtk.util.numpy_support import vtk_to_numpy


@pytest.fixture(scope="module")
def run(run_example):
    return run_example("single_fracture").results


def read_with_vtk(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


@pytest.mark.parametrize("start", ["matrix", "cracks"])
def test_grid_equals_what_vtk_reads(run, start):
    path = sorted(run.path.glob(f"fields/{start}_*.vtu"))[-1]
    ours, theirs = read_vtu(path), read_with_vtk(path)
    assert np.array_equal(ours.points, vtk_to_numpy(theirs.GetPoints().GetData())[:, :2])
    cells = vtk_to_numpy(theirs.GetCells().GetConnectivityArray())
    assert np.array_equal(ours.cells.ravel(), cells)
    for data, fields in ((ours.point_data, theirs.GetPointData()),
                         (ours.cell_data, theirs.GetCellData())):
        assert sorted(data) == sorted(fields.GetArrayName(i)
                                      for i in range(fields.GetNumberOfArrays()))
        for name, values in data.items():
            expected = vtk_to_numpy(fields.GetArray(name))
            assert np.array_equal(values, expected[:, :2] if values.ndim == 2 else expected)


def test_frames_are_found_by_their_time(run):
    assert run.times == pytest.approx([0.0, 0.001, 0.01, 0.1, 0.2])
    assert run.frame().time == 0.2
    assert run.frame(0.012).time == pytest.approx(0.01)
    assert run.frame(0.1).matrix.time == pytest.approx(0.1)


def test_pressure_jumps_across_the_fracture(run):
    grid = run.frame().matrix
    on_fracture = abs(grid.points[:, 0]) < 1e-9
    heights = grid.points[on_fracture, 1]
    assert len(heights) == 2 * len(np.unique(heights))
    assert np.ptp(grid.point_data["pressure_Pa"][on_fracture]) > 1e5


def test_tables(run):
    assert run.history["time_s"][-1] == pytest.approx(0.2)
    assert run.summary["end_time_s"] == pytest.approx(0.2)
    assert run.probe_names == ["line"]
    rows = run.probe("line").at_time(0.1)
    assert len(rows) == 600
    assert rows["pressure_Pa"].max() < 8e6
    assert run.resolved["time"]["scheme"] == "implicit"
    assert run.title.startswith("A fracture at constant pressure")


def test_unknown_probe_is_refused_with_the_known_ones(run):
    with pytest.raises(RunDirectoryError, match="no probe lime; there are: line"):
        run.probe("lime")


def test_directory_without_results_is_refused(tmp_path):
    with pytest.raises(RunDirectoryError, match="not a run directory"):
        RunDirectory(tmp_path)
    with pytest.raises(RunDirectoryError, match="no such directory"):
        RunDirectory(tmp_path / "absent")


def test_damaged_field_file_is_named(run, tmp_path):
    source = sorted(run.path.glob("fields/matrix_*.vtu"))[-1]
    damaged = tmp_path / "damaged.vtu"
    content = source.read_bytes()
    for cut in (10, 400, len(content) // 2):
        damaged.write_bytes(content[:cut])
        with pytest.raises(VtuError, match="damaged.vtu"):
            read_vtu(damaged)


def test_table_with_words_is_refused(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text("# comment\na,b\n1,\n2,3\n")
    table = read_table(path)
    assert np.isnan(table["b"][0]) and table["b"][1] == 3
    path.write_text("a,b\n1,2\n3\n")
    with pytest.raises(RunDirectoryError, match="table.csv: .*rows of different lengths"):
        read_table(path)
    path.write_text("a\nword\n")
    with pytest.raises(RunDirectoryError, match="table.csv: not a table of numbers"):
        read_table(path)


def test_columns_of_words_are_read_where_asked_for(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text('a,mode\n1,"shear, late"\n2,tensile\n')
    table = read_table(path, words=("mode",))
    assert list(table["mode"]) == ["shear, late", "tensile"]
    assert table.where(table["mode"] == "tensile")["a"] == 2


def test_names_that_are_not_there_tell_those_that_are(run):
    grid = run.frame().matrix
    with pytest.raises(KeyError, match="^no column time; there are: time_s, ") as told:
        run.history["time"]
    assert isinstance(told.value, UnknownNameError) and isinstance(told.value, Error)
    with pytest.raises(UnknownNameError, match="no array presure; there are: pressure_Pa, "):
        grid.point_data["presure"]
    with pytest.raises(UnknownNameError, match="no array a; there are: none$"):
        Grid(grid.points, grid.cells).cell_data["a"]
    with pytest.raises(UnknownNameError, match=r" c29 and 70 more$"):
        Table({f"c{i}": np.zeros(1) for i in range(100)})["x"]
    assert grid.point_data.get("presure") is None and "presure" not in grid.point_data


def test_a_run_directory_is_printed_with_its_outcome_and_frames(run):
    assert repr(run) == f"RunDirectory({str(run.path)!r}, outcome=finished, frames=5)"


def test_to_print_a_run_that_goes_on_keeps_nothing_of_it(tmp_path):
    (tmp_path / "resolved.toml").write_text("format = 1\n")
    run = RunDirectory(tmp_path)
    assert repr(run) == f"RunDirectory({str(tmp_path)!r}, outcome=none yet, frames=0)"
    (tmp_path / "matrix.pvd").write_text(
        '<VTKFile><Collection><DataSet timestep="1" file="a.vtu"/></Collection></VTKFile>')
    (tmp_path / "summary.json").write_text('{"outcome": "stopped"}')
    assert repr(run) == f"RunDirectory({str(tmp_path)!r}, outcome=stopped, frames=1)"
    assert run.times == [1.0]
    (tmp_path / "summary.json").write_text("{")
    assert repr(run) == f"RunDirectory({str(tmp_path)!r}, damaged)"


def test_tables_without_pandas_tell_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match="pip install pandas"):
        Table({"a": np.zeros(1)}).to_pandas()


def test_a_run_of_flow_has_no_events(run):
    with pytest.raises(RunDirectoryError, match="a run of flow has no events"):
        _ = run.events
    with pytest.raises(RunDirectoryError, match="a run of flow has no fragments"):
        _ = run.fragments


def test_a_failed_run_tells_why_it_left_nothing(tmp_path):
    (tmp_path / "resolved.toml").write_text("format = 1\n")
    (tmp_path / "summary.json").write_text('{"outcome": "failed", "reason": "the rock would drain"}')
    run = RunDirectory(tmp_path)
    with pytest.raises(RunDirectoryError, match="no frames; the run failed: the rock would drain"):
        run.frame()
    with pytest.raises(RunDirectoryError, match="history.csv: missing; the run failed: the rock"):
        _ = run.history
