# SPDX-License-Identifier: BSD-3-Clause
"""The progress line on a pseudo terminal."""

import os
import pty
import re
import select
import signal
import subprocess
import time

from conftest import ENDLESS, SHORT


def run_on_terminal(command, cwd, seconds=None):
    """Runs `command` on a pseudo terminal, for `seconds` if given; returns exit code and text."""
    master, slave = pty.openpty()
    process = subprocess.Popen(command, cwd=cwd, stdout=slave, stderr=slave, stdin=slave,
                               env={**os.environ, "OMP_WAIT_POLICY": "passive"})
    os.close(slave)
    text = b""
    start = time.monotonic()
    interrupted = False
    while True:
        if seconds is not None and not interrupted and time.monotonic() - start > seconds:
            process.send_signal(signal.SIGINT)
            interrupted = True
        ready, _, _ = select.select([master], [], [], 0.1)
        if ready:
            try:
                part = os.read(master, 65536)
            except OSError:
                break
            if not part:
                break
            text += part
        elif process.poll() is not None:
            break
        assert time.monotonic() - start < 100
    os.close(master)
    return process.wait(), text.decode()


def test_line_is_redrawn_in_place(program, strip, tmp_path):
    code, text = run_on_terminal([program, "run", strip, *ENDLESS], tmp_path, seconds=2.0)
    assert code == 130
    drawn = re.findall(r"\rstep (\d+)  time [^\r]*", text)
    assert 3 <= len(drawn) <= 25  # at most five a second
    assert [int(step) for step in drawn] == sorted(int(step) for step in drawn)
    assert "ETA" in text
    assert "step size" in text
    # The line has gone before the last words.
    assert re.search(r"\r\x1b\[Kinterrupted by SIGINT at time", text)


def test_line_gives_way_to_the_end(program, strip, tmp_path):
    code, text = run_on_terminal([program, "run", strip, *SHORT], tmp_path)
    assert code == 0
    assert re.search(r"\r\x1b\[Kboundary.left: \S+ m2/s into the rock\r\nboundary.right: .*\r\n"
                     r"finished at time 0.02 s after \d+ steps", text)


def test_quiet_draws_nothing(program, strip, tmp_path):
    assert run_on_terminal([program, "run", strip, *SHORT, "--quiet"], tmp_path) == (0, "")
