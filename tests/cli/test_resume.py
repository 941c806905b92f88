# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed or stopped and go on from their checkpoint; checkpoints that are refused."""

import fcntl
import json
import os
import random
import shutil
import signal
import struct
import subprocess
import time

import pytest

from conftest import ROOT, files_of

CASES = ROOT / "verification/restart"
QUIET = ("--threads", "1", "--quiet")


def outputs(folder):
    """What a run leaves but for the log and times on the wall."""
    files = files_of(folder)
    summary = json.loads(files.pop("summary.json"))
    del summary["wall_time_s"], files["run.log"]
    return {**files, "summary": summary}


def has_finished(folder):
    """Whether a run wrote all its results: the signal may come just before it leaves."""
    summary = folder / "summary.json"
    return summary.exists() and json.loads(summary.read_text())["outcome"] == "finished"


@pytest.fixture(scope="session")
def whole(program, tmp_path_factory):
    """whole(name) -> folder and seconds of a run of a case without interruption."""
    done = {}

    def run(name):
        if name not in done:
            folder = tmp_path_factory.mktemp(name) / "out"
            start = time.monotonic()
            subprocess.run([program, "run", CASES / f"{name}.toml", "--output", folder, *QUIET],
                           check=True, timeout=120, capture_output=True)
            done[name] = folder, time.monotonic() - start
        return done[name]

    return run


@pytest.fixture
def interrupted(program, tmp_path):
    """interrupted(name, number, delay) -> folder of a run that got a signal after its first
    checkpoint and a delay, in s; a run that came to its end before is tried again, earlier."""

    def run(name, number=signal.SIGKILL, delay=0.0, cases=CASES):
        folder = tmp_path / "out"
        while True:
            process = subprocess.Popen(
                [program, "run", cases / f"{name}.toml", "--output", folder, "--force", *QUIET],
                stderr=subprocess.DEVNULL, env={**os.environ, "OMP_WAIT_POLICY": "passive"})
            while process.poll() is None and not (folder / "checkpoint.bin").exists():
                time.sleep(0.002)
            time.sleep(delay)
            process.send_signal(number)
            if process.wait() != 0 and not has_finished(folder):
                return folder
            delay /= 2

    return run


@pytest.mark.parametrize("name", ["rock", "water", "pumped", "slow"])
@pytest.mark.parametrize("trial", range(3))
def test_a_killed_run_goes_on_to_the_same_results(percolith, whole, interrupted, name, trial):
    expected, seconds = whole(name)
    delay = random.Random(trial).uniform(0.0, 0.6 * seconds)
    folder = interrupted(name, delay=delay)
    done = percolith("run", "--resume", folder, "--threads", "1")
    assert done.returncode == 0, done.stderr
    assert "goes on from the checkpoint at time" in done.stdout
    assert outputs(folder) == outputs(expected)


@pytest.mark.parametrize("name", ["rock", "water", "pumped", "slow"])
def test_a_stopped_run_goes_on_to_the_same_results(percolith, whole, interrupted, name):
    expected, _ = whole(name)
    folder = interrupted(name, signal.SIGTERM)
    assert json.loads((folder / "summary.json").read_text())["outcome"] == "interrupted"
    # It has gone on to report the moment it stopped at, which the run that goes on takes back.
    done = percolith("run", "--resume", folder, "--threads", "2", "--quiet")
    assert done.returncode == 0, done.stderr
    found = outputs(folder)
    assert found["summary"].pop("threads") == 2
    wanted = outputs(expected)
    del wanted["summary"]["threads"]
    assert found == wanted
    log = (folder / "run.log").read_text()
    assert " runs " in log and "interrupted by SIGTERM" in log and "goes on from" in log


def test_a_signal_is_heard_within_a_long_step(program, tmp_path):
    folder = tmp_path / "out"
    process = subprocess.Popen(
        [program, "run", CASES / "slow.toml", "--output", folder, "--set", "time.step=600",
         "--set", "time.tolerance=1e-6", "--set", "source.pump.rate=5e-6", *QUIET],
        stderr=subprocess.DEVNULL, env={**os.environ, "OMP_WAIT_POLICY": "passive"})
    while process.poll() is None and not (folder / "history.csv").exists():
        time.sleep(0.002)
    time.sleep(0.3)
    process.send_signal(signal.SIGTERM)
    assert process.wait(timeout=20) == 128 + signal.SIGTERM
    summary = json.loads((folder / "summary.json").read_text())
    assert (summary["outcome"], summary["end_time_s"]) == ("interrupted", 0)
    assert (folder / "checkpoint.bin").exists()
    # The start was reported already.
    assert len((folder / "history.csv").read_text().splitlines()) == 2


def test_a_resolved_case_runs_to_the_same_results(percolith, whole, tmp_path):
    folder, _ = whole("slow")
    done = percolith("run", folder / "resolved.toml", "--output", tmp_path / "again", *QUIET)
    assert done.returncode == 0, done.stderr
    again, first = outputs(tmp_path / "again"), outputs(folder)
    for results in (again, first):
        del results["summary"]["case_file"]
    assert again == first


def test_a_run_that_has_finished_says_so_and_stays_as_it_is(percolith, whole, tmp_path):
    folder = tmp_path / "out"
    shutil.copytree(whole("rock")[0], folder)
    before = files_of(folder)
    assert "checkpoint.bin" not in before
    done = percolith("run", "--resume", folder)
    assert done.returncode == 0
    assert done.stdout == f"the run in {folder} has finished; there is nothing to go on with\n"
    assert files_of(folder) == before


def test_a_run_killed_between_its_summary_and_its_end_is_tidied(percolith, whole, interrupted):
    folder = interrupted("rock")
    shutil.copy(whole("rock")[0] / "summary.json", folder)
    assert percolith("run", "--resume", folder).returncode == 0
    assert not (folder / "checkpoint.bin").exists()


def refusal(percolith, folder, code=4):
    """What the program says when it refuses to go on, and that it has changed nothing."""
    before = files_of(folder)
    done = percolith("run", "--resume", folder)
    assert done.returncode == code, done.stderr
    assert files_of(folder) == before
    return done.stderr


def test_a_run_without_a_checkpoint_is_refused(percolith, interrupted):
    folder = interrupted("rock")
    (folder / "checkpoint.bin").unlink()
    assert (f"error: --resume = {folder}: the folder holds no checkpoint.bin: the run was ended "
            "before its first checkpoint, or is a steady one") in refusal(percolith, folder, 2)


def test_damaged_checkpoints_are_refused(percolith, interrupted):
    folder = interrupted("rock")
    file = folder / "checkpoint.bin"
    sound = file.read_bytes()
    file.write_bytes(sound[:len(sound) // 2])
    said = refusal(percolith, folder)
    assert f"{file}: the checkpoint is cut short" in said
    middle = len(sound) // 2
    file.write_bytes(sound[:middle] + bytes([sound[middle] ^ 1]) + sound[middle + 1:])
    assert f"{file}: the checkpoint is damaged: its checksum" in refusal(percolith, folder)
    file.write_bytes(sound.replace(b"format 2,", b"format 9,", 1))
    assert "format 9" in refusal(percolith, folder)
    # Sound again, it is gone on with.
    file.write_bytes(sound)
    assert percolith("run", "--resume", folder, *QUIET).returncode == 0


def test_foreign_checkpoints_are_refused(percolith, interrupted, whole):
    folder = interrupted("rock")
    other = folder.parent / "other"
    shutil.copytree(whole("water")[0], other)
    (other / "summary.json").unlink()
    shutil.copy(folder / "checkpoint.bin", other)
    assert "the checkpoint belongs to another case than resolved.toml" in refusal(percolith, other)


def test_a_changed_case_is_refused(percolith, interrupted):
    folder = interrupted("rock")
    case = folder / "resolved.toml"
    case.write_text(case.read_text().replace("end = 0.012", "end = 0.013"))
    assert "or that file was changed since" in refusal(percolith, folder)


def test_a_changed_mesh_is_refused(percolith, tmp_path, interrupted):
    shutil.copytree(CASES, tmp_path / "case")
    folder = interrupted("rock", cases=tmp_path / "case")
    mesh = tmp_path / "case/block.msh"
    sound = mesh.read_bytes()
    height, moved = struct.pack("<d", 0.65), struct.pack("<d", 0.6501)
    assert height in sound
    mesh.write_bytes(sound.replace(height, moved))
    assert "belongs to another mesh than that of mesh.file" in refusal(percolith, folder)
    mesh.unlink()
    assert "there is no file" in refusal(percolith, folder, 2)
    mesh.write_bytes(sound)
    assert percolith("run", "--resume", folder, *QUIET).returncode == 0


def test_results_that_are_gone_are_refused(percolith, interrupted):
    folder = interrupted("rock")
    history = folder / "history.csv"
    rows = history.read_bytes()
    history.write_bytes(rows[:100])
    assert f"{history}: the file has 100 bytes" in refusal(percolith, folder)
    history.unlink()
    assert f"{history}: cannot go on with the file" in refusal(percolith, folder)


def test_fields_that_are_gone_are_refused(percolith, interrupted, tmp_path):
    folder = interrupted("rock", delay=0.05)
    first = folder / "fields/matrix_000000.vtu"
    sound = first.read_bytes()
    first.write_bytes(b"")
    assert f"{first}: the file has 0 bytes" in refusal(percolith, folder)
    first.write_bytes(sound)
    (folder / "fields").rename(tmp_path / "fields")
    assert f"{first}: cannot go on with the file" in refusal(percolith, folder)
    (tmp_path / "fields").rename(folder / "fields")
    assert percolith("run", "--resume", folder, *QUIET).returncode == 0


def test_a_folder_without_a_run_is_refused(percolith, tmp_path):
    done = percolith("run", "--resume", tmp_path / "none")
    assert done.returncode == 2
    assert "there is no such folder; allowed: the folder of a run" in done.stderr
    (tmp_path / "empty").mkdir()
    assert "the folder holds no run" in refusal(percolith, tmp_path / "empty", 2)


def test_a_folder_in_use_is_refused(percolith, interrupted):
    folder = interrupted("rock")
    with open(folder / "run.log") as log:
        fcntl.flock(log, fcntl.LOCK_EX)
        assert "another run is writing to this folder" in refusal(percolith, folder, 2)


def test_a_case_and_its_options_do_not_go_with_resume(percolith):
    for arguments in (["case.toml"], ["--set", "time.end=1"], ["--force"], ["--output", "other"]):
        done = percolith("run", "--resume", "out", *arguments)
        assert done.returncode == 2
        assert "excludes" in done.stderr and "--resume" in done.stderr


def test_checkpoints_follow_the_clock_on_the_wall(percolith, tmp_path):
    done = percolith("run", CASES / "rock.toml", "--set", "output.checkpoint_interval=",
                     "--set", "output.checkpoint_wall_interval=1 us", *QUIET)
    assert done.returncode == 0
    assert "checkpoint at time" in (tmp_path / "rock.results/run.log").read_text()
