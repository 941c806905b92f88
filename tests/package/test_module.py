# SPDX-License-Identifier: BSD-3-Clause
"""`python -m percolith` is the command line."""

import os
import subprocess
import sys
from importlib import metadata

import percolith
import percolith.__main__ as module
import pytest
from conftest import ROOT

STRIP = ROOT / "examples/strip/case.toml"
SHORT = ("--set", "time.end=5 ms", "--set", "output.times=[]", "--quiet")


@pytest.fixture
def command(program):
    """command(*arguments) runs the module with the program of the tests on the PATH."""
    folder = os.path.dirname(program("--version").args[0])

    def run(*arguments, path=folder):
        return subprocess.run([sys.executable, "-m", "percolith", *map(str, arguments)],
                              capture_output=True, text=True, check=False, timeout=120,
                              env={**os.environ, "PATH": path})

    return run


def test_without_arguments_it_tells_its_version(command):
    done = command()
    assert done.returncode == 0 and not done.stderr
    assert done.stdout.startswith(f"percolith {percolith.__version__}; python -m percolith --help")


def test_help_names_all_commands(command, program):
    text = command("--help").stdout
    assert text.startswith(f"percolith {percolith.__version__}, ")
    told = program("--help").stdout
    for name in ("run", "check", "schema", "new", "plot", "report"):
        assert f"\n  {name} " in text and name in told
    assert max(map(len, text.splitlines())) <= 102


@pytest.mark.parametrize("arguments", [("--version",), ("schema",), ("check", STRIP),
                                       ("check", "nowhere.toml"), ("rum", STRIP)])
def test_the_program_gets_the_arguments(command, program, arguments):
    ours, its = command(*arguments), program(*arguments)
    assert (ours.returncode, ours.stdout, ours.stderr) == (its.returncode, its.stdout, its.stderr)


def test_a_case_is_run_and_drawn(command, tmp_path):
    assert command("run", STRIP, "--output", tmp_path / "out", *SHORT).returncode == 0
    assert percolith.open_run(tmp_path / "out").summary["outcome"] == "finished"
    drawn = command("plot", tmp_path / "out", path="/nowhere")
    assert drawn.returncode == 0 and (tmp_path / "out/pressure.png").is_file()
    page = command("report", tmp_path / "out", "--output", tmp_path / "page.html", path="/nowhere")
    assert page.returncode == 0 and (tmp_path / "page.html").is_file()
    wrong = command("plot", tmp_path, path="/nowhere")
    assert wrong.returncode == 2 and "not a run directory" in wrong.stderr


def test_a_package_without_its_program_says_so(monkeypatch, tmp_path, capsys):
    def absent(name):
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(module, "__file__", str(tmp_path / "a/b/__main__.py"))
    monkeypatch.setattr(module.importlib.metadata, "files", absent)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert module.main(["run", str(STRIP)]) == 4
    assert "there is no program percolith beside this package" in capsys.readouterr().err
    assert module.main(["--version"]) == 0
    assert capsys.readouterr().out == f"percolith {percolith.__version__}\n"


def test_the_program_of_the_build_comes_first(monkeypatch, tmp_path):
    for folder in ("build/bin", "other"):
        (tmp_path / folder).mkdir(parents=True)
        (tmp_path / folder / "percolith").write_text("#!/bin/sh\n")
        (tmp_path / folder / "percolith").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path / "other"))
    monkeypatch.setattr(module, "__file__", str(tmp_path / "build/python/percolith/__main__.py"))
    assert module.find_program() == tmp_path / "build/bin/percolith"
    (tmp_path / "build/bin/percolith").chmod(0o644)
    monkeypatch.setattr(module.importlib.metadata, "files", lambda name: None)
    assert module.find_program() == tmp_path / "other/percolith"
