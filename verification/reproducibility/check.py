# SPDX-License-Identifier: BSD-3-Clause
"""Runs with one and two threads give the same bits."""

import hashlib
from pathlib import Path

from report import Chapter
from studies import run_example

TITLE = "Reproducibility: the same bits for any number of threads"


def fingerprint(folder: Path) -> dict[str, str]:
    """Hash of every field, probe, history, event and fragment file of a run."""
    files = sorted([*folder.glob("fields/*.vtu"), *folder.glob("probes/*.csv"),
                    *folder.glob("*.csv")])
    return {str(f.relative_to(folder)): hashlib.sha256(f.read_bytes()).hexdigest() for f in files}


def check(chapter: Chapter, work: Path) -> None:
    variants = {
        "six_fractures": {},
        "radial": {},
        "single_fracture": {"time.scheme": "explicit", "time.step": 1e-6, "time.end": 0.005,
                            "output.times": []},
        "double_fracture": {"model.pore_joints": "finite"},
        "compression": {"time.end": 3.2e-3},  # past its strength
        "rubble": {"time.end": 0.4},
    }
    for name, settings in variants.items():
        runs = [run_example(name, work, f"{name}_{n}", settings, threads=n) for n in (1, 2)]
        prints = [fingerprint(run.results.path) for run in runs]
        different = sum(prints[0][f] != prints[1].get(f) for f in prints[0])
        different += abs(len(prints[0]) - len(prints[1]))
        hashes = {run.results.summary["state_hash"] for run in runs}
        chapter.at_most(f"{name}.files", f"{name}: files that differ between 1 and 2 threads, of "
                        f"{len(prints[0])}", different, 0)
        chapter.at_most(f"{name}.state", f"{name}: different state hashes beyond one",
                        len(hashes) - 1, 0)
