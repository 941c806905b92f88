# SPDX-License-Identifier: BSD-3-Clause
"""Probes against reference values: `percolith plot DIR --reference FILE.csv`."""

import numpy as np
import pytest
from percolith import CaseError, RunDirectory, plot
from percolith.reference_curves import read_reference, read_references
from synthetic_coupled_run import write_coupled_run
from synthetic_run import HEIGHT, WIDTH, write_mechanics_run, write_table

END = 2e-3  # s


@pytest.fixture
def block(tmp_path):
    """A run with one probe along its axis, from (0.025, 0) to (0.025, 0.1)."""
    return RunDirectory(write_mechanics_run(tmp_path / "results"))


@pytest.fixture
def plate(tmp_path):
    """A run with two probes in points."""
    run = RunDirectory(write_coupled_run(tmp_path / "results", frames=2))
    write_table(run.path / "probes/far.csv", {
        "time_s": [0.0, 5e-3], "x_m": [1.5] * 2, "y_m": [0.75] * 2, "pressure_Pa": [0.0, 1e3]})
    return run


def written(tmp_path, text: str, name: str = "measured.csv"):
    path = tmp_path / name
    path.write_text(text)
    return path


def mistakes(path, run) -> list[str]:
    with pytest.raises(CaseError) as caught:
        read_reference(path, run)
    assert [one.message for one in caught.value.problems] == str(caught.value).splitlines()
    assert all(line.startswith(str(path)) for line in str(caught.value).splitlines())
    return [line.removeprefix(str(path)) for line in str(caught.value).splitlines()]


def test_values_along_a_line(block, tmp_path):
    path = written(tmp_path, "# from a formula\ntime_s,distance_m,displacement_y_m,stress_yy_Pa\n"
                             f"{END},0.02,-2e-5,\n{END},0.04,-4e-5,-3e7\n0.001,0.04,-2e-5,\n")
    curves = read_reference(path, block)
    assert [(one.column, one.time, one.x.tolist()) for one in curves] == [
        ("displacement_y_m", END, [0.02, 0.04]), ("stress_yy_Pa", END, [0.04]),
        ("displacement_y_m", END / 2, [0.04])]
    assert curves[0].name == "measured" and curves[0].probe == "axis"


def test_places_count_along_the_line(block, tmp_path):
    path = written(tmp_path, f"x_m,y_m,displacement_y_m\n{WIDTH / 2},0.03,-1e-5\n")
    (curve,) = read_reference(path, block)
    assert curve.x == pytest.approx([0.03]) and curve.time == END  # without a time the last one


def test_series_of_several_probes(plate, tmp_path):
    path = written(tmp_path, "probe,time_s,pressure_Pa\nnear,0.001,2e5\nnear,0.004,3e5\n"
                             "far,0.004,900\n")
    near, far = read_reference(path, plate)
    assert (near.probe, near.time, near.x.tolist()) == ("near", None, [0.001, 0.004])
    assert far.values.tolist() == [900.0]
    (named,) = read_reference(written(tmp_path, "time_s,pressure_Pa\n0.001,7\n", "far.csv"), plate)
    assert named.probe == "far"


def test_markers_lie_over_the_curves(block, tmp_path):
    one = written(tmp_path, f"distance_m,displacement_y_m\n0.05,-5e-5\n{HEIGHT},-1e-4\n")
    other = written(tmp_path, "distance_m,displacement_y_m\n0.05,-6e-5\n", "other.csv")
    figure = block.plot_probes(reference=[one, other])
    axes = next(axes for axes in figure.axes if axes.get_ylabel().startswith("Displacement along y"))
    curves = [line for line in axes.lines if line.get_linestyle() == "-"]
    markers = [line for line in axes.lines if line.get_linestyle() == "None"]
    assert [line.get_marker() for line in markers] == ["o", "s"]
    assert markers[0].get_xdata() == pytest.approx([0.05, 0.1])
    assert markers[0].get_ydata() == pytest.approx([-50.0, -100.0])  # µm, as the curves
    assert np.allclose(markers[0].get_markeredgecolor(), curves[-1].get_color())
    names = [text.get_text() for text in axes.get_legend().get_texts()]
    assert names == ["0 ms", "1 ms", "2 ms", "measured", "other"]


def test_a_quantity_of_references_alone_has_a_panel(plate, tmp_path):
    path = written(tmp_path, "probe,time_s,saturation\nnear,0.001,0.5\n")
    figure = plate.plot_probes(reference=path)
    (axes,) = (axes for axes in figure.axes if axes.get_ylabel() == "Saturation")
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["simulation", "measured"]


def test_all_mistakes_of_a_table_are_told_with_their_lines(block, tmp_path):
    path = written(tmp_path, "# comment\ntime_s,distance_m,displacement_y_m\n"
                             "0.0005,0.02,-2e-5\n0.002,here,-2e-5\n\n0.002,0.02,nan\n")
    assert mistakes(path, block) == [
        ":3: time_s = 0.0005: the probe has no profile then; allowed: 0, 0.001, 0.002",
        ':4: distance_m = "here" is not a number; allowed: finite numbers in SI units',
        ':6: displacement_y_m = "nan" is not a number; allowed: finite numbers in SI units']


@pytest.mark.parametrize("text, message", [
    ("", ": empty; allowed: a line of names, then rows of numbers"),
    ("distance_m,stress_yy_Pa\n", ":1: no rows below the names"),
    ("distance_m,stress_yy_MPa\n0,1\n", ':1: unknown column "stress_yy_MPa"; allowed: probe, '
     "time_s, distance_m, x_m, y_m and displacement_x_m, displacement_y_m, stress_yy_Pa"),
    ("distance_m\n0\n", ":1: no column with a quantity of a probe; allowed: displacement_x_m"),
    ("time_s,stress_yy_Pa\n0,1\n", ":1: no place, which the probe axis along a line needs; "
     "allowed: a column distance_m, or x_m and y_m"),
    ("distance_m,stress_yy_Pa\n0,1,2\n", ":2: 3 fields in a row; allowed: 2, as in the line of"),
    ("x_m,y_m,stress_yy_Pa\n0.02,0.05,1\n", ":2: the place is 0.005 m off the line of the probe; "
     "allowed: places from (0.025, 0) to (0.025, 0.1)"),
    ("probe,distance_m,stress_yy_Pa\naxle,0,1\n", ':2: no probe "axle"; allowed: axis'),
    ("distance_m,distance_m,stress_yy_Pa\n0,0,1\n", ':1: two columns "distance_m"'),
    ("distance_m,stress_yy_Pa\n,1\n", ':2: distance_m = "" is not a number'),
])
def test_one_mistake(block, tmp_path, text, message):
    (told,) = mistakes(written(tmp_path, text), block)
    assert told.startswith(message)


def test_mistakes_where_there_are_several_probes(plate, tmp_path):
    (told,) = mistakes(written(tmp_path, "time_s,pressure_Pa\n0,1\n"), plate)
    assert told == (":1: no column probe, which this run needs to tell its probes apart; allowed: a "
                    "column probe with far, near, or a file called after one of them, as far.csv")
    (told,) = mistakes(written(tmp_path, "probe,pressure_Pa\nfar,1\n"), plate)
    assert told == ":1: no column time_s, which the probe far in one point needs"
    (told,) = mistakes(written(tmp_path, "probe,time_s,saturation,pressure_Pa\nfar,0,1,1\n"
                                         "near,0,1,1\n"), plate)
    assert told == ":2: the probe far has no saturation; allowed: an empty cell"


def test_files_that_cannot_be_read(block, tmp_path):
    assert mistakes(tmp_path / "absent.csv", block) == [": cannot be read: No such file or directory"]
    path = tmp_path / "words.csv"
    path.write_bytes(b"\xff\xfe\x00")
    assert mistakes(path, block) == [": cannot be read: not a text in UTF-8"]


def test_a_run_without_probes(block, tmp_path):
    (block.path / "probes/axis.csv").unlink()
    path = written(tmp_path, "distance_m,stress_yy_Pa\n0,1\n")
    assert "nothing to compare with" in mistakes(path, block)[0]


def test_the_mark_of_a_spreadsheet_is_no_part_of_a_name(block, tmp_path):
    path = tmp_path / "sheet.csv"
    path.write_bytes(b"\xef\xbb\xbfdistance_m,stress_yy_Pa\r\n0.05,-3e7\r\n")
    assert read_references([path, path], block)[1].number == 1


def test_the_command_line_draws_nothing_where_a_reference_is_wrong(block, tmp_path, capsys):
    wrong = written(tmp_path, "distance_m,stress_yy_Pa\n0,one\n0.1,two\n")
    assert plot.main([str(block.path), "--reference", str(wrong)]) == 2
    printed = capsys.readouterr()
    assert printed.err.splitlines() == [
        f'percolith-plot: error: {wrong}:{line}: stress_yy_Pa = "{word}" is not a number; allowed: '
        "finite numbers in SI units" for line, word in ((2, "one"), (3, "two"))]
    assert not list(block.path.glob("*.png"))
