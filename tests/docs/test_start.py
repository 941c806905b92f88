# SPDX-License-Identifier: BSD-3-Clause
"""The start page does what it says: its files are saved, its commands are run, in its order."""

import json
import os
import re
import subprocess

import markdown_text

from conftest import ROOT

PAGE = (ROOT / "docs/start.md").read_text(encoding="utf-8")
# What needs a bare machine, root and a network is run by `make test-fresh`.
FRESH = ["apt install make git", "make demo"]


def blocks():
    return markdown_text.blocks(PAGE)


def test_every_block_is_a_file_to_save_or_commands_to_run():
    for block in blocks():
        saved = re.search(r"Save this as `([\w.]+)`:$", block.before)
        assert (block.language == "sh") != bool(saved), f"docs/start.md:{block.line}"


def test_what_needs_a_bare_machine_is_run_on_one():
    fresh = (ROOT / "tools/test_fresh.sh").read_text(encoding="utf-8")
    assert "apt-get -q -y install make git" in fresh
    assert "targets=(demo test)" in fresh
    assert blocks()[0].text.splitlines() == FRESH


def as_script() -> str:
    """The page as one script, in which every file is written where the page says to save it."""
    parts = ["set -e"]
    for block in blocks()[1:]:
        saved = re.search(r"`([\w.]+)`:$", block.before)
        if block.language == "sh":
            parts.append(block.text)
        else:
            parts.append(f"cat >{saved[1]} <<'END_OF_FILE'\n{block.text}END_OF_FILE")
    return "\n".join(parts)


def summary(folder) -> dict:
    return json.loads((folder / "summary.json").read_text())


def test_the_page_runs_and_says_what_comes_out(program, tmp_path):
    search = f"{program.parent}:{ROOT / '.venv/bin'}:{os.environ['PATH']}"
    done = subprocess.run(["bash", "-c", as_script()], cwd=tmp_path, check=False, text=True,
                          capture_output=True, timeout=400, env={**os.environ, "PATH": search})
    assert done.returncode == 0, done.stdout + done.stderr
    rock = tmp_path / "my_rock"
    for picture in ("results/pressure.png", "results/history.png", "results/crack_growth.png",
                    "longer.png", "stiffer.png"):
        assert (rock / picture).is_file(), picture
    # The mistake of the page is refused, and nothing is left of it.
    assert "porosity = 20" in done.stderr and done.stdout.endswith("as it should\n")
    assert not (rock / "case.results").exists()

    first, longer, stiffer = (summary(rock / name) for name in ("results", "longer", "stiffer"))
    broken = [run["mechanics"]["broken_joints"] for run in (first, longer, stiffer)]
    assert 4 <= broken[0] <= 16 and 0 <= broken[1] < broken[0] and broken[2] > broken[1]
    told = re.findall(r"(\d\.\d) MPa", re.sub(r"```.*?```", "", PAGE, flags=re.DOTALL))
    peaks = [run["mechanics"]["peak_pressures"]["source.pump"]["pressure_Pa"] / 1e6
             for run in (first, longer, stiffer)]
    for said, peak in zip(told, peaks, strict=True):
        assert abs(float(said) - peak) < 0.15 * peak
