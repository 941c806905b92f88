# SPDX-License-Identifier: BSD-3-Clause
"""What several verifications share: running examples, profiles as figures, orders."""

from __future__ import annotations

from pathlib import Path

import criteria
import matplotlib.pyplot as plt
import numpy as np
from percolith.plot import draw
from program import Result, run_case
from report import Chapter


def example_case(name: str) -> Path:
    return criteria.EXAMPLES / name / "case.toml"


def run_example(name: str, work: Path, label: str = "case", settings: dict | None = None,
                threads: int = 2) -> Result:
    """Runs an example, with replaced options, into `work/label`."""
    return run_case(example_case(name), work / label, settings, threads)


def check_criteria(chapter: Chapter, name: str, work: Path) -> Result:
    """Runs an example as shipped and adds a row a criterion."""
    result = run_example(name, work)
    for i, (quantity, value, limit) in enumerate(criteria.evaluate(name, result)):
        chapter.at_most(f"criterion_{i}", quantity, value, limit)
    return result


def check_example(chapter: Chapter, name: str, work: Path) -> Result:
    """Runs an example as shipped, adds a row a criterion and its field as a picture."""
    result = check_criteria(chapter, name, work)
    for path in draw(result.results, output=work / "field.png"):
        chapter.add_picture(path, "The field as `percolith plot` draws it", "field")
    return result


def expected_profiles(name: str) -> list[dict]:
    return criteria.read(name)["profile"]


def compare_figure(curves: list[tuple[str, np.ndarray, np.ndarray, np.ndarray]], xlabel: str,
                   ylabel: str, scale: float = 1.0, marks: int = 40, style: str = "-"):
    """Left: computed curves with the reference as circles; right: computed minus reference.
    `curves` holds (label, position, computed, reference) in SI, divided by `scale`; `style` is
    the style of the lines."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    colours = plt.cm.viridis(np.linspace(0, 0.85, len(curves)))
    for (label, x, computed, reference), colour in zip(curves, colours):
        left.plot(x, computed / scale, style, color=colour, label=label)
        every = max(1, len(x) // marks)
        left.plot(x[::every], reference[::every] / scale, "o", markersize=4, color=colour,
                  markerfacecolor="none")
        right.plot(x, (computed - reference) / scale, style, color=colour, label=label)
    left.plot([], [], "o", color="black", markerfacecolor="none", markersize=4, label="reference")
    right.set_title("Computed minus reference", fontsize=10)
    for axes in (left, right):
        axes.set_xlabel(xlabel)
        axes.set_ylabel(ylabel)
        axes.grid(alpha=0.3)
    left.legend(fontsize="small", frameon=False)
    return figure


def observed_order(sizes, errors) -> float:
    """Slope of log(error) over log(size), by least squares."""
    return float(np.polyfit(np.log(sizes), np.log(errors), 1)[0])
