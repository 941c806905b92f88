# SPDX-License-Identifier: BSD-3-Clause
"""Times as texts, with the units of the simulator and without it."""

import pytest
from percolith import quantity, times


@pytest.mark.parametrize("text", ["10 ms", "2 day", "2 days", "5 us", "1.5e-1 s", "3 h", "3 hours",
                                  "2 min", "-1 s", "4 weeks", "1 year", ".5 d", "1 µs", "20", " 1ms"])
def test_units_are_the_same_without_the_simulator(text, monkeypatch):
    known = quantity(text, "s")
    assert times.seconds(text) == known
    monkeypatch.setattr(times.importlib.util, "find_spec", lambda name: None)
    assert times.seconds(text) == pytest.approx(known, rel=1e-14)


@pytest.mark.parametrize("text, reason", [
    ("noon", "does not begin with a number"),
    ("nan", "not a finite time"), ("inf", "not a finite time")])
def test_reasons_are_the_same_without_the_simulator(text, reason, monkeypatch):
    for _ in range(2):
        with pytest.raises(ValueError, match=f"^{reason}$"):
            times.seconds(text)
        monkeypatch.setattr(times.importlib.util, "find_spec", lambda name: None)


def test_units_that_are_none_of_time(monkeypatch):
    with pytest.raises(ValueError, match='^the unit "MPa" is not one of time$'):
        times.seconds("2 MPa")
    monkeypatch.setattr(times.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(ValueError, match='^the unit "ns" is not one of time that is read here: '
                                         'us, µs, ms, s, .*week, year$'):
        times.seconds("2 ns")
