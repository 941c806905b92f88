# SPDX-License-Identifier: BSD-3-Clause
"""Rigid bodies are told from the rock, and pictures leave them out of the colours."""

import numpy as np
import pytest
from percolith import RunDirectory
from percolith.deformation import damage_since_the_start
from percolith.mechanics_fields import rock_and_bodies, values_of
from percolith.mechanics_picture import draw_mechanics
from percolith.rigid_bodies import rigid_triangles
from percolith.view import view_of_times
from synthetic_run import add_bodies, write_mechanics_run
from test_mechanics_plot import share_of

GREY = "#B4B4B4"
BODY = '[body.platen]\nregions = ["corner"]\nrigid = true\n'


def run_with(folder, bodies=BODY):
    directory = write_mechanics_run(folder / "results")
    add_bodies(directory, bodies, "block", "corner")
    return RunDirectory(directory)


def frame_with_a_corner(run):
    """The last frame, whose upper right piece is the region of the body."""
    frame = run.frame()
    cells = frame.matrix.cell_data
    cells["region"] = (cells["fragment"] == 2).astype("<i4")
    return frame


def test_rigid_are_the_regions_of_rigid_bodies(tmp_path):
    run = run_with(tmp_path)
    frame = frame_with_a_corner(run)
    rigid = rigid_triangles(run, frame.matrix)
    assert np.array_equal(rigid, frame.matrix.cell_data["fragment"] == 2)
    rock, bodies = rock_and_bodies(run, frame)
    assert len(bodies.cells) == rigid.sum() and len(rock.matrix.cells) == (~rigid).sum()
    assert bodies.points[bodies.cells] == pytest.approx(
        frame.matrix.points[frame.matrix.cells[rigid]])
    assert len(values_of(rock, "displacement")) == len(rock.matrix.points)


@pytest.mark.parametrize("bodies", ["", BODY.replace("true", "false")])
def test_other_bodies_are_rock(tmp_path, bodies):
    run = run_with(tmp_path, bodies)
    assert not rigid_triangles(run, frame_with_a_corner(run).matrix).any()


def test_a_run_that_goes_on_shows_everything_as_rock(tmp_path):
    run = run_with(tmp_path)
    (run.path / "summary.json").unlink()
    assert not rigid_triangles(run, frame_with_a_corner(run).matrix).any()


def test_a_model_of_rigid_bodies_alone_is_shown(tmp_path):
    run = run_with(tmp_path, BODY.replace('"corner"', '"block", "corner"'))
    rock, bodies = rock_and_bodies(run, frame_with_a_corner(run))
    assert bodies is None and len(rock.matrix.cells) > 0


def test_joints_that_lay_loose_on_a_body_are_no_cracks(tmp_path):
    run = run_with(tmp_path)
    frame = frame_with_a_corner(run)
    before = frame.cracks.cell_data["mode"]
    rock, _ = rock_and_bodies(run, frame)
    after = rock.cracks.cell_data["mode"]
    assert (before == 0).sum() > (after == 0).sum()
    for mode in (-1, 1, 2, 3):  # what broke is shown beside a body too
        assert (before == mode).sum() == (after == mode).sum()
    assert len(rock.cracks.cells) == len(after) == len(rock.cracks.cell_data["damage"])


def test_damage_counts_joints_that_were_bonded(tmp_path):
    frame = run_with(tmp_path).frame()
    mode = frame.cracks.cell_data["mode"] = np.zeros(len(frame.cracks.cells), int)
    assert not damage_since_the_start(frame).any()
    mode[0] = 1
    assert (damage_since_the_start(frame) == 1.0).sum() == 2


@pytest.mark.parametrize("field", ["displacement", "principal_stress_2", "damage", "fragments"])
def test_bodies_are_grey(tmp_path, field):
    run = run_with(tmp_path)
    path = tmp_path / "picture.png"
    draw_mechanics(run, frame_with_a_corner(run), field, path)
    assert share_of(path, GREY) > 0.01


def test_the_colours_end_where_the_rock_does(tmp_path):
    run = run_with(tmp_path)
    frame = frame_with_a_corner(run)
    run.frame = lambda time: frame
    alone, _ = rock_and_bodies(run, frame)
    moved = frame.matrix.point_data["displacement_m"] = (
        frame.matrix.point_data["displacement_m"].copy())
    moved[frame.matrix.cells[frame.matrix.cell_data["region"] == 1]] = 1.0
    assert view_of_times(run, run.times, "displacement").rock.high == pytest.approx(
        values_of(alone, "displacement").max())
