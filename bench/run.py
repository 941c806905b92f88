#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmarks, prints their tables and writes build/bench/report.json.

Usage: run.py [NAME...], NAME a part of a benchmark's name; without one all are run. The programs
are those of `make bench`, or of the folder that the variable PERCOLITH_BENCH_PROGRAMS names.
Exit code 1 when a figure misses its limit or a program fails.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = Path(os.environ.get("PERCOLITH_BENCH_PROGRAMS", ROOT / "build/bench-programs/bin"))
REPORT = ROOT / "build/bench/report.json"
SIX_FRACTURES_LIMIT = 5.0  # s, on two threads
# Threads that wander lose what their processor had in its caches. They wait as they do for users: a
# thread that sleeps between two loops may take longer to wake up than the loop lasts.
ENVIRONMENT = {**os.environ, "OMP_PROC_BIND": "true"}


def processor() -> str:
    """The processor's name and the number of processors, as the system gives them."""
    names = [line.split(":", 1)[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines()
             if line.startswith("model name")]
    return f"{names[0] if names else 'unknown processor'}, {os.cpu_count()} processors"


def run_program(program: Path) -> list[dict]:
    """The figures of a benchmark program; its tables go to the terminal."""
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results.json"
        subprocess.run([program, results], check=True, env=ENVIRONMENT)
        return json.loads(results.read_text())


def run_six_fractures() -> list[dict]:
    """Wall time of the example of six fractures, three hours of flow, best of three runs."""
    seconds = []
    for _ in range(3):
        with tempfile.TemporaryDirectory() as folder:
            start = time.perf_counter()
            subprocess.run([PROGRAMS / "percolith", "run",
                            ROOT / "examples/six_fractures/case.toml", "--output",
                            Path(folder) / "results", "--threads", "2", "--quiet"],
                           check=True, env=ENVIRONMENT)
            seconds.append(time.perf_counter() - start)
    print(f"\nsix fractures, 3 h, whole program on 2 threads: {min(seconds):.3f} s "
          f"(at most {SIX_FRACTURES_LIMIT:g})")
    return [{"name": "program.six_fractures", "value": min(seconds), "unit": "s",
             "limit": SIX_FRACTURES_LIMIT, "sense": "max"}]


def passes(figure: dict) -> bool:
    """Whether a figure keeps its limit; one that is only reported always does."""
    if figure["sense"] == "max":
        return figure["value"] <= figure["limit"]
    if figure["sense"] == "min":
        return figure["value"] >= figure["limit"]
    return True


def print_limits(figures: list[dict]) -> None:
    print("\nfigures with a limit")
    for figure in figures:
        if figure["sense"] != "report":
            sign = "<=" if figure["sense"] == "max" else ">="
            verdict = "ok" if figure["pass"] else "MISSED"
            print(f"  {figure['name']:<46}{figure['value']:>10.3f} {sign} "
                  f"{figure['limit']:<6g}{verdict}")


def main() -> int:
    if not (PROGRAMS / "percolith").is_file():
        print(f"{PROGRAMS}: no benchmark programs; run `make bench`", file=sys.stderr)
        return 1
    benchmarks = {path.name.removeprefix("bench_"): (lambda path=path: run_program(path))
                  for path in sorted(PROGRAMS.glob("bench_*"))}
    benchmarks["six_fractures"] = run_six_fractures
    wanted = sys.argv[1:]
    chosen = [name for name in benchmarks if not wanted or any(part in name for part in wanted)]
    if not chosen:
        print(f"no benchmark is called {', '.join(wanted)}; there are: {', '.join(benchmarks)}",
              file=sys.stderr)
        return 1
    print(f"{processor()}; load {os.getloadavg()[0]:.1f}")
    figures = []
    failed = False
    for name in chosen:
        try:
            figures += benchmarks[name]()
        except subprocess.CalledProcessError as error:
            print(f"{name}: ended with exit code {error.returncode}", file=sys.stderr)
            failed = True
    figures = [{**figure, "pass": passes(figure)} for figure in figures]
    print_limits(figures)
    REPORT.parent.mkdir(parents=True, exist_ok=True)
    REPORT.write_text(json.dumps(figures, indent=1) + "\n")
    print(f"\n{REPORT.relative_to(ROOT)}: {len(figures)} figures")
    return 1 if failed or not all(figure["pass"] for figure in figures) else 0


if __name__ == "__main__":
    sys.exit(main())
