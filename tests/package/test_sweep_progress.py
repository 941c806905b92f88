# SPDX-License-Identifier: BSD-3-Clause
"""How far a sweep is told to be."""

import io
import sys
import warnings

import percolith
import pytest
from percolith import SweepProgress, sweep_progress
from percolith.sweeps import main

END = "3 of 4 runs done, 1 failed"


class Terminal(io.StringIO):
    def isatty(self):
        return True


def of_lines(text: str) -> list[str]:
    return [line.strip() for line in text.replace("\r", "\n").splitlines() if line.strip()]


@pytest.fixture
def study(strip, tmp_path) -> percolith.Sweep:
    """Four short runs, of which the third fails."""
    strip["fluid.cavitation_pressure"] = 0
    strip["source.well"] = {"point": [0.5, 0.01], "rate": 0.0}
    return percolith.sweep(strip, {"source.well.rate": [0.0, 1e-9, -10.0, 2e-9]}, tmp_path / "study")


@pytest.mark.parametrize("progress, text", [
    ((7, 1, 3, 24, 240.0), "7 of 24 runs done, 1 failed, 3 running, about 4 min left"),
    ((0, 0, 2, 24, None), "0 of 24 runs done, 2 running"),
    ((23, 0, 1, 24, 12.2), "23 of 24 runs done, 1 running, about 12 s left"),
    ((2, 0, 1, 24, 12000.0), "2 of 24 runs done, 1 running, about 3 h left"),
    ((2, 0, 1, 24, 9e5), "2 of 24 runs done, 1 running, about 10 days left"),
    ((24, 0, 0, 24, 0.0), "24 of 24 runs done")])
def test_progress_reads_well(progress, text):
    assert str(SweepProgress(*progress)) == text


def test_the_rest_takes_as_long_as_what_has_ended(monkeypatch):
    now = [0.0]
    monkeypatch.setattr(sweep_progress.time, "monotonic", lambda: now[0])
    tally = sweep_progress.Tally(total=8, done=1, left=7, processes=2)
    tally.begin(1), tally.begin(2)
    assert tally.progress == SweepProgress(1, 0, 2, 8, None)
    now[0] = 10.0
    tally.end(1, failed=False)
    tally.begin(3)
    # Six are left, of which one has been at work for as long as the first took.
    assert tally.progress == SweepProgress(2, 0, 2, 8, pytest.approx(25.0))
    tally.end(2, failed=True)
    tally.begin(4)
    assert tally.progress == SweepProgress(2, 1, 2, 8, pytest.approx(25.0))


def test_a_function_is_told(study):
    seen = []
    assert list(study.run(processes=2, progress=seen.append)) == [2]
    assert len(seen) == 5 and all(progress.total == 4 for progress in seen)
    assert (seen[0].done, seen[0].failed, seen[0].running, seen[0].remaining) == (0, 0, 2, None)
    assert str(seen[-1]) == END and seen[-1].remaining == 0.0
    assert study.run(progress=seen.append) and str(seen[5]) == "3 of 4 runs done, 1 running"


def test_what_a_function_raises_ends_the_sweep(study):
    def refuse(progress):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        study.run(processes=1, progress=refuse)


def test_lines_of_a_log(study, capsys):
    study.run(processes=1, progress=True)
    lines = of_lines(capsys.readouterr().out)
    assert [line.partition(":")[0] for line in lines] == [
        "point 0 finished", "point 1 finished", "point 2 failed", "point 3 finished"]
    assert lines[-1] == f"point 3 finished: {END}"


@pytest.mark.parametrize("progress", [None, False])
def test_a_log_has_nothing_without_being_asked(study, capsys, progress):
    study.run(processes=2, progress=progress)
    told = capsys.readouterr()
    assert told.out == told.err == ""


def test_a_terminal_has_one_line(study, monkeypatch):
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    study.run(processes=1)
    assert terminal.getvalue().count("\n") == 1 and terminal.getvalue().endswith("\n")
    lines = of_lines(terminal.getvalue())
    assert len(lines) == 5 and lines[0] == "0 of 4 runs done, 1 running" and lines[-1] == END


def test_a_warning_is_no_part_of_the_line(coupled, tmp_path, monkeypatch):
    study = percolith.sweep(coupled, {"material.rock.density": [2000]}, tmp_path / "study")
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        monkeypatch.setattr(warnings, "showwarning",
                            lambda message, *rest: terminal.write(f"{message}\n"))
        study.run(processes=1)
    (told,) = [line for line in terminal.getvalue().splitlines() if "cohesive length" in line]
    assert told.split("\r")[-1].startswith("warning: ")
    assert of_lines(terminal.getvalue())[-1] == "1 of 1 runs done"


def test_a_notebook_has_one_line(study, monkeypatch, capsys):
    class Python:
        @staticmethod
        def get_ipython():
            return type("Shell", (), {"kernel": None})

    monkeypatch.setitem(sys.modules, "IPython", Python)
    study.run(processes=2)
    told = capsys.readouterr()
    assert told.err == "" and of_lines(told.out)[-1] == END


def test_the_command_tells_as_well(study, capsys):
    assert main([str(study.folder), "--processes", "1", "--progress"]) == 2
    told = capsys.readouterr()
    assert told.out.splitlines()[-1] == f"point 3 finished: {END}"
    assert told.err.startswith("point 2: ")


def test_other_progress_is_refused(study):
    with pytest.raises(percolith.CaseError, match="progress = 'bar': allowed: True, False, None or"):
        study.run(progress="bar")
