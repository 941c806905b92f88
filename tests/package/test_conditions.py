# SPDX-License-Identifier: BSD-3-Clause
"""Conditions of the flow that are changed while a simulation waits."""

import percolith
import pytest
from conftest import ROOT
from test_simulation import results


def test_a_rate_and_a_pressure_are_changed(strip, coupled):
    simulation = strip.simulation()
    simulation.advance(steps=5)
    simulation.set_condition("boundary.left.pressure", "250 kPa")
    simulation.advance(steps=1)
    assert simulation.flow.pressure.max() == pytest.approx(2.5e5)
    simulation.advance()
    assert simulation.mass_balance["relative_error"] < 1e-12

    simulation = coupled.simulation()
    simulation.advance(steps=20)
    let_in = simulation.values()["source.lower.volume_m2"]
    simulation.set_condition("source.lower.rate", 0)
    simulation.advance(steps=20)
    values = simulation.values()
    assert values["source.lower.volume_m2"] == let_in > 0
    assert values["source.lower_m2_per_s"] == 0 < values["source.upper_m2_per_s"]


@pytest.mark.parametrize("name, option, value", [("strip", "boundary.left.pressure", 3e4),
                                                 ("coupled", "source.middle.rate", 3e-2)])
def test_a_run_with_a_changed_condition_goes_on_to_the_same_bits(name, option, value, tmp_path,
                                                                 request):
    case = request.getfixturevalue(name)

    def change(simulation):
        simulation.advance(steps=5)
        simulation.set_condition(option, value)

    with case.simulation(tmp_path / "whole") as simulation:
        change(simulation)
        simulation.advance()
    with case.simulation(tmp_path / "parts") as simulation:
        change(simulation)
        simulation.advance(steps=4)
    percolith.resume(tmp_path / "parts")
    assert results(tmp_path / "parts") == results(tmp_path / "whole")
    with case.simulation() as unchanged:
        unchanged.advance()
        assert unchanged.state_hash != simulation.state_hash
    assert f"{option} was set to {value:g}\n" in (tmp_path / "parts/run.log").read_text()


@pytest.mark.parametrize("option, value, message", [
    ("boundary.left.head", 1.0, r"boundary.left.head: no condition of the flow has this option; "
                                r"allowed: boundary.left.pressure, "),
    ("left", 1.0, "left: no condition of the flow"),
    ("boundary.left.pressure", float("nan"), "boundary.left.pressure = nan: not a finite number"),
    ("boundary.left.pressure", -1.0, "below the cavitation pressure; allowed: .* at least 0 Pa"),
    ("boundary.left.pressure", "3 m", "3 m.*a unit of pressure"),
    ("boundary.left.presure", "3 Pa", "there is no such option; did you mean"),
])
def test_conditions_that_cannot_be_are_refused(strip, option, value, message):
    strip["fluid.cavitation_pressure"] = 0
    simulation = strip.simulation()
    before = simulation.state_hash
    with pytest.raises(percolith.CaseError, match=message):
        simulation.set_condition(option, value)
    simulation.advance(steps=3)
    untouched = strip.simulation()
    assert untouched.state_hash == before
    untouched.advance(steps=3)
    assert untouched.state_hash == simulation.state_hash


def test_a_condition_that_presses_on_the_rock_as_well_is_refused(mechanics):
    well = percolith.Case.load(ROOT / "examples/pressurised_well/case.toml").simulation()
    with pytest.raises(percolith.CaseError, match="boundary.wall.pressure: .*presses on the rock"):
        well.set_condition("boundary.wall.pressure", 5e6)
    with pytest.raises(percolith.CaseError, match="this run has none that can be changed"):
        mechanics.simulation().set_condition("boundary.top.pressure", 0)
