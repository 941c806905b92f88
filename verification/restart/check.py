# SPDX-License-Identifier: BSD-3-Clause
"""Runs that are killed at random times and resumed leave the same bits as one without interruption.
"""

import json
import os
import random
import shutil
import signal
import subprocess
import time
from pathlib import Path

from program import ProgramError, program, run_case
from report import Chapter

TITLE = "Restart: killed runs that go on leave the same bits"
CASES = ("rock", "water", "pumped", "slow")
TRIALS = 34  # of each case
MOST_KILLS = 4  # in a trial


def outputs(folder: Path) -> dict[str, bytes | dict]:
    """Every file of a run with its content, but for the log and what the summary says of times on
    the wall."""
    files = {str(f.relative_to(folder)): f.read_bytes() for f in sorted(folder.rglob("*"))
             if f.is_file() and f.name not in ("run.log", "summary.json")}
    summary = json.loads((folder / "summary.json").read_text())
    del summary["wall_time_s"]
    return {**files, "summary.json": summary}


class Trial:
    """One run that is killed again and again, at random, by SIGKILL or SIGTERM."""

    def __init__(self, case: Path, folder: Path, seconds: float, seed: int):
        self.fresh = [str(program()), "run", str(case), "--output", str(folder), "--force"]
        self.go_on = [str(program()), "run", "--resume", str(folder)]
        self.folder = folder
        self.seconds = seconds
        self.random = random.Random(seed)
        self.kills = self.resumes = 0

    def run(self) -> dict[str, bytes | dict]:
        shutil.rmtree(self.folder, ignore_errors=True)
        while not self.attempt(may_be_killed=self.kills < MOST_KILLS):
            self.kills += 1
        return outputs(self.folder)

    def attempt(self, may_be_killed: bool) -> bool:
        """Starts the run or goes on with it; true where it came to its end."""
        can_go_on = (self.folder / "checkpoint.bin").exists()
        self.resumes += can_go_on
        command = [*(self.go_on if can_go_on else self.fresh), "--threads", "1", "--quiet"]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   text=True, env={**os.environ, "OMP_WAIT_POLICY": "passive"})
        if may_be_killed:
            time.sleep(self.random.uniform(0.0, self.seconds))
            process.send_signal(self.random.choice([signal.SIGKILL, signal.SIGTERM]))
        _, said = process.communicate(timeout=600)
        # After a signal that came too late, or before the run began to listen for it.
        if process.returncode not in (0, -signal.SIGKILL, -signal.SIGTERM, 128 + signal.SIGTERM):
            raise ProgramError(f"{' '.join(command)}: exit code {process.returncode}\n{said}")
        if may_be_killed:
            self.learn(process.returncode == 0)
        return process.returncode == 0

    def learn(self, has_ended: bool) -> None:
        """Kills sooner after runs that ended before, and later after those that had no checkpoint:
        how long a run takes depends on what else the machine does."""
        if has_ended:
            self.seconds *= 0.8
        elif not (self.folder / "checkpoint.bin").exists():
            self.seconds *= 1.2


def check(chapter: Chapter, work: Path) -> None:
    for name in CASES:
        case = Path(__file__).with_name(f"{name}.toml")
        reference = run_case(case, work / name, threads=1)
        expected = outputs(work / name)
        trials = []
        different = []
        seconds = reference.wall_time
        for seed in range(TRIALS):
            trial = Trial(case, work / f"{name}_killed", seconds, seed)
            found = trial.run()
            seconds = trial.seconds
            different += [f for f in {*expected, *found} if expected.get(f) != found.get(f)]
            trials.append(trial)
        chapter.at_most(f"{name}.files", f"{name}: files that differ, of {len(expected)} in each of "
                        f"{TRIALS} trials{': ' if different else ''}{', '.join(different)}",
                        len(different), 0)
        chapter.at_least(f"{name}.resumes", f"{name}: times a run went on from a checkpoint",
                         sum(trial.resumes for trial in trials), TRIALS)
