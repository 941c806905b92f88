# SPDX-License-Identifier: BSD-3-Clause
"""Many runs of one case."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import percolith
import pytest
from conftest import ROOT
from percolith.simulation import reopen_run
from percolith.sweeps import Point, main

OPTIONS = {"boundary.left.pressure": [1e5, "200 kPa"], "material.rock.porosity": [0.1, 0.2]}


@pytest.fixture
def case(strip) -> percolith.Case:
    """The strip, its rock under a name that does not depend on the example."""
    (name,) = strip["material"]
    rock = strip["material"][name].to_dict()
    del strip["material"]
    strip["material.rock"] = rock
    return strip


def test_all_combinations_are_run_and_told(case, tmp_path):
    sweep = percolith.sweep(case, OPTIONS, tmp_path / "study")
    assert [point.state for point in sweep.points] == ["waiting"] * 4
    assert sweep.run(processes=2) == {}
    assert [point.state for point in sweep.points] == ["finished"] * 4
    assert [point.options for point in sweep.points][2] == {
        "boundary.left.pressure": "200 kPa", "material.rock.porosity": 0.1}
    table = sweep.table()
    assert list(table["state"]) == ["finished"] * 4
    assert table["in_m2"][2] == pytest.approx(2 * table["in_m2"][0], rel=0.2)
    for name in ("maximum_pressure_Pa", "minimum_pressure_Pa", "minimum_saturation"):
        assert table[name][2] == sweep.points[2].results().summary["extremes"][name], name
    assert table["maximum_pressure_Pa"] == pytest.approx([1e5, 1e5, 2e5, 2e5])
    assert table["boundary.left_m2_per_s"][0] > 0 > table["boundary.right_m2_per_s"][0]
    for point, rate in zip(sweep.points, table["boundary.left_m2_per_s"]):
        assert rate == point.results().history["boundary.left_m2_per_s"][-1]
    case["boundary.left.pressure"] = "200 kPa"
    case["material.rock.porosity"] = 0.1
    with case.simulation() as alone:
        alone.run()
    assert sweep.points[2].results().summary["state_hash"] == alone.state_hash


def test_options_are_numbers_in_the_table(case, tmp_path):
    points = [{"boundary.left.pressure": "200 kPa", "material.rock.porosity": "10 %"},
              {"boundary.left.pressure": 1e5, "material.rock.porosity": 0.2, "fluid.viscosity": "1 cP",
               "material.rock.permeability": 1e-14, "time.scheme": "implicit"},
              {"material.rock.permeability": [1e-14, 1e-14, 0.0], "model.gravity": 0,
               "output.fields": False}]
    table = percolith.sweep(case, points, tmp_path / "study").table()
    expected = {"boundary.left.pressure_Pa": [2e5, 1e5, np.nan],
                "material.rock.porosity": [0.1, 0.2, np.nan],
                "fluid.viscosity_Pa_s": [np.nan, 1e-3, np.nan],
                "model.gravity_m_per_s2": [np.nan, np.nan, 0.0]}
    for name, values in expected.items():
        assert table[name].dtype.kind == "f"
        assert table[name] == pytest.approx(values, nan_ok=True)
    assert list(table["material.rock.permeability"]) == ["", "1e-14", "[1e-14, 1e-14, 0.0]"]
    assert list(table["time.scheme"]) == ["", "implicit", ""]
    assert list(table["output.fields"]) == ["", "", "False"]
    pandas = pytest.importorskip("pandas")
    assert pandas.api.types.is_float_dtype(table.to_pandas()["boundary.left.pressure_Pa"])


def test_peak_pressures_of_sources_are_in_the_table(coupled, tmp_path):
    sweep = percolith.sweep(coupled, {"source.middle.rate": [1e-2, 2e-2]}, tmp_path / "study")
    sweep.run_point(1)
    table = sweep.table()
    peaks = sweep.points[1].results().summary["mechanics"]["peak_pressures"]
    assert set(peaks) == {"source.lower", "source.middle", "source.upper"}
    for name, peak in peaks.items():
        assert table[f"peak_pressures.{name}.pressure_Pa"][1] == peak["pressure_Pa"]
        assert table[f"peak_pressures.{name}.time_s"][1] == peak["time_s"]
    assert np.isnan(table["peak_pressures.source.middle.pressure_Pa"][0])


def test_what_has_finished_is_not_run_again_and_the_rest_goes_on(case, tmp_path):
    sweep = percolith.sweep(case, OPTIONS, tmp_path / "study")
    sweep.run_point(0)
    before = (sweep.points[0].folder / "summary.json").stat().st_mtime_ns
    with sweep.case(1).simulation(sweep.points[1].folder) as simulation:
        simulation.advance(steps=7)
    assert sweep.points[1].state == "interrupted"
    again = percolith.sweep(case, OPTIONS, tmp_path / "study")
    assert again.run(processes=1) == {}
    assert (sweep.points[0].folder / "summary.json").stat().st_mtime_ns == before
    assert "goes on from the checkpoint" in (sweep.points[1].folder / "run.log").read_text()
    shutil.rmtree(sweep.points[3].folder)
    assert np.isnan(sweep.table()["end_time_s"][3]) and sweep.points[3].state == "waiting"


def test_a_sweep_is_printed_with_the_states_of_its_points(case, tmp_path, monkeypatch):
    sweep = percolith.sweep(case, {"material.rock.porosity": [0.1, 0.2, 0.3]}, tmp_path / "study")
    assert repr(sweep) == f"Sweep({sweep.folder}: 3 points, 3 waiting)"
    sweep.run_point(1)
    assert repr(sweep) == f"Sweep({sweep.folder}: 3 points, 1 finished, 2 waiting)"
    monkeypatch.setattr(percolith.sweeps, "_FEW", 2)
    assert repr(sweep) == f"Sweep({sweep.folder}: 3 points)"


def test_points_may_be_listed_one_by_one(case, tmp_path):
    sweep = percolith.sweep(case, [{"time.step": "2 ms"}, {"boundary.left.pressure": 3e5}],
                            tmp_path / "study")
    assert sweep.case(0)["time.step"] == "2 ms"
    # One step more ends at 5 ms, a time of output.
    assert sweep.run_point(0).summary["steps"] == 11


def test_a_point_that_fails_does_not_stop_the_others(case, tmp_path):
    case["fluid.cavitation_pressure"] = 0
    case["source.well"] = {"point": [0.5, 0.01], "rate": 0.0}
    sweep = percolith.sweep(case, {"source.well.rate": [-10.0, 0.0]}, tmp_path / "study")
    failed = sweep.run(processes=1)
    assert list(failed) == [0] and isinstance(failed[0], percolith.SolverError)
    assert [point.state for point in sweep.points] == ["failed", "finished"]


def test_what_points_warn_of_is_told_once(coupled, tmp_path, recwarn):
    coupled["material.rock.biot_coefficient"] = 0.1
    options = {"material.rock.density": [2000, 2100]}

    def told():
        texts = [str(each.message) for each in recwarn if each.category is percolith.CaseWarning]
        assert all(each.filename == __file__ for each in recwarn)
        recwarn.clear()
        return texts

    sweep = percolith.sweep(coupled, options, tmp_path / "study")
    (planned,) = told()
    assert "biot_coefficient = 0.1 is outside" in planned
    assert sweep.run(processes=1) == {}
    (ran,) = told()  # what only a model that is run can tell
    assert "cohesive length" in ran

    for point in sweep.points:
        shutil.rmtree(point.folder)
    assert percolith.Sweep(sweep.folder).run(processes=1) == {}
    first, second = told()
    assert "biot_coefficient = 0.1 is outside" in first and "cohesive length" in second


def test_mistakes_are_told_before_anything_is_written(case, tmp_path):
    for options, message in [({"time.stepp": [1]}, "time.stepp"), ({"time.step": "2 ms"}, "no list"),
                             ([], "without points"), ({"time.step": []}, "without points"),
                             ([{"time.end": "3 MPa"}], "the unit \"MPa\"")]:
        with pytest.raises(percolith.CaseError, match=message):
            percolith.sweep(case, options, tmp_path / "study")
    assert not (tmp_path / "study").exists()


def test_meshes_and_their_groups_are_checked_beforehand(case, tmp_path):
    here = case.file.parent / case["mesh.file"]
    for options, message in [
            ({"mesh.file": [str(here), "nowhere.msh"]}, "point 1: .*nowhere.msh"),
            ({"boundary.left.groups": [["left"], ["nothing"]]}, "point 1: .*nothing"),
            ([{}, {"probe.far": {"point": [99.0, 99.0]}}], "point 1: .*probe.far"),
            ([{}, {}, {"time.end": "3 MPa"}], "point 2: error: time.end")]:
        with pytest.raises((percolith.CaseError, percolith.FileError), match=message):
            percolith.sweep(case, options, tmp_path / "study")
    assert not (tmp_path / "study").exists()


def test_a_mesh_is_read_once_for_all_points_that_ask_the_same_of_it(case, tmp_path, monkeypatch):
    built = []
    monkeypatch.setattr("percolith.sweeps.start_run", built.append)
    percolith.sweep(case, {"material.rock.porosity": np.linspace(0.1, 0.2, 5),
                           "probe.there": [{"point": [0.5, 0.1]}, {"point": [0.6, 0.1]}]},
                    tmp_path / "study")
    assert len(built) == 2


@pytest.mark.parametrize("alone", [True, False])
def test_a_point_that_fails_at_its_start_is_told(case, tmp_path, capsys, alone):
    shutil.copy(case.file.parent / case["mesh.file"], tmp_path / "own.msh")
    sweep = percolith.sweep(case, {"mesh.file": [case.file.parent / case["mesh.file"],
                                                 tmp_path / "own.msh"]}, tmp_path / "study")
    good = (tmp_path / "own.msh").read_bytes()
    (tmp_path / "own.msh").write_bytes(good.replace(b'"left"', b'"lost"'))
    if alone:
        with pytest.raises(percolith.CaseError) as caught:
            sweep.run_point(1)
        error = caught.value
    else:
        failed = sweep.run(processes=1)
        assert list(failed) == [1]
        error = failed[1]
    assert str(error).startswith("point 1: ") and "left" in str(error)
    assert isinstance(error, percolith.CaseError) and error.problems[0].key
    point = sweep.points[1]
    assert point.state == "failed" and sweep.table()["state"][1] == "failed"
    assert str(point.failure) == str(error) and point.failure.problems == error.problems
    assert alone or np.isnan(sweep.table()["end_time_s"][1])
    assert main([str(sweep.folder), "--list"]) == 0
    assert "1 failed " in capsys.readouterr().out
    assert main([str(sweep.folder), "--point", "1"]) == 2
    assert capsys.readouterr().err.count("point 1: ") == 1

    (tmp_path / "own.msh").write_bytes(good)
    sweep.run_point(1)
    assert sweep.points[1].state == "finished" and sweep.points[1].failure is None


def test_an_attempt_that_is_killed_does_not_fail_as_the_one_before(case, tmp_path, monkeypatch):
    sweep = percolith.sweep(case, OPTIONS, tmp_path / "study")

    def end(error: BaseException):
        def run(*_, **__):
            raise error
        monkeypatch.setattr(percolith.Case, "run", run)

    end(percolith.FileError("no room on the disk"))
    with pytest.raises(percolith.FileError, match="point 0: no room"):
        sweep.run_point(0)
    assert sweep.points[0].state == "failed"
    end(SystemExit())  # as suddenly as a kill, which leaves no time to tell anything
    with pytest.raises(SystemExit):
        sweep.run_point(0)
    assert sweep.points[0].state == "waiting" and sweep.points[0].failure is None


def test_a_point_at_work_elsewhere_has_not_failed(case, tmp_path):
    sweep = percolith.sweep(case, OPTIONS, tmp_path / "study")
    with sweep.case(0).simulation(sweep.points[0].folder):
        with pytest.raises(percolith.CaseError, match="point 0: .*another run"):
            sweep.run_point(0)
        assert sweep.points[0].state == "waiting"


@pytest.mark.parametrize("plan", ["[]", "{}", '{"points": []}', "{"])
def test_a_damaged_plan_is_no_sweep(plan, tmp_path):
    (tmp_path / "sweep.json").write_text(plan)
    with pytest.raises(percolith.CaseError, match="no sweep here"):
        percolith.Sweep(tmp_path)


def test_a_point_with_a_damaged_summary_waits(tmp_path):
    (tmp_path / "summary.json").write_text("[]")
    assert Point(0, {}, tmp_path).state == "waiting"


def test_a_folder_keeps_its_sweep(case, tmp_path):
    sweep = percolith.sweep(case, OPTIONS, tmp_path / "study")
    with pytest.raises(percolith.CaseError, match="another sweep"):
        percolith.sweep(case, {"time.step": ["2 ms"]}, tmp_path / "study")
    with pytest.raises(percolith.CaseError, match="no sweep here"):
        percolith.Sweep(tmp_path)
    with pytest.raises(percolith.CaseError, match="point 4: .*0 to 3"):
        sweep.run_point(4)
    for wrong in (0, "2", 1.5):
        with pytest.raises(percolith.CaseError, match="processes = "):
            sweep.run(processes=wrong)
        with pytest.raises(percolith.CaseError, match="threads = "):
            sweep.run(processes=1, threads=wrong)


def test_a_job_of_an_array_runs_one_point(case, tmp_path, capsys):
    sweep = percolith.sweep(case, OPTIONS, tmp_path / "study")
    done = subprocess.run([sys.executable, "-m", "percolith.sweeps", sweep.folder, "--point", "3",
                           "--threads", "1"], check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert sweep.points[3].state == "finished"
    assert main([str(sweep.folder), "--list"]) == 0
    assert "3 finished " + json.dumps(sweep.points[3].options) in capsys.readouterr().out
    assert main([str(sweep.folder), "--point", "9"]) == 2
    assert "no number of a point" in capsys.readouterr().err


def test_ctrl_c_ends_a_sweep_that_goes_on_later(case, tmp_path, capsys):
    case["time"] = {"scheme": "explicit", "end": "1e6 s"}
    del case["output.times"]
    sweep = percolith.sweep(case, {"boundary.left.pressure": [1e5, 2e5, 3e5]}, tmp_path / "study")

    def interrupt():
        deadline = time.monotonic() + 60
        while not all((sweep.points[i].folder / "history.csv").is_file() for i in (0, 1)):
            assert time.monotonic() < deadline
            time.sleep(0.05)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        sweep.run(processes=2)
    thread.join()
    told = capsys.readouterr().err
    assert told == (f"{sweep.folder}: ended by Ctrl-C; results and checkpoints are kept, and the "
                    "same lines go on with them\n")
    assert [point.state for point in sweep.points] == ["interrupted", "interrupted", "waiting"]
    assert (sweep.points[0].folder / "checkpoint.bin").is_file()


@pytest.mark.skipif(sys.platform != "linux", reason="asks Linux to tell of the end of a parent")
def test_runs_end_with_a_sweep_that_is_killed(case, tmp_path):
    case["time"] = {"scheme": "explicit", "end": "1e6 s"}
    del case["output.times"]
    sweep = percolith.sweep(case, {"boundary.left.pressure": [1e5, 2e5]}, tmp_path / "study")
    lines = f"import percolith; percolith.Sweep({str(sweep.folder)!r}).run(processes=2)"
    process = subprocess.Popen([sys.executable, "-c", lines])
    _wait_until(lambda: all((point.folder / "history.csv").is_file() for point in sweep.points))
    process.kill()
    process.wait()
    _wait_until(lambda: all(point.state == "interrupted" for point in sweep.points))
    for point in sweep.points:
        assert "interrupted by SIGTERM" in (point.folder / "run.log").read_text()
        steps = point.results().summary["steps"]
        run = _wait_until(lambda folder=point.folder: _reopened(folder))
        run.advance(float("inf"), 5, False)
        assert run.steps == steps + 5
        run.close("the test")


def _wait_until(asked):
    deadline = time.monotonic() + 60
    while not (answer := asked()):
        assert time.monotonic() < deadline
        time.sleep(0.05)
    return answer


def _reopened(folder):
    """The run; None as long as the process that has written its results has not ended."""
    try:
        return reopen_run(folder)
    except percolith.CaseError as error:
        assert "another run" in str(error)
        return None


def test_a_run_whose_sweep_has_gone_already_does_not_begin(case, tmp_path):
    sweep = percolith.sweep(case, OPTIONS, tmp_path / "study")
    # In a process of its own: what it asks of Linux would last.
    done = subprocess.run([sys.executable, "-m", "percolith.sweeps", sweep.folder, "--point", "0",
                           "--parent", "1"], check=False, capture_output=True, text=True)
    assert done.returncode == 128 + signal.SIGTERM
    assert not sweep.points[0].folder.exists()


@pytest.mark.parametrize("words", [["--point", "0"], ["--processes", "2"]])
@pytest.mark.parametrize("ending", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_ends_a_job_that_goes_on_later(case, tmp_path, words, ending):
    case["time"] = {"scheme": "explicit", "end": "1e6 s"}
    del case["output.times"]
    sweep = percolith.sweep(case, {"boundary.left.pressure": [1e5, 2e5]}, tmp_path / "study")
    process = subprocess.Popen([sys.executable, "-m", "percolith.sweeps", sweep.folder, *words],
                               stderr=subprocess.PIPE, text=True)
    begun = sweep.points[:1] if "--point" in words else sweep.points
    deadline = time.monotonic() + 60
    while not all((point.folder / "history.csv").is_file() for point in begun):
        assert time.monotonic() < deadline and process.poll() is None
        time.sleep(0.05)
    process.send_signal(ending)
    _, told = process.communicate(timeout=60)
    assert process.returncode == 128 + ending
    assert "Traceback" not in told
    assert told.count("ended by") == 1
    assert f"{sweep.folder}: ended by {ending.name}; results and checkpoints are kept" in told
    for point in begun:
        assert point.state == "interrupted" and (point.folder / "checkpoint.bin").is_file()
        if "--point" in words:
            assert f"interrupted by {ending.name}" in (point.folder / "run.log").read_text()
        steps = point.results().summary["steps"]
        run = reopen_run(point.folder)
        run.advance(float("inf"), 5, False)
        assert run.steps == steps + 5
        run.close("the test")


def test_the_job_script_of_the_page_gets_the_signal_to_the_run():
    page = (ROOT / "docs/python.md").read_text()
    assert re.search(r"^#SBATCH --signal=B:TERM@\d+$", page, re.MULTILINE)
    assert re.search(r"^exec python -m percolith.sweeps ", page, re.MULTILINE)
