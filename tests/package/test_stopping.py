# SPDX-License-Identifier: BSD-3-Clause
"""Runs that end before their end: Ctrl-C, errors, a block that is left; and go on."""

import json
import os
import signal
import subprocess
import sys
import threading
import time

import percolith
import pytest

from test_simulation import results


def endless(case):
    """Millions of steps."""
    case["time"] = {"scheme": "explicit", "end": "1e6 s"}
    del case["output.times"]
    return case


def outcome(folder) -> tuple[str, str]:
    summary = json.loads((folder / "summary.json").read_text())
    return summary["outcome"], summary["reason"]


def test_ctrl_c_stops_after_the_present_step_and_keeps_the_results(strip, tmp_path, capsys):
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        endless(strip).run(tmp_path / "results")
    timer.join()
    assert outcome(tmp_path / "results") == ("interrupted", "SIGINT")
    assert (tmp_path / "results/checkpoint.bin").is_file()
    told = capsys.readouterr().err
    folder = tmp_path / "results"
    assert f'to go on: percolith.resume("{folder}"), or percolith run --resume {folder}' in told


def test_a_program_that_is_interrupted_ends_at_once(strip, tmp_path):
    strip = endless(strip)
    strip.save(tmp_path / "case.toml")
    child = subprocess.Popen([sys.executable, "-c", "import percolith;"
                              "percolith.Case.load('case.toml').run('results')"],
                             cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    deadline = time.monotonic() + 60
    while not (tmp_path / "results/history.csv").is_file() and time.monotonic() < deadline:
        time.sleep(0.05)
    child.send_signal(signal.SIGINT)
    _, told = child.communicate(timeout=30)
    assert "KeyboardInterrupt" in told
    assert outcome(tmp_path / "results") == ("interrupted", "SIGINT")


@pytest.mark.parametrize("name", ["strip", "coupled", "mechanics"])
def test_a_run_that_was_closed_goes_on_to_the_same_bits(name, tmp_path, request, capsys):
    case = request.getfixturevalue(name)
    case.run(tmp_path / "whole")
    with case.simulation(tmp_path / "parts") as simulation:
        simulation.advance(steps=8)
    told = capsys.readouterr().err
    assert f'percolith.resume("{tmp_path / "parts"}")' in told
    assert outcome(tmp_path / "parts")[0] == "interrupted"
    run = percolith.resume(tmp_path / "parts")
    assert results(tmp_path / "parts") == results(tmp_path / "whole")
    assert run.summary["outcome"] == "finished"
    assert percolith.resume(tmp_path / "parts").summary == run.summary


def test_what_a_callback_raises_ends_the_run(strip, tmp_path):
    def fail(simulation):
        raise ValueError("enough")

    with pytest.raises(ValueError, match="enough"):
        strip.simulation(tmp_path / "results").run(on_output=fail)
    assert outcome(tmp_path / "results") == ("interrupted", "ValueError")


def test_a_run_that_cannot_go_on_raises_a_solver_error(strip, tmp_path, program):
    strip["source.well"] = {"point": [0.5, 0.01], "rate": -10.0}
    strip["fluid.cavitation_pressure"] = 0
    with pytest.raises(percolith.SolverError) as caught:
        strip.run(tmp_path / "results")
    assert outcome(tmp_path / "results") == ("failed", str(caught.value))
    strip.save(tmp_path / "case.toml")
    told = program("run", tmp_path / "case.toml", "--output", tmp_path / "other", "--quiet").stderr
    assert "error: " + str(caught.value) in told
    assert isinstance(caught.value, RuntimeError)


def test_results_are_not_replaced_unless_forced(strip, tmp_path):
    strip.run(tmp_path / "results")
    with pytest.raises(percolith.CaseError, match="output = .*: force=True to replace them, or "
                       "another output") as caught:
        strip.run(tmp_path / "results")
    assert caught.value.problems[0].key == "output" and "--" not in str(caught.value)
    strip.run(tmp_path / "results", force=True)


def test_a_folder_in_use_is_refused(strip, tmp_path):
    with strip.simulation(tmp_path / "results"):
        with pytest.raises(percolith.CaseError, match="another run"):
            strip.simulation(tmp_path / "results", force=True)


def test_other_threads_work_while_a_run_does(strip):
    counted = []
    simulation = endless(strip).simulation()
    ended = threading.Event()

    def count():
        while not ended.is_set():
            counted.append(simulation.time)
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.monotonic()
    while time.monotonic() < start + 0.3:
        simulation.advance(steps=2000)
    ended.set()
    thread.join()
    assert len(counted) > 20


def test_one_thread_at_a_time(strip):
    simulation = endless(strip).simulation()
    errors = []

    def disturb():
        time.sleep(0.1)
        try:
            simulation.advance(steps=1)
        except RuntimeError as error:
            errors.append(str(error))

    thread = threading.Thread(target=disturb)
    thread.start()
    simulation.advance(steps=100000)
    thread.join()
    assert errors == ["the simulation is at work in another thread"]


def test_nothing_to_go_on_with(tmp_path):
    with pytest.raises(percolith.CaseError, match="folder = .*: the folder holds no run"):
        percolith.resume(tmp_path)


@pytest.mark.parametrize("threads", [0, -1, "2", 1.5, True])
def test_a_number_of_threads_that_is_none(strip, threads):
    with pytest.raises(percolith.CaseError, match="threads = "):
        strip.simulation(threads=threads)
