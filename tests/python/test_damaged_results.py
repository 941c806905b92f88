# SPDX-License-Identifier: BSD-3-Clause
"""What is cut, damaged or lost of a run is told with the name of the file and what to do."""

import json
import os
import subprocess
import sys

import numpy as np
import percolith
import pytest
from percolith import FileError, RunDirectoryError, plot, reports
from percolith.run_directory import RunDirectory, column_names, read_table
from program import ROOT
from synthetic_run import write_mechanics_run

CUT_TOML = 'title = "A block\n[model'
BINARY = bytes(range(128, 256))
DAMAGE = {
    "cut summary": ("summary.json", b'{"end_time_s": 0.0', "damaged: Expecting"),
    "summary of another kind": ("summary.json", b"[]", "damaged: not a JSON object"),
    "cut input": ("resolved.toml", CUT_TOML.encode(), "damaged: "),
    "binary input": ("resolved.toml", BINARY, "damaged: not a text in UTF-8"),
    "cut list of frames": ("matrix.pvd", b"<VTKFile><Collection><DataSet", "damaged: "),
    "no time": ("matrix.pvd", b'<VTKFile><DataSet timestep="soon" file="a.vtu"/></VTKFile>',
                "damaged: could not convert"),
    "time that is none": ("matrix.pvd", b'<V><DataSet timestep="nan" file="a.vtu"/></V>',
                          'damaged: timestep = "nan"'),
    "frame without a file": ("matrix.pvd", b'<V><DataSet timestep="1"/></V>', "damaged: "),
    "binary history": ("history.csv", BINARY, "damaged: not a text in UTF-8"),
    "binary events": ("events.csv", BINARY, "damaged: not a text in UTF-8"),
    "cut history": ("history.csv", b"time_s,step\n0,1\n0", "rows of different lengths"),
    "lost frame": ("fields/matrix_000001.vtu", None, "No such file"),
    "cut frame": ("fields/matrix_000001.vtu", b"<VTK", "not a field file of Percolith, or damaged"),
    "lost history": ("history.csv", None, "missing; did the run end"),
}


@pytest.fixture
def folder(tmp_path):
    return write_mechanics_run(tmp_path / "block")


@pytest.fixture
def finished(folder):
    """A run that says how it ended and that it was to leave frames."""
    with open(folder / "resolved.toml", "a") as file:
        file.write("[output]\nfields = true\n")
    summary = json.loads((folder / "summary.json").read_text())
    (folder / "summary.json").write_text(json.dumps({**summary, "outcome": "finished"}))
    return folder


def damage(folder, name, content) -> None:
    if content is None:
        (folder / name).unlink()
    else:
        (folder / name).write_bytes(content)


# Pictures need no summary.
COMMANDS = [(reports.main, case) for case in DAMAGE] + [
    (plot.main, case) for case in DAMAGE if DAMAGE[case][0] != "summary.json"]


@pytest.mark.parametrize("command, case", COMMANDS)
def test_commands_tell_of_it_in_one_line(command, case, folder, capsys):
    name, content, told = DAMAGE[case]
    damage(folder, name, content)
    assert command([str(folder)]) in (2, 4)
    said = capsys.readouterr().err
    assert said.count("\n") == 1 and "Traceback" not in said
    assert name in said and told in said


@pytest.mark.parametrize("case", DAMAGE)
def test_the_package_raises_errors_of_its_own(case, folder):
    name, content, _ = DAMAGE[case]
    damage(folder, name, content)
    with pytest.raises(percolith.Error, match=name.split("/")[-1]):
        run = RunDirectory(folder)
        _ = run.summary, run.resolved, run.history, run.events, list(run.frames())


def test_what_to_do_is_told(folder):
    (folder / "summary.json").write_text("{")
    with pytest.raises(RunDirectoryError, match="copy the results anew .* or run the case again"):
        _ = RunDirectory(folder).summary


def test_the_program_ends_without_a_traceback(folder):
    (folder / "summary.json").write_text("[]")
    done = subprocess.run([sys.executable, "-m", "percolith.reports", folder],
                          capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": str(ROOT / "python")})
    assert done.returncode == 2
    assert done.stderr.startswith(f"percolith-report: error: {folder}/summary.json: damaged: ")
    assert done.stderr.count("\n") == 1


def test_a_lost_list_of_frames_is_no_wish_of_the_case(finished, capsys):
    (finished / "matrix.pvd").unlink()
    with pytest.raises(RunDirectoryError, match="no frames; matrix.pvd, .* is missing; copy"):
        RunDirectory(finished).frame()
    assert reports.main([str(finished)]) == 2
    assert "matrix.pvd" in capsys.readouterr().err


def test_a_case_that_wants_no_frames_is_named(finished):
    text = (finished / "resolved.toml").read_text()
    (finished / "resolved.toml").write_text(text.replace("fields = true", "fields = false"))
    (finished / "matrix.pvd").unlink()
    with pytest.raises(RunDirectoryError, match="the case sets output.fields = false"):
        RunDirectory(finished).frame()


def test_a_run_that_goes_on_has_no_frames_yet(finished):
    (finished / "matrix.pvd").unlink()
    (finished / "summary.json").unlink()
    with pytest.raises(RunDirectoryError, match="no frames; did the run end\\? see run.log"):
        RunDirectory(finished).frame()


def test_a_page_without_a_folder_to_go_to(folder, tmp_path):
    with pytest.raises(FileError, match="report.html: cannot be written: no folder"):
        percolith.report(folder, tmp_path / "nowhere/report.html")
    assert reports.main([str(folder), "--output", str(tmp_path / "nowhere/report.html")]) == 4


def test_a_picture_without_a_folder_to_go_to(folder, tmp_path, capsys):
    for words in (["--field", "damage", "--output", str(tmp_path / "nowhere/damage.png")],
                  ["--animate", "--output", str(tmp_path / "nowhere/film.gif")]):
        assert plot.main([str(folder), *words]) == 4
        assert "cannot be written: " in capsys.readouterr().err
    with pytest.raises(FileError, match="film.gif: cannot be written"):
        RunDirectory(folder).animate(tmp_path / "nowhere/film.gif")


def test_tables_that_are_not_there(tmp_path):
    with pytest.raises(FileError, match="absent.csv: cannot be read: No such file"):
        read_table(tmp_path / "absent.csv")
    with pytest.raises(FileError, match="absent.csv"):
        column_names(tmp_path / "absent.csv")
    with pytest.raises(FileError, match="absent.vtu: cannot be read: No such file"):
        percolith.read_vtu(tmp_path / "absent.vtu")


@pytest.mark.parametrize("time", [np.nan, np.inf])
def test_a_time_is_finite(time, folder, capsys):
    with pytest.raises(RunDirectoryError, match="not a finite time; allowed: seconds"):
        RunDirectory(folder).frame(time)
    with pytest.raises(SystemExit):
        plot.main([str(folder), "--time", str(time)])
    assert "not a finite time; allowed: last, all, seconds" in capsys.readouterr().err
