# SPDX-License-Identifier: BSD-3-Clause
"""`percolith plot DIR --window X0 X1 Y0 Y1`: maps of a part of the model."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.axes import Axes
from percolith import RunDirectory, event_picture, plot
from percolith.animation import draw_animation
from percolith.event_picture import draw_events
from percolith.field_picture import field_figure
from percolith.mechanics_picture import mechanics_figure
from percolith.view import shown_parts, view_of_frame, view_of_times
from percolith.window import meets, window_from
from synthetic_coupled_run import PRESSURE, SIZE
from synthetic_run import HEIGHT, WIDTH, write_grid, write_series
from test_animation import pictures
from test_mechanics_plot import names

CORNER = np.array([[0.0, 0.0], [0.02, 0.03]])  # of the block, below its cracks


def words(window: np.ndarray) -> list[str]:
    return [str(end) for end in window.T.ravel()]


def test_shapes_that_meet_a_window():
    window = np.array([[0.0, 0.0], [1.0, 1.0]])
    shapes = np.array([[[0.2, 0.2], [0.3, 0.2], [0.2, 0.3]],  # inside
                       [[-9, -9], [9, -9], [0, 9]],  # all round
                       [[1.9, 0.5], [0.5, 1.9], [2, 2]],  # beyond a corner, though the boxes meet
                       [[1.2, 0.5], [0.5, 1.2], [2, 2]],  # across a corner
                       [[1.1, 0], [2, 0], [2, 1]]])
    assert meets(shapes, window).tolist() == [True, True, False, True, False]
    lines = np.array([[[-1, 0.5], [2, 0.5]], [[-0.6, 0.5], [0.5, 1.7]], [[0.5, 2], [0.5, 0.9]]])
    assert meets(lines, window).tolist() == [True, False, True]
    assert meets(np.empty((0, 3, 2)), window).tolist() == []


def test_four_words_are_a_window():
    assert window_from(["-1", "2e-1", "0", " 5"]).tolist() == [[-1, 0], [0.2, 5]]


@pytest.mark.parametrize("ends, reason", [
    (["a", "1", "0", "1"], "a 1 0 1: not four numbers"),
    (["1", "0", "0", "1"], "1 0 0 1: reversed"),
    (["0", "1", "1", "-1e-3"], "0 1 1 -1e-3: reversed"),
    (["0", "0", "0", "1"], "0 0 0 1: without width"),
    (["0", "nan", "0", "1"], "0 nan 0 1: not finite"),
    (["-inf", "1", "0", "1"], "-inf 1 0 1: not finite"),
])
def test_windows_that_are_none(block, ends, reason, capsys):
    with pytest.raises(SystemExit) as end:
        plot.main([str(block.path), "--window", *ends])
    assert end.value.code == 2
    allowed = "allowed: X0 X1 Y0 Y1 in m, with X0 < X1 and Y0 < Y1"
    assert f"--window = {reason}; {allowed}" in capsys.readouterr().err


def test_three_numbers_are_no_window(block, capsys):
    with pytest.raises(SystemExit) as end:
        plot.main([str(block.path), "--window", "0", "-1e-3", "0"])
    assert end.value.code == 2
    assert "--window: expected 4 arguments" in capsys.readouterr().err


@pytest.mark.parametrize("more", [[], ["--time", "all"], ["--animate"]])
def test_a_window_without_rock(block, more, capsys):
    window = ["-3e-1", "-.2", "0", "1"]
    assert plot.main([str(block.path), "--scale", "0", *more, "--window", *window]) == 2
    assert ("--window = -0.3 -0.2 0 1: no rock there; the rock reaches from x = 0 to 0.05 m and "
            "from y = 0 to 0.1 m") in capsys.readouterr().err


def test_colours_suit_what_is_seen(block, coupled):
    frame = block.frame()
    high = view_of_frame(block, frame, "displacement", 1.0).rock.high
    part = view_of_frame(block, frame, "displacement", 1.0, window=CORNER)
    assert 3.0e-5 < part.rock.high < 4.0e-5 < 0.5 * high  # a thousandth of the height
    upper = np.array([[0.0, 0.4], [SIZE, 1.0]])  # above the crack and its fluid
    view = view_of_frame(coupled, coupled.frame(), "pressure", 1.0, window=upper)
    assert view.rock.high < 0.01 * PRESSURE and view.cracks is None and view.modes == ()
    mouth = np.array([[0.0, -0.1], [0.2, 0.1]])
    view = view_of_frame(coupled, coupled.frame(), "pressure", 1.0, window=mouth)
    assert view.modes == (0,) and view.cracks.high == pytest.approx(PRESSURE, rel=0.02)
    assert view.cracks.low > 0.9 * PRESSURE


def test_the_parts_that_are_shown_reach_into_the_window(block):
    frame = block.frame()
    whole = view_of_frame(block, frame, "damage", 1.0)
    assert len(shown_parts(block, frame, whole)[0].matrix.cells) == len(frame.matrix.cells)
    view = view_of_frame(block, frame, "damage", 1.0, window=CORNER)
    part, _ = shown_parts(block, frame, view)
    assert 0 < len(part.cracks.cells) < len(frame.cracks.cells)
    assert len(part.cracks.cell_data["mode"]) == len(part.cracks.cells)
    squares = (CORNER[1] / [WIDTH / 20, HEIGHT / 40]).prod()
    assert 2 * squares <= len(part.matrix.cells) <= 2.7 * squares


@pytest.mark.parametrize("field", ["displacement", "principal_stress_1", "damage", "fragments"])
def test_the_axes_end_with_the_window(block, field):
    view = view_of_frame(block, block.frame(), field, window=CORNER)
    figure = mechanics_figure(block, block.frame(), field, view)
    axes = figure.axes[0]
    assert [axes.get_xlim(), axes.get_ylim()] == [(0.0, 0.02), (0.0, 0.03)]
    assert ("3 fragments in all" in axes.get_title()) == (field == "fragments")


def test_rock_at_rest_has_windows_too(tmp_path):
    folder = tmp_path / "results"
    folder.mkdir()
    (folder / "resolved.toml").write_text('[model]\nphysics = "seepage"\n')
    points = np.array([[0.0, 0], [1, 0], [2, 0], [0, 1], [1, 1], [2, 1]])
    cells = np.array([[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4]])
    write_grid(folder / "fields/matrix_000000.vtu", points, cells,
               {"pressure_Pa": 1e6 * points[:, 0]})
    ends = points[[1, 4, 2, 5]]
    write_grid(folder / "fields/cracks_000000.vtu", ends, np.array([[0, 1], [2, 3]]),
               {"pressure_Pa": 1e6 * ends[:, 0]})
    write_series(folder, "matrix", {0: 0.0})
    write_series(folder, "cracks", {0: 0.0})
    run = RunDirectory(folder)
    window = np.array([[-1.0, 0.0], [0.5, 1.0]])  # partly beside the rock
    view = view_of_frame(run, run.frame(), "pressure", window=window)
    assert (view.rock.low, view.rock.high) == (0.0, 1e6)
    part, bodies = shown_parts(run, run.frame(), view)
    assert len(part.matrix.cells) == 2 and not len(part.cracks.cells) and bodies is None
    figure = field_figure(run, run.frame(), "pressure", view)
    assert figure.axes[0].get_xlim() == (-1.0, 0.5)


def test_pictures_from_the_command_line(block, capsys):
    assert plot.main([str(block.path), "--window", *words(CORNER)]) == 0
    drawn = names(capsys.readouterr().out)
    assert "damage.png" in drawn and "events.png" in drawn


@pytest.mark.parametrize("field", ["pressure", "flux", "principal_stress_1", "fragments"])
def test_animations_of_a_part(coupled, field, tmp_path):
    window = np.array([[0.0, -0.2], [0.5, 0.2]])
    path = draw_animation(coupled, field, tmp_path / "part.gif", window=window)
    assert len(pictures(path)) == 4
    whole = view_of_times(coupled, coupled.times, "pressure")
    part = view_of_times(coupled, coupled.times, "pressure", window=window)
    assert whole.window[1, 0] == SIZE and part.window[1, 0] == 0.5
    assert part.pixel < whole.pixel


@pytest.mark.parametrize("field", ["displacement", "principal_stress_1", "fragments"])
def test_rock_that_has_left_the_window_leaves_it_blank(block, field):
    frame = block.frame()
    frame.matrix.point_data["displacement_m"] = np.full((len(frame.matrix.points), 2), 1.0)
    view = view_of_times(block, block.times, field, 1.0, window=CORNER)
    plt.close(mechanics_figure(block, frame, field, view))


def test_the_map_of_events_shows_those_in_the_window(block, tmp_path, monkeypatch):
    drawn = []
    monkeypatch.setattr(event_picture, "_scatter",
                        lambda axes, events, *_: drawn.append((axes, len(events))))
    monkeypatch.setattr(Axes, "legend", lambda *_, **__: None)
    window = np.array([[0.0, 0.02], [0.02, 0.05]])
    draw_events(block, tmp_path / "events.png", window)
    (_, in_time), (axes, in_place) = drawn
    x, y = block.events["x_m"], block.events["y_m"]
    assert in_time == 150
    assert in_place == ((x <= 0.02) & (y >= 0.02) & (y <= 0.05)).sum() > 10
    assert axes.get_xlim() == (0.0, 0.02) and axes.get_ylim() == (0.02, 0.05)
    monkeypatch.undo()
    draw_events(block, tmp_path / "none.png", np.array([[0.0, 0.09], [0.01, 0.1]]))
