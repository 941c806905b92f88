# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of `percolith plot`."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from percolith import plot
from percolith.units import format_time, power_scale, pressure_scale, time_scale


@pytest.fixture(scope="module")
def directory(run_example):
    return run_example("single_fracture").results.path


def colours(path) -> int:
    """Number of different colours in a picture."""
    pixels = (plt.imread(path)[:, :, :3] * 255).astype(int).reshape(-1, 3)
    return len(np.unique(pixels, axis=0))


def test_defaults_write_field_probes_and_history(directory, capsys):
    assert plot.main([str(directory)]) == 0
    printed = capsys.readouterr().out.split()
    assert [path.rsplit("/", 1)[1] for path in printed] == ["pressure.png", "probes.png",
                                                            "history.png"]
    for path in printed:
        assert colours(path) > 50, path


@pytest.mark.parametrize("field", ["saturation", "flux"])
def test_other_fields(directory, field, tmp_path):
    output = tmp_path / "field.png"
    assert plot.main([str(directory), "--field", field, "--output", str(output)]) == 0
    assert colours(output) > 30


def test_pictures_differ_between_times(directory, tmp_path):
    early, late = tmp_path / "early.png", tmp_path / "late.png"
    plot.main([str(directory), "--time", "0.001", "--output", str(early)])
    plot.main([str(directory), "--time", "last", "--arrows", "--output", str(late)])
    assert early.read_bytes() != late.read_bytes()


def test_all_frames_and_references(directory, tmp_path, capsys):
    reference = tmp_path / "formula.csv"
    reference.write_text("time_s,x_m,y_m,pressure_Pa\n0.01,0,5,4439110\n0.1,0,5,6553266\n")
    without = (directory / "probes.png").read_bytes()
    assert plot.main([str(directory), "--time", "all", "--reference", str(reference)]) == 0
    assert (directory / "probes.png").read_bytes() != without
    names = [line.rsplit("/", 1)[1] for line in capsys.readouterr().out.split()]
    assert names[:5] == [f"pressure_{i:04d}.png" for i in range(5)]


def test_head_needs_gravity(directory, capsys):
    assert plot.main([str(directory), "--field", "head"]) == 2
    assert "no head in this run" in capsys.readouterr().err


def test_head_of_a_steady_run(run_example, tmp_path):
    directory = run_example("double_fracture").results.path
    output = tmp_path / "head.png"
    assert plot.main([str(directory), "--field", "head", "--output", str(output)]) == 0
    assert colours(output) > 50


def test_a_steady_run_has_no_history_to_draw(run_example, capsys):
    directory = run_example("radial").results.path
    assert plot.main([str(directory)]) == 0
    names = [line.rsplit("/", 1)[1] for line in capsys.readouterr().out.split()]
    assert names == ["pressure.png", "probes.png"]


def test_directory_without_results(tmp_path, capsys):
    assert plot.main([str(tmp_path)]) == 2
    message = capsys.readouterr().err
    assert str(tmp_path) in message and "not a run directory" in message


def test_output_in_a_missing_folder(directory, tmp_path, capsys):
    output = tmp_path / "absent" / "field.png"
    assert plot.main([str(directory), "--output", str(output)]) == 4
    assert str(output) in capsys.readouterr().err


def test_contradicting_options(directory, capsys):
    with pytest.raises(SystemExit):
        plot.main([str(directory), "--time", "noon"])
    assert "--time = noon: does not begin with a number; allowed: last, all, seconds" in capsys.readouterr().err


def test_scales():
    assert pressure_scale([2e7]).unit == "MPa"
    assert pressure_scale([0.0]).unit == "Pa"
    assert time_scale([10800.0]).label("Time") == "Time (h)"
    assert format_time(0.02) == "20 ms"
    assert format_time(0.2) == "0.2 s"
    assert format_time(36) == "36 s"
    assert format_time(36, time_scale([10800.0])) == "0.01 h"
    assert power_scale([3e-6], "m/s").factor == pytest.approx(1e-6)
    assert power_scale([120.0], "m").label("Head") == "Head (m)"
    assert pressure_scale([2e7, float("nan")]).unit == "MPa"
    assert power_scale([float("nan"), 3e-6], "m/s").factor == pytest.approx(1e-6)
    assert power_scale([float("nan")], "m/s").unit == "m/s"
