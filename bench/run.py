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
THREE_CRACKS_LIMIT = 30.0  # s, on two threads
THREE_CRACKS_TRIANGLES = 15202
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


def coupled_run(end: str, threads: int) -> tuple[dict, float]:
    """Summary and wall time (s) of the three-crack example, 10 ms or less of injection."""
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results"
        start = time.perf_counter()
        subprocess.run([PROGRAMS / "percolith", "run", ROOT / "examples/three_cracks/case.toml",
                        "--output", results, "--threads", str(threads), "--quiet",
                        "--set", f"time.end={end}", "--set", "output.interval=",
                        "--set", "output.history_interval=0.1 ms",
                        "--set", "model.joint_stress=effective"],
                       check=True, env=ENVIRONMENT, stderr=subprocess.DEVNULL)
        return json.loads((results / "summary.json").read_text()), time.perf_counter() - start


# What is spent in the loop over the steps, by the names of `wall_time_s`.
COUPLED_PHASES = {"rock": ("joints", "closed joints", "triangles and motion", "contact search",
                           "contact force", "breakage"),
                  "pores": ("pore flow", "pore contents"),
                  "cracks": ("crack flow", "crack openings", "crack pressure")}


def coupled_phases(end: str) -> tuple[dict, dict]:
    """ns a triangle and step by phase and by loop, on one thread; the best of three runs."""
    best = {}, {}
    for _ in range(3):
        summary, _ = coupled_run(end, 1)
        work = summary["steps"] * THREE_CRACKS_TRIANGLES * 1e-9
        loops = {part: summary["wall_time_s"].get(part, 0.0) / work
                 for parts in COUPLED_PHASES.values() for part in parts}
        phases = {phase: sum(loops[part] for part in parts)
                  for phase, parts in COUPLED_PHASES.items()}
        if not best[0] or sum(phases.values()) < sum(best[0].values()):
            best = phases, loops
    return best


def run_three_cracks() -> list[dict]:
    """Time a triangle and step of the coupled loop, intact and while cracks grow, by phase on one
    thread; and the whole program for 10 ms of injection on two."""
    figures = []
    for name, end in (("intact", "0.6 ms"), ("10 ms", "10 ms")):
        phases, loops = coupled_phases(end)
        total = sum(phases.values())
        print(f"\nthree cracks, {name}, one thread, ns a triangle and step: {total:.1f}")
        for phase, parts in COUPLED_PHASES.items():
            print(f"  {phase:<7} {phases[phase]:6.1f}  "
                  + ", ".join(f"{part} {loops[part]:.1f}" for part in parts))
        limit = {"limit": 50.0, "sense": "max"} if name == "intact" else {"sense": "report"}
        figures.append({"name": f"coupled.{name}.total", "value": total, "unit": "ns", **limit})
        figures.append({"name": f"coupled.{name}.cracks", "value": phases["cracks"] / total,
                        "unit": "share", "limit": 0.15, "sense": "max"})
    seconds = min(coupled_run("10 ms", 2)[1] for _ in range(2))
    print(f"three cracks, 10 ms of injection, whole program on 2 threads: {seconds:.1f} s "
          f"(at most {THREE_CRACKS_LIMIT:g})")
    figures.append({"name": "program.three_cracks", "value": seconds, "unit": "s",
                    "limit": THREE_CRACKS_LIMIT, "sense": "max"})
    return figures


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
    benchmarks["three_cracks"] = run_three_cracks
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
