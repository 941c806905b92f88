# SPDX-License-Identifier: BSD-3-Clause
"""The factor of displacements that pictures choose turns no triangle inside out and closes no
opening."""

import numpy as np
import pytest
from percolith.exaggeration import automatic_scale, factor_of_areas, factor_of_openings
from percolith.outline import openings_of, outline_of
from percolith.vtu import Grid

COUNT = 40  # squares along a side of a plate of 1 m


def plate(is_rock, moved) -> Grid:
    """A plate, of which the triangles remain whose centroids `is_rock` keeps. Displacements are
    `moved` of the places; every triangle has points of its own."""
    x, y = np.meshgrid(np.linspace(0, 1, COUNT + 1), np.linspace(0, 1, COUNT + 1))
    places = np.stack([x.ravel(), y.ravel()], axis=1)
    row, column = (part.ravel() for part in np.divmod(np.arange(COUNT**2), COUNT))
    a = row * (COUNT + 1) + column
    b, c, d = a + 1, a + COUNT + 2, a + COUNT + 1
    corners = places[np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])]
    corners = corners[is_rock(*corners.mean(axis=1).T)]
    points = corners.reshape(-1, 2)
    return Grid(points, np.arange(len(points)).reshape(-1, 3),
                {"displacement_m": moved(points)})


def all_of(matrix: Grid) -> np.ndarray:
    return np.ones(len(matrix.cells), bool)


def borehole(x, y):
    return np.hypot(x - 0.5, y - 0.5) > 0.05


def notch(x, y):
    return (np.abs(x - 0.5) > 0.025) | (y < 0.5)


def pinch(points):
    """Both sides of the middle move towards it by 0.01 mm, away from it less and less, so that the
    rock is hardly strained."""
    offset = points[:, 0] - 0.5
    return np.stack([-1e-5 * np.tanh(offset / 0.02), np.zeros(len(points))], axis=1)


def test_the_outline_has_the_walls_of_holes_too():
    matrix = plate(borehole, pinch)
    ends = matrix.points[outline_of(matrix).points]
    on_border = ((ends == 0.0) | (ends == 1.0)).any(axis=2).all(axis=1)
    assert on_border.sum() == 4 * COUNT
    assert (~on_border).sum() > 10 and (np.hypot(*(ends[~on_border] - 0.5).T).max() < 0.1)


def test_openings_are_measured_across_holes_and_notches():
    assert not len(openings_of(plate(lambda x, y: x > -1, pinch)).width)
    across = openings_of(plate(notch, pinch))
    upper = np.abs(across.direction[:, 0]) > 0.5
    assert across.width[upper] == pytest.approx(0.05)
    assert upper.sum() == COUNT and upper.all()  # the bottom of the notch faces the outside


@pytest.mark.parametrize("is_rock", [borehole, notch])
def test_openings_keep_half_of_their_width(is_rock):
    matrix = plate(is_rock, pinch)
    openings = openings_of(matrix)
    limit = factor_of_openings(matrix, openings, all_of(matrix))
    far, near = (matrix.points[ends] + limit * matrix.point_data["displacement_m"][ends]
                 for ends in (openings.far, openings.near))
    share = openings.share[:, None]
    lines = far[:, 0] + share * (far[:, 1] - far[:, 0]) - near.mean(axis=1)
    left = (lines * openings.direction).sum(axis=1) / openings.width
    assert left.min() == pytest.approx(0.5)
    assert automatic_scale(matrix) == 1000
    assert automatic_scale(plate(lambda x, y: x > -1, pinch)) == 2000  # 3 % of the plate: 3000


def test_an_opening_that_grows_does_not_matter():
    matrix = plate(borehole, lambda points: -pinch(points))
    assert factor_of_openings(matrix, openings_of(matrix), all_of(matrix)) == np.inf


def test_a_loose_piece_may_not_cross_the_opening():
    def falling(points):
        x, y = (points - [0.5, 0.75]).T
        return np.stack([1e-5 * ((np.abs(y) < 0.1) & (x < 0)), np.zeros(len(x))], axis=1)

    matrix = plate(notch, falling)
    limit = factor_of_openings(matrix, openings_of(matrix), all_of(matrix))
    assert limit == pytest.approx(0.025 / 1e-5)


@pytest.mark.parametrize("strain, limit", [
    ([[-1e-3, 0], [0, 0]], 800.0),
    ([[-1e-3, 0], [0, -1e-3]], 1000 * (1 - 0.2**0.5)),
    ([[-1e-3, 0], [0, 1e-3]], 1000 * 0.8**0.5),
    ([[0, 1e-3], [1e-3, 0]], 1000 * 0.8**0.5),
    ([[1e-3, 0], [0, 1e-3]], np.inf),
    ([[0, 1e-3], [0, 0]], np.inf),
    ([[0, -1e-3], [1e-3, 0]], np.inf),
])
def test_triangles_keep_a_fifth_of_their_area(strain, limit):
    matrix = plate(lambda x, y: x > -1, lambda points: points @ np.array(strain).T)
    found = factor_of_areas(matrix, all_of(matrix))
    assert found == pytest.approx(limit)
    if np.isfinite(limit):
        corners = (matrix.points + found * matrix.point_data["displacement_m"])[matrix.cells]
        one, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        area = 0.5 * (one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])
        assert area == pytest.approx(0.2 * 0.5 / COUNT**2)


def test_values_that_a_failed_run_lacks_set_no_limit():
    matrix = plate(notch, pinch)
    matrix.point_data["displacement_m"][:9] = np.nan
    assert np.isfinite(automatic_scale(matrix))


def test_the_narrowest_moment_of_a_series_counts():
    wide, narrow = (plate(notch, lambda points, s=s: s * pinch(points)) for s in (0.01, 4.0))
    alone = automatic_scale(wide)
    assert alone >= 1e5
    assert automatic_scale(wide, [narrow, wide]) == 200


def test_a_window_counts_what_it_shows():
    matrix = plate(notch, pinch)
    corner = np.array([[0.0, 0.0], [0.2, 0.2]])
    assert automatic_scale(matrix, window=corner) == 500  # 3 % of 0.2 m: 600
    beside = np.array([[0.0, 0.0], [0.44, 1.0]])
    assert automatic_scale(matrix, window=beside) == 2000  # without the notch
    whole = np.array([[0.0, 0.0], [1.0, 1.0]])
    assert automatic_scale(matrix, window=whole) == automatic_scale(matrix) == 1000
