# SPDX-License-Identifier: BSD-3-Clause
"""Version, help, commands that are programs of their own, and mistakes on the command line."""

import os
import subprocess
from pathlib import Path

import pytest


def write_program(path: Path, text: str) -> None:
    path.write_text("#!/bin/sh\n" + text)
    path.chmod(0o755)


def test_version(percolith):
    done = percolith("--version")
    assert done.returncode == 0
    assert done.stdout.startswith("percolith ")
    assert "compiled by " in done.stdout
    assert done.stderr == ""


@pytest.mark.parametrize("command", ["run", "check", "schema", "new"])
def test_help_shows_an_example(percolith, command):
    done = percolith(command, "--help")
    assert done.returncode == 0
    assert f"Example: percolith {command}" in done.stdout


def test_help_names_commands_and_exit_codes(percolith):
    text = percolith("--help").stdout
    for word in ["run", "check", "schema", "new", "percolith plot DIR", "percolith report DIR",
                 "Exit codes: 0 success"]:
        assert word in text


def test_no_command(percolith):
    done = percolith()
    assert done.returncode == 2
    assert done.stderr == ("error: no command given; allowed: run, check, schema, new, "
                           "plot, report; see percolith --help\n")


def test_unknown_command_names_the_nearest(percolith):
    done = percolith("chekc", "case.toml")
    assert done.returncode == 2
    assert done.stderr.startswith("error: unknown command chekc, did you mean check?; allowed: ")
    assert done.stdout == ""


def test_unknown_option_names_the_nearest(percolith):
    done = percolith("run", "case.toml", "--outptu", "x")
    assert done.returncode == 2
    assert done.stderr == ("error: unknown argument --outptu, did you mean --output?; "
                           "see percolith run --help\n")


@pytest.mark.parametrize("threads", ["0", "-1", "two"])
def test_threads_must_be_a_positive_number(percolith, threads):
    done = percolith("run", "case.toml", f"--threads={threads}")
    assert done.returncode == 2
    assert f"--threads: Value {threads} not in range 1 to 1024" in done.stderr


def test_command_on_the_path_gets_arguments_and_gives_exit_code(percolith, tmp_path):
    write_program(tmp_path / "percolith-hello", 'echo "hello $1 $2"; exit 7\n')
    path = f"{tmp_path}:{os.environ['PATH']}"
    done = percolith("hello", "two words", "--help", env={"PATH": path})
    assert done.returncode == 7
    assert done.stdout == "hello two words --help\n"
    assert "hello" in percolith("helo", env={"PATH": path}).stderr


def test_command_next_to_the_program_comes_first(percolith, program, tmp_path):
    own = program.parent / "percolith-selftest"
    (tmp_path / "elsewhere").mkdir()
    write_program(tmp_path / "elsewhere/percolith-selftest", "echo path\n")
    try:
        write_program(own, "echo own\n")
        path = f"{tmp_path / 'elsewhere'}:{os.environ['PATH']}"
        assert percolith("selftest", env={"PATH": path}).stdout == "own\n"
    finally:
        own.unlink()


def test_a_path_is_no_command(percolith, tmp_path):
    write_program(tmp_path / "percolith-x", "echo no\n")
    done = percolith("../x")
    assert done.returncode == 2
    assert "unknown command ../x" in done.stderr


def test_full_standard_output_is_an_error(program):
    with open("/dev/full", "w") as full:
        done = subprocess.run([program, "schema"], stdout=full, stderr=subprocess.PIPE, text=True,
                              check=False)
    assert done.returncode == 4
    assert done.stderr == ("error: cannot write to the standard output: "
                           "No space left on device\n")
