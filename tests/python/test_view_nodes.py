# SPDX-License-Identifier: BSD-3-Clause
"""Which points of the rock the view of a report draws as one, and how it closes what cracks leave
open where they meet."""

import numpy as np
from percolith.reporting.nodes import hubs, joined_points, nodes_of
from percolith.vtu import Grid

MIDDLE = np.array([0.5, 0.5])
CORNERS = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


def square() -> Grid:
    """Four triangles around the middle of a square, each with points of its own; the middle is the
    first of each."""
    points = np.concatenate([[MIDDLE, CORNERS[i], CORNERS[(i + 1) % 4]] for i in range(4)])
    return Grid(points, np.arange(12).reshape(4, 3))


def cracks(*numbers: int) -> Grid:
    """Cracks from the middle to some of the corners."""
    ends = np.concatenate([[MIDDLE, CORNERS[i]] for i in numbers])
    return Grid(ends, np.arange(len(ends)).reshape(-1, 2))


def test_points_hang_together_where_nothing_has_broken():
    whole = joined_points(square(), [])
    assert len(np.unique(whole)) == 5
    assert (whole[::3] == 0).all()


def test_a_crack_parts_its_corner_but_not_its_tip():
    joined = joined_points(square(), [cracks(1)])
    assert (joined[::3] == 0).all()
    assert joined[2] != joined[4]  # both at the corner where the crack comes out
    assert len(np.unique(joined)) == 6


def test_cracks_of_all_times_part_nodes():
    nodes = nodes_of(square(), [cracks(1), cracks(3)])
    middle = nodes.node[::3]
    assert middle[1] == middle[2] != middle[0] == middle[3]
    values = np.arange(12.0)
    assert not nodes.holds(values)
    assert nodes.means(values)[middle[1]] == 4.5
    assert nodes.holds(nodes.means(values)[nodes.node])


def test_where_three_cracks_meet_the_space_between_is_closed():
    matrix = square()
    for numbers, count in (((0, 2), 0), ((0, 1, 2), 1), ((0, 1, 2, 3), 2)):
        corners, at = hubs(matrix, joined_points(matrix, [cracks(*numbers)]))
        assert len(corners) == len(at) == count
        assert (matrix.points[corners] == MIDDLE).all() and (matrix.points[at] == MIDDLE).all()
        assert all(len(set(row)) == 3 for row in corners.tolist())
