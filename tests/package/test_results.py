# SPDX-License-Identifier: BSD-3-Clause
"""Results that are opened again."""

import zlib

import numpy as np
import percolith
import pytest
from conftest import short_case


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    case = short_case("three_cracks")
    with case.simulation(tmp_path_factory.mktemp("run") / "results") as simulation:
        simulation.run()
        last = simulation.frame(), simulation.history, simulation.probe_history("tip")
        return percolith.open_run(simulation.results().path), *last


def test_frames_are_those_of_the_simulation(run):
    run, last, *_ = run
    frame = run.frame()
    assert frame.time == last.time
    for grid, other in [(frame.matrix, last.matrix), (frame.cracks, last.cracks)]:
        assert np.array_equal(grid.points, other.points)
        assert np.array_equal(grid.cells, other.cells)
        for name in other.point_data:
            assert np.array_equal(grid.point_data[name], other.point_data[name]), name
        for name in other.cell_data:
            assert np.array_equal(grid.cell_data[name], other.cell_data[name]), name
        assert grid.point_data.keys() == other.point_data.keys()
        assert grid.cell_data.keys() == other.cell_data.keys()


def test_tables_are_those_of_the_simulation(run):
    run, _, history, tip = run
    for table, other in [(run.history, history), (run.probe("tip"), tip)]:
        assert list(table) == list(other)
        for name in table:
            assert np.array_equal(table[name], other[name], equal_nan=True), name


def test_all_frames_in_turn(run):
    run, *_ = run
    assert [frame.time for frame in run.frames()] == run.times
    assert [frame.matrix.time for frame in run.frames()] == pytest.approx(run.times)


def test_cracks_as_a_table(run):
    run, *_ = run
    frame = run.frame()
    table = frame.crack_table()
    assert len(table) == len(frame.cracks.cells)
    length = np.hypot(table["x1_m"] - table["x0_m"], table["y1_m"] - table["y0_m"])
    assert length.sum() > 0.5 and {"aperture_m", "mode", "opening_m"} <= set(table)
    frame.cracks = None
    assert len(frame.crack_table()) == 0


def test_tables_become_frames_of_pandas(run):
    pandas = pytest.importorskip("pandas")
    run, *_ = run
    history = run.history.to_pandas()
    assert isinstance(history, pandas.DataFrame)
    assert history["time_s"].iloc[-1] == run.summary["end_time_s"]
    assert len(run.frame().crack_table().to_pandas()) == len(run.frame().cracks.cells)


def test_no_results_are_told():
    with pytest.raises(percolith.RunDirectoryError, match="no such directory"):
        percolith.open_run("nothing")
    assert issubclass(percolith.RunDirectoryError, percolith.Error)


def test_damage_within_an_array_is_told_when_it_is_read(run, tmp_path):
    run, *_ = run
    file = sorted((run.path / "fields").glob("matrix_*.vtu"))[0]
    content = bytearray(file.read_bytes())
    start = content.find(b"<AppendedData")
    stream = content.find(zlib.compress(b"", 1)[:2], start)
    content[stream:stream + 8] = bytes(8)
    (tmp_path / "broken.vtu").write_bytes(content)
    with pytest.raises(percolith.VtuError, match="broken.vtu"):
        grid = percolith.read_vtu(tmp_path / "broken.vtu")
        for values in [*grid.point_data.values(), *grid.cell_data.values()]:
            values.sum()
