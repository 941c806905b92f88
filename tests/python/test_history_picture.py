# SPDX-License-Identifier: BSD-3-Clause
"""The panel of rates can be read where the first moments let in far more than all later ones."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from percolith.history_picture import _draw_rates, lasting_range
from percolith.run_directory import Table
from percolith.units import Scale

TIME = np.linspace(0.0, 100.0, 201)


def panel(rate: np.ndarray):
    """The panel of one condition."""
    _, axes = plt.subplots()
    history = Table({"time_s": TIME, "boundary.left_m2_per_s": rate})
    _draw_rates(axes, history, Scale(1.0, "s"), {"boundary.left_m2_per_s": "boundary.left"})
    return axes


def test_what_lasts_counts_by_its_time():
    assert lasting_range(TIME, np.array([np.full(201, 2.0), np.full(201, -1.0)])) == (-1.0, 2.0)
    peak = 1.0 + 99.0 * np.exp(-TIME)
    assert lasting_range(TIME, peak[None])[1] < 10.0
    # Many rows in the first second are but a second.
    time = np.concatenate([np.linspace(0.0, 1.0, 1000), [50.0, 100.0]])
    rates = np.where(time < 1.0, 50.0, 1.0)
    assert lasting_range(time, rates[None]) == (0.0, 1.0)
    assert lasting_range(np.array([0.0]), np.array([[3.0]])) == (0.0, 3.0)
    assert lasting_range(TIME, np.array([np.full(201, np.nan)])) == (0.0, 0.0)


def test_a_moment_is_cut_off_and_told():
    axes = panel(2e-6 + 3e-4 * np.exp(-20.0 * TIME))
    assert axes.get_ylim()[1] < 5.0
    assert axes.get_ylabel() == "Rate into the model ($10^{\N{MINUS SIGN}6}$ m²/s)"
    (note,) = axes.texts
    assert note.get_text() == ("for moments beyond the panel: up to 3.02 × "
                               "$10^{\N{MINUS SIGN}4}$ m²/s")
    note = panel(-2e-6 - 3e-4 * np.exp(-20.0 * TIME)).texts[0].get_text()
    assert note.startswith("for moments beyond the panel: down to -3.02 × ")


@pytest.mark.parametrize("rate", [np.zeros(201), np.full(201, 1e-6), np.sin(TIME),
                                  np.where(TIME < 60.0, 1.0, 5.0), 2.0 + np.exp(-TIME)])
def test_rates_that_last_are_shown_whole(rate):
    axes = panel(rate)
    assert not axes.texts
    low, high = axes.get_ylim()
    shown = axes.lines[0].get_ydata()
    assert low <= shown.min() and shown.max() <= high
