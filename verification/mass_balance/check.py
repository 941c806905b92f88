# SPDX-License-Identifier: BSD-3-Clause
"""Mass balance of partly saturated flow, by both schemes."""

from pathlib import Path

from report import Chapter
from studies import run_example

TITLE = "Mass balance: partly saturated pores and cracks"
LIMIT = 1e-12


def check(chapter: Chapter, work: Path) -> None:
    dry = {"initial.saturation": 0.3}
    variants = {
        "strip_implicit": ("strip", dry),
        "strip_explicit": ("strip", dry | {"time.scheme": "explicit"}),
        "strip_finite": ("strip", dry | {"model.pore_joints": "finite"}),
        "six_implicit": ("six_fractures", {"initial.saturation": 0.9, "time.end": 3600,
                                           "initial.crack_saturation": 0, "output.times": [360]}),
        "single_explicit": ("single_fracture", {"initial.saturation": 0.999, "time.end": 0.01,
                                                "time.scheme": "explicit", "time.step": 1e-6,
                                                "output.times": []}),
    }
    for label, (name, settings) in variants.items():
        result = run_example(name, work, label, settings)
        lowest = result.results.history["minimum_saturation"].min()
        chapter.at_most(label, f"{name}, {label.split('_')[1]}, lowest saturation {lowest:.3g}: "
                        "mass balance error", result.balance, LIMIT)
