# SPDX-License-Identifier: BSD-3-Clause
"""Which reactions `loading.png` shows: those that load the rock, not what rounding leaves."""

import numpy as np
import pytest
from percolith.loading_picture import load_curves
from percolith.run_directory import Table

SHARE = np.linspace(0.0, 1.0, 50)
FORCE, MOVED = 2e6, 1e-4  # N/m, m


def history(share_of_force: float, share_of_motion: float, **more: float) -> Table:
    """Fluid does the work of FORCE over MOVED; a boundary has these shares of both."""
    columns = {"time_s": SHARE, "fluid_work_J_per_m": FORCE * MOVED * SHARE**2,
               "boundary.wall.reaction_x_N_per_m": share_of_force * FORCE * SHARE,
               "boundary.wall.displacement_x_m": share_of_motion * MOVED * SHARE}
    return Table(columns | {name: value * SHARE for name, value in more.items()})


def test_rounding_is_no_load():
    # What a well under pressure leaves: 20 N/m over 0.5 µm, where its fluid does 250 J/m.
    assert load_curves(history(1e-5, 5e-3)) == []
    # And in a coarse mesh: 760 N/m over 3 µm, where 590 J/m come in.
    assert load_curves(history(1e-3, 4e-3)) == []


@pytest.mark.parametrize("force, motion", [(1.0, 1.0), (1e-2, 1.0), (1e-2, 1e-2)])
def test_a_load_is_shown_beside_fluid_that_does_more(force, motion):
    (curve,) = load_curves(history(force, motion))
    assert curve.name == "boundary.wall, x" and curve.reaction[-1] == force * FORCE


@pytest.mark.parametrize("energy", ["elastic_J_per_m", "gravity_J_per_m", "external_work_J_per_m"])
def test_every_energy_of_the_rock_counts(energy):
    small = {"fluid_work_J_per_m": 0.0}
    assert len(load_curves(history(1e-5, 5e-3, **small))) == 1
    assert load_curves(history(1e-5, 5e-3, **small, **{energy: -FORCE * MOVED})) == []


def test_what_damping_takes_does_not_count():
    assert len(load_curves(history(1.0, 1.0, damping_J_per_m=1e9 * FORCE * MOVED))) == 1


def test_values_that_a_failed_run_lacks_do_not_count():
    table = history(1.0, 1.0)
    table["fluid_work_J_per_m"][-1] = np.nan
    assert len(load_curves(table)) == 1
