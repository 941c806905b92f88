# SPDX-License-Identifier: BSD-3-Clause
"""What is drawn of a run in which fluid breaks rock: the fields of flow and of mechanics."""

import numpy as np
import pytest
from percolith import RunDirectory, plot
from percolith.crack_fields import shown_values
from percolith.crack_growth_picture import draw_crack_growth
from percolith.crack_picture import MODES
from percolith.deformation import crack_gaps, deformed_points
from percolith.flow_fields import rock_and_crack_ranges
from percolith.mechanics_history import draw_mechanics_history
from percolith.pictures import fields_of
from percolith.run_directory import Table, carries_fluid
from percolith.view import view_of_frame, view_of_times
from synthetic_coupled_run import OPENING, PRESSURE, SIZE, write_coupled_run
from synthetic_run import add_bodies, write_mechanics_run
from test_mechanics_plot import names, pixels, share_of


@pytest.fixture(scope="module")
def directory(tmp_path_factory):
    return write_coupled_run(tmp_path_factory.mktemp("coupled") / "results")


@pytest.fixture(scope="module")
def run(directory):
    return RunDirectory(directory)


def test_a_run_is_what_it_has_left(run, tmp_path):
    assert run.has_flow and run.has_mechanics and not run.is_steady
    assert fields_of(run)[:2] == ("pressure", "saturation") and "damage" in fields_of(run)
    dry = write_mechanics_run(tmp_path / "dry")
    (dry / "resolved.toml").write_text('[model]\nphysics = "coupled"\n')
    assert RunDirectory(dry).has_mechanics and not RunDirectory(dry).has_flow


@pytest.mark.parametrize("physics, flows, deforms", [
    ("seepage", True, False), ("mechanics", False, True), ("coupled", True, True)])
def test_a_run_that_has_left_nothing_is_what_its_case_says(tmp_path, physics, flows, deforms):
    (tmp_path / "resolved.toml").write_text(f'[model]\nphysics = "{physics}"\n')
    run = RunDirectory(tmp_path)
    assert (run.has_flow, run.has_mechanics) == (flows, deforms)


def test_defaults_draw_flow_and_mechanics(directory, capsys):
    assert plot.main([str(directory)]) == 0
    printed = capsys.readouterr().out
    assert names(printed) == [
        "pressure.png", "displacement.png", "principal_stress_1.png", "principal_stress_2.png",
        "damage.png", "probes.png", "history.png", "fluid.png", "crack_growth.png", "events.png"]
    for path in printed.split():
        assert len(np.unique(pixels(path), axis=0)) > 50, path


def test_every_field_can_be_drawn(directory, tmp_path):
    for field in ("saturation", "flux", "velocity", "fragments"):
        output = tmp_path / f"{field}.png"
        words = ["--field", field, "--output", str(output), "--scale", "100"]
        assert plot.main([str(directory), *words]) == 0
        assert output.stat().st_size > 10_000


def test_the_gap_of_a_crack_lies_between_its_faces(run):
    frame = run.frame()
    gaps = crack_gaps(frame)
    assert np.array_equal(gaps.segment, np.arange(len(frame.cracks.cells)))
    undeformed = frame.matrix.points[gaps.corners]
    ends = frame.cracks.points[frame.cracks.cells]
    assert undeformed == pytest.approx(ends[:, [0, 1, 1, 0]])
    moved = deformed_points(frame.matrix, 1.0)[gaps.corners]
    at_the_mouth = np.abs(moved[:, 0, 1] - moved[:, 3, 1]).max()
    assert at_the_mouth == pytest.approx(OPENING)


def test_joints_that_only_soften_hold_no_fluid(run):
    frame = run.frame()
    wet = carries_fluid(frame.cracks)
    assert np.array_equal(~wet, frame.cracks.cell_data["mode"] == -1)
    assert shown_values(frame, "pressure").min() > 0.4 * PRESSURE
    del frame.cracks.cell_data["wet"]
    assert carries_fluid(frame.cracks).all()


def test_cracks_have_colours_of_their_own_where_their_pressure_is_far_above(run):
    view = view_of_frame(run, run.frame(), "pressure")
    assert view.rock.high == pytest.approx(0.2 * PRESSURE, rel=0.02)
    assert view.cracks.high == pytest.approx(PRESSURE, rel=0.02)
    rock, cracks = np.array([0.0, 6e6]), np.array([0.0, 8e6])
    assert rock_and_crack_ranges("pressure", rock, cracks, True)[1] is None
    assert rock_and_crack_ranges("pressure", rock / 2, cracks, True)[1] is not None
    both, none = rock_and_crack_ranges("pressure", rock / 2, cracks, False)
    assert both.high == 8e6 and none is None and both.beyond == "neither"


def test_fluid_that_is_squeezed_in_few_places_does_not_stretch_the_colours():
    rock = np.append(np.linspace(0.0, 1e6, 9999), 5e7)
    cracks = np.array([0.0, 1.5e6, np.nan])
    squeezed, none = rock_and_crack_ranges("pressure", rock, cracks, True)
    assert squeezed.high == pytest.approx(1.5e6, rel=0.02) and none is None
    assert squeezed.beyond == "both"
    at_rest, _ = rock_and_crack_ranges("pressure", rock, np.empty(0), False)
    assert at_rest.high == 5e7 and at_rest.beyond == "neither"


def test_pictures_of_stress_show_the_modes_of_cracks(directory, run, tmp_path):
    output = tmp_path / "stress.png"
    plot.main([str(directory), "--field", "principal_stress_1", "--output", str(output)])
    for number in set(view_of_frame(run, run.frame(), "pressure").modes):
        assert share_of(output, MODES[number][1]) > 5e-5, number


def test_a_series_has_one_view(run):
    view = view_of_times(run, run.times, "pressure")
    assert view.modes == (-1, 0, 1, 3)
    assert view.window[0, 0] == 0.0 and view.window[1, 0] == SIZE
    tallest = max(deformed_points(run.frame(time).matrix, view.scale)[:, 1].max()
                  for time in run.times)
    assert view.window[1, 1] == pytest.approx(tallest)


def test_probes_of_a_coupled_run_show_both(run, monkeypatch, tmp_path):
    from percolith import probe_picture
    shown = []
    monkeypatch.setattr(probe_picture, "_draw_point",
                        lambda axes, table, column, references: shown.append(column))
    probe_picture.draw_probes(run, "pressure", tmp_path / "probes.png")
    assert shown == ["pressure_Pa", "displacement_x_m", "displacement_y_m"]


def test_work_of_the_fluid_is_among_the_energies(run, monkeypatch, tmp_path):
    from percolith import mechanics_history
    drawn = {}
    monkeypatch.setattr(mechanics_history, "draw_curves", lambda axes, history, time, curves, scale,
                        quantity: drawn.update({quantity: list(curves.values())}))
    draw_mechanics_history(run, tmp_path / "history.png")
    assert "fluid" in drawn["Energy exchanged"]


def test_crack_growth_draws_the_columns_there_are(run, monkeypatch, tmp_path):
    from percolith import crack_growth_picture
    drawn = []
    monkeypatch.setattr(crack_growth_picture, "draw_curves",
                        lambda axes, history, time, curves, scale, quantity:
                        drawn.append((quantity, scale.unit)))
    path = draw_crack_growth(run, tmp_path / "growth.png")
    assert path.is_file() and [quantity for quantity, _ in drawn] == [
        "Pressure at the source", "Length of cracks", "Volume",
        "Mean hydraulic aperture", "Volume that went in"]
    assert drawn[0][1] == "MPa" and drawn[3][1] == "µm"
    drawn.clear()
    columns = {name: run.history[name] for name in ("time_s", "crack_length_m")}
    columns["source.mouth.pressure_Pa"] = np.full(len(run.history), np.nan)
    run.__dict__["history"] = Table(columns)
    draw_crack_growth(run, tmp_path / "growth.png")
    assert drawn == [("Length of cracks", "m")]
    run.__dict__["history"] = Table({"time_s": columns["time_s"]})
    assert draw_crack_growth(run, tmp_path / "none.png") is None
    del run.__dict__["history"]


def test_lengths_of_cracks_tell_which_joints_they_count(run, monkeypatch):
    """Fluid may be in joints that soften and have not broken."""
    for enters, joints in (("broken", "broken"), ("softening", "broken or softening")):
        monkeypatch.setitem(run.resolved["model"], "fluid_enters", enters)
        figure = run.plot_crack_growth()
        axes = next(one for one in figure.axes if one.get_ylabel().startswith("Length of cracks"))
        assert [text.get_text() for text in axes.get_legend().get_texts()] == [
            f"open to fluid ({joints} joints)", "full of fluid"]


def test_there_is_no_mean_aperture_before_there_is_a_crack(run, monkeypatch):
    columns = dict(run.history.columns)
    columns["crack_length_m"] = np.where(columns["time_s"] < 1e-3, 0.0, columns["crack_length_m"])
    monkeypatch.setitem(run.__dict__, "history", Table(columns))
    axes = next(one for one in run.plot_crack_growth().axes if "aperture" in one.get_ylabel())
    assert (np.isnan(axes.lines[0].get_ydata()) == (columns["crack_length_m"] == 0.0)).all()
    assert np.isnan(axes.lines[0].get_ydata()).any()


def test_stress_of_probes_is_effective_where_there_is_fluid():
    from percolith.probe_picture import _label
    wet = Table({"stress_xx_Pa": np.zeros(1), "pressure_Pa": np.zeros(1)})
    assert _label(wet, "stress_xx_Pa") == "Effective stress xx"
    assert _label(wet, "pressure_Pa") == "Pressure"
    assert _label(Table({"stress_xx_Pa": np.zeros(1)}), "stress_xx_Pa") == "Stress xx"


def test_rigid_bodies_are_grey_under_pressure_too(tmp_path):
    directory = write_coupled_run(tmp_path / "results", frames=2)
    add_bodies(directory, '[body.plate]\nregions = ["corner"]\nrigid = true\n', "plate", "corner")
    run = RunDirectory(directory)
    frame = run.frame()
    centre = frame.matrix.points[frame.matrix.cells].mean(axis=1)
    frame.matrix.cell_data["region"] = (centre[:, 1] > 0.7).astype("<i4")
    from percolith.field_picture import draw_field
    draw_field(run, frame, "pressure", tmp_path / "pressure.png")
    assert share_of(tmp_path / "pressure.png", "#B4B4B4") > 0.05


def test_the_table_of_cracks_has_the_means_of_both_ends(coupled):
    cracks = coupled.frame().cracks
    table, wet = coupled.frame().crack_table(), carries_fluid(cracks)
    assert 0 < wet.sum() < len(table)
    for name in ("pressure_Pa", "saturation"):
        ends = cracks.point_data[name][cracks.cells]
        assert table[name][wet] == pytest.approx(0.5 * (ends[:, 0] + ends[:, 1])[wet])
        assert np.isnan(table[name][~wet]).all()
    assert (table["mode"] == cracks.cell_data["mode"]).all()


def test_cracks_of_rock_at_rest_are_full(run_example):
    table = run_example("single_fracture").results.frame().crack_table()
    assert np.isfinite(table["pressure_Pa"]).all() and (table["pressure_Pa"] > 0).any()
