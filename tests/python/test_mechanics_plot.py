# SPDX-License-Identifier: BSD-3-Clause
"""What is read from and drawn of a run of mechanics."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.axes import Axes
from percolith import Frame, RunDirectory, deformation, mechanics_history, plot
from percolith.b_value import BIN_WIDTH, b_value, reason_for_none
from percolith.colours import distinct_colour
from percolith.deformation import crack_faces, deformed_points, edge_keys
from percolith.event_picture import draw_events, shown_window
from percolith.exaggeration import automatic_scale
from percolith.mechanics_fields import fragment_count
from percolith.loading_picture import LoadCurve, load_curves
from percolith.mechanics_picture import MODES, draw_mechanics
from percolith.units import length_scale, prefix_scale
from synthetic_run import HEIGHT, write_mechanics_run


@pytest.fixture(scope="module")
def directory(tmp_path_factory):
    return write_mechanics_run(tmp_path_factory.mktemp("mechanics") / "results")


def pixels(path) -> np.ndarray:
    return (plt.imread(path)[:, :, :3] * 255).round().astype(int).reshape(-1, 3)


def share_of(path, colour) -> float:
    """Share of the pixels that have a colour given as `#RRGGBB`."""
    wanted = [int(colour[i:i + 2], 16) for i in (1, 3, 5)]
    return float((np.abs(pixels(path) - wanted).max(axis=1) <= 2).mean())


def names(printed: str) -> list[str]:
    return [line.rsplit("/", 1)[1] for line in printed.split()]


def test_defaults_draw_everything(directory, capsys):
    assert plot.main([str(directory)]) == 0
    printed = capsys.readouterr().out
    assert names(printed) == [
        "displacement.png", "principal_stress_1.png", "principal_stress_2.png", "damage.png",
        "fragments.png", "probes.png", "history.png", "loading.png", "events.png"]
    for path in printed.split():
        assert len(np.unique(pixels(path), axis=0)) > 50, path


def test_an_intact_block_has_no_fragments_and_no_events_to_draw(tmp_path, capsys):
    directory = write_mechanics_run(tmp_path / "results", events=0, cracked=False)
    assert plot.main([str(directory)]) == 0
    drawn = names(capsys.readouterr().out)
    assert "damage.png" in drawn and "loading.png" in drawn
    assert "fragments.png" not in drawn and "events.png" not in drawn


def test_a_probe_in_an_excavation_is_drawn_as_far_as_there_was_rock(tmp_path, capsys):
    directory = write_mechanics_run(tmp_path / "results")
    probe = directory / "probes/axis.csv"
    lines = probe.read_text().splitlines()
    place = [line.rsplit(",", 3)[0] for line in lines[31:]]
    probe.write_text("\n".join(lines[:31] + [f"{start},,," for start in place]) + "\n")
    assert np.isnan(RunDirectory(directory).probe("axis")["stress_yy_Pa"]).sum() == 60
    assert plot.main([str(directory)]) == 0
    assert "probes.png" in names(capsys.readouterr().out)


def test_tables(directory):
    run = RunDirectory(directory)
    assert run.has_mechanics and not run.has_flow and not run.is_steady
    assert run.history["external_work_J_per_m"][-1] > 0
    assert len(run.events) == 150
    assert set(run.events["mode"]) == {"tensile", "shear", "mixed"}
    assert run.events["magnitude"].dtype == float and run.events["material"][0] == "rock"
    assert len(run.events.where(run.events["mode"] == "shear")) < 150


def test_events_may_be_none(tmp_path):
    run = RunDirectory(write_mechanics_run(tmp_path / "results", events=0))
    assert len(run.events) == 0 and "mode" in run.events


def test_small_displacements_are_enlarged_and_large_ones_are_not(tmp_path):
    def scale(load):
        run = RunDirectory(write_mechanics_run(tmp_path / f"{load}", load=load))
        return automatic_scale(run.frame().matrix)

    assert scale(1e-3) == 20  # 0.1 mm of 100 mm: shown as 2 mm
    assert scale(1e-6) == 20000
    assert scale(0.02) == 1  # 2 mm, almost a triangle
    assert scale(0.1) == 1
    assert automatic_scale(RunDirectory(tmp_path / "0.1").frame(0.0).matrix) == 1  # at rest


def test_the_deformed_shape_is_the_model_plus_the_scaled_displacements(directory):
    matrix = RunDirectory(directory).frame().matrix
    moved = deformed_points(matrix, 50.0)
    assert moved - matrix.points == pytest.approx(50.0 * matrix.point_data["displacement_m"])
    assert moved[:, 1].max() < HEIGHT


def test_crack_faces_are_the_two_edges_of_triangles_on_each_segment(directory):
    frame = RunDirectory(directory).frame()
    faces, segment, triangle = crack_faces(frame)
    assert np.array_equal(np.bincount(segment), np.full(len(frame.cracks.cells), 2))
    on_face = np.sort(frame.matrix.points[faces].reshape(-1, 4), axis=1)
    on_crack = np.sort(frame.cracks.points[frame.cracks.cells].reshape(-1, 4), axis=1)
    assert on_face == pytest.approx(on_crack[segment])
    assert all(set(face) < set(cell) for face, cell in zip(faces, frame.matrix.cells[triangle]))
    assert len(np.unique(faces)) > len(np.unique(frame.matrix.points[faces].reshape(-1, 2), axis=0))


def test_crack_faces_are_found_once_for_grids_that_belong_together(directory, monkeypatch):
    found = []
    frame = RunDirectory(directory).frame()
    monkeypatch.setattr(deformation, "edge_keys",
                        lambda *grids: found.append(grids) or edge_keys(*grids))
    first = crack_faces(frame)
    assert crack_faces(Frame(0.0, frame.matrix, frame.cracks)) is first and len(found) == 1
    other = RunDirectory(directory).frame()
    assert crack_faces(Frame(0.0, frame.matrix, other.cracks)) is not first and len(found) == 2
    assert crack_faces(other) is not first and len(found) == 3


def test_no_cracks_have_no_faces(directory):
    faces, segment, triangle = crack_faces(RunDirectory(directory).frame(0.0))
    assert len(faces) == len(segment) == len(triangle) == 0


def test_damage_shows_every_mode_in_its_colour(directory, tmp_path):
    path = tmp_path / "damage.png"
    run = RunDirectory(directory)
    draw_mechanics(run, run.frame(), "damage", path)
    for number, (name, colour) in MODES.items():
        assert share_of(path, colour) > 2e-4, name
    draw_mechanics(run, run.frame(0.0), "damage", path)
    for number in (-1, 1, 2, 3):
        assert share_of(path, MODES[number][1]) == 0.0, number


def test_crosses_tell_tension_from_compression(directory, tmp_path):
    run = RunDirectory(directory)
    path = tmp_path / "stress.png"
    frame = run.frame()
    stresses = frame.matrix.cell_data
    stresses["principal_stress_1_Pa"] = 6.0 * stresses["principal_stress_1_Pa"]  # as large as 2
    draw_mechanics(run, frame, "principal_stress_1", path)
    tension, compression = share_of(path, "#D7191C"), share_of(path, "#2C4FBB")
    assert tension > 1e-3 and compression > 1e-3
    stresses["principal_stress_1_Pa"] = -np.abs(stresses["principal_stress_1_Pa"])
    draw_mechanics(run, frame, "principal_stress_1", path)
    assert share_of(path, "#D7191C") < 0.2 * tension  # the legend alone
    assert share_of(path, "#2C4FBB") > compression


def test_fragments_have_colours_of_their_own(directory, tmp_path):
    run = RunDirectory(directory)
    assert fragment_count(run.frame()) == 3 and fragment_count(run.frame(0.0)) == 1
    path = tmp_path / "fragments.png"
    draw_mechanics(run, run.frame(), "fragments", path)
    for number in range(3):
        colour = "#" + "".join(f"{round(255 * part):02X}" for part in distinct_colour(number))
        assert share_of(path, colour) > 0.02, number
    many = np.array([distinct_colour(number) for number in range(40)])
    distance = np.abs(many[:, None] - many[None]).sum(axis=2) + 9 * np.eye(40)
    assert distance.min() > 0.05
    assert np.abs(np.diff(many, axis=0)).sum(axis=1).min() > 0.3


def test_the_scale_is_used_and_told(directory, tmp_path):
    sizes = {}
    for scale in ("0", "100", "auto"):
        output = tmp_path / f"{scale}.png"
        assert plot.main([str(directory), "--scale", scale, "--output", str(output)]) == 0
        sizes[scale] = output.read_bytes()
    assert len(set(sizes.values())) == 3
    explicit = tmp_path / "20.png"
    plot.main([str(directory), "--scale", "20", "--output", str(explicit)])
    assert explicit.read_bytes() == sizes["auto"]


def test_all_frames_share_one_range_and_one_scale(directory, capsys):
    assert plot.main([str(directory), "--time", "all", "--field", "velocity"]) == 0
    assert names(capsys.readouterr().out)[:2] == ["velocity_0000.png", "velocity_0001.png"]
    first, last = (pixels(directory / f"velocity_000{i}.png") for i in (0, 1))
    lowest = np.array(plt.get_cmap("viridis")(0.0)[:3]) * 255
    assert (np.abs(first - lowest).max(axis=1) < 2).mean() > 0.3  # at rest: all in one colour
    assert (np.abs(last - lowest).max(axis=1) < 2).mean() < 0.1


@pytest.mark.parametrize("words, message", [
    (["--field", "pressure"], "no pressure in this run; there are: displacement, velocity"),
    (["--arrows"], "--arrows shows the Darcy flux, and this is a run of mechanics"),
])
def test_options_of_flow_are_refused(directory, words, message, capsys):
    assert plot.main([str(directory), *words]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("words, message", [
    (["--field", "damage"], "no damage in this run; there are: pressure, head"),
    (["--scale", "2"], "--scale is for runs of mechanics, and this is one of flow"),
])
def test_options_of_mechanics_are_refused_in_a_run_of_flow(tmp_path, words, message, capsys):
    (tmp_path / "resolved.toml").write_text('[model]\nphysics = "seepage"\n')
    assert plot.main([str(tmp_path), *words]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("scale", ["-1", "huge", "nan", "inf"])
def test_scales_that_mean_nothing(directory, scale, capsys):
    with pytest.raises(SystemExit):
        plot.main([str(directory), f"--scale={scale}"])
    assert "--scale: allowed: auto, or a number that is not negative" in capsys.readouterr().err


def test_a_field_that_the_files_lack_is_named(tmp_path, capsys):
    directory = write_mechanics_run(tmp_path / "results")
    for file in directory.glob("fields/cracks_*.vtu"):
        file.write_bytes(file.read_bytes().replace(b'"damage"', b'"demage"'))
    assert plot.main([str(directory), "--field", "damage"]) == 2
    assert "no damage in the field files of this run" in capsys.readouterr().err


def test_loading_is_of_boundaries_that_move_against_a_force(directory):
    (curve,) = load_curves(RunDirectory(directory).history)
    assert curve.name == "boundary.top, y"
    assert curve.displacement[-1] == pytest.approx(-1e-4)
    assert curve.reaction.min() == pytest.approx(-30e9 * 1e-3 * 0.05 * 0.7, rel=1e-3)


def test_b_value_of_events_that_follow_the_law():
    random = np.random.default_rng(7)
    above = random.exponential(np.log10(np.e) / 1.2, 20000)
    fit = b_value(-5.0 - BIN_WIDTH / 2 + above)
    assert fit.value == pytest.approx(1.2, abs=3 * fit.error + 0.02)
    assert fit.smallest == pytest.approx(-5.0) and fit.count == 20000
    assert fit.number_above(np.array([-5.0 - BIN_WIDTH / 2])) == pytest.approx(20000)
    # Events that the mesh is too coarse for are not counted.
    small = random.uniform(-6.0, -5.06, 400)
    assert b_value(np.concatenate([-5.05 + above, small])).value == pytest.approx(fit.value)


def test_b_value_by_hand():
    fit = b_value(np.array([-3.0] * 40 + [-2.9] * 12 + [-2.5] * 8 + [-np.inf]))
    assert fit.count == 60
    assert fit.value == pytest.approx(np.log10(np.e) / (0.1 * 12 / 60 + 0.5 * 8 / 60 + 0.05))
    assert fit.error == pytest.approx(fit.value / 60**0.5)


def test_few_events_have_no_b_value():
    complete = np.repeat([-3.0, -2.7, -2.5], [30, 10, 9])
    below = np.repeat([-3.3, -3.2, -3.1], 20)  # that the mesh leaves out do not count
    assert b_value(np.concatenate([below, complete])) is None
    assert "fewer than 50 events" in reason_for_none(np.concatenate([below, complete]))
    assert b_value(np.concatenate([complete, [-2.5]])) is not None
    assert "fewer than 50 events" in reason_for_none(np.full(80, -np.inf))


def test_events_much_alike_have_no_b_value():
    alike = np.repeat([-3.0, -2.9, -2.6], [100, 50, 20])
    assert b_value(alike) is None
    assert reason_for_none(alike) == "magnitudes from the fullest bin on span less than 0.5"
    assert reason_for_none(np.concatenate([alike, [-2.5]])) == ""


def test_the_picture_of_events_says_why_it_has_no_b_value(tmp_path, monkeypatch):
    notes = []
    monkeypatch.setattr(Axes, "set_title", lambda self, text, **_: notes.append(text))
    for count in (150, 30):
        run = RunDirectory(write_mechanics_run(tmp_path / f"{count}", events=count))
        assert draw_events(run, tmp_path / "events.png").is_file()
    assert notes == ["no b-value: fewer than 50 events in the fullest bin and above"]


def test_the_places_of_events_fill_their_panel():
    outline = np.array([[[0.0, 0.0], [20.0, 0.0]], [[20.0, 0.0], [20.0, 10.0]]])
    whole = shown_window(outline, np.array([[1.0, 1.0], [15.0, 9.0]]))
    assert whole == pytest.approx(np.array([[-0.6, -0.6], [20.6, 10.6]]))
    assert shown_window(outline, np.array([[5.0, 5.0]])) == pytest.approx(whole)
    near = shown_window(outline, np.array([[0.0, 4.0], [2.0, 6.0]]))
    assert near == pytest.approx(np.array([[-0.6, 2.4], [3.6, 7.6]]))


def test_curves_on_the_zero_line_are_not_drawn(directory, monkeypatch):
    drawn = {}
    monkeypatch.setattr(mechanics_history, "draw_curves", lambda axes, history, time, curves, scale,
                        quantity: drawn.update({quantity: list(curves.values())}))
    mechanics_history.draw_mechanics_history(RunDirectory(directory), directory / "history.png")
    assert drawn["Reaction"] == ["boundary.bottom, y", "boundary.top, y"]  # x has 1e-4 of it
    assert "elastic" in drawn["Energy held"] and "gravity" not in drawn["Energy exchanged"]


def test_a_peak_is_a_reaction_that_falls_again():
    moved = np.linspace(0.0, 1.0, 5)
    assert LoadCurve("top", moved, np.array([0.0, -1.0, -3.0, -2.0, -2.5])).peak == 2
    assert LoadCurve("top", moved, np.array([0.0, 1.0, 2.0, 3.0, 2.9])).peak is None
    assert LoadCurve("top", moved, np.array([0.0, 1.0, 2.0, np.nan, np.nan])).peak == 2
    assert LoadCurve("top", moved, np.zeros(5)).peak is None


@pytest.mark.parametrize("size, unit", [
    (0.0, "m"), (0.2, "m"), (0.02, "mm"), (5e-5, "µm"), (5e-9, "nm"), (1e-12, "nm")])
def test_units_of_lengths(size, unit):
    assert length_scale([size]).unit == unit


@pytest.mark.parametrize("size, unit", [
    (2.57e6, "MN/m"), (850e3, "kN/m"), (12.0, "N/m"), (3e-3, "mN/m"), (0.0, "N/m")])
def test_units_with_prefixes(size, unit):
    assert prefix_scale([size, -size / 2], "N/m").unit == unit


def test_sizes_beyond_all_prefixes_are_powers_of_ten():
    assert prefix_scale([1e-9], "N/m").factor == pytest.approx(1e-9)
    assert prefix_scale([1e13], "N/m").factor == pytest.approx(1e13)


def test_a_run_that_failed_can_still_be_drawn(tmp_path, capsys):
    directory = write_mechanics_run(tmp_path / "results")
    table = directory / "history.csv"
    lines = table.read_text().splitlines()
    cells = lines[-1].split(",")
    lines[-1] = ",".join(cells[:3] + ["nan"] * (len(cells) - 3))
    table.write_text("\n".join(lines) + "\n")
    assert plot.main([str(directory)]) == 0
    assert "loading.png" in capsys.readouterr().out
