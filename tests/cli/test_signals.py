# SPDX-License-Identifier: BSD-3-Clause
"""SIGINT and SIGTERM during a run, and a folder that another run is writing to."""

import json
import os
import signal
import subprocess
import time

import pytest

from conftest import ENDLESS, files_of


@pytest.fixture
def endless(program, strip, tmp_path):
    """A run that takes millions of steps, with its first results written."""
    command = [program, "run", strip, *ENDLESS, "--output", "out", "--threads", "1"]
    process = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True,
                               env={**os.environ, "OMP_WAIT_POLICY": "passive"})
    deadline = time.monotonic() + 60
    # The last output time of the case; from then on only steps follow.
    while not (tmp_path / "out/fields/matrix_000003.vtu").exists():
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < deadline
        time.sleep(0.02)
    time.sleep(0.2)
    yield process
    if process.poll() is None:
        process.kill()
    process.communicate()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_the_run_after_the_step(endless, tmp_path, number):
    endless.send_signal(number)
    _, errors = endless.communicate(timeout=30)
    assert endless.returncode == 128 + number
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["outcome"] == "interrupted"
    assert summary["reason"] == number.name
    assert 0.01 < summary["end_time_s"] < 1e6
    assert f"interrupted by {number.name} at time" in errors
    # The last frame and the last row are those of the moment it stopped.
    assert (tmp_path / "out/matrix.pvd").read_text().count("<DataSet ") == 5
    last = (tmp_path / "out/history.csv").read_text().splitlines()[-1]
    assert float(last.split(",")[0]) == summary["end_time_s"]
    assert not list((tmp_path / "out").rglob("*.part"))


def test_a_second_sigterm_does_not_hurry(endless, tmp_path):
    endless.send_signal(signal.SIGTERM)
    endless.send_signal(signal.SIGTERM)
    endless.communicate(timeout=30)
    assert endless.returncode == 128 + signal.SIGTERM
    assert json.loads((tmp_path / "out/summary.json").read_text())["outcome"] == "interrupted"
    assert (tmp_path / "out/checkpoint.bin").is_file()


def test_a_folder_in_use_is_refused_even_with_force(endless, percolith, strip, tmp_path):
    before = set(files_of(tmp_path / "out"))
    done = percolith("run", strip, "--output", "out", "--force")
    assert done.returncode == 2
    assert done.stderr == ("error: --output = out: another run is writing to this folder; allowed: "
                           "another --output, or wait for that run to end\n")
    assert endless.poll() is None
    assert set(files_of(tmp_path / "out")) == before


def test_a_killed_run_leaves_its_folder_free(endless, percolith, strip, tmp_path):
    endless.kill()
    endless.wait()
    done = percolith("run", strip, "--set", "time.step=1 ms", "--output", "out", "--force")
    assert done.returncode == 0, done.stderr
    assert json.loads((tmp_path / "out/summary.json").read_text())["outcome"] == "finished"
