# SPDX-License-Identifier: BSD-3-Clause
"""Numbers with their units as a reader expects them: 55 GPa, 1.2 × 10⁻¹³ m²."""

from __future__ import annotations

import math
import re

from percolith.units import Scale, length_scale, pressure_scale, time_scale

_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_DIGITS = 5
_TIMES = "\N{NO-BREAK SPACE}×\N{NO-BREAK SPACE}"

# Endings of the names of results, longer ones before those they end with.
_ENDINGS = [("_m2_per_s", "m²/s"), ("_m_per_s", "m/s"), ("_J_per_m", "J/m"), ("_N_per_m", "N/m"),
            ("_m2", "m²"), ("_Pa", "Pa"), ("_s", "s"), ("_m", "m")]


def unit_text(unit: str) -> str:
    """A unit with raised powers: m2 becomes m². Of pictures, $10^{-3}$ m/s becomes 10⁻³ m/s."""
    unit = re.sub(r"\$10\^\{([^}]*)\}\$",
                  lambda match: "10" + match[1].replace("\N{MINUS SIGN}", "-").translate(_RAISED),
                  unit)
    return re.sub(r"(?<=[A-Za-z])\^?(-?\d)", lambda match: match[1].translate(_RAISED), unit)


def number_text(value: float) -> str:
    """A number with five digits; large and small ones as a power of ten."""
    if isinstance(value, int) or not math.isfinite(value):
        return str(value).replace("-", "\N{MINUS SIGN}").replace("inf", "∞")
    text = f"{value:.{_DIGITS}g}"
    if "e" in text:
        mantissa, power = text.split("e")
        power = f"10{str(int(power)).translate(_RAISED)}"
        text = power if mantissa == "1" else mantissa + _TIMES + power
    return text.replace("-", "\N{MINUS SIGN}")


def _suiting(value: float, unit: str) -> Scale:
    if unit == "Pa":
        return pressure_scale([value])
    if unit == "m" and abs(value) >= 1e-9:
        return length_scale([value])
    if unit == "s" and abs(value) >= 1e-9:
        return time_scale([value]) if abs(value) >= 1e-6 else Scale(1e-9, "ns")
    if unit == "rad":
        return Scale(math.pi / 180, "°")
    return Scale(1.0, unit)


def quantity_text(value: float, unit: str) -> str:
    """A value in SI in the unit that suits its size."""
    if isinstance(value, int) or not math.isfinite(value):
        return f"{number_text(value)} {unit_text(unit)}".strip()
    scale = _suiting(value, unit)
    shown = number_text(value / scale.factor)
    return shown + scale.unit if scale.unit == "°" else f"{shown} {unit_text(scale.unit)}".strip()


def unit_of(name: str) -> str:
    """The unit that the name of a result ends with: m of crack_length_m."""
    return next((unit for ending, unit in _ENDINGS if name.endswith(ending)), "")
