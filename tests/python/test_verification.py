# SPDX-License-Identifier: BSD-3-Clause
"""The helpers of the verification: formulas against tables, measures, rows that fail."""

import json
from pathlib import Path

import numpy as np
import pytest
from percolith.run_directory import read_table

VERIFICATION = Path(__file__).resolve().parents[2] / "verification"


@pytest.mark.parametrize("time", [0.001, 0.01, 0.1, 0.2])
@pytest.mark.parametrize("name, table", [("semi_infinite", "single_fracture_semi_infinite.csv"),
                                         ("slab", "single_fracture_slab20.csv")])
def test_film_formulas_agree_with_the_tables(name, table, time):
    import formulas

    rows = read_table(VERIFICATION / "single_fracture" / table)
    computed = getattr(formulas, name)(rows["x_m"], time)
    assert computed == pytest.approx(rows[f"p_Pa_t{time}s"], rel=1e-6, abs=1.0)


def test_strip_and_radial_meet_their_boundary_values():
    import formulas

    assert formulas.strip([0.0, 1.0], 0.02) == pytest.approx([1e5, 0.0], abs=1e-6)
    assert formulas.strip(np.linspace(0, 1, 5), 10.0) == pytest.approx(np.linspace(1e5, 0, 5))
    assert formulas.radial([0.1, 1.0]) == pytest.approx([1e7, 1e6])
    slope = (formulas.radial(0.5001) - formulas.radial(0.4999)) / 2e-4
    assert slope == pytest.approx(float(formulas.radial_gradient(0.5)), rel=1e-6)


@pytest.mark.parametrize("time", [0.00147159, 0.0735795, 1.47159])
def test_consolidation_agrees_with_the_table(time):
    from poroelastic_formulas import Consolidation, PorousRock

    rows = read_table(VERIFICATION / "terzaghi" / "terzaghi.csv")
    column = Consolidation(PorousRock(), height=1.0, load=1e6)
    computed = column.pressure(rows["z_m"], time)
    assert computed == pytest.approx(rows[f"p_Pa_t{time}s"], rel=1e-5, abs=1.0)
    assert column.settlement(0.0735795)[0] == pytest.approx(4.0174e-5, rel=1e-5)
    assert column.settlement(1e4)[0] == pytest.approx(1e6 / PorousRock().oedometer)


@pytest.mark.parametrize("time", ["0.001472", "0.01472", "0.1472"])
def test_borehole_agrees_with_the_table(time):
    from poroelastic_formulas import Borehole, PorousRock

    rows = read_table(VERIFICATION / "borehole" / "borehole_wall_pressure.csv")
    hole = Borehole(PorousRock(), radius=0.1, pressure=1e6)
    radial, hoop = hole.stress(rows["r_m"], float(time))
    assert hole.pressure(rows["r_m"], float(time)) == pytest.approx(rows[f"p_t{time}s"], abs=100)
    assert radial == pytest.approx(rows[f"srr_t{time}s"], abs=100)
    assert hoop == pytest.approx(rows[f"stt_t{time}s"], abs=100)


def test_rock_with_pores_keeps_its_identities():
    from poroelastic_formulas import PorousRock

    rock = PorousRock(biot=0.8)
    assert PorousRock().diffusivity == pytest.approx(0.6795, rel=1e-3)
    assert PorousRock().eta == pytest.approx(0.375)
    # Sealed rock: no fluid enters, so its volume falls by what the pressure presses together.
    pressure = rock.undrained_pressure(-20e3)
    strain = rock.strain(-12e3, -8e3, pressure)
    assert pressure == pytest.approx(-rock.modulus * rock.biot * sum(strain))
    # Pressure all round and inside presses the grains alone.
    both = rock.strain(-1e4, -1e4, 1e4)
    assert both[0] == pytest.approx(-0.2 * 1e4 / (2 * rock.plane_bulk))


def test_cracks_that_a_fluid_opens():
    from fracture_formulas import PressedCrack, ToughnessCrack

    crack = PressedCrack(half=2.0, modulus=10e9)
    x = np.linspace(-2, 2, 20001)
    assert np.trapezoid(crack.opening(x, 1e6), x) == pytest.approx(crack.compliance * 1e6, rel=1e-5)
    assert crack.sealed_pressure(1e-3, 1e-9, 1e9) == pytest.approx(1e-3 / crack.compliance)
    driven = ToughnessCrack(rate=1e-4, toughness=1e6, modulus=32e9)
    assert driven.half_length(10.0) == pytest.approx(4.335, rel=1e-3)
    assert driven.width(10.0) == pytest.approx(1.468e-4, rel=1e-3)
    assert driven.pressure(10.0) == pytest.approx(2.710e5, rel=1e-3)
    # Its volume is what has been pumped.
    crack = PressedCrack(driven.half_length(10.0), 32e9)
    assert crack.compliance * driven.pressure(10.0) == pytest.approx(1e-3)


def test_stress_beside_a_pressed_crack():
    from fracture_formulas import PressedCrack

    crack = PressedCrack(half=0.5, modulus=1.0)
    beside = np.array([0.1, 0.4, 2.0])
    known = (1 + (0.5 / beside) ** 2) ** -1.5 - 1  # in the line through its middle
    for sign in (-1, 1):
        assert crack.normal_stress(0.0, sign * beside, 2e6) == pytest.approx(2e6 * known)
    assert crack.normal_stress([-0.4, 0.3], 0.0, 2e6) == pytest.approx(-2e6)  # on its faces
    ahead = 0.6 / np.sqrt(0.6**2 - 0.5**2) - 1
    assert crack.normal_stress([-0.6, 0.6], 0.0, 2e6) == pytest.approx(2e6 * ahead)


def test_crossing_of_an_interface():
    from fracture_formulas import crossing_friction, crossing_ratio

    assert crossing_ratio(0.5) == pytest.approx(1.05 / 1.06)
    assert crossing_friction(crossing_ratio([0.2, 0.8])) == pytest.approx([0.2, 0.8])
    assert np.isinf(crossing_friction(0.33))


def test_breakdown_bounds():
    import fracture_formulas as f

    stresses = (5.0, 7.0, 4.0, 1.0)
    assert f.breakdown_sealed_wall(*stresses) == 11.0
    assert f.breakdown_open_wall(*stresses, 0.375) == pytest.approx(9.0)
    assert f.breakdown_open_wall_by_total_stress(*stresses, 0.375) == pytest.approx(45.0)


def test_uplift_below_a_dam():
    from foundation_formulas import FlatDam

    dam, x = FlatDam(head=30.0, half=20.0), np.linspace(-19.9, 19.9, 400)
    assert dam.bare(0.0) == pytest.approx(15.0)
    for shallow in (dam.with_fracture(x, 1e-4), dam.with_wall(x, -12.0, 1e-4)):
        assert shallow == pytest.approx(dam.bare(x), abs=1e-3)
    # In the middle the axis has half the head anyway: a drain of this head changes nothing.
    assert dam.with_drain(x, 0.0, 12.0, 15.0) == pytest.approx(dam.bare(x), rel=1e-9)
    # Both ways to bring the head of the reservoir to the heel agree, the drain next to it.
    near = dam.with_drain(x[20:], -20.0 + 1e-3, 12.0, 30.0)
    assert near == pytest.approx(dam.with_fracture(x[20:], 12.0), abs=5e-3)
    # The two faces of a wall, where heel and toe are mapped to -208^0.5 and 1168^0.5.
    assert dam.with_wall(-12.0 - 1e-9, -12.0, 12.0) == pytest.approx(25.700, abs=1e-3)
    assert dam.with_wall(-12.0 + 1e-9, -12.0, 12.0) == pytest.approx(14.165, abs=1e-3)
    assert dam.discharge(1e-7, 100.0) == pytest.approx(1e-7 * 30 / np.pi * np.log(5 + 24**0.5))


def test_measures():
    import criteria

    values = criteria.Profile(np.arange(3.0), np.array([1.0, 2.0, 5.0]), np.array([1.0, 2.0, 3.0]))
    assert criteria.measure("maximum", values, 4.0) == 0.5
    assert criteria.measure("rms", values) == pytest.approx((4 / 3) ** 0.5)
    assert criteria.measure("rms_over_range", values) == pytest.approx((4 / 3) ** 0.5 / 2)
    assert criteria.measure("relative_sum", values) == pytest.approx(2 / 6)
    values.computed[0] = np.nan
    assert criteria.measure("rms", values) == float("inf")


def test_rows_beyond_their_limit_fail_and_reach_the_report(tmp_path):
    import report

    chapter = report.Chapter("case", "A case")
    chapter.at_most("small", "an error", 0.5, 1.0)
    chapter.at_least("order", "an order", 1.9, 1.8)
    assert chapter.passes
    chapter.at_most("nan", "no number", float("nan"), 1.0)
    chapter.at_least("low", "an order", 1.0, 1.8)
    assert not chapter.passes
    broken = report.Chapter("broken", "Broken", error="it broke <here>")
    assert not broken.passes
    assert not report.Chapter("empty").passes
    report.write([chapter, broken], tmp_path)
    rows = json.loads((tmp_path / "report.json").read_text())
    assert [(row["id"], row["pass"]) for row in rows] == [
        ("case.small", True), ("case.order", True), ("case.nan", False), ("case.low", False),
        ("broken.error", False)]
    assert set(rows[0]) == {"id", "quantity", "value", "limit", "sense", "pass"}
    page = (tmp_path / "index.html").read_text()
    assert "2 of 5 comparisons pass" in page and "it broke &lt;here&gt;" in page


@pytest.fixture
def history_run():
    from types import SimpleNamespace

    columns = {"up": np.array([0.0, 3.0, 1.0]), "down": np.array([0.0, -1.0, -2.0])}
    return SimpleNamespace(history=columns)


@pytest.mark.parametrize("criterion, value", [
    ({"columns": ["up"], "measure": "maximum", "expected": 4.0}, 0.25),
    ({"columns": ["up", "down"], "measure": "last", "scale": 2.0}, 0.5),
    ({"columns": ["down"], "measure": "minimum", "expected": -2.0}, 0.0)])
def test_criteria_on_the_history(history_run, criterion, value):
    import criteria

    assert criteria.history_value(criterion, history_run) == pytest.approx(value)


@pytest.mark.parametrize("criterion, value", [
    ({"measure": "outside", "axis": 90, "within": 45}, 0.25),
    ({"measure": "outside", "axis": 90, "within": 20}, 0.5),
    ({"measure": "reach", "axis": 90, "within": 45, "expected": 2.0}, 0.25),
    ({"measure": "outside", "axis": 0, "within": 45}, float("inf"))])
def test_criteria_on_broken_joints(criterion, value):
    import criteria
    from types import SimpleNamespace

    events = {"x_m": np.array([0.0, 0.0, 0.5, 1.0]), "y_m": np.array([3.0, -2.0, 1.0, 0.5])}
    assert criteria.event_value(criterion, SimpleNamespace(events=events)) == pytest.approx(value)


def test_settings_are_written_as_the_command_line_reads_them():
    from program import in_toml

    table = {"times": [0, 0.5], "values": [0, 5e6], "interpolation": "step"}
    assert in_toml(table) == '{ times = [0, 0.5], values = [0, 5000000.0], interpolation = "step" }'
    assert in_toml(None) == ""
    assert in_toml("elastic") == '"elastic"'


def test_formulas_of_solids():
    import solid_formulas as solid

    # Under equal stresses the wall moves by a p/(2 G); far out a ring is a hole.
    inward = solid.tunnel_wall_displacement([0.0, 1.0], -10e6, -10e6, 1.0, 10e9, 0.25)
    assert inward == pytest.approx([-1.25e-3, -1.25e-3])
    assert solid.ring_displacement(1.0, 10e6, 1.0, 1e6, 10e9, 0.25) == pytest.approx(1.25e-3)
    radial, hoop = solid.tunnel_stress(np.array([1.0, 1e4]), -15e6, -10e6, 1.0)
    assert radial == pytest.approx([0.0, -15e6], rel=1e-6, abs=1.0)
    assert hoop == pytest.approx([3 * -10e6 + 15e6, -10e6], rel=1e-6)
    assert solid.wave_speeds(10e9, 0.25, 2500.0) == pytest.approx([2190.89, 1264.91], rel=1e-5)
    assert solid.mohr_coulomb(5e6, 10e6, np.pi / 6) == pytest.approx(49.641e6, rel=1e-5)
    assert solid.slide_distance(2.0, np.radians(35), np.radians(30)) == pytest.approx(1.97453, 1e-4)
    assert solid.slide_distance(1.0, np.radians(25), np.radians(30)) == 0.0
    assert solid.plane_failure(1e6, np.radians(35), np.radians(35)) == pytest.approx(1.0)
    wet = solid.plane_failure(1e6, np.radians(30), np.radians(45), 0.1e6, 0.05e6)
    assert wet == pytest.approx((3**0.5 / 2 - 0.1 - 0.025) / (0.5 + 0.05 * 3**0.5 / 2))


def test_how_deep_a_hole_is_overstressed():
    import solid_formulas as solid

    assert solid.overstressed_depth(1.0, 1.0, 1.0) == pytest.approx(2**0.5)
    assert solid.overstressed_depth(1.0, 2.0, 5.1) == 1.0  # the wall has 3*2 - 1
    assert solid.overstressed_depth(1.0, 2.0, 0.9) == float("inf")
    depth = solid.overstressed_depth(12.5e6, 25e6, 26e6)
    radial, hoop = solid.tunnel_stress(depth, -12.5e6, -25e6, 1.0)
    assert radial - hoop == pytest.approx(26e6)
    # Pressure inside takes 2 p/r^2 off the difference.
    depth = solid.overstressed_depth(1.0, 1.0, 1.0, 0.5)
    assert depth == pytest.approx(1.0)
    assert solid.overstressed_depth(2.0, 2.0, 1.0, 0.5) == pytest.approx(3**0.5)


def test_how_wide_a_breakout_is():
    import solid_formulas as solid

    # Without friction the wall bears 2 c beside the pressure: 40 + 40 cos(2 a) - 0 = 60.
    assert solid.breakout_half_width(10.0, 30.0, 0.0, 30.0, 0.0) == pytest.approx(np.pi / 6)
    assert solid.breakout_half_width(10.0, 30.0, 0.0, 40.1, 0.0) == 0.0
    assert solid.breakout_half_width(10.0, 30.0, 10.0, 20.0, 0.0) == pytest.approx(np.pi / 6)


def test_beams_and_mixed_mode():
    import solid_formulas as solid

    beam = solid.DoubleCantilever(10e9, 0.2, 100.0, 0.1)
    opening = 1.2e-3
    length = beam.length(opening)
    assert beam.load(length) == pytest.approx(float(beam.elastic_load(opening, length)))
    assert beam.load(0.3) == pytest.approx(25456, rel=1e-4)
    for direction, energy in ((0.0, 100.0), (np.pi / 2, 200.0), (np.pi / 4, 300 / 2**0.5)):
        assert solid.mixed_energy(direction, 5e6, 10e6, 100.0, 200.0) == pytest.approx(energy)


def make_frame():
    from percolith.run_directory import Frame
    from percolith.vtu import Grid

    points = np.array([[0.0, 0.0], [2.0, 0.0], [0.0, 2.0], [2.0, 2.0]])
    velocity = np.array([[3.0, 0.0], [0.0, 0.0], [0.0, 3.0], [0.0, 6.0]])
    matrix = Grid(points, np.array([[0, 1, 2], [1, 3, 2]]), {"velocity_m_per_s": velocity})
    cracks = Grid(points, np.array([[1, 2], [0, 1]]), {}, {"mode": np.array([2, 0])})
    return Frame(0.0, matrix, cracks)


def test_modes_have_the_colours_of_other_pictures():
    import solid
    from percolith.crack_picture import MODES

    assert {number: (name, colour) for number, name, colour in solid.BROKEN} == {
        number: MODES[number] for number in (1, 2, 3)}


def test_sums_over_bodies():
    import solid

    frame = make_frame()
    assert solid.areas(frame) == pytest.approx([2.0, 2.0])
    assert solid.mean_of(frame, "velocity_m_per_s") == pytest.approx([0.5, 2.0])
    assert solid.mean_of(frame, "velocity_m_per_s", np.array([True, False])) == pytest.approx(
        [1.0, 1.0])
    broken = solid.broken_by_mode(frame)
    assert broken["shear"] == pytest.approx(np.array([[1.0, 1.0]]))
    assert len(broken["tensile"]) == 0
