# SPDX-License-Identifier: BSD-3-Clause
"""The page of `percolith report`: what it says, what it shows, and that it needs nothing else."""

import base64
import json
import re
import shutil
from html.parser import HTMLParser

import numpy as np
import percolith
import pytest
from percolith import reports
from percolith.reporting import page as page_module
from percolith.reporting.packed import STEPS, Packed, unpack
from percolith.reporting.view_data import view_data
from percolith.run_directory import RunDirectory
from synthetic_coupled_run import OPENING, write_coupled_run
from synthetic_run import add_bodies, write_excavated_run, write_mechanics_run

_EMPTY = {"meta", "img", "input", "br", "link"}


class Page(HTMLParser):
    """Reads a page: its rows of tables, texts, arrays, pictures and all addresses it names."""

    def __init__(self, text: str):
        super().__init__()
        self.text, self.open, self.rows, self.words = text, [], [], []
        self.arrays, self.addresses, self.pictures, self.about = {}, [], [], None
        self.feed(text)
        assert not self.open, f"never closed: {self.open}"

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        if tag not in _EMPTY:
            self.open.append((tag, given))
        self.addresses += [given[name] for name in ("src", "href") if name in given]
        if tag in ("img", "video"):
            self.pictures.append(given)
        if tag == "tr":
            self.rows.append([])

    def handle_endtag(self, tag):
        assert self.open.pop()[0] == tag

    def handle_data(self, data):
        tag, given = self.open[-1] if self.open else ("", {})
        if tag in ("th", "td"):
            self.rows[-1].append(data.replace("\N{NO-BREAK SPACE}", " "))
        elif tag == "script" and given.get("id", "").startswith("array-"):
            rounding = [float(given[name]) for name in ("data-low", "data-step") if name in given]
            packed = Packed(given["data-kind"], int(given["data-length"]), data, *rounding)
            self.arrays[given["id"].removeprefix("array-")] = unpack(packed)
            assert len(self.arrays[given["id"].removeprefix("array-")]) == packed.length
        elif given.get("id") == "view-about":
            self.about = json.loads(data)
        elif tag not in ("script", "style"):
            self.words.append(data)

    @property
    def said(self) -> str:
        return " ".join(self.words)

    def value(self, name: str) -> str:
        return next(row[1] for row in self.rows if row and row[0] == name)


def page_at(path) -> Page:
    return Page(path.read_text(encoding="utf-8"))


@pytest.fixture
def without_pictures(monkeypatch):
    monkeypatch.setattr(page_module, "drawn", lambda run, time, scale: [])


@pytest.fixture(scope="module")
def mechanics(tmp_path_factory):
    return write_mechanics_run(tmp_path_factory.mktemp("mechanics") / "run")


@pytest.fixture(scope="module")
def coupled(tmp_path_factory):
    return write_coupled_run(tmp_path_factory.mktemp("coupled") / "run")


@pytest.fixture(scope="module")
def coupled_page(coupled):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(page_module, "drawn", lambda run, time, scale: [])
        return page_at(percolith.report(coupled))


@pytest.fixture
def flow(run_example, tmp_path):
    return shutil.copytree(run_example("single_fracture").results.path, tmp_path / "flow")


def test_the_page_needs_no_other_file(coupled, coupled_page):
    assert coupled_page.text.startswith("<!DOCTYPE html>")
    assert all(address.startswith(("data:", "#")) for address in coupled_page.addresses)
    assert not re.search(r"https?://|@import|url\(", coupled_page.text)
    assert "default-src 'none'" in coupled_page.text
    assert [path.name for path in coupled.glob("*report*")] == ["report.html"]


def test_pictures_and_films_have_captions(flow):
    (flow / "pressure.gif").write_bytes(b"GIF89a")
    (flow / "flux.mp4").write_bytes(b"film")
    before = sorted(path.name for path in flow.iterdir())
    page = page_at(percolith.report(flow))
    assert sorted(path.name for path in flow.iterdir()) == sorted([*before, "report.html"])
    captions = [picture.get("alt") for picture in page.pictures]
    assert captions[:2] == ["Pressure.", "What the probes recorded."]
    assert captions[3:] == [None, "Pressure over time (pressure.gif)."]
    assert "Darcy flux over time (flux.mp4)." in page.said
    contents = [base64.b64decode(picture["src"].split(",")[1]) for picture in page.pictures]
    assert all(content.startswith(b"\x89PNG") for content in contents[:3])
    assert contents[3:] == [b"film", b"GIF89a"]


def test_a_film_that_is_too_large_is_named_alone(flow, without_pictures, monkeypatch):
    monkeypatch.setattr("percolith.reporting.page_pictures.LARGEST_ANIMATION", 5)
    (flow / "pressure.gif").write_bytes(b"GIF89a")
    page = page_at(percolith.report(flow))
    assert not page.pictures
    assert "pressure.gif). It has 0 MB and is not in this page." in page.said


def rock_values(page: Page, name: str, frame: int = -1) -> np.ndarray:
    """Values of the points, or of the triangles, at the time of a frame of the view."""
    keys = page.about["frames"][frame]["arrays"]
    values, node = page.arrays[keys[f"rock-{name}"]], page.arrays[keys["node"]]
    field = next(field for field in page.about["rock"] if field["name"] == name)
    by_node = field["atPoints"] and len(values) != len(node)
    return values[node] if by_node else values


def test_the_view_holds_the_numbers_of_the_last_frame(coupled, coupled_page):
    frame = RunDirectory(coupled).frame()
    matrix, about, arrays = frame.matrix, coupled_page.about, coupled_page.arrays
    places = arrays["places"].reshape(-1, 2)[arrays["node"]] + about["origin"]
    assert places == pytest.approx(matrix.points, abs=1e-6)
    assert (arrays["cells"].reshape(-1, 3) == matrix.cells).all()
    assert arrays["displacement"].reshape(-1, 2)[arrays["node"]] == pytest.approx(
        matrix.point_data["displacement_m"], rel=1e-6)
    assert rock_values(coupled_page, "pressure") == pytest.approx(
        matrix.point_data["pressure_Pa"], rel=1e-6)
    assert rock_values(coupled_page, "principal_stress_1") == pytest.approx(
        matrix.cell_data["principal_stress_1_Pa"], rel=1e-6)
    assert about["first"] == "pressure" and about["triangles"] == len(matrix.cells)


def test_the_view_holds_other_times_rounded(coupled, coupled_page):
    run, about, arrays = RunDirectory(coupled), coupled_page.about, coupled_page.arrays
    assert len(about["frames"]) == len(run.times) == about["allFrames"] == 4
    assert about["asked"] == 3
    moments = [frame["moment"] for frame in about["frames"]]
    assert moments[0] == "t = 0 ms" and moments[3] == "t = 5 ms" == about["moment"]
    for number, (time, shown) in enumerate(zip(run.times, about["frames"])):
        pressure = run.frame(time).matrix.point_data["pressure_Pa"]
        step = np.ptp(pressure) / STEPS if number != about["asked"] else 0.0
        held = rock_values(coupled_page, "pressure", number)
        assert held == pytest.approx(pressure, rel=1e-6, abs=step)
        assert shown["segments"] == len(run.frame(time).cracks.cells)
        assert arrays[shown["arrays"]["crack-mode"]].size == shown["segments"]
    # What does not change stands in the page once.
    assert len({frame["arrays"]["cells"] for frame in about["frames"]}) == 1
    assert {"cells@1", "places@1", "node@1", "rock-region@1"}.isdisjoint(arrays)
    assert "Of 4 frames of the run 4 are here" in coupled_page.said


def test_colours_of_the_view_suit_all_times(mechanics):
    run = RunDirectory(mechanics)
    about = view_data(run, run.frame(0.0)).about
    one = next(field for field in about["rock"] if field["name"] == "displacement")
    highest = [frame["ranges"]["rock-displacement"]["ends"][1] for frame in about["frames"]]
    assert about["asked"] == 0 and len(highest) == len(run.times)
    # At the start nothing has moved, and the colours of that time alone would say nothing.
    moved = np.hypot(*run.frame().matrix.point_data["displacement_m"].T)
    assert one["ends"][1] == max(highest) == pytest.approx(moved.max(), rel=0.1)


def test_a_page_has_room_for_so_many_frames(coupled, coupled_page, without_pictures, monkeypatch):
    monkeypatch.setattr("percolith.reporting.view_data.MOST_FRAMES", 3)
    few = page_at(percolith.report(coupled, coupled / "few.html", time=1.7e-3))
    moments = [frame["moment"] for frame in few.about["frames"]]
    assert moments[::2] == ["t = 0 ms", "t = 5 ms"]
    assert few.about["frames"][few.about["asked"]]["moment"] == few.about["moment"] == moments[1]
    monkeypatch.setattr("percolith.reporting.view_data.LARGEST_SERIES", 10)
    one = page_at(percolith.report(coupled, coupled / "one.html"))
    assert len(one.about["frames"]) == 1 and 'type="range"' not in one.text
    assert "This is one of 4 frames of the run" in one.said
    assert len(one.text) < len(few.text) < len(coupled_page.text)


def test_the_view_of_an_excavation_has_a_mesh_for_each_time(tmp_path, monkeypatch):
    run = RunDirectory(write_excavated_run(tmp_path / "run"))
    view = view_data(run, run.frame())
    shown, arrays = view.about["frames"], view.arrays
    assert [frame["segments"] > 0 for frame in shown] == [False, False, False, True]
    for frame, one in zip(run.frames(), shown):
        held = {name: unpack(arrays[key]) for name, key in one["arrays"].items()}
        places = held["places"].reshape(-1, 2)[held["node"]] + view.about["origin"]
        assert places == pytest.approx(frame.matrix.points, abs=1e-6)
        assert (held["cells"].reshape(-1, 3) == frame.matrix.cells).all()
        assert len(held["rock-damage"]) == len(held["rock-region"]) == len(frame.matrix.cells)
        assert len(held["displacement"]) == len(held["places"])
        assert ("gaps" in held) == ("crack-mode" in held) == (one["segments"] > 0)
    # The last frame is the smallest, and its size not that of the others.
    own = set(shown[-1]["arrays"].values())
    room = beside_the_one_asked_for(view) - 1
    assert min(frame["arrays"]["cells"] not in own for frame in shown[:-1])
    monkeypatch.setattr("percolith.reporting.view_data.LARGEST_SERIES", room)
    fewer = view_data(run, run.frame())
    assert len(fewer.about["frames"]) < 4 and beside_the_one_asked_for(fewer) <= room


def beside_the_one_asked_for(view) -> int:
    """Letters of arrays that the frame asked for does not have."""
    own = set(view.about["frames"][view.about["asked"]]["arrays"].values())
    return sum(len(packed.text) for key, packed in view.arrays.items() if key not in own)


def test_frames_fill_the_room_of_a_page_and_no_more(tmp_path, monkeypatch):
    run = RunDirectory(write_coupled_run(tmp_path / "run", frames=13))
    whole = view_data(run, run.frame())
    assert len(whole.about["frames"]) == 13
    all_of_them = beside_the_one_asked_for(whole)
    for share in (0.3, 0.6, 0.9):
        room = int(share * all_of_them)
        monkeypatch.setattr("percolith.reporting.view_data.LARGEST_SERIES", room)
        view = view_data(run, run.frame())
        assert 0.4 * room < beside_the_one_asked_for(view) <= room
        assert len(view.about["frames"]) < 13


@pytest.mark.parametrize("number", [0, 1, 3])
def test_a_damaged_frame_is_not_needed_for_another(coupled, tmp_path, request, number):
    if number < 3:  # pictures take long; one of them is of the last frame
        request.getfixturevalue("without_pictures")
    path = shutil.copytree(coupled, tmp_path / "run")
    file = path / f"fields/matrix_{number:06d}.vtu"
    file.write_bytes(file.read_bytes()[:2000])
    (path / "fields/cracks_000001.vtu").unlink()
    page = page_at(percolith.report(path, time=3.3e-3))
    moments = [frame["moment"] for frame in page.about["frames"]]
    lost = {0: "0 s, 1.667 ms", 1: "1.667 ms", 3: "1.667 ms, 5 ms"}[number]
    assert page.about["moment"] == "t = 3.333 ms"
    assert f"Left out, as their files are damaged or missing: the frames of {lost}." in page.said
    assert f"Of 4 frames of the run {len(moments)} are here" in page.said
    assert len(moments) == 4 - len(lost.split(","))


def test_a_piece_that_has_flown_off_does_not_hide_the_openings(coupled):
    run = RunDirectory(coupled)
    other = run.frame()
    other.matrix.point_data["displacement_m"][-3:] += 10.0  # m, of a triangle at a corner
    run.frame = lambda time: other if time == other.time else RunDirectory(coupled).frame(time)
    view = view_data(run, run.frame(0.0))
    keys = view.about["frames"][-1]["arrays"]
    moved = unpack(view.arrays[keys["displacement"]]).reshape(-1, 2)
    gaps = unpack(view.arrays[keys["gaps"]]).reshape(-1, 4)
    assert np.ptp(moved) > 1.0
    opening = np.hypot(*(moved[gaps[:, 0]] - moved[gaps[:, 3]]).T)
    assert opening.max() == pytest.approx(OPENING, rel=1e-4)


def test_joints_that_hold_are_drawn_shut(coupled):
    """They are springs and give a little, which large displacements would show as speckles."""
    run = RunDirectory(coupled)
    frame = run.frame()
    moved = frame.matrix.point_data["displacement_m"].copy()
    parted = moved + 1e-6 * np.random.default_rng(1).normal(size=moved.shape)
    frame.matrix.point_data["displacement_m"] = parted
    arrays = view_data(run, frame).arrays
    node, held = unpack(arrays["node"]), unpack(arrays["displacement"]).reshape(-1, 2)
    assert len(held) < 0.3 * len(moved)
    for axis in (0, 1):
        mean = np.bincount(node, parted[:, axis]) / np.bincount(node)
        # Corners apart at another time, which hang together now, move as one.
        assert held[:, axis] == pytest.approx(mean, abs=1e-8)
    assert np.abs(held[node] - moved).max() < 3e-6


def test_the_view_knows_which_cracks_hold_fluid(coupled, coupled_page):
    about, arrays = coupled_page.about, coupled_page.arrays
    gaps = arrays["gaps"].reshape(-1, 4)
    assert len(gaps) == about["segments"] == len(RunDirectory(coupled).frame().cracks.cells)
    moved = arrays["displacement"].reshape(-1, 2)
    opening = np.hypot(*(moved[gaps[:, 0]] - moved[gaps[:, 3]]).T)
    assert opening.max() == pytest.approx(OPENING, rel=1e-4)
    fields = {field["name"]: field for field in about["cracks"]}
    assert fields["mode"]["names"][3] == "shear"
    pressure = arrays[fields["pressure"]["values"]].reshape(-1, 2)
    wet = RunDirectory(coupled).frame().cracks.cell_data["wet"] != 0
    assert (np.isnan(pressure).all(axis=1) == ~wet).all() and not wet.all()
    assert fields["pressure"]["unit"] == "MPa" and fields["pressure"]["factor"] == 1e6


def test_rigid_bodies_have_no_values(mechanics, tmp_path):
    path = shutil.copytree(mechanics, tmp_path / "run")
    add_bodies(path, '[body.platen]\nregions = ["steel"]\nrigid = true\n', "rock", "steel")
    run = RunDirectory(path)
    frame = run.frame()
    steel = frame.matrix.points[frame.matrix.cells].mean(axis=1)[:, 1] > 0.09
    frame.matrix.cell_data["region"] = steel.astype(np.int32)
    view = view_data(run, frame)
    stress = unpack(view.arrays["rock-principal_stress_2"])
    assert (np.isnan(stress) == steel).all()
    size = unpack(view.arrays["rock-displacement"]).reshape(-1, 3)
    assert (np.isnan(size) == steel[:, None]).all()
    assert (unpack(view.arrays["rock-region"]) == steel).all()
    assert view.about["rock"][-1]["names"] == ["rock", "steel"]


def test_rows_of_mechanics(mechanics, without_pictures):
    summary = {"end_time_s": 2e-3, "outcome": "finished", "reached_rest": True, "mechanics": {
        "external_work_J_per_m": 12.5, "elastic_J_per_m": 12.0, "fracture_J_per_m": 0.5,
        "residual_J_per_m": 1e-5, "energy_error": 8e-7, "broken_joints": 60,
        "broken_joints_shear": 41, "fragment_area_m2": 0.005, "peak_reactions": {
            "boundary.top": {"x_N_per_m": 1.0, "x_time_s": 1e-3, "y_N_per_m": -3e6,
                             "y_time_s": 1.6e-3}}}}
    before = (mechanics / "summary.json").read_text()
    (mechanics / "summary.json").write_text(json.dumps(summary))
    try:
        page = page_at(percolith.report(mechanics, mechanics / "other.html"))
    finally:
        (mechanics / "summary.json").write_text(before)
    assert "The run came to rest at 2 ms." in page.said
    assert page.value("work of loads and supports") == "12.5 J/m"
    assert page.value("held and lost in all") == "12.5 J/m"
    assert page.value("in shear") == "41"
    assert page.value("relative error") == "8 × 10⁻⁷"
    assert ["boundary.top", "1 N/m", "1 ms", "−3 × 10⁶ N/m", "1.6 ms"] in page.rows


def test_energy_held_at_the_start_closes_the_balance(mechanics, without_pictures, tmp_path):
    path = shutil.copytree(mechanics, tmp_path / "run")
    head, first, *rows = (path / "history.csv").read_text().splitlines()
    names, values = head.split(","), first.split(",")
    values[names.index("elastic_J_per_m")] = "320.5"
    values[names.index("joint_J_per_m")] = "0.5"
    (path / "history.csv").write_text("\n".join([head, ",".join(values), *rows]) + "\n")
    (path / "summary.json").write_text(json.dumps({"end_time_s": 2e-3, "mechanics": {
        "external_work_J_per_m": 47.0, "elastic_J_per_m": 367.0, "fracture_J_per_m": 1.0}}))
    page = page_at(percolith.report(path))
    shown = [float(page.value(name).removesuffix(" J/m")) for name in (
        "held at the start", "given in all", "held and lost in all")]
    assert shown == [321.0, 47.0, 368.0]


def test_nothing_held_at_the_start_has_no_row(mechanics, without_pictures):
    page = page_at(percolith.report(mechanics, mechanics / "other.html"))
    assert not any(row[:1] == ["held at the start"] for row in page.rows)


def test_lengths_of_cracks_tell_which_joints_they_count(coupled, without_pictures, tmp_path):
    run = shutil.copytree(coupled, tmp_path / "run")
    text = (run / "resolved.toml").read_text()
    (run / "resolved.toml").write_text(text.replace(
        'physics = "coupled"\n', 'physics = "coupled"\nfluid_enters = "softening"\n'))
    (run / "summary.json").write_text(json.dumps({"end_time_s": 5e-3, "regions": ["plate"],
        "mechanics": {"broken_joints": 0, "crack_length_m": 0.16, "filled_crack_length_m": 0.1}}))
    page = page_at(percolith.report(run))
    assert page.value("joints that broke, in all") == "0"
    assert page.value("length open to fluid (broken or softening joints)") == "0.16 m"


def test_rows_of_flow(flow, without_pictures):
    page = page_at(percolith.report(flow))
    summary = RunDirectory(flow).summary
    assert "The run came to its end at" in page.said
    assert page.value("version of percolith") == summary["version"]
    assert page.value("hash of the final state") == summary["state_hash"]
    assert page.value("triangles") == "3004"
    assert page.value("smallest edge") == "0.36483 m"
    assert page.value("limit by crack flow") == "681.82 ns"
    assert page.value("permeability").endswith(" m²")
    assert float(page.value("relative error").split(" ")[0]) >= 0
    assert "resolved.toml" in page.said and "Derived values" in page.said
    # Rock at rest: cracks by their ends, nothing that moves.
    assert "displacement" not in page.arrays and not page.about["deforms"]
    cracks = RunDirectory(flow).frame().cracks
    ends = page.arrays["ends"].reshape(-1, 2, 2) + page.about["origin"]
    assert ends == pytest.approx(cracks.points[cracks.cells], abs=1e-5)


def test_a_steady_run_tells_rates(run_example, without_pictures, tmp_path):
    page = page_at(percolith.report(run_example("radial").results.path, tmp_path / "page.html"))
    assert "The run found the steady state." in page.said
    assert page.value("comes in").endswith(" m²/s")
    assert "takes no step of time" in page.said


def test_another_time_and_scale(coupled, without_pictures):
    first = page_at(percolith.report(coupled, coupled / "first.html", time=0.0, scale=3))
    assert first.about["moment"] == "t = 0 ms" and first.about["scale"] == 3
    assert 'value="3"' in first.text


def test_texts_of_the_user_stay_texts(mechanics, without_pictures, tmp_path):
    run = shutil.copytree(mechanics, tmp_path / "run")
    text = (run / "resolved.toml").read_text().replace(
        "A block under axial compression", "a <b>bold</b> </script> title & more")
    (run / "resolved.toml").write_text(text)
    page = page_at(percolith.report(run))
    assert "<b>" not in page.text and page.said.count("a <b>bold</b> </script> title & more") == 3


def test_a_run_that_has_not_ended(coupled, tmp_path, without_pictures):
    run = shutil.copytree(coupled, tmp_path / "run")
    (run / "summary.json").unlink()
    (run / "checkpoint.bin").write_bytes(b"")
    (run / "run.log").write_text("2026-01-01T00:00:00+00:00 warning: elements are coarse\n")
    page = page_at(percolith.report(run))
    assert "Unfinished." in page.said and "elements are coarse" in page.said
    assert f"percolith run --resume {run} goes on" in page.said
    assert page.value("joints that broke in tension") == "16"
    assert page.value("work of the fluid").endswith(" J/m")


def test_a_run_that_has_only_begun(tmp_path):
    run = tmp_path / "run"
    run.mkdir()
    (run / "resolved.toml").write_text('title = "Begun"\n[model]\nphysics = "coupled"\n')
    page = page_at(percolith.report(run))
    assert "The run has left no results in tables yet." in page.said
    assert "There is nothing to draw" in page.said and page.about is None


@pytest.mark.parametrize("name", ["history.csv", "events.csv"])
def test_a_missing_table_of_a_run_that_ended(mechanics, tmp_path, capsys, without_pictures, name):
    run = shutil.copytree(mechanics, tmp_path / "run")
    (run / name).unlink()
    (run / "report.html").write_text("an earlier page")
    assert reports.main([str(run)]) == 2
    assert f"{run / name}: missing" in capsys.readouterr().err
    assert (run / "report.html").read_text() == "an earlier page"


def test_missing_and_damaged_field_files(mechanics, tmp_path, capsys, without_pictures):
    run = shutil.copytree(mechanics, tmp_path / "run")
    field = run / "fields/matrix_000001.vtu"
    field.write_bytes(field.read_bytes()[:2000])
    assert reports.main([str(run)]) == 4
    assert f"{field}: not a field file of Percolith, or damaged" in capsys.readouterr().err
    field.unlink()
    assert reports.main([str(run)]) == 4
    assert str(field) in capsys.readouterr().err
    assert not list(run.glob("*report.html*")) and not list(run.glob(".report*"))


def test_no_run_directory(tmp_path, capsys):
    assert reports.main([str(tmp_path)]) == 2
    assert f"{tmp_path}: not a run directory" in capsys.readouterr().err


def test_output_in_a_missing_folder(mechanics, tmp_path, capsys, without_pictures):
    assert reports.main([str(mechanics), "--output", str(tmp_path / "absent/page.html")]) == 4
    assert "absent" in capsys.readouterr().err


def test_scale_is_for_mechanics(flow, capsys):
    assert reports.main([str(flow), "--scale", "10"]) == 2
    assert "--scale is for runs of mechanics" in capsys.readouterr().err


@pytest.mark.parametrize("option, value, reason", [
    ("--time", "noon", "does not begin with a number"), ("--time", "-1", "a negative time"),
    ("--scale", "-1", "no factor"), ("--scale", "nan", "no factor"), ("--scale", "x", "no factor")])
def test_wrong_options(mechanics, capsys, option, value, reason):
    with pytest.raises(SystemExit):
        reports.main([str(mechanics), f"{option}={value}"])
    assert f"{option} = {value}: {reason}; allowed: " in capsys.readouterr().err
