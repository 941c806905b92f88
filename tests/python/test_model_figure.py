# SPDX-License-Identifier: BSD-3-Clause
"""The figure of a model: all that is written fits, whatever the shape of the model."""

from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pytest
from percolith.model_figure import ModelFigure


@pytest.mark.parametrize("height", [0.2, 0.46, 0.5, 0.62, 0.8, 1.0, 1.3])
def test_title_and_label_lie_inside_the_figure(height):
    view = SimpleNamespace(window=np.array([[0.0, 0.0], [1.0, height]]), is_part=True)
    model = ModelFigure(view)
    model.colour_bar(model.axes.scatter([0.5], [0.1], c=[1.0]), "Displacement (m)")
    model.axes.set_title("A block slides\nDisplacement, t = 3 s, true to scale", fontsize=11)
    model.figure.canvas.draw()
    whole = model.figure.bbox
    title, label = (text.get_window_extent() for text in (model.axes.title, model.axes.xaxis.label))
    plt.close(model.figure)
    assert title.y1 <= whole.y1 and label.y0 >= whole.y0
