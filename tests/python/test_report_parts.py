# SPDX-License-Identifier: BSD-3-Clause
"""What the page of a run is made of: numbers with units, packed arrays, the text of the input."""

import tomllib
from types import SimpleNamespace

import numpy as np
import pytest
from percolith.reporting.outcome import outcome_of
from percolith.reporting.packed import STEPS, pack, pack_rounded, unpack
from percolith.reporting.quantities import number_text, quantity_text, unit_of, unit_text
from percolith.reporting.resolved_text import read_resolved
from percolith.reporting.tables import option_tables


@pytest.mark.parametrize("value, unit, text", [
    (5.5e10, "Pa", "55 GPa"), (0.0, "Pa", "0 Pa"), (-2.5e6, "Pa", "\u22122.5 MPa"),
    (1e-13, "m2", "10\u207b\u00b9\u00b3 m\u00b2"), (2e-4, "m", "200 \u00b5m"), (3.2, "m", "3.2 m"),
    (5.0294e-7, "s", "502.94 ns"), (4.5e-4, "s", "450 \u00b5s"), (7200.0, "s", "2 h"),
    (np.pi / 6, "rad", "30\u00b0"), (1e-9, "m/(Pa s)", "10\u207b\u2079 m/(Pa s)"), (7, "", "7"),
    (float("inf"), "s", "∞ s")])
def test_quantities(value, unit, text):
    assert quantity_text(value, unit).replace("\N{NO-BREAK SPACE}", " ") == text


def test_numbers_and_units():
    assert number_text(1234567) == "1234567"
    assert number_text(-2.22e-16).replace("\N{NO-BREAK SPACE}", " ") == "\u22122.22 × 10⁻¹⁶"
    assert unit_text("$10^{\N{MINUS SIGN}3}$ m/s") == "10⁻³ m/s"
    assert unit_text("J/m2") == "J/m²"
    names = ("in_m2", "rate_m2_per_s", "fragments")
    assert [unit_of(name) for name in names] == ["m²", "m²/s", ""]


@pytest.mark.parametrize("values, kind", [
    ([0.1, float("nan"), -3e38, 0.0], "float32"), ([5, 0, 4294967295, 7], "uint32"),
    ([], "float32"), ([], "uint32")])
def test_arrays_are_unpacked_to_the_same_bits(values, kind):
    array = np.array(values, kind)
    packed = pack(array, kind)
    assert packed.length == len(values)
    assert unpack(packed).tobytes() == array.tobytes()


@pytest.mark.parametrize("values", [
    [2.0, -3.0, float("nan"), 7.0, 1.23456], [5.0, 5.0], [float("nan")], []])
def test_rounded_arrays_lose_half_a_step(values):
    packed = pack_rounded(np.array(values))
    step = np.nanmax(values) - np.nanmin(values) if np.isfinite(values).any() else 0.0
    assert packed.length == len(values)
    assert unpack(packed) == pytest.approx(values, rel=1e-6, abs=0.51 * step / STEPS, nan_ok=True)


RESOLVED = """format = 1
title = "a  # b"

[material.one]
regions = ["x  # y"]
density = 2500.0  # kg/m3
permeability = [1e-13, 2e-13, 0.0]  # m2
joints = "breakable"
# cohesion is not given

[material.two]
regions = ["z"]
density = 2600.0  # kg/m3

[boundary.top]
fixed = false
velocity_y = { times = [0.0, 5e-04], values = [0.0, -0.04], interpolation = "linear" }  # m/s

[time]
end = 2.0  # s

# Derived values
# version of percolith = 0.1.0 (abc)
# triangles = 42
# smallest edge = 0.5 m
# limit of the explicit step by joints = 2e-07 s
# limit of the explicit step by contact = 1e-07 s
# limit of the explicit step by all together = 9e-08 s
"""


def test_the_text_of_the_input():
    text = read_resolved(RESOLVED)
    assert text.units == {("material", "density"): "kg/m3", ("material", "permeability"): "m2",
                          ("boundary", "velocity_y"): "m/s", ("time", "end"): "s"}
    assert [(one.name, one.value, one.unit) for one in text.derived] == [
        ("version of percolith", "0.1.0 (abc)", ""), ("triangles", 42, ""),
        ("smallest edge", 0.5, "m")]
    assert list(text.single_limits) == ["contact", "joints"] and text.together == 9e-8


def test_tables_of_options():
    rocks, boundaries, time = option_tables(tomllib.loads(RESOLVED), read_resolved(RESOLVED))
    assert rocks.head == ["", "one", "two"]
    rows = {row[0]: row[1:] for row in rocks.rows}
    assert rows["density"] == ["2500 kg/m³", "2600 kg/m³"]
    assert rows["permeability"][1] == "" and rows["joints"] == ["breakable", ""]
    assert rows["permeability"][0].startswith("10⁻¹³ m²")
    assert boundaries.rows == [["velocity y", "0 m/s at 0 s; −0.04 m/s at 500 µs"]]
    assert time.head == [] and time.rows == [["end", "2 s"]]


@pytest.mark.parametrize(("more", "how"), [
    ({}, "came to its end"), ({"reached_rest": True}, "came to rest"),
    ({"reached_rest": True, "change_over_throughput": 1e-4}, "settled"),
    ({"reached_rest": False, "change_over_throughput": 0.5}, "came to its end")])
def test_how_a_run_ended(more, how):
    run = SimpleNamespace(has_summary=True, is_steady=False, summary={"end_time_s": 2e-3, **more})
    assert outcome_of(run).text == f"The run {how} at 2 ms."
