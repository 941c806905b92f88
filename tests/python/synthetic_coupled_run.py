# SPDX-License-Identifier: BSD-3-Clause
"""Makes a run directory of fluid that breaks rock without a run: a plate with a crack that water
drives from its left side to the right."""

import json
from pathlib import Path

import numpy as np
from synthetic_run import write_grid, write_series, write_table

SIZE = 2.0  # m, width of the plate, and half its height on either side of the crack
COUNT = 16  # squares along a side; the crack runs on the edges between two rows of them
OPENING = 2e-4  # m, at the left side, at the end
PRESSURE = 8e6  # Pa, at the left side, at the end


def triangles() -> np.ndarray:
    """Corners of the triangles of the plate, (n, 3, 2): squares cut by alternating diagonals."""
    x, y = np.meshgrid(np.linspace(0, SIZE, COUNT + 1), np.linspace(-1, 1, COUNT + 1))
    places = np.stack([x.ravel(), y.ravel()], axis=1)
    row, column = (part.ravel() for part in np.divmod(np.arange(COUNT**2), COUNT))
    a = row * (COUNT + 1) + column
    b, c, d = a + 1, a + COUNT + 2, a + COUNT + 1
    one = np.where(((row + column) % 2)[:, None], np.stack([a, b, c], 1), np.stack([a, b, d], 1))
    other = np.where(((row + column) % 2)[:, None], np.stack([a, c, d], 1), np.stack([b, c, d], 1))
    return places[np.concatenate([one, other])]


def _opening(x: np.ndarray, length: float) -> np.ndarray:
    """Opening (m) of a crack of this length at the places x."""
    return OPENING * np.sqrt(np.clip(1 - x / max(length, 1e-9), 0, 1))


def _matrix(folder: Path, number: int, time: float, length: float) -> None:
    corners = triangles()
    centre = corners.mean(axis=1)
    points = corners.reshape(-1, 2)
    above = np.repeat(centre[:, 1] > 0, 3)
    half = 0.5 * _opening(points[:, 0], length) * np.exp(-np.abs(points[:, 1]))
    displacement = np.stack([np.zeros(len(points)), np.where(above, half, -half)], axis=1)
    distance = np.hypot(np.clip(points[:, 0] - length, 0, None), points[:, 1])
    pressure = 0.2 * PRESSURE * np.exp(-((distance / 0.15) ** 2))
    from_tip = np.hypot(centre[:, 0] - length, centre[:, 1]) + 0.05
    flat = np.zeros(len(corners))
    write_grid(
        folder / f"fields/matrix_{number:06d}.vtu", points, np.arange(len(points)).reshape(-1, 3),
        {"pressure_Pa": pressure, "saturation": np.ones(len(points)),
         "displacement_m": displacement, "velocity_m_per_s": 100 * displacement},
        {"region": flat.astype("<i4"),
         "darcy_flux_m_per_s": 1e-5 * centre / np.hypot(*centre.T)[:, None],
         "principal_stress_1_Pa": 2e5 / from_tip, "principal_stress_2_Pa": -3e5 / from_tip,
         "principal_direction": np.stack([flat, flat + 1], axis=1),
         "damage": np.exp(-from_tip), "fragment": flat.astype("<i4")}, time)


def _cracks(folder: Path, number: int, time: float, length: float) -> None:
    """Broken joints up to the tip, those of the first quarter from the start, and one beyond the
    tip that only softens and holds no fluid."""
    x = np.linspace(0, SIZE, COUNT + 1)
    inside = x[:-1] < length + SIZE / COUNT - 1e-9
    ends = np.stack([x[:-1][inside], x[1:][inside]], axis=1)
    points = np.stack([ends.ravel(), np.zeros(ends.size)], axis=1)
    count = len(ends)
    mode = np.where(ends[:, 1] <= SIZE / 4 + 1e-9, 0, np.where(np.arange(count) % 5 == 4, 3, 1))
    mode[-1] = -1
    wet = points[:, 0] <= length + 1e-9
    wet[-2:] = False
    write_grid(folder / f"fields/cracks_{number:06d}.vtu", points,
               np.arange(2 * count).reshape(-1, 2),
               {"pressure_Pa": np.where(wet, PRESSURE * (1 - 0.5 * points[:, 0] / SIZE), 0.0),
                "saturation": wet.astype(float)},
               {"fracture": np.where(mode == 0, 0, -1).astype("<i4"), "mode": mode.astype("<i4"),
                "wet": (mode >= 0).astype("<i4"),
                "aperture_m": _opening(ends[:, 0], length), "flux_m2_per_s": np.full(count, 1e-3),
                "opening_m": _opening(ends[:, 0], length), "slip_m": np.zeros(count),
                "damage": np.where(mode < 0, 0.5, 1.0), "closed": np.zeros(count, "<i4"),
                "break_time_s": np.where(mode > 0, time, np.nan)}, time)


def _history(folder: Path, end: float) -> None:
    time = np.linspace(0, end, 120)
    share, zero = time / end, np.zeros(120)
    length = SIZE / 4 * (1 + np.clip(3 * share - 1, 0, None) ** 0.67)
    pressure = PRESSURE * np.minimum(3 * share, 1 / np.sqrt(length * 4 / SIZE))
    into, volume = 1e-2 * time, 0.7e-2 * time
    work = np.concatenate([[0], np.cumsum(np.diff(into) * pressure[1:])])
    write_table(folder / "history.csv", {
        "time_s": time, "step": np.arange(120), "step_size_s": zero + 1e-7,
        "minimum_pressure_Pa": zero, "maximum_pressure_Pa": 0.2 * pressure,
        "minimum_crack_pressure_Pa": zero, "maximum_crack_pressure_Pa": pressure,
        "minimum_saturation": zero, "in_m2": into, "out_m2": 0.1 * into, "stored_m2": 0.9 * into,
        "in_place_m2": 0.8 + 0.9 * into, "error_m2": zero + 1e-17, "relative_error": zero + 1e-15,
        "source.mouth_m2_per_s": zero + 1e-2, "boundary.far_m2_per_s": zero - 1e-3,
        "kinetic_J_per_m": 1e-3 * work, "elastic_J_per_m": 0.6 * work, "joint_J_per_m": 0.05 * work,
        "fracture_J_per_m": 0.1 * work, "contact_J_per_m": zero, "friction_J_per_m": 0.01 * work,
        "damping_J_per_m": 0.2 * work, "absorbed_J_per_m": zero, "gravity_J_per_m": zero,
        "external_work_J_per_m": zero, "fluid_work_J_per_m": work,
        "residual_J_per_m": 1e-4 * work, "broken_joints": np.floor(16 * share).astype(int),
        "fragments": zero + 1, "unbalanced_ratio": 1e-2 + zero,
        "boundary.far.reaction_x_N_per_m": -1e5 * share,
        "boundary.far.reaction_y_N_per_m": 1e3 * share,
        "boundary.far.displacement_x_m": zero, "boundary.far.displacement_y_m": zero,
        "source.mouth.pressure_Pa": pressure, "crack_length_m": length,
        "filled_crack_length_m": 0.9 * length, "mean_aperture_m": volume / length,
        "crack_volume_m2": volume, "crack_fluid_m2": 0.95 * volume, "leaked_m2": into - volume,
        "source.mouth.volume_m2": into, "boundary.far.volume_m2": -0.1 * into})


def _tables(folder: Path, end: float) -> None:
    write_table(folder / "events.csv", {
        "time_s": np.linspace(0.3 * end, end, 16), "step": np.arange(16),
        "x_m": np.linspace(0.5, 1.4, 16), "y_m": np.zeros(16), "mode": ["tensile"] * 16,
        "length_m": [0.0625] * 16, "released_energy_J_per_m": [0.125] * 16,
        "magnitude": [-3.8] * 16, "material": ["rock"] * 16})
    write_table(folder / "probes/near.csv", {
        "time_s": [0.0, end / 2, end], "x_m": [0.5] * 3, "y_m": [0.25] * 3,
        "pressure_Pa": [0.0, 1e5, 4e5], "saturation": [1.0] * 3,
        "displacement_x_m": [0.0] * 3, "displacement_y_m": [0.0, 1e-6, 5e-6]})


def write_coupled_run(folder: Path, frames: int = 4, end: float = 5e-3) -> Path:
    """A run with so many frames; the crack begins with a quarter of the width."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "resolved.toml").write_text(
        'title = "Water drives a crack through a plate"\n[model]\nphysics = "coupled"\n'
        '[time]\nscheme = "explicit"\n')
    (folder / "summary.json").write_text(json.dumps({"end_time_s": end, "regions": ["plate"]}))
    times = dict(enumerate(np.linspace(0, end, frames).tolist()))
    for number, time in times.items():
        length = SIZE / 4 * (1 + 2 * round(number / (frames - 1) * 4) / 4)
        _matrix(folder, number, time, length)
        _cracks(folder, number, time, length)
    write_series(folder, "matrix", times)
    write_series(folder, "cracks", times)
    _history(folder, end)
    _tables(folder, end)
    return folder
