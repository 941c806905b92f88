# SPDX-License-Identifier: BSD-3-Clause
"""Fields are drawn by interpolated values, in colours of the colour map only."""

from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pytest
from percolith.field_picture import draw_field
from percolith.fine_triangles import LARGEST_COUNT, barycentric_parts, refine
from percolith.run_directory import Frame
from percolith.vtu import Grid

TWO = np.array([[[0.0, 0.0], [3.0, 0.0], [1.0, 2.0]], [[3.0, 0.0], [4.0, 2.0], [1.0, 2.0]]])


def area(corners):
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return 0.5 * (first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])


@pytest.mark.parametrize("number", [1, 2, 7])
def test_parts_are_equal_and_fill_the_triangle(number):
    parts = barycentric_parts(number)
    assert parts.shape == (number**2, 3, 3)
    assert parts.sum(axis=2) == pytest.approx(1.0)
    assert parts.min() >= 0.0
    assert area(parts @ TWO[0]) == pytest.approx(area(TWO[:1])[0] / number**2)
    assert len(np.unique(parts.mean(axis=1).round(9), axis=0)) == number**2


def test_values_are_those_of_the_linear_field():
    values = 2.0 + TWO @ np.array([0.3, -0.7])
    fine = refine(TWO, values, step=0.01)
    centroids = fine.corners.mean(axis=1)
    assert fine.values == pytest.approx(2.0 + centroids @ np.array([0.3, -0.7]))
    assert area(fine.corners).sum() == pytest.approx(area(TWO).sum())
    # A part spans a step at most.
    assert np.ptp(2.0 + fine.corners @ np.array([0.3, -0.7]), axis=1).max() <= 0.01 + 1e-12


def test_a_jump_between_triangles_stays():
    values = np.array([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]])
    fine = refine(TWO, values, step=0.01)
    assert sorted(fine.values) == [0.0, 1.0]


def test_only_steep_triangles_are_cut_and_never_into_too_many():
    corners = np.repeat(TWO[:1], 1000, axis=0)
    values = np.zeros((1000, 3))
    values[:10, 0] = 1.0
    assert len(refine(corners, values, step=0.1).values) == 990 + 10 * 10**2
    values[:, 0] = 1.0
    assert 0.5 * LARGEST_COUNT < len(refine(corners, values, step=1e-4).values) <= LARGEST_COUNT
    many = refine(corners, values, step=1e-4, largest_count=999)
    assert len(many.values) == 1000


def test_every_colour_drawn_lies_on_the_colour_map(tmp_path):
    """Saturation 0 on the left, 1 on the right: across the steep front, no blend of both ends."""
    points = np.array([[0, 0], [1, 0], [2, 0], [3, 0], [0, 2], [1, 2], [2, 2], [3, 2]], float)
    cells = np.array([[i, i + 1, i + 5] for i in range(3)] + [[i, i + 5, i + 4] for i in range(3)])
    saturation = (points[:, 0] > 1.5).astype(float)
    grid = Grid(points=points, cells=cells, point_data={"saturation": saturation}, cell_data={})
    run = SimpleNamespace(times=np.array([0.0]), is_steady=True, title="Front")
    path = draw_field(run, Frame(0.0, grid, None), "saturation", tmp_path / "front.png")
    pixels = (plt.imread(path)[:, :, :3] * 255).round().astype(int)
    height, width = pixels.shape[:2]
    drawn = pixels[height // 3:height // 2, width // 5:3 * width // 5].reshape(-1, 3)
    drawn = np.unique(drawn, axis=0)
    colour_map = (plt.get_cmap("viridis")(np.arange(256))[:, :3] * 255).round().astype(int)
    distance = np.abs(drawn[:, None] - colour_map[None]).max(axis=2).min(axis=1)
    assert len(drawn) > 100
    assert distance.max() <= 1


def test_no_part_is_too_small_to_be_painted():
    fine = refine(TWO[:1], np.array([[0.0, 0.0, 1.0]]), step=1e-3, smallest=0.1)
    longest = np.hypot(*(TWO[0] - np.roll(TWO[0], 1, axis=0)).T).max()
    assert len(fine.values) == int(longest / 0.1) ** 2
    coarse = refine(TWO[:1], np.array([[0.0, 0.0, 1.0]]), step=1e-3, smallest=100.0)
    assert len(coarse.values) == 1
