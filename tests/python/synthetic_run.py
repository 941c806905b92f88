# SPDX-License-Identifier: BSD-3-Clause
"""Makes run directories of mechanics without a run: a block that is pressed until it shears."""

import json
import zlib
from pathlib import Path

import numpy as np

WIDTH, HEIGHT = 0.05, 0.1  # m
COLUMNS, ROWS = 20, 40
_TYPES = {np.dtype("<f8"): "Float64", np.dtype("<i4"): "Int32", np.dtype("u1"): "UInt8"}


def write_grid(path: Path, points, cells, point_data=None, cell_data=None, time=0.0) -> None:
    """Writes a field file as the program does: appended arrays, each one zlib block."""
    blocks = []

    def entry(name, values):
        values = np.ascontiguousarray(values)
        if values.ndim == 2:
            values = np.column_stack([values, np.zeros(len(values))])
        raw = values.tobytes()
        packed = zlib.compress(raw)
        offset = sum(map(len, blocks))
        blocks.append(np.array([1, max(len(raw), 1), 0, len(packed)], "<u8").tobytes() + packed)
        parts = values.shape[1] if values.ndim == 2 else 1
        return (f'<DataArray type="{_TYPES[values.dtype]}" Name="{name}" '
                f'NumberOfComponents="{parts}" format="appended" offset="{offset}"/>')

    def section(tag, arrays):
        return f"<{tag}>" + "".join(entry(*one) for one in arrays.items()) + f"</{tag}>"

    corners = cells.shape[1]
    offsets = np.arange(corners, corners * len(cells) + 1, corners, dtype="<i4")
    shape = np.full(len(cells), {2: 3, 3: 5}[corners], "u1")
    xml = ('<VTKFile type="UnstructuredGrid" header_type="UInt64" '
           'compressor="vtkZLibDataCompressor"><UnstructuredGrid>'
           + section("FieldData", {"TimeValue": np.array([time])})
           + f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">'
           + section("PointData", point_data or {}) + section("CellData", cell_data or {})
           + section("Points", {"Points": points})
           + section("Cells", {"connectivity": cells.astype("<i4").ravel(), "offsets": offsets,
                               "types": shape}) + "</Piece></UnstructuredGrid>")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(xml.encode() + b'<AppendedData encoding="raw">_' + b"".join(blocks)
                     + b"</AppendedData></VTKFile>")


def triangles() -> np.ndarray:
    """Corners of the triangles of the block, (n, 3, 2): squares cut by alternating diagonals."""
    x, y = np.meshgrid(np.linspace(0, WIDTH, COLUMNS + 1), np.linspace(0, HEIGHT, ROWS + 1))
    places = np.stack([x.ravel(), y.ravel()], axis=1)
    cells = []
    for row in range(ROWS):
        for column in range(COLUMNS):
            a = row * (COLUMNS + 1) + column
            b, c, d = a + 1, a + COLUMNS + 2, a + COLUMNS + 1
            cells += [[a, b, c], [a, c, d]] if (row + column) % 2 else [[a, b, d], [b, c, d]]
    return places[np.array(cells)]


def _fragments(centre: np.ndarray) -> np.ndarray:
    """Below the shear plane 0, above it 1, the upper right corner 2."""
    above = centre[:, 1] > 0.025 + 1.2 * centre[:, 0]
    corner = centre[:, 0] - 0.035 + 0.4 * (centre[:, 1] - 0.09) > 0
    return np.where(above & corner, 2, above.astype(int)).astype("<i4")


def _edges_between(corners: np.ndarray, differs) -> np.ndarray:
    """Ends (n, 2, 2) of the edges whose two triangles satisfy `differs`."""
    sides = np.concatenate([corners[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
    owner = np.tile(np.arange(len(corners)), 3)
    key = np.sort(np.round(sides / 1e-6).astype(np.int64) @ [1, 10**6], axis=1)
    order = np.lexsort(key.T)
    key, sides, owner = key[order], sides[order], owner[order]
    twins = np.flatnonzero((key[1:] == key[:-1]).all(axis=1))
    return sides[twins[differs(owner[twins], owner[twins + 1])]]


def _cracks(corners: np.ndarray, fragment: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Ends and modes of the cracks: between fragments, and a few that soften in the lower part."""
    ends = _edges_between(corners, lambda a, b: fragment[a] != fragment[b])
    middle = ends.mean(axis=1)
    mode = np.where(middle[:, 1] > 0.07, 1, np.where(middle[:, 0] < 0.012, 3, 2))
    mode[middle[:, 0] > 0.045] = 0
    low = corners.mean(axis=1)[:, 1] < 0.02
    soft = _edges_between(corners, lambda a, b: low[a] & low[b] & ((a * 7 + b) % 11 == 0))
    return np.concatenate([ends, soft]), np.concatenate([mode, np.full(len(soft), -1)])


def _write_frame(folder: Path, number: int, time: float, load: float, cracked: bool,
                 highest: float = HEIGHT) -> None:
    corners = triangles()
    corners = corners[corners.mean(axis=1)[:, 1] < highest]
    centre = corners.mean(axis=1)
    fragment = _fragments(centre) if cracked else np.zeros(len(corners), "<i4")
    slide = np.array([[0.0, 0.0], [-2.0, -2.4], [3.0, -1.0]])[fragment]
    points = corners.reshape(-1, 2)
    displacement = load * (points * [0.25, -1.0] + 2e-3 * np.repeat(slide, 3, axis=0))
    stress_2 = -30e9 * load * (1 - 0.6 * np.exp(-((centre[:, 0] - 0.02) / 0.01) ** 2))
    stress_1 = 5e6 * load / 1e-3 * np.sin(2 * np.pi * centre[:, 1] / HEIGHT)
    angle = 0.4 * np.sin(np.pi * centre[:, 0] / WIDTH)
    write_grid(
        folder / f"fields/matrix_{number:06d}.vtu", points,
        np.arange(len(points)).reshape(-1, 3),
        {"displacement_m": displacement, "velocity_m_per_s": 10 * displacement},
        {"region": np.zeros(len(corners), "<i4"), "principal_stress_1_Pa": stress_1,
         "principal_stress_2_Pa": stress_2,
         "principal_direction": np.stack([np.cos(angle), np.sin(angle)], axis=1),
         "damage": np.clip(load * 400 * np.exp(-centre[:, 1] / 0.04), 0, 1),
         "fragment": fragment}, time)
    if cracked:
        ends, mode = _cracks(corners, fragment)
        count = len(ends)
        write_grid(folder / f"fields/cracks_{number:06d}.vtu", ends.reshape(-1, 2),
                   np.arange(2 * count).reshape(-1, 2), {},
                   {"fracture": np.full(count, -1, "<i4"), "mode": mode.astype("<i4"),
                    "damage": np.where(mode < 0, 0.5, 1.0),
                    "opening_m": np.full(count, 1e-6)}, time)


def write_series(folder: Path, name: str, frames: dict[int, float]) -> None:
    entries = "".join(f'<DataSet timestep="{time}" file="fields/{name}_{number:06d}.vtu"/>'
                      for number, time in frames.items())
    (folder / f"{name}.pvd").write_text(f"<VTKFile><Collection>{entries}</Collection></VTKFile>")


def write_table(path: Path, columns: dict) -> None:
    path.parent.mkdir(exist_ok=True)
    rows = zip(*columns.values())
    lines = [",".join(columns)] + [",".join(str(value) for value in row) for row in rows]
    path.write_text("\n".join(lines) + "\n")


def _write_history(folder: Path, load: float, end: float) -> None:
    time = np.linspace(0, end, 200)
    share = time / end
    strength = np.minimum(share, 0.7) - 0.8 * np.clip(share - 0.8, 0, None)
    moved = -load * HEIGHT * share
    force = -30e9 * load * WIDTH * strength
    elastic = 0.5 * force * moved
    joint = 0.02 * elastic.max() * np.clip(share - 0.6, 0, None)
    friction = 3 * joint * share
    work = np.concatenate([[0], np.cumsum(np.diff(moved) * 0.5 * (force[1:] + force[:-1]))])
    zero = np.zeros_like(time)
    write_table(folder / "history.csv", {
        "time_s": time, "step": np.arange(200), "step_size_s": zero + 1e-8,
        "kinetic_J_per_m": 0.01 * elastic * share, "elastic_J_per_m": elastic,
        "joint_J_per_m": joint, "fracture_J_per_m": 2 * joint,
        "contact_J_per_m": 0.1 * joint, "friction_J_per_m": friction,
        "damping_J_per_m": 0.02 * work, "absorbed_J_per_m": zero, "gravity_J_per_m": zero,
        "external_work_J_per_m": work, "residual_J_per_m": 1e-4 * work * np.sin(40 * share),
        "broken_joints": np.floor(60 * np.clip(share - 0.6, 0, None) / 0.4).astype(int),
        "fragments": np.where(share > 0.85, 3, 1), "unbalanced_ratio": 1e-3 + 0.1 * share**8,
        "boundary.top.reaction_x_N_per_m": 1e-4 * force, "boundary.top.reaction_y_N_per_m": force,
        "boundary.top.displacement_x_m": zero, "boundary.top.displacement_y_m": moved,
        "boundary.bottom.reaction_x_N_per_m": zero, "boundary.bottom.reaction_y_N_per_m": -force,
        "boundary.bottom.displacement_x_m": zero, "boundary.bottom.displacement_y_m": zero})


def _write_events(folder: Path, count: int, end: float) -> None:
    random = np.random.default_rng(1)
    magnitude = -6.0 + random.exponential(np.log10(np.e) / 1.3, count)
    along = random.uniform(0, WIDTH, count)
    write_table(folder / "events.csv", {
        "time_s": np.sort(end * (0.6 + 0.4 * random.uniform(size=count))),
        "step": np.arange(count), "x_m": along,
        "y_m": 0.025 + 1.2 * along + random.normal(0, 0.003, count),
        "mode": random.choice(["tensile", "shear", "mixed"], count, p=[0.5, 0.35, 0.15]),
        "length_m": np.full(count, 0.0025),
        "released_energy_J_per_m": 10 ** (1.5 * magnitude + 4.8), "magnitude": magnitude,
        "material": np.full(count, "rock")})


def _write_probe(folder: Path, load: float, end: float) -> None:
    height = np.linspace(0, HEIGHT, 30)
    share = np.repeat([0.0, 0.5, 1.0], 30)
    y = np.tile(height, 3)
    write_table(folder / "probes/axis.csv", {
        "time_s": end * share, "x_m": np.full(90, WIDTH / 2), "y_m": y,
        "displacement_x_m": 0.25 * load * share * WIDTH / 2, "displacement_y_m": -load * share * y,
        "stress_yy_Pa": -30e9 * load * share})


def write_mechanics_run(folder: Path, load: float = 1e-3, events: int = 150,
                        cracked: bool = True, end: float = 2e-3) -> Path:
    """A run of the block: two frames, of which the second is `cracked`; `load` is the axial strain
    at the end."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "resolved.toml").write_text(
        'title = "A block under axial compression"\n[model]\nphysics = "mechanics"\n'
        '[time]\nscheme = "implicit"\n')
    (folder / "summary.json").write_text(json.dumps(
        {"end_time_s": end, "reached_rest": False, "mechanics": {"energy_error": 1e-4}}))
    _write_frame(folder, 0, 0.0, 0.0, False)
    _write_frame(folder, 1, end, load, cracked)
    write_series(folder, "matrix", {0: 0.0, 1: end})
    if cracked:
        write_series(folder, "cracks", {1: end})
    _write_history(folder, load, end)
    _write_events(folder, events, end)
    _write_probe(folder, load, end)
    return folder


def write_excavated_run(folder: Path, frames: int = 4, end: float = 2e-3) -> Path:
    """The block, from which a fifth of its height is dug out from above before each frame but the
    first; only the last is cracked, below what is left."""
    write_mechanics_run(folder, end=end)
    times = dict(enumerate(np.linspace(0, end, frames).tolist()))
    for number, time in times.items():
        _write_frame(folder, number, time, 1e-3 * number / (frames - 1), number == frames - 1,
                     highest=HEIGHT * (1 - 0.2 * number))
    write_series(folder, "matrix", times)
    write_series(folder, "cracks", {frames - 1: end})
    return folder


def add_bodies(folder: Path, bodies: str, *regions: str) -> None:
    """Adds tables of bodies to the input of a run, and the names of its regions to its summary."""
    with open(folder / "resolved.toml", "a") as file:
        file.write(bodies)
    summary = json.loads((folder / "summary.json").read_text())
    (folder / "summary.json").write_text(json.dumps(summary | {"regions": regions}))
