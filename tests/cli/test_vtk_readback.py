# SPDX-License-Identifier: BSD-3-Clause
"""VTK, which ParaView is made of, reads the field files."""

import csv
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from conftest import SHORT, STEADY

vtk = pytest.importorskip("vtk")
numpy_support = pytest.importorskip("vtk.util.numpy_support")


def read(path):
    """The grid of a `.vtu` file; fails on any complaint of VTK."""
    complaints = []
    reader = vtk.vtkXMLUnstructuredGridReader()
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_: complaints.append(event))
    reader.SetFileName(str(path))
    reader.Update()
    assert not complaints and reader.GetErrorCode() == 0
    return reader.GetOutput()


def array(data, name):
    return numpy_support.vtk_to_numpy(data.GetArray(name))


def shapes(grid):
    return {grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}


def frames(collection):
    """(time, file) of a `.pvd` collection."""
    return [(float(entry.get("timestep")), collection.parent / entry.get("file"))
            for entry in ElementTree.parse(collection).iter("DataSet")]


def test_matrix_series(percolith, strip, tmp_path):
    assert percolith("run", strip, *SHORT, "--output", "out").returncode == 0
    series = frames(tmp_path / "out/matrix.pvd")
    assert [time for time, _ in series] == pytest.approx([0, 1e-3, 5e-3, 0.01, 0.02])
    for time, file in series:
        grid = read(file)
        assert array(grid.GetFieldData(), "TimeValue")[0] == time
        assert shapes(grid) == {vtk.VTK_TRIANGLE}
    points = grid.GetPointData()
    assert array(points, "pressure_Pa").max() == pytest.approx(1e5)
    assert np.all(array(points, "saturation") == 1)
    assert points.GetArray("head_m") is None  # no gravity
    flux = array(grid.GetCellData(), "darcy_flux_m_per_s")
    assert flux.shape == (grid.GetNumberOfCells(), 3)
    assert np.all(flux[:, 2] == 0) and flux[:, 0].max() > 0
    assert np.all(array(grid.GetCellData(), "region") == 0)
    bounds = grid.GetBounds()
    assert bounds == pytest.approx((0, 1, 0, 0.2, 0, 0), abs=1e-12)


def test_values_are_those_of_the_probe(percolith, strip, tmp_path):
    assert percolith("run", strip, *STEADY, "--output", "out").returncode == 0
    grid = read(frames(tmp_path / "out/matrix.pvd")[-1][1])
    probe = vtk.vtkProbeFilter()
    points = vtk.vtkPoints()
    with open(tmp_path / "out/probes/centre.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    rows = [row for row in rows if row["time_s"] == rows[-1]["time_s"]][1:-1]
    for row in rows:
        points.InsertNextPoint(float(row["x_m"]), float(row["y_m"]), 0)
    places = vtk.vtkPolyData()
    places.SetPoints(points)
    probe.SetInputData(places)
    probe.SetSourceData(grid)
    probe.Update()
    seen = array(probe.GetOutput().GetPointData(), "pressure_Pa")
    expected = np.array([float(row["pressure_Pa"]) for row in rows])
    assert seen == pytest.approx(expected, abs=1e-6 * 1e5)


def test_cracks_series_and_the_jump_across_them(percolith, six_fractures, tmp_path):
    done = percolith("run", six_fractures, *STEADY, "--output", "out")
    assert done.returncode == 0, done.stderr
    cracks = read(frames(tmp_path / "out/cracks.pvd")[-1][1])
    assert shapes(cracks) == {vtk.VTK_LINE}
    assert np.all(array(cracks.GetCellData(), "aperture_m") == 1e-3)
    assert array(cracks.GetCellData(), "flux_m2_per_s").size == cracks.GetNumberOfCells()
    assert np.all(array(cracks.GetCellData(), "fracture") == 0)
    assert array(cracks.GetPointData(), "saturation").min() == 1
    pressure = array(cracks.GetPointData(), "pressure_Pa")
    assert 0 < pressure.min() < pressure.max() < 20e6

    matrix = read(frames(tmp_path / "out/matrix.pvd")[-1][1])
    places = numpy_support.vtk_to_numpy(matrix.GetPoints().GetData())
    values = array(matrix.GetPointData(), "pressure_Pa")
    _, index, counts = np.unique(places, axis=0, return_inverse=True, return_counts=True)
    index = index.reshape(-1)
    lowest = np.full(counts.size, np.inf)
    highest = np.full(counts.size, -np.inf)
    np.minimum.at(lowest, index, values)
    np.maximum.at(highest, index, values)
    assert counts.max() >= 2  # one point a side of a crack
    assert (highest - lowest)[counts > 1].max() > 1e3
