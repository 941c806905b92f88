# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the head show where the water is and where none is."""

from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pytest
from percolith.colour_range import ColourRange
from percolith.flow_fields import is_dry, rock_values
from percolith.head_picture import _split, draw_head
from percolith.reporting import view_fields
from percolith.run_directory import Frame
from percolith.units import Scale
from percolith.vtu import Grid

METRES = Scale(1.0, "m")


def tank(level: float, rows: int = 8) -> Frame:
    """A square metre of rock in which water rests at `level` (m)."""
    x, y = np.meshgrid(np.linspace(0, 1, rows + 1), np.linspace(0, 1, rows + 1))
    points = np.stack([x.ravel(), y.ravel()], axis=1)
    first = np.array([row * (rows + 1) + column for row in range(rows) for column in range(rows)])
    up = first + rows + 1
    cells = np.concatenate([np.stack([first, first + 1, up], 1),
                            np.stack([first + 1, up + 1, up], 1)])
    height = points[:, 1]
    pressure = 1e4 * np.maximum(level - height, 0.0)
    saturation = np.where(height <= level + 1e-9, 1.0, 0.2)
    return Frame(0.0, Grid(points, cells, {"pressure_Pa": pressure,
                                           "head_m": height + pressure / 1e4,
                                           "saturation": saturation}, {}, 0.0), None)


def drawn(frame: Frame, low: float, high: float):
    """The axes and the entries of the legend."""
    _, axes = plt.subplots()
    handles = draw_head(axes, frame, frame.matrix.points, ColourRange(low, high, METRES))
    return axes, [handle.get_label() for handle in handles]


def area(polygon: np.ndarray) -> float:
    x, y = polygon.T
    return 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))


def test_colours_span_the_rock_that_is_full():
    frame = tank(0.5)
    assert np.nanmax(rock_values(frame, "head")) == pytest.approx(0.5)
    assert np.isnan(rock_values(frame, "head")[is_dry(frame.matrix)]).all()
    assert np.isfinite(rock_values(frame, "pressure")).all()
    # Without any water there is nothing else to span.
    assert np.nanmax(rock_values(tank(-1.0), "head")) == 1.0


@pytest.mark.parametrize("level", [0.5, 0.55, 0.6])
def test_dry_rock_lies_above_the_water_table(level):
    axes, labels = drawn(tank(level), 0.0, 1.0)
    assert labels[-2:] == ["not full of water", "water table"]
    dry, table = axes.collections[-2:]
    parts = [path.vertices[:-1] for path in dry.get_paths()]
    assert sum(map(area, parts)) == pytest.approx(1.0 - level, abs=0.08)
    ends = np.concatenate(table.get_segments())
    assert np.ptp(ends[:, 0]) == pytest.approx(1.0)
    assert np.abs(ends[:, 1] - level).max() < 0.125  # an element


def test_full_rock_has_lines_of_equal_head_alone():
    frame = tank(2.0)
    frame.matrix.point_data["head_m"] = 5.0 * frame.matrix.points[:, 0]
    axes, labels = drawn(frame, 0.0, 5.0)
    assert labels == ["equal head, every 0.5 m"]
    (lines,) = axes.collections
    middle = [path.vertices[:, 0].mean() for path in lines.get_paths() if len(path.vertices)]
    assert middle == pytest.approx(np.arange(0.5, 5.0, 0.5) / 5.0)


def test_parts_of_triangles_meet_in_the_line():
    corners = np.array([[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]])
    for wetness, size in [([-1.0, 1.0, 1.0], 0.125), ([1.0, -1.0, -1.0], 0.375),
                          ([-1.0, -1.0, -1.0], 0.5), ([1.0, 1.0, 1.0], 0.0)]:
        parts, line = _split(corners, np.array([wetness]))
        assert sum(map(area, parts)) == pytest.approx(size)
        assert len(line) == (0.0 < size < 0.5)
        if len(line):
            assert sorted(map(tuple, line[0])) == [(0.0, 0.5), (0.5, 0.0)]


def test_of_a_run_with_a_water_table(run_example):
    run = run_example("dam", time__end="1 hour", output__times=[600]).results
    axes = run.plot("head")
    labels = [text.get_text() for text in axes.figure.legends[0].get_texts()]
    assert {"not full of water", "water table"} <= set(labels)
    # The bar ends at the head of the lake, not at the crest.
    assert axes.figure.axes[1].get_ylim()[1] == pytest.approx(5.0)
    assert not run.plot("pressure").figure.legends


def test_the_view_of_a_report_has_the_head_of_dry_rock_too():
    """Where it has no value the page tells of a rigid body."""
    run = SimpleNamespace(has_flow=True, has_mechanics=False, path="run", resolved={})
    frame = tank(0.5)
    assert is_dry(frame.matrix).any()
    head = view_fields.rock_field(run, [frame], "head", 1.0)
    assert head.at_points
    np.testing.assert_array_equal(view_fields.rock_values(frame, "head"),
                                  frame.matrix.point_data["head_m"])
