# SPDX-License-Identifier: BSD-3-Clause
"""The helpers of the verification: formulas against tables, measures, rows that fail."""

import json
from pathlib import Path

import numpy as np
import pytest
from percolith.run_directory import read_table

VERIFICATION = Path(__file__).resolve().parents[2] / "verification"


@pytest.mark.parametrize("time", [0.001, 0.01, 0.1, 0.2])
@pytest.mark.parametrize("name, table", [("semi_infinite", "single_fracture_semi_infinite.csv"),
                                         ("slab", "single_fracture_slab20.csv")])
def test_film_formulas_agree_with_the_tables(name, table, time):
    import formulas

    rows = read_table(VERIFICATION / "single_fracture" / table)
    computed = getattr(formulas, name)(rows["x_m"], time)
    assert computed == pytest.approx(rows[f"p_Pa_t{time}s"], rel=1e-6, abs=1.0)


def test_strip_and_radial_meet_their_boundary_values():
    import formulas

    assert formulas.strip([0.0, 1.0], 0.02) == pytest.approx([1e5, 0.0], abs=1e-6)
    assert formulas.strip(np.linspace(0, 1, 5), 10.0) == pytest.approx(np.linspace(1e5, 0, 5))
    assert formulas.radial([0.1, 1.0]) == pytest.approx([1e7, 1e6])
    slope = (formulas.radial(0.5001) - formulas.radial(0.4999)) / 2e-4
    assert slope == pytest.approx(float(formulas.radial_gradient(0.5)), rel=1e-6)


def test_measures():
    import criteria

    values = criteria.Profile(np.arange(3.0), np.array([1.0, 2.0, 5.0]), np.array([1.0, 2.0, 3.0]))
    assert criteria.measure("maximum", values, 4.0) == 0.5
    assert criteria.measure("rms", values) == pytest.approx((4 / 3) ** 0.5)
    assert criteria.measure("rms_over_range", values) == pytest.approx((4 / 3) ** 0.5 / 2)
    assert criteria.measure("relative_sum", values) == pytest.approx(2 / 6)
    values.computed[0] = np.nan
    assert criteria.measure("rms", values) == float("inf")


def test_rows_beyond_their_limit_fail_and_reach_the_report(tmp_path):
    import report

    chapter = report.Chapter("case", "A case")
    chapter.at_most("small", "an error", 0.5, 1.0)
    chapter.at_least("order", "an order", 1.9, 1.8)
    assert chapter.passes
    chapter.at_most("nan", "no number", float("nan"), 1.0)
    chapter.at_least("low", "an order", 1.0, 1.8)
    assert not chapter.passes
    broken = report.Chapter("broken", "Broken", error="it broke <here>")
    assert not broken.passes
    assert not report.Chapter("empty").passes
    report.write([chapter, broken], tmp_path)
    rows = json.loads((tmp_path / "report.json").read_text())
    assert [(row["id"], row["pass"]) for row in rows] == [
        ("case.small", True), ("case.order", True), ("case.nan", False), ("case.low", False),
        ("broken.error", False)]
    assert set(rows[0]) == {"id", "quantity", "value", "limit", "sense", "pass"}
    page = (tmp_path / "index.html").read_text()
    assert "2 of 5 comparisons pass" in page and "it broke &lt;here&gt;" in page
