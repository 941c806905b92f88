# SPDX-License-Identifier: BSD-3-Clause
"""Scales of the axes: SI values in the unit that suits their size. Values that are missing (NaN)
do not count."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Scale:
    """A unit and its value in SI: number in the unit = SI number / factor."""

    factor: float
    unit: str

    def label(self, quantity: str) -> str:
        return f"{quantity} ({self.unit})" if self.unit else quantity


_PRESSURE = [(1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa"), (1.0, "Pa")]
_TIME = [(86400.0, "d"), (3600.0, "h"), (60.0, "min"), (1.0, "s"), (1e-3, "ms"), (1e-6, "µs")]

_PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ")]


def _largest_below(steps: list[tuple[float, str]], size: float) -> Scale:
    for factor, unit in steps:
        if size >= factor:
            return Scale(factor, unit)
    return Scale(*steps[-1])


def pressure_scale(values) -> Scale:
    """Pa to GPa, by the largest value."""
    size = float(np.nanmax(np.abs(values), initial=0.0))
    return _largest_below(_PRESSURE, size) if size > 0 else Scale(1.0, "Pa")


def time_scale(values) -> Scale:
    """Microseconds to days, by the largest value: 0.2 s, but 20 ms."""
    size = float(np.nanmax(np.abs(values), initial=0.0))
    if size == 0 or 0.1 <= size < 60:
        return Scale(1.0, "s")
    return _largest_below(_TIME, size)


def length_scale(values) -> Scale:
    """Nanometres to metres, by the largest value: 0.2 m, but 20 mm."""
    size = float(np.max(np.abs(values), initial=0.0))
    if size == 0 or size >= 0.1:
        return Scale(1.0, "m")
    return _largest_below([(1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm")], size)


def prefix_scale(values, unit: str) -> Scale:
    """`unit` with a prefix from micro to giga, by the largest value; a power of ten times `unit`
    beyond."""
    size = float(np.max(np.abs(values), initial=0.0))
    for factor, prefix in _PREFIXES:
        if factor <= size < 1e3 * factor:
            return Scale(factor, prefix + unit)
    return power_scale(values, unit)


def power_scale(values, unit: str) -> Scale:
    """A power of ten times `unit`, for quantities without a usual prefix."""
    size = float(np.nanmax(np.abs(values), initial=0.0))
    if size == 0 or 0.01 <= size < 1e4:
        return Scale(1.0, unit)
    power = int(np.floor(np.log10(size)))
    exponent = str(power).replace("-", "\N{MINUS SIGN}")
    return Scale(10.0**power, f"$10^{{{exponent}}}$ {unit}")


_SCALES = [("_Pa", pressure_scale), ("_J_per_m", lambda values: prefix_scale(values, "J/m")),
           ("_m2_per_s", lambda values: power_scale(values, "m²/s")),
           ("_m_per_s", lambda values: power_scale(values, "m/s")),
           ("_m", length_scale), ("_s", time_scale)]


def without_unit(name: str) -> str:
    """The name of an array or a column without the unit at its end."""
    endings = [ending for ending, _ in _SCALES if name.endswith(ending)]
    return name.removesuffix(endings[0]) if endings else name


def scale_of(name: str, values) -> Scale:
    """The scale that suits the values of an array or a column, whose unit is the end of its name;
    a power of ten where it has none."""
    values = np.asarray(values)[np.isfinite(values)]
    for ending, suitable in _SCALES:
        if name.endswith(ending):
            return suitable(values)
    scale = power_scale(values, "")
    return Scale(scale.factor, scale.unit.strip())


def format_value(value: float, scale: Scale) -> str:
    """A value (SI) in the unit of `scale`, which may be a power of ten times a unit."""
    times = "× " if scale.unit.startswith("$") else ""
    return f"{value / scale.factor:.3g} {times}{scale.unit}".rstrip()


def format_time(seconds: float, scale: Scale | None = None) -> str:
    """A time in the unit of `scale`, or in the one that suits it."""
    scale = scale or time_scale([seconds])
    return f"{seconds / scale.factor:.4g} {scale.unit}"
