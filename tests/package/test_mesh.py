# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of shapes and of networks of fractures."""

import inspect
import typing

import numpy as np
import percolith
import pytest
from percolith import mesh
from percolith.mesh.closeness import close_pairs, crossings, near_pieces
from percolith.mesh.meshing import Meshing, SideMeshing

pytest.importorskip("gmsh")


def flow_case(made: mesh.MadeMesh, high: str, low: str) -> percolith.Case:
    """Steady flow from one side to another, along the fractures too."""
    case = percolith.Case({
        "mesh.file": made.file, "model.gravity": 0, "time.scheme": "steady",
        "material.rock": {"regions": list(made.regions), "permeability": 1e-14, "porosity": 0.1},
        "boundary.high": {"groups": [high], "pressure": 1e5},
        "boundary.low": {"groups": [low], "pressure": 0},
    })
    if made.fractures:
        case["fracture.all"] = {"groups": list(made.fractures), "initial_aperture": "0.1 mm",
                                "exchange": "inf"}
    return case


def check(made: mesh.MadeMesh, high: str, low: str, smallest_angle: float = 15.0):
    """The simulator takes the mesh, and fluid gets through without loss."""
    simulation = flow_case(made, high, low).simulation()
    report = simulation.check()
    assert report.triangles == made.triangles and not report.warnings
    assert report.smallest_angle > smallest_angle
    simulation.run()
    assert simulation.mass_balance["relative_error"] < 1e-8
    return report


def line(*points, group="fractures") -> mesh.Fracture:
    return mesh.Fracture(np.array(points), group)


def test_a_rectangle_with_a_crack(tmp_path):
    made = mesh.rectangle(tmp_path / "m.msh", 2, 4, size=0.2, size_at_fractures=0.05,
                          fractures=[line((0.4, 1.6), (1.6, 2.4), group="crack")])
    report = check(made, "left", "right")
    assert report.area == pytest.approx(8.0)
    assert report.fracture_length == pytest.approx(np.hypot(1.2, 0.8))
    assert made.fractures == ("crack",) and made.sides == ("bottom", "left", "right", "top")
    assert report.smallest_edge < 0.06 and report.largest_edge > 0.15
    assert not made.changes
    assert repr(made) == (f"MadeMesh({made.file}: {made.triangles} triangles, {made.points} points"
                          "; regions: rock; sides: bottom, left, right, top; fractures: crack; "
                          "0 changes)")


@pytest.mark.parametrize("irregular", [True, False])
def test_triangles_that_cracks_run_along_lie_in_no_order(tmp_path, coupled, irregular):
    made = mesh.rectangle(tmp_path / "m.msh", 1, 1, size=0.05, irregular=irregular)
    case = percolith.Case({"mesh.file": made.file, "model": {"physics": "mechanics", "gravity": 0},
                           "material.rock": {**coupled["material.rock"].to_dict()},
                           "time.end": "1 ms"})
    for name in ("permeability", "porosity", "biot_modulus", "biot_coefficient"):
        del case[f"material.rock.{name}"]
    warned = [text for text in case.check().warnings if "run in few directions" in text]
    assert len(warned) == (0 if irregular else 1)


def test_a_disc_with_loaded_arcs(tmp_path):
    made = mesh.disc(tmp_path / "m.msh", 0.05, size=0.004, flat_deg=12)
    assert made.sides == ("bottom", "edge", "top")
    assert check(made, "top", "bottom").area == pytest.approx(np.pi * 0.05**2, rel=5e-3)


def test_a_borehole_through_a_fracture(tmp_path):
    made = mesh.borehole(tmp_path / "m.msh", 2, 2, 0.1, size=0.2,
                         fractures=[line((-0.5, 0.02), (0.6, 0.1))])
    report = check(made, "hole", "left")
    assert [change.kind for change in made.changes].count("left out") == 1
    assert report.fracture_length == pytest.approx(np.hypot(1.1, 0.08) - 0.2, rel=0.1)


def test_holes_lie_where_they_are_wanted(tmp_path):
    def places(case):
        with case.simulation() as simulation:
            return simulation.mesh.vertices

    well = mesh.borehole(tmp_path / "m.msh", 4, 2, 0.1, size=0.2, centre=(-1.5, 0.6))
    check(well, "hole", "right")
    far = places(flow_case(well, "hole", "right"))
    assert far.min(axis=0) == pytest.approx([-2, -1]) and far.max(axis=0) == pytest.approx([2, 1])
    assert np.hypot(*(far - [-1.5, 0.6]).T).min() == pytest.approx(0.1, rel=1e-3)
    drift = mesh.tunnel(tmp_path / "t.msh", 20, 20, 3, 2, size=1.5, centre=np.array([4.0, -5.0]))
    assert check(drift, "top", "wall").area == pytest.approx(400 - 6 - np.pi * 1.5**2 / 2, rel=1e-3)
    floor = places(flow_case(drift, "top", "wall"))
    assert np.hypot(*(floor - [2.5, -6.75]).T).min() < 1e-9


@pytest.mark.parametrize("excavated", [False, True])
def test_a_tunnel(tmp_path, excavated):
    made = mesh.tunnel(tmp_path / "m.msh", 20, 20, 3, 2, size=1.5, excavated=excavated)
    area = 400 - (0 if excavated else 3 * 2 + np.pi * 1.5**2 / 2)
    assert check(made, "top", "bottom").area == pytest.approx(area, rel=1e-3)
    assert made.regions == (("rock", "tunnel") if excavated else ("rock",))
    assert ("wall" in made.sides) != excavated
    case = flow_case(made, "top", "bottom")
    for side in made.sides:
        case[f"boundary.{side}"] = {"groups": [side], "pressure": 0}
    del case["boundary.high"], case["boundary.low"]
    case.check()


def test_a_slope(tmp_path):
    made = mesh.slope(tmp_path / "m.msh", 10, 60, foot=10, crest=15, depth=8, size=1.5,
                      fractures=[line((1, 0), (10, 9))])
    back = 10 / np.tan(np.radians(60))
    assert check(made, "face", "bottom").area == pytest.approx(
        8 * (25 + back) + 10 * 15 + 5 * back)


def test_elements_at_fractures_and_at_a_hole_have_sizes_of_their_own(tmp_path):
    def triangles(**sizes):
        return mesh.borehole(tmp_path / "m.msh", 2, 2, 0.1, size=0.2,
                             fractures=[line((0.2, 0.1), (0.9, 0.5))], **sizes).triangles

    plain, coarse = triangles(), triangles(size_at_fractures=0.1)
    medium, fine = triangles(size_at_fractures=0.05), triangles(size_at_fractures=0.0125)
    assert plain <= coarse < 1.02 * plain
    assert 1.02 * plain < medium < 1.3 * plain and fine > 1.5 * plain
    assert triangles(size_at_fractures=0.05, size_at_hole=0.05) < 0.7 * medium
    tunnels = [mesh.tunnel(tmp_path / "m.msh", 20, 20, 3, 2, size=2.0, size_at_fractures=near,
                           fractures=[line((3, 3), (9, 8))]).triangles for near in (1.0, 0.25)]
    assert tunnels[0] < 0.8 * tunnels[1]


@pytest.mark.parametrize("points", [[(0.1, 0), (0.6, 0.2)], [(-0.5, 0.12), (0.6, 0.12)]])
def test_coarse_elements_at_fractures_do_not_bend_them_to_a_fine_hole(tmp_path, points):
    made = mesh.borehole(tmp_path / "m.msh", 2, 2, 0.1, size=0.2, fractures=[line(*points)])
    assert not made.changes
    assert made.meshed_length == pytest.approx(made.asked_length)
    check(made, "hole", "left")


LOST = {
    "the same twice": ([((0.2, 0.5), (1.8, 0.5)), ((0.2, 0.5), (1.8, 0.5))], "covered by fracture 0"),
    "without length": ([((0.2, 0.5), (1.8, 0.5)), ((1.0, 1.0), (1.0, 1.0))], "without length"),
    "on the edge": ([((0.2, 0.5), (1.8, 0.5)), ((0.0, 0.2), (0.0, 1.8))], "covered by side left"),
    "on another edge": ([((0.2, 0.5), (1.8, 0.5)), ((2.0, 0.2), (2.0, 1.8))],
                        "covered by side right"),
    "just within the edge": ([((0.2, 0.5), (1.8, 0.5)), ((0.01, 0.2), (0.01, 1.8))],
                             "covered by side left"),
    "outside": ([((0.2, 0.5), (1.8, 0.5)), ((2.5, 0.2), (3.0, 1.8))], "outside the rock"),
    "short": ([((0.2, 0.5), (1.8, 0.5)), ((1.0, 1.0), (1.0, 1.01))], "merged to a point"),
}


@pytest.mark.parametrize("name", LOST)
def test_a_fracture_of_which_nothing_is_left_is_told(tmp_path, name):
    points, reason = LOST[name]
    fractures = [line(*points[0], group="kept"), line(*points[1], group="lost")]
    made = mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.2, size_at_fractures=0.05,
                          fractures=fractures)
    assert made.fractures == ("kept",)
    assert made.left_out == (1,) and made.lost_groups == ("lost",)
    assert made.meshed_length == pytest.approx(1.6)
    first, group, change = made.report().splitlines()[:3]
    asked = fractures[0].length + fractures[1].length
    assert first.startswith(f"asked {asked:.4g} m, meshed 1.6 m, 1 of 2 fractures left out; ")
    assert group == "group lost: none of its fractures is left"
    assert change.startswith("left out as a whole at (") and change.endswith(reason)
    assert made.changes[0].fractures == (1,)


def test_a_line_that_leaves_the_rock_and_comes_back_keeps_its_parts(tmp_path):
    made = mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.2, size_at_fractures=0.05,
                          fractures=[line((0.5, 1.0), (0.5, 2.5), (1.5, 2.5), (1.5, 1.0))])
    assert made.asked_length == pytest.approx(4.0) and made.meshed_length == pytest.approx(2.0)
    assert {change.kind for change in made.changes} == {"left out"} and made.left_out == ()


CLOSE = {
    "crossing at two degrees": [((0.2, 0.5), (1.8, 0.5)), ((0.2, 0.47), (1.8, 0.53))],
    "lying on each other": [((0.2, 0.5), (1.8, 0.5)), ((0.5, 0.501), (1.2, 0.499))],
    "the same twice": [((0.2, 0.5), (1.8, 0.5)), ((0.2, 0.5), (1.8, 0.5))],
    "ending just short": [((0.2, 0.5), (1.8, 0.5)), ((1.0, 0.51), (1.0, 1.5))],
    "ending just beyond": [((0.2, 0.5), (1.8, 0.5)), ((1.0, 0.49), (1.0, 1.5))],
    "three through one place": [((0.2, 0.5), (1.8, 1.5)), ((0.2, 1.5), (1.8, 0.501)),
                                ((1.001, 0.2), (1.0, 1.8))],
    "along the edge": [((0.2, 0.004), (1.8, 0.006))],
    "just short of the edge": [((1.0, 1.0), (1.99, 1.2))],
    "beyond the edge": [((1.0, 1.0), (2.7, 1.2))],
    "from a corner at a small angle": [((0.0, 0.0), (1.5, 0.1))],
    "a fan": [((0.2, 1.0), (1.8, 1.0 + 0.1 * i)) for i in range(6)],
}


@pytest.mark.parametrize("name", CLOSE)
def test_fractures_that_nearly_touch_are_meshed_and_told(tmp_path, name):
    fractures = [line(*points) for points in CLOSE[name]]
    made = mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.2, size_at_fractures=0.05,
                          fractures=fractures)
    check(made, "left", "right")
    if name != "the same twice":
        assert made.changes
    told = [str(change) for change in made.changes]
    assert made.report().splitlines()[1 + len(made.lost_groups):] == told
    lines = mesh.arrange(mesh.box(2, 2), fractures, 0.025)
    for change in lines.changes:
        assert change.kind != "points merged" or change.distance < 0.025


@pytest.mark.parametrize("seed", range(3))
def test_a_network_is_meshed_whatever_the_seed(tmp_path, seed):
    region = mesh.box(2, 2)
    sets = [mesh.FractureSet(angle_deg=20, spread_deg=8, density=4, group="first"),
            mesh.FractureSet(density=3, shortest=0.1, group="second")]
    network = mesh.fracture_network(region, sets, seed)
    made = mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.1, size_at_fractures=0.04,
                          fractures=network)
    report = check(made, "left", "right", smallest_angle=10.0)
    total = sum(fracture.length for fracture in network)
    assert report.fracture_length == pytest.approx(total, rel=0.1)
    assert made.fractures == ("first", "second")


@pytest.mark.parametrize("seed", [3, 17])
def test_hundreds_of_fractures_are_brought_apart(seed):
    region, tolerance = mesh.box(10, 10), 0.05
    network = mesh.fracture_network(region, [
        mesh.FractureSet(angle_deg=20, spread_deg=10, shortest=0.5, longest=8, density=1.5),
        mesh.FractureSet(density=1, shortest=0.3, longest=5)], seed)
    assert len(network) > 250
    lines = mesh.arrange(region, network, tolerance)
    ends = np.array([[edge.a, edge.b] for edge in lines.edges])
    inner = np.array([edge.owner >= 0 for edge in lines.edges])
    assert sum(map(lines.length, np.array(lines.edges)[inner])) == pytest.approx(
        sum(fracture.length for fracture in network), rel=0.1)

    used = np.unique(ends)
    gap = np.hypot(*(lines.nodes[used][:, None] - lines.nodes[used]).transpose(2, 0, 1))
    fixed = lines.fixed[used]
    assert gap[np.triu(~(fixed[:, None] & fixed), 1)].min() >= tolerance
    start, way = lines.nodes[ends[:, 0]], lines.nodes[ends[:, 1]] - lines.nodes[ends[:, 0]]
    for node in used[~fixed]:
        share = np.clip(np.sum((lines.nodes[node] - start) * way, axis=1)
                        / np.sum(way**2, axis=1), 0, 1)
        apart = np.hypot(*(lines.nodes[node] - start - share[:, None] * way).T)
        assert apart[(ends != node).all(axis=1)].min() >= 0.86 * tolerance


def test_places_and_pieces_that_are_close_are_found():
    generator = np.random.default_rng(1)
    places, ends = generator.random((200, 2)), generator.random((150, 2, 2))
    gap = np.hypot(*(places[:, None] - places).transpose(2, 0, 1))
    pairs = {(i, j) for i, j, _ in zip(*close_pairs(places, 0.05))}
    assert pairs == set(zip(*np.nonzero(np.triu(gap < 0.05, 1))))

    def cross(u, v):
        return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]

    nodes = np.arange(300).reshape(150, 2)
    found = {(i, j) for i, j, _ in zip(*crossings(ends, nodes))}
    a, b = ends[:, 0], ends[:, 1]
    parts = cross((b - a)[:, None], a - a[:, None]) * cross((b - a)[:, None], b - a[:, None]) < 0
    assert found == set(zip(*np.nonzero(np.triu(parts & parts.T, 1)))) and len(found) > 100
    assert not len(crossings(ends, np.zeros_like(nodes))[0])

    near = {(i, j) for i, j, *_ in zip(*near_pieces(ends, places, 0.05))}
    way, to_place = (b - a)[:, None], places - a[:, None]
    share = np.sum(to_place * way, axis=2) / np.sum(way**2, axis=2)
    beside = np.hypot(*(to_place - share[..., None] * way).transpose(2, 0, 1)) < 0.05
    assert near == set(zip(*np.nonzero(beside & (share > 0) & (share < 1)))) and len(near) > 500


def test_a_network_has_the_statistics_it_was_asked_for():
    region = mesh.box(40, 40)
    one = mesh.FractureSet(angle_deg=30, spread_deg=5, shortest=0.2, longest=2, exponent=2.5,
                           density=1.5)
    network = mesh.fracture_network(region, one, seed=4)
    lengths = np.array([fracture.length for fracture in network])
    assert lengths.sum() / region.area == pytest.approx(1.5, rel=0.01)
    ways = np.array([fracture.points[1] - fracture.points[0] for fracture in network])
    angles = np.degrees(np.arctan2(ways[:, 1], ways[:, 0]))
    assert angles.mean() == pytest.approx(30, abs=0.5) and angles.std() == pytest.approx(5, abs=0.3)
    quantiles = one.lengths(np.array([0.25, 0.5, 0.75]))
    assert np.quantile(lengths, [0.25, 0.5, 0.75]) == pytest.approx(quantiles, rel=0.05)
    again = mesh.fracture_network(region, one, seed=4)
    assert all(np.array_equal(a.points, b.points) for a, b in zip(network, again))
    inside = np.concatenate([fracture.points for fracture in network])
    assert (inside > -1e-9).all() and (inside < 40 + 1e-9).all()


def test_a_fracture_is_clipped_to_the_rock():
    region = mesh.box(2, 2)
    region.holes = [mesh.box(0.5, 0.5, (1.0, 1.0))]
    from percolith.mesh.fractures import clip
    parts = clip(np.array([-1.0, 1.0]), np.array([3.0, 1.0]), region)
    assert np.allclose(parts, [[[0, 1], [0.75, 1]], [[1.25, 1], [2, 1]]])
    assert clip(np.array([-1.0, 3.0]), np.array([3.0, 3.0]), region) == []


def make(tmp_path, **changes):
    arguments = {"path": tmp_path / "m.msh", "width": 2, "height": 2, "size": 0.5, **changes}
    return mesh.rectangle(**arguments)


@pytest.mark.parametrize("changes, message", [
    ({"size": 0}, "size = 0: not a positive length"),
    ({"size": "a"}, "size = 'a': not a positive length"),
    ({"tolerance": 3}, "tolerance = 3: larger than the elements at fractures.*up to 0.5 m"),
    ({"tolerance": 0.2, "size_at_fractures": 0.1}, "allowed: up to 0.1 m"),
    ({"width": -1}, "width = -1: not a positive length"),
    ({"path": "m.geo"}, "a mesh is written to a file .msh"),
    ({"fine_sides": ["roof"]}, "no side roof; there are: bottom, left, right, top"),
    ({"smallest_angle_deg": 80}, "allowed: 0 to 45 degrees"),
    ({"fractures": [line((0.5, 0.5), (1.5, 1.0), group="left")]}, "left: the name of a side"),
])
def test_meshes_that_cannot_be_are_refused(tmp_path, changes, message):
    with pytest.raises(percolith.MeshError, match=message):
        make(tmp_path, **changes)


def test_other_mistakes(tmp_path):
    with pytest.raises(percolith.FileError, match="no folder"):
        make(tmp_path, path=tmp_path / "nowhere" / "m.msh")
    (tmp_path / "taken.msh").mkdir()
    with pytest.raises(percolith.FileError, match="taken.msh: cannot write the mesh"):
        make(tmp_path, path=tmp_path / "taken.msh")
    with pytest.raises(percolith.MeshError, match="points of a fracture: not pairs of numbers"):
        mesh.Fracture([(0, 0), (1,)])
    with pytest.raises(percolith.MeshError, match="corners of an outline: not pairs of numbers"):
        mesh.Outline([(0, 0), (1,), (1, 1)], ["a"] * 3)
    for seed in ("a", -1, 1.5, None):
        with pytest.raises(percolith.MeshError, match="seed = .*a whole number"):
            mesh.fracture_network(mesh.box(1, 1), mesh.FractureSet(), seed)
    with pytest.raises(percolith.MeshError, match="two points"):
        mesh.Fracture([(0, 0)])
    with pytest.raises(percolith.MeshError, match="shortest <= longest"):
        mesh.FractureSet(shortest=3)
    with pytest.raises(percolith.MeshError, match="within the rectangle"):
        mesh.borehole(tmp_path / "m.msh", 1, 1, 0.6, size=0.1)
    for centre in ((0.9, 0), (0, -0.95), (5, 5)):
        with pytest.raises(percolith.MeshError, match="hole does not lie within.*to .1, 1., or touc"):
            mesh.borehole(tmp_path / "m.msh", 2, 2, 0.1, size=0.1, centre=centre)
    with pytest.raises(percolith.MeshError, match=r"centre = \(0, 9\): the hole does not lie"):
        mesh.tunnel(tmp_path / "m.msh", 20, 20, 3, 2, size=1, centre=(0, 9))
    for centre in ("middle", 1.0, (1, 2, 3), (np.nan, 0)):
        with pytest.raises(percolith.MeshError, match="centre = .*: no place; allowed: .x, y. in m"):
            mesh.borehole(tmp_path / "m.msh", 2, 2, 0.1, size=0.1, centre=centre)
    with pytest.raises(percolith.MeshError, match="angle_deg = 0"):
        mesh.slope(tmp_path / "m.msh", 1, 0, foot=1, crest=1, depth=1, size=0.1)


def test_a_model_of_the_caller_is_left_alone(tmp_path):
    import gmsh

    gmsh.initialize(interruptible=False)
    try:
        gmsh.model.add("mine")
        gmsh.model.geo.addPoint(0, 0, 0)
        make(tmp_path)
        assert gmsh.model.getCurrent() == "mine"
    finally:
        gmsh.finalize()


@pytest.mark.parametrize("shape, options", [
    (mesh.rectangle, SideMeshing), (mesh.disc, SideMeshing), (mesh.slope, SideMeshing),
    (mesh.borehole, Meshing), (mesh.tunnel, Meshing)])
def test_shapes_tell_the_options_of_meshing(shape, options):
    taken = inspect.signature(shape).parameters
    names = typing.get_type_hints(options)
    assert "meshing" not in taken and "size" in taken
    assert {name for name in taken if name in typing.get_type_hints(SideMeshing)} == set(names)
    for name in names:
        assert taken[name] == inspect.signature(mesh.outline_mesh).parameters[name]
    for name in ["size", *names]:
        assert f"\n- {name}: " in shape.__doc__
    assert "size: of the elements, m." in shape.__doc__ and "MeshError" in shape.__doc__


def test_options_of_meshing_are_those_of_an_outline():
    hints = typing.get_type_hints(mesh.outline_mesh)
    for name in ("path", "outline", "size", "return"):
        del hints[name]
    assert typing.get_type_hints(SideMeshing) == hints


def test_a_shape_refuses_options_that_there_are_not(tmp_path):
    with pytest.raises(TypeError, match="growht"):
        mesh.rectangle(tmp_path / "m.msh", 1, 1, size=0.2, growht=0.1)
    with pytest.raises(TypeError, match="size"):
        mesh.rectangle(tmp_path / "m.msh", 1, 1)


def test_wrong_arguments_name_the_shape_that_was_asked_for(tmp_path):
    file = tmp_path / "block.msh"
    with pytest.raises(TypeError, match=r"^borehole\(\) takes no 'center'; it takes: path, width, "):
        mesh.borehole(file, 10, 10, 1, size=1, center=(1, 1))
    with pytest.raises(percolith.MeshError, match="^size = '1 m': not a positive length in m$"):
        mesh.borehole(file, 10, 10, 1, size="1 m")
    with pytest.raises(percolith.MeshError, match=r"^fractures\[1\] is a list; allowed: "):
        mesh.rectangle(file, 10, 10, size=1,
                       fractures=[mesh.Fracture([[2, 2], [5, 5]]), [[0, 0], [1, 1]]])
    assert not file.exists()


NUMBERS = {
    mesh.rectangle: {"width": 10, "height": 10},
    mesh.disc: {"radius": 5, "flat_deg": 12},
    mesh.borehole: {"width": 10, "height": 10, "radius": 1, "size_at_hole": 0.2},
    mesh.tunnel: {"width": 20, "height": 20, "tunnel_width": 3, "wall_height": 2,
                  "size_at_wall": 0.5},
    mesh.slope: {"height": 10, "angle_deg": 60, "foot": 5, "crest": 5, "depth": 5},
}
OF_ALL = {"size": 1, "size_at_fractures": 0.5, "growth": 0.2, "tolerance": 0.1,
          "smallest_angle_deg": 20}
UNITS = {"growth": "a positive number", "flat_deg": "a number in degrees",
         "angle_deg": "a number in degrees", "smallest_angle_deg": "a number in degrees"}


@pytest.mark.parametrize("shape, name", [
    (shape, name) for shape, own in NUMBERS.items() for name in {**own, **OF_ALL}])
def test_a_text_in_place_of_a_number_is_told_with_the_name(tmp_path, shape, name):
    arguments = {**NUMBERS[shape], **OF_ALL, name: "0.1 m"}
    wanted = f"^{name} = '0.1 m': not {UNITS.get(name, 'a positive length in m')}$"
    with pytest.raises(percolith.MeshError, match=wanted):
        shape(tmp_path / "m.msh", **arguments)
    in_order = [arguments.pop(one) for one, taken in inspect.signature(shape).parameters.items()
                if taken.kind is taken.POSITIONAL_OR_KEYWORD and one in arguments]
    with pytest.raises(percolith.MeshError, match=wanted):
        shape(tmp_path / "m.msh", *in_order, **arguments)


@pytest.mark.parametrize("name, unit", [
    ("shortest", " in m"), ("longest", " in m"), ("density", " in 1/m"), ("exponent", ""),
    ("angle_deg", " in degrees"), ("spread_deg", " in degrees")])
def test_a_set_names_what_is_no_number(name, unit):
    with pytest.raises(percolith.MeshError, match=f"^{name} = '2 m': not a number{unit}$"):
        mesh.FractureSet(**{name: "2 m"})


def test_a_fracture_and_sides_have_numbers(tmp_path):
    with pytest.raises(percolith.MeshError, match="points of a fracture: not pairs of numbers"):
        mesh.Fracture([("0.1 m", 0), (1, 1)])
    with pytest.raises(percolith.MeshError, match="^size_at_fine_sides = '1 m': not a positive"):
        make(tmp_path, fine_sides=["left"], size_at_fine_sides="1 m")


def test_a_fracture_that_is_left_out_is_told_once(tmp_path):
    made = mesh.rectangle(tmp_path / "block.msh", 10, 10, size=1, fractures=[
        mesh.Fracture([[20, 0], [21, 1]]), mesh.Fracture([[2, 2], [5, 5]])])
    assert made.left_out == (0,)
    assert made.report().count("left out at") == 0
    assert made.report().count("left out as a whole") == 1
