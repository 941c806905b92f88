# SPDX-License-Identifier: BSD-3-Clause
"""`percolith run`: what it leaves behind and what it never destroys."""

import csv
import json
import re
import tomllib

import pytest

from conftest import ROOT, SHORT, STEADY, files_of, line_of


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def test_leaves_a_complete_run_directory(percolith, strip, tmp_path):
    done = percolith("run", strip, *SHORT, "--threads", "2", "--output", "out")
    assert done.returncode == 0, done.stderr
    out = tmp_path / "out"
    summary = json.loads((out / "summary.json").read_text())
    assert summary["outcome"] == "finished"
    assert summary["title"] == "Transient flow through a strip"
    assert summary["case_file"] == str(strip)
    assert summary["end_time_s"] == pytest.approx(0.02, rel=1e-12)
    assert summary["steps"] >= 20
    assert summary["threads"] == 2
    assert summary["mass_balance"]["relative_error"] < 1e-12
    assert summary["extremes"]["maximum_pressure_Pa"] == pytest.approx(1e5)
    assert summary["state_hash"]
    assert {"case file", "mesh file", "model", "output", "total"} <= set(summary["wall_time_s"])

    history = rows_of(out / "history.csv")
    times = [float(row["time_s"]) for row in history]
    assert times == sorted(times)
    assert {0, 0.001, 0.005, 0.01, 0.02} <= {round(time, 12) for time in times}
    assert float(history[-1]["boundary.left_m2_per_s"]) > 0
    assert history[-1]["minimum_crack_pressure_Pa"] == ""

    probe = rows_of(out / "probes/centre.csv")
    assert len(probe) == 5 * 21
    assert list(probe[0])[:4] == ["time_s", "x_m", "y_m", "pressure_Pa"]

    assert (out / "matrix.pvd").read_text().count("<DataSet ") == 5
    assert len(list((out / "fields").glob("matrix_*.vtu"))) == 5
    assert not (out / "cracks.pvd").exists()
    assert not list(out.rglob("*.part"))
    log = (out / "run.log").read_text()
    assert "info: percolith " in log
    assert "info: finished at time 0.02 s" in log


def test_resolved_case_gives_the_same_run(percolith, strip, tmp_path):
    assert percolith("run", strip, *STEADY, "--output", "one").returncode == 0
    resolved = tmp_path / "one/resolved.toml"
    assert tomllib.loads(resolved.read_text())["time"]["scheme"] == "steady"
    done = percolith("run", resolved, "--output", "two")
    assert done.returncode == 0, done.stderr
    hashes = {json.loads((tmp_path / run / "summary.json").read_text())["state_hash"]
              for run in ("one", "two")}
    assert len(hashes) == 1


def test_cracks_have_their_series(percolith, six_fractures, tmp_path):
    done = percolith("run", six_fractures, *STEADY, "--output", "out")
    assert done.returncode == 0, done.stderr
    assert "<DataSet " in (tmp_path / "out/cracks.pvd").read_text()
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["fractures"] == ["network"]
    assert "maximum_crack_pressure_Pa" in summary["extremes"]


def test_results_go_here_named_after_the_case(percolith, strip, tmp_path):
    assert percolith("run", strip, *STEADY).returncode == 0
    assert (tmp_path / "case.results/summary.json").is_file()


def test_set_replaces_options(percolith, strip, tmp_path):
    done = percolith("run", strip, *STEADY, "--set", "boundary.left.pressure=2 bar",
                     "--output", "out")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["extremes"]["maximum_pressure_Pa"] == pytest.approx(2e5)


def test_mechanics_sums_up_what_it_came_to(percolith, tmp_path):
    done = percolith("run", ROOT / "examples/incline/case.toml", "--set", "time.end=1 ms",
                     "--set", "output=", "--output", "out")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert "rejected_steps" not in summary and "iterations" not in summary
    results = summary["mechanics"]
    counts = [results[name] for name in ("broken_joints", "broken_joints_tensile",
                                         "broken_joints_shear", "broken_joints_mixed",
                                         "closed_joints", "fragments")]
    assert all(isinstance(count, int) for count in counts)
    slope = results["peak_reactions"]["body.slope"]
    history = rows_of(tmp_path / "out/history.csv")
    reactions = {float(row["time_s"]): float(row["body.slope.reaction_y_N_per_m"])
                 for row in history}
    assert abs(slope["y_N_per_m"]) == max(map(abs, reactions.values()))
    assert reactions[slope["y_time_s"]] == slope["y_N_per_m"]
    assert not any("-0" in row.values() for row in history)
    lines = done.stdout.splitlines()[-3:]
    assert lines[0] == "joints that broke: 0 (0 in tension, 0 in shear, 0 mixed)"
    assert lines[1].startswith("largest reaction of body.slope: x ")
    assert lines[1] in (tmp_path / "out/run.log").read_text()


def test_coupled_runs_sum_up_what_fluid_did(percolith, tmp_path):
    done = percolith("run", ROOT / "verification/restart/pumped.toml",
                     "--output", "out")
    assert done.returncode == 0, done.stderr
    results = json.loads((tmp_path / "out/summary.json").read_text())["mechanics"]
    peak = results["peak_pressures"]["source.pump"]
    pressures = {float(row["time_s"]): float(row["source.pump.pressure_Pa"])
                 for row in rows_of(tmp_path / "out/history.csv")}
    assert pressures[peak["time_s"]] == peak["pressure_Pa"] == max(pressures.values())
    source = next(line for line in done.stdout.splitlines() if line.startswith("source.pump: "))
    assert "injected, highest pressure " in source
    cracks = f"cracks: {results['crack_length_m']:.4g} m open to fluid, "
    assert any(line.startswith(cracks) for line in done.stdout.splitlines())


def test_fields_can_be_left_out(percolith, strip, tmp_path):
    assert percolith("run", strip, *STEADY, "--set", "output.fields=false", "--output",
                     "out").returncode == 0
    assert not (tmp_path / "out/matrix.pvd").exists()
    assert (tmp_path / "out/history.csv").is_file()


def test_quiet_prints_nothing(percolith, strip):
    done = percolith("run", strip, *SHORT, "--quiet")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


def test_says_where_the_results_are(percolith, strip):
    done = percolith("run", strip, *SHORT)
    assert done.stdout.splitlines()[-1].startswith("finished at time 0.02 s after ")
    assert done.stdout.endswith("results in case.results\n")
    assert "\r" not in done.stdout
    steady = percolith("run", strip, *STEADY, "--output", "steady")
    assert steady.stdout.splitlines()[-1].startswith("finished the steady state, mass balance ")


def test_plain_progress_lines_without_a_terminal(percolith, strip):
    lines = percolith("run", strip, *SHORT).stdout.splitlines()
    assert [line.split(":")[0] for line in lines[-3:-1]] == ["boundary.left", "boundary.right"]
    assert 5 <= len(lines[:-3]) <= 12
    assert all(line.startswith("step ") and " of 0.02 s (" in line for line in lines[:-3])


@pytest.mark.parametrize("settings", [STEADY, SHORT])
def test_flow_ends_with_the_rate_of_each_condition(percolith, strip, tmp_path, settings):
    done = percolith("run", strip, *settings, "--output", "out")
    rate = json.loads((tmp_path / "out/summary.json").read_text())["rate_m2_per_s"]
    left, right = (f"{abs(rate[f'boundary.{side}']):.5g} m2/s" for side in ("left", "right"))
    lines = [f"boundary.left: {left} into the rock", f"boundary.right: {right} out of the rock"]
    assert done.stdout.splitlines()[-3:-1] == lines
    assert all(line in (tmp_path / "out/run.log").read_text() for line in lines)


def test_flow_ends_when_it_has_settled(percolith, strip, tmp_path):
    steady = percolith("run", strip, *STEADY, "--output", "steady")
    wanted = json.loads((tmp_path / "steady/summary.json").read_text())["rate_m2_per_s"]
    settings = ("--set", "time.step=", "--set", "time.end=1 day", "--set", "output.times=",
                "--set", "time.stop_ratio=1e-3")
    steps = set()
    for threads in ("1", "2"):
        done = percolith("run", strip, *settings, "--threads", threads, "--output", threads)
        assert done.returncode == 0, done.stderr
        last = done.stdout.splitlines()[-1]
        assert re.search(r" steps, settled: what is stored and given up is \S+ of what flows "
                         r"through, mass balance", last), last
        summary = json.loads((tmp_path / threads / "summary.json").read_text())
        assert summary["reached_rest"] and summary["end_time_s"] < 3600
        assert summary["change_over_throughput"] <= 1e-3
        for name, rate in summary["rate_m2_per_s"].items():
            assert rate == pytest.approx(wanted[name], rel=1e-3)
        assert float(rows_of(tmp_path / threads / "history.csv")[-1]["time_s"]) == \
            summary["end_time_s"]
        steps.add((summary["steps"], summary["state_hash"]))
    assert len(steps) == 1
    done = percolith("run", strip, *settings, "--set", "time.end=1 ms", "--output", "short")
    assert " steps, not settled: what is stored and given up is " in done.stdout.splitlines()[-1]
    refused = percolith("run", strip, *STEADY, "--set", "time.stop_ratio=1e-3")
    assert refused.returncode == 2
    assert "--set: error: time.stop_ratio = 0.001: has no effect here: it needs a time.scheme " \
        'other than "steady"' in refused.stderr
    assert steady.returncode == 0


def test_a_steady_run_that_would_drain_tells_the_way_out(percolith):
    dam = (ROOT / "examples/dam/case.toml", *STEADY)
    way_out = 'Use time.scheme = "implicit" with time.stop_ratio, such as 1e-3'
    checked = percolith("check", *dam)
    assert checked.returncode == 0
    assert "no condition lifts water above y = 5 m: the rock would drain there" in checked.stderr
    assert way_out in checked.stderr
    done = percolith("run", *dam, "--output", "out")
    assert done.returncode == 3
    assert "the rock would drain there. " + way_out in done.stderr


def test_equal_bits_for_one_and_two_threads(percolith, six_fractures, tmp_path):
    texts = set()
    for threads in ("1", "2"):
        out = tmp_path / threads
        assert percolith("run", six_fractures, *STEADY, "--threads", threads, "--output",
                         out).returncode == 0
        texts.add((out / "probes/y5.csv").read_bytes())
    assert len(texts) == 1


def test_a_folder_is_no_case_and_results_go_on_with_resume(percolith, strip, tmp_path):
    assert percolith("run", strip, *STEADY).returncode == 0
    before = files_of(tmp_path / "case.results")
    for more in ((), ("--force",)):
        done = percolith("run", "case.results", *more)
        assert done.returncode == 2
        assert done.stderr == ("error: case.results: is a folder; a run begins with a case file; allowed: "
                               "a case file, or percolith run --resume FOLDER to go on with results\n")
    assert files_of(tmp_path / "case.results") == before


def test_earlier_results_need_force(percolith, strip, tmp_path):
    assert percolith("run", strip, *STEADY).returncode == 0
    before = files_of(tmp_path / "case.results")
    done = percolith("run", strip, *STEADY)
    assert done.returncode == 2
    assert done.stderr == ("error: --output = case.results: the folder holds results of an earlier "
                           "run; allowed: --force to replace them, or another --output\n")
    assert files_of(tmp_path / "case.results") == before
    (tmp_path / "case.results/notes.txt").write_text("mine")
    assert percolith("run", strip, *SHORT, "--force").returncode == 0
    assert (tmp_path / "case.results/notes.txt").read_text() == "mine"
    assert len(list((tmp_path / "case.results/fields").iterdir())) == 5


def test_force_never_touches_other_folders(percolith, strip, tmp_path):
    (tmp_path / "home").mkdir()
    (tmp_path / "home/history.csv").write_text("mine")
    done = percolith("run", strip, *STEADY, "--output", "home", "--force")
    assert done.returncode == 2
    assert "the folder is not empty and holds no results of a run" in done.stderr
    assert files_of(tmp_path / "home") == {"history.csv": b"mine"}


@pytest.mark.parametrize("mistake", [("porosity = 0.1", "porosity = -0.1"),
                                     ("strip_05.msh", "none.msh"),
                                     ('["left"]', '["lefft"]')])
def test_bad_input_never_destroys_earlier_results(percolith, strip, tmp_path, mistake):
    assert percolith("run", strip, *STEADY).returncode == 0
    before = files_of(tmp_path / "case.results")
    strip.write_text(strip.read_text().replace(*mistake))
    done = percolith("run", strip, *STEADY, "--force")
    assert done.returncode == 2
    assert done.stderr.startswith(f"{strip}:{line_of(strip, mistake[1])}:"), done.stderr
    assert ": error: " in done.stderr
    assert files_of(tmp_path / "case.results") == before


def test_bad_input_leaves_no_folder(percolith, strip, tmp_path):
    done = percolith("run", strip, "--set", "material.rock.porosity=2", "--output", "out")
    assert done.returncode == 2
    assert "material.rock.porosity" in done.stderr
    assert not (tmp_path / "out").exists()


def test_output_without_a_name(percolith, strip, tmp_path):
    done = percolith("run", strip, *STEADY, "--output", "")
    assert done.returncode == 2, done.stderr
    assert done.stderr == ("error: --output: the name of the folder is empty; allowed: a new "
                           "folder\n")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["strip"]


def test_output_that_cannot_be_made(percolith, strip, tmp_path):
    (tmp_path / "file").write_text("")
    done = percolith("run", strip, *STEADY, "--output", "file/out")
    assert done.returncode in (2, 4)
    assert "file/out" in done.stderr
