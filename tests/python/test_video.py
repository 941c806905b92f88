# SPDX-License-Identifier: BSD-3-Clause
"""Animations as MP4: `percolith plot DIR --animate --output FILE.mp4`."""

import sys

import numpy as np
import percolith
import pytest
from percolith import RunDirectoryError, plot
from percolith.video import require_encoder, write_video
from PIL import Image
from synthetic_coupled_run import write_coupled_run

av = pytest.importorskip("av")


def pictures(path) -> list[np.ndarray]:
    """Pixels of every picture, (height, width, 3)."""
    with av.open(str(path)) as file:
        return [frame.to_ndarray(format="rgb24").astype(int) for frame in file.decode(video=0)]


def test_each_picture_stays_as_long_as_it_should(tmp_path):
    path = tmp_path / "colours.mp4"
    colours = [(255, 0, 0), (0, 255, 0), (0, 0, 255)]
    write_video(path, (Image.new("RGB", (65, 47), colour) for colour in colours), 200, 400)
    shown = pictures(path)
    assert shown[0].shape == (48, 66, 3)  # even, as the format needs
    middle = [picture[20, 30] for picture in shown]
    assert [int(np.argmax(colour)) for colour in middle] == [0] * 5 + [1] * 5 + [2] * 10
    assert min(colour.max() for colour in middle) > 200
    assert (shown[0][-1, 5] > 200).all()  # the row that was added is white
    with av.open(str(path)) as file:
        video = file.streams.video[0]
        assert video.codec_context.name == "h264" and video.codec_context.pix_fmt == "yuv420p"
        assert file.duration / av.time_base == pytest.approx(0.8, abs=0.05)


def test_a_run_over_time(tmp_path, capsys):
    run = percolith.open_run(write_coupled_run(tmp_path / "run", frames=2))
    output = tmp_path / "field.mp4"
    words = ["--animate", "--field", "principal_stress_1", "--cracks", "pressure", "--output"]
    assert plot.main([str(run.path), *words, str(output)]) == 0
    assert capsys.readouterr().out.strip() == str(output)
    shown = pictures(output)
    assert len(shown) == round(0.5 * 25) + 50  # half a second, and two for the last
    assert np.abs(shown[0] - shown[-1]).max() > 100
    assert not list(tmp_path.glob(".*"))


def test_what_was_there_stays_where_drawing_fails(tmp_path):
    path = tmp_path / "old.mp4"
    path.write_text("old")

    def failing():
        yield Image.new("RGB", (64, 64))
        raise RunDirectoryError("damaged")

    with pytest.raises(RunDirectoryError, match="damaged"):
        write_video(path, failing(), 100, 100)
    assert path.read_text() == "old" and len(list(tmp_path.iterdir())) == 1


def test_a_missing_folder_is_told(tmp_path, capsys):
    run = write_coupled_run(tmp_path / "run", frames=2)
    output = tmp_path / "absent/field.mp4"
    assert plot.main([str(run), "--animate", "--output", str(output)]) == 4
    assert str(output) in capsys.readouterr().err


def test_a_missing_encoder_is_told_before_anything_is_drawn(tmp_path, monkeypatch, capsys):
    run = write_coupled_run(tmp_path / "run", frames=2)
    monkeypatch.setitem(sys.modules, "av", None)
    assert plot.main([str(run), "--animate", "--output", str(tmp_path / "field.mp4")]) == 2
    message = capsys.readouterr().err
    assert "an MP4 needs the package av (PyAV), which is not installed: `pip install av`" in message
    assert "FILE.gif works without" in message and not (tmp_path / "field.mp4").exists()
    with pytest.raises(RunDirectoryError, match="needs the package av"):
        require_encoder()


def test_another_ending_is_refused(tmp_path):
    run = percolith.open_run(write_coupled_run(tmp_path / "run", frames=2))
    with pytest.raises(RunDirectoryError, match="an animation is a GIF or an MP4; allowed: FILE.g"):
        run.animate(tmp_path / "field.avi")
