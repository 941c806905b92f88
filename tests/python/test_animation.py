# SPDX-License-Identifier: BSD-3-Clause
"""Animations: `percolith plot DIR --animate`."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from percolith import RunDirectory, animation, plot
from percolith.animation import draw_animation, encode, thinned
from percolith.crack_picture import MODES
from PIL import Image
from synthetic_coupled_run import write_coupled_run
from synthetic_run import write_mechanics_run


@pytest.fixture(scope="module")
def coupled(tmp_path_factory):
    return write_coupled_run(tmp_path_factory.mktemp("coupled") / "results")


def pictures(path) -> list[np.ndarray]:
    """Pixels of every picture, (height, width, 3)."""
    with Image.open(path) as file:
        shown = []
        for number in range(file.n_frames):
            file.seek(number)
            shown.append(np.asarray(file.convert("RGB")).astype(int))
        return shown


def share_of(picture: np.ndarray, colour: str) -> float:
    wanted = np.round(255 * np.array(plt.matplotlib.colors.to_rgb(colour)))
    return float((np.abs(picture - wanted).max(axis=2) <= 6).mean())


def test_the_pressure_is_shown_over_time(coupled, capsys):
    assert plot.main([str(coupled), "--animate"]) == 0
    assert capsys.readouterr().out.strip() == str(coupled / "pressure.gif")
    shown = pictures(coupled / "pressure.gif")
    assert len(shown) == 4 and len({picture.shape for picture in shown}) == 1
    for one, next_one in zip(shown, shown[1:]):
        assert (one != next_one).any(axis=2).mean() > 1e-3
    # Colour bars and axes stay where they are: the right fifth of all pictures is the same.
    bars = [picture[:, -picture.shape[1] // 5:] for picture in shown]
    assert all((bar == bars[0]).all() for bar in bars)
    assert (shown[0][:2] == 255).all()


def test_cracks_of_dry_rock_have_the_colours_of_their_modes(tmp_path):
    run = RunDirectory(write_mechanics_run(tmp_path / "results"))
    path = draw_animation(run, scale=1.0)
    assert path.name == "principal_stress_1.gif"
    first, last = pictures(path)
    for number in (-1, 1, 2, 3):
        assert share_of(last, MODES[number][1]) > share_of(first, MODES[number][1]), number


def test_another_field_and_another_file(coupled, tmp_path, capsys):
    output = tmp_path / "stress.gif"
    words = ["--field", "principal_stress_1", "--scale", "100", "--output", str(output)]
    assert plot.main([str(coupled), "--animate", *words]) == 0
    assert len(pictures(output)) == 4 and capsys.readouterr().out.strip() == str(output)


def test_the_last_picture_stays_longest(coupled, tmp_path):
    path = draw_animation(RunDirectory(coupled), path=tmp_path / "pressure.gif")
    with Image.open(path) as file:
        times = []
        for number in range(file.n_frames):
            file.seek(number)
            times.append(file.info["duration"])
        assert file.info["loop"] == 0
    assert times == [500, 500, 500, 2000]


def test_thinning_keeps_both_ends():
    assert thinned(list(range(200)), 60)[::59] == [0, 199]
    assert len(thinned(list(range(200)), 60)) == 60
    assert thinned([1, 2, 3], 60) == [1, 2, 3]


def test_a_file_that_is_too_large_gets_fewer_and_then_smaller_pictures():
    random = np.random.default_rng(3)
    images = [Image.fromarray(random.integers(0, 255, (200, 240, 3), np.uint8)) for _ in range(40)]
    whole = len(encode(images, 10**9))
    for largest in (int(0.8 * whole), whole // 8):
        content = encode(images, largest)
        assert 0.4 * largest < len(content) <= largest


def test_a_single_frame_is_no_animation(coupled, tmp_path, capsys):
    directory = write_coupled_run(tmp_path / "results", frames=2)
    for name in ("matrix.pvd", "cracks.pvd"):
        text = (directory / name).read_text()
        (directory / name).write_text(text[:text.rindex("<DataSet")] + "</Collection></VTKFile>")
    assert plot.main([str(directory), "--animate"]) == 2
    assert "an animation needs two frames" in capsys.readouterr().err


@pytest.mark.parametrize("words, message", [
    (["--time", "all"], "--animate shows all times; leave out --time"),
    (["--reference", "probe.csv"], "--reference is for the picture of the probes"),
    (["--output", "field.png"],
     "--output = field.png: not the name of an animation; allowed: FILE.gif, FILE.mp4"),
])
def test_options_that_contradict_it(coupled, words, message, capsys):
    with pytest.raises(SystemExit):
        plot.main([str(coupled), "--animate", *words])
    assert message in capsys.readouterr().err


def test_a_field_that_the_run_lacks(tmp_path, capsys):
    directory = write_mechanics_run(tmp_path / "results")
    assert plot.main([str(directory), "--animate", "--field", "pressure"]) == 2
    assert "no pressure in this run; there are: displacement" in capsys.readouterr().err


def test_at_most_so_many_frames(tmp_path, monkeypatch):
    monkeypatch.setattr(animation, "MOST_FRAMES", 3)
    run = RunDirectory(write_coupled_run(tmp_path / "results", frames=6))
    assert len(pictures(draw_animation(run))) == 3
