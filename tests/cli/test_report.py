# SPDX-License-Identifier: BSD-3-Clause
"""`percolith report` as a user meets it."""


def test_a_run_becomes_a_page(percolith, strip, tmp_path):
    assert percolith("run", strip, "--output", "results", "--set", "time.end=1 ms",
                     "--set", "output.times=[]").returncode == 0
    done = percolith("report", "results")
    assert done.returncode == 0, done.stderr
    assert done.stdout == "results/report.html\n"
    page = (tmp_path / "results/report.html").read_text(encoding="utf-8")
    assert "Transient flow through a strip" in page and "came to its end at 1 ms" in page


def test_a_folder_without_results(percolith, tmp_path):
    done = percolith("report", ".")
    assert done.returncode == 2
    assert done.stderr.startswith("percolith-report: error: .: not a run directory")
