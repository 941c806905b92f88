# SPDX-License-Identifier: BSD-3-Clause
"""How far cracks have run."""

import crack_paths
import numpy as np
import pytest


def lines(*ends):
    return np.array(ends, dtype=float)


def test_what_does_not_hang_together_is_left_out():
    broken = lines([(0, 0), (1, 0)], [(1, 0), (2, 1)], [(5, 0), (6, 0)])
    reached = crack_paths.branches(broken, {"crack": [(0, 0)]})["crack"]
    assert sorted(map(tuple, reached)) == [(0, 0), (1, 0), (2, 1)]


def test_a_bridge_between_two_cracks_is_shared_by_the_shorter_way():
    broken = lines([(0, 0), (0, 1)], [(0, 1), (0, 2)], [(0, 2), (0, 3)])
    reached = crack_paths.branches(broken, {"low": [(0, 0)], "high": [(0, 3)]})
    assert sorted(map(tuple, reached["low"])) == [(0, 0), (0, 1)]
    assert sorted(map(tuple, reached["high"])) == [(0, 2), (0, 3)]


def test_a_crack_may_go_on_beside_its_tip():
    broken = lines([(0, 0), (1, 0)], [(1.05, 0.05), (2, 0)], [(2.5, 0), (3, 0)])
    reached = crack_paths.branches(broken, {"crack": [(0, 0)]}, bridge=0.1)["crack"]
    assert max(reached[:, 0]) == pytest.approx(2)


def test_a_crack_that_has_not_grown_has_its_start():
    reached = crack_paths.branches(np.empty((0, 2, 2)), {"crack": [(1, 2)]})["crack"]
    assert reached.tolist() == [[1, 2]]


def test_round_off_in_places_does_not_part_lines():
    broken = lines([(0, 0), (1, 0)], [(1 + 1e-9, 0), (2, 0)])
    assert len(crack_paths.branches(broken, {"crack": [(0, 0)]})["crack"]) == 3


@pytest.mark.parametrize("tip, angle", [((1, 1), 45), ((1, -1), -45), ((0, 0), 0)])
def test_deflection(tip, angle):
    assert crack_paths.deflection((0, 0), tip) == pytest.approx(angle)
