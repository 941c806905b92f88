# SPDX-License-Identifier: BSD-3-Clause
"""Runs that cannot go on: a full disk, values that are not numbers, a reader that has gone."""

import json
import os
import resource
import shutil
import signal
import subprocess

import pytest

from conftest import SHORT, files_of


def limit_file_size(size):
    """Lets no file grow beyond `size` bytes in the process to be started."""

    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))

    return limit


def test_file_size_limit_ends_the_run_and_keeps_what_was_written(percolith, strip, tmp_path):
    assert percolith("run", strip, *SHORT, "--output", "whole").returncode == 0
    whole = files_of(tmp_path / "whole")
    # The fields fit; the probe outgrows the limit with its last rows.
    limit = len(whole["probes/centre.csv"]) - 10
    done = percolith("run", strip, *SHORT, "--set", "output.fields=false", "--output", "cut",
                     preexec_fn=limit_file_size(limit))
    assert done.returncode == 4, done.stderr
    assert done.stderr.startswith("error: cut/probes/centre.csv: cannot write the file: File too "
                                  "large; raise the file size limit (ulimit -f)"), done.stderr
    cut = files_of(tmp_path / "cut")
    for name, content in cut.items():
        if name.endswith(".csv"):
            assert content.endswith(b"\n")
            assert whole[name].startswith(content)
    assert not [name for name in cut if name.endswith(".part")]
    summary = json.loads(cut["summary.json"])
    assert summary["outcome"] == "failed"
    assert "File too large" in summary["reason"]


def test_full_disk_ends_the_run_and_keeps_what_was_written(program, strip, tmp_path):
    """On a file system of 150 kB, where the system lets us mount one."""
    if shutil.which("unshare") is None:
        pytest.skip("no unshare")
    disk = tmp_path / "disk"
    disk.mkdir()
    script = ('mount -t tmpfs -o size=152k none "$1" || exit 99\n'
              'program="$2"; case="$3"; disk="$1"; shift 3\n'
              '"$program" run "$case" --output "$disk/out" --quiet "$@"\n'
              'code=$?; cp -r "$disk/out" "$disk/../copy"; exit $code\n')
    done = subprocess.run(["unshare", "--user", "--map-root-user", "--mount", "sh", "-c", script,
                           "sh", disk, program, strip, "--set", "time.step=1 ms", "--set",
                           "output.times=", "--set", "output.interval=1 ms"],
                          capture_output=True, text=True, check=False, timeout=120,
                          env={**os.environ, "OMP_WAIT_POLICY": "passive"})
    if done.returncode in (1, 99):
        pytest.skip("cannot mount a file system here: " + done.stderr)
    assert done.returncode == 4, done.stderr
    assert "No space left on device; free some space or choose another --output" in done.stderr
    copy = files_of(tmp_path / "copy")
    listed = copy["matrix.pvd"].decode().count("<DataSet ")
    assert 1 <= listed < 20
    for i in range(listed):
        assert copy[f"fields/matrix_{i:06}.vtu"].endswith(b"</VTKFile>\n")
    assert not [name for name in copy if name.endswith(".part")]


def test_a_value_that_is_no_number_ends_the_run(percolith, strip, tmp_path):
    (strip.parent / "jump.csv").write_text("time_s,pressure_Pa\n0,1e5\n0.0102,1e5\n0.0104,1e308\n")
    done = percolith("run", strip, *SHORT, "--set", "material.rock.permeability=1e3 m2",
                     "--set", 'boundary.left.pressure={ file = "jump.csv" }',
                     "--output", "out")
    assert done.returncode == 3, (done.stdout, done.stderr)
    assert done.stderr.splitlines()[-1].startswith("error: ")
    summary = json.loads((tmp_path / "out/summary.json").read_text())
    assert summary["outcome"] == "failed"
    assert summary["reason"] in done.stderr
    assert 0.01 <= summary["end_time_s"] < 0.02
    # Frames up to the last good output time are there.
    assert (tmp_path / "out/matrix.pvd").read_text().count("<DataSet ") >= 4
    assert "nan" not in (tmp_path / "out/probes/centre.csv").read_text()
    assert "error: " + summary["reason"] in (tmp_path / "out/run.log").read_text()


def test_too_little_memory_ends_the_run(percolith, strip, tmp_path):
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (2**30, 2**30))

    line = "{ from = [0, 0], to = [1, 0], points = 1000000 }"
    probes = [word for i in range(40) for word in ("--set", f"probe.line{i}={line}")]
    done = percolith("run", strip, *SHORT, *probes, "--threads", "1", "--output", "out",
                     preexec_fn=limit)
    assert done.returncode == 3, (done.stdout, done.stderr)
    assert done.stderr == ("error: not enough memory for this model; use a coarser mesh, fewer "
                           "outputs, or a machine with more memory\n")


def test_a_reader_that_has_gone_does_not_end_the_run(program, strip, tmp_path):
    process = subprocess.Popen([program, "run", strip, *SHORT], cwd=tmp_path,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.close()
    assert process.wait(timeout=60) == 0, process.stderr.read()
    process.stderr.close()
    assert json.loads((tmp_path / "case.results/summary.json").read_text())["outcome"] == "finished"
