# SPDX-License-Identifier: BSD-3-Clause
"""The figure of a model: all that is written fits, whatever the shape of the model."""

from types import SimpleNamespace

import numpy as np
import pytest
from matplotlib.lines import Line2D
from percolith.model_figure import ModelFigure


WORDS = ["Principal stress 1", "t = 3 s", "displacements × 1000"]
NAME = "A column of rock with a long name is pressed between two platens until it breaks"


def model_of(height: float, second_bar: bool = False) -> ModelFigure:
    view = SimpleNamespace(window=np.array([[0.0, 0.0], [1.0, height]]), is_part=True)
    model = ModelFigure(view, second_bar)
    for label in ["Effective principal stress 1, most tensile (MPa)"] * (1 + second_bar):
        model.colour_bar(model.axes.scatter([0.5], [0.1], c=[1.0]), label)
    model.legend([Line2D([], [], label="broken from the start (4)"),
                  Line2D([], [], label="longest arrow: 2.81 × $10^{-3}$ m/s")])
    model.title(NAME, WORDS)
    model.figure.canvas.draw()
    return model


@pytest.mark.parametrize("second_bar", [False, True])
@pytest.mark.parametrize("height", [1 / 30, 0.2, 0.46, 0.5, 0.62, 0.8, 1.0, 1.3, 2.0, 3.0, 5.0,
                                    30.0])
def test_all_that_is_written_lies_inside_the_figure(height, second_bar):
    model = model_of(height, second_bar)
    whole = model.figure.bbox
    texts = [model.axes.title, model.axes.xaxis.label, model.axes.yaxis.label,
             *(label for axes in model.figure.axes for label in axes.get_yticklabels()),
             *(axes.yaxis.label for axes in model.figure.axes),
             *(axes.xaxis.label for axes in model.figure.axes),
             *model.figure.legends[0].get_texts()]
    for box in (text.get_window_extent() for text in texts if text.get_text()):
        assert whole.x0 <= box.x0 and box.x1 <= whole.x1
        assert whole.y0 <= box.y0 and box.y1 <= whole.y1


@pytest.mark.parametrize("height", [1 / 30, 0.2, 1.0, 3.0, 5.0, 30.0])
def test_labels_of_ticks_do_not_touch(height):
    axes = model_of(height).axes
    for axis, side, shown in ((axes.xaxis, 0, axes.get_xlim()), (axes.yaxis, 1, axes.get_ylim())):
        ends = sorted(tuple(label.get_window_extent().get_points()[:, side])
                      for label, place in zip(axis.get_ticklabels(), axis.get_ticklocs())
                      if shown[0] <= place <= shown[1])
        assert len(ends) >= 1
        assert all(one[1] < other[0] for one, other in zip(ends, ends[1:]))


def test_bars_beside_tall_models_are_long():
    for height in (3.0, 30.0):
        axes, bar = (part.get_window_extent() for part in model_of(height).figure.axes)
        assert bar.height > 0.5 * axes.height and 10 < bar.width < 40
        assert bar.x0 - axes.x1 > 4


def test_a_part_of_a_title_stays_whole():
    lines = model_of(30.0).axes.get_title().split("\n")
    assert lines[-2:] == ["Principal stress 1, t = 3 s", "displacements × 1000"]
    assert model_of(0.5).axes.get_title().split("\n")[-1] == ", ".join(WORDS)
