# SPDX-License-Identifier: BSD-3-Clause
"""Histories of many conditions: the largest are named, the panel keeps its room."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from percolith.history_picture import draw_curves, largest_curves
from percolith.run_directory import Table
from percolith.units import Scale

TIME = np.linspace(0.0, 1.0, 200)


def panel(count: int, name: str = "source.injection_well_number_{}_in_the_northern_field"):
    """The lower of two panels, with so many curves of which the last is the largest."""
    names = [name.format(i) for i in range(count)]
    history = Table({"time_s": TIME} | {one: -(i + 1.0) * TIME for i, one in enumerate(names)})
    figure, grid = plt.subplots(2, 2, figsize=(11, 7), layout="constrained")
    draw_curves(grid[1, 1], history, Scale(1.0, "s"), {one: one for one in names},
                Scale(1.0, "m²/s"), "Rate into the model")
    figure.canvas.draw()
    return grid[1, 1]


@pytest.mark.parametrize("count", [12, 40])
def test_many_long_names_leave_room_for_the_panel(count):
    axes = panel(count)
    assert len(axes.lines) == count
    names = [text.get_text() for text in axes.get_legend().get_texts()]
    assert len(names) == 4 and names[-1] == f"{count - 3} others, smaller"
    assert names[2] == f"source.injection_well_number_{count - 1}_in_the_northern_field"
    box, legend = axes.get_window_extent(), axes.get_legend().get_window_extent()
    assert box.height > 0.25 * axes.figure.bbox.height
    assert axes.yaxis.label.get_window_extent().y1 < legend.y0 + 0.25 * legend.height


def test_many_short_names_are_named_up_to_four_rows():
    names = [text.get_text() for text in panel(30, "well {}").get_legend().get_texts()]
    assert len(names) == 20 and names[0] == "well 11" and names[-1] == "11 others, smaller"


def test_few_are_all_named_in_their_order():
    names = [text.get_text() for text in panel(4).get_legend().get_texts()]
    assert [name.split("_")[3] for name in names] == ["0", "1", "2", "3"]


def test_the_largest_by_what_is_finite():
    table = Table({"a": np.array([np.nan, 1.0]), "b": np.array([-3.0, 0.0]),
                   "c": np.array([np.inf, 2.0]), "d": np.array([np.nan, np.nan])})
    assert largest_curves(table, ["a", "b", "c", "d"], 2) == ["b", "c"]
