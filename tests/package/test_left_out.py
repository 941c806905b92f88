# SPDX-License-Identifier: BSD-3-Clause
"""Warnings of fractures that a mesh does not follow, or not as they are drawn."""

import math
import re
from dataclasses import replace

import numpy as np
import percolith
import pytest
from percolith import mesh

pytest.importorskip("gmsh")


def line(*points, group="fractures") -> mesh.Fracture:
    return mesh.Fracture(np.array(points), group)


def warned(recwarn) -> list[str]:
    """Texts of the warnings, all of which name the line of this file."""
    told = [each for each in recwarn if each.category is percolith.CaseWarning]
    assert all(each.filename == __file__ for each in told)
    return [str(each.message) for each in told]


def test_what_is_left_out_as_a_whole_is_told_with_the_reason(tmp_path, recwarn):
    mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.4, fractures=[
        line((0.2, 0.5), (1.8, 0.5)), line((0.0, 0.2), (0.0, 1.8), group="edge"),
        line((2.5, 0.2), (3.0, 1.8), group="far")])
    assert warned(recwarn) == [
        "fracture 1 of group edge is left out of the mesh: covered by side left",
        "fracture 2 of group far is left out of the mesh: outside the rock"]


def test_parts_are_told_with_their_places(tmp_path, recwarn):
    mesh.borehole(tmp_path / "m.msh", 2, 2, 0.1, size=0.2, fractures=[
        line((-0.5, 0), (1.3, 0), group="through"), line((0.2, 0.5), (0.8, 0.5))])
    assert warned(recwarn) == [
        "fracture 0 of group through is left out of the mesh over 0.2 m at (0, 0), 0.3 m at "
        "(1.15, 0): outside the rock"]


def test_any_outline_is_warned_of(tmp_path, recwarn):
    mesh.outline_mesh(tmp_path / "m.msh", mesh.box(1, 1), size=0.5, fractures=[line((2, 0), (3, 0))])
    assert len(warned(recwarn)) == 1


def test_of_many_the_first_are_told(tmp_path, recwarn):
    mesh.rectangle(tmp_path / "m.msh", 1, 1, size=0.5,
                   fractures=[line((2, 0.1 * i), (3, 0.1 * i)) for i in range(9)])
    told = warned(recwarn)
    assert len(told) == 6 and told[4].startswith("fracture 4 of group fractures is left out")
    assert told[5].startswith("4 more fractures are left out of the mesh, as a whole or in part;")


def test_random_networks_lose_some_without_a_word(tmp_path, recwarn):
    region = mesh.box(2, 2)
    network = mesh.fracture_network(region, mesh.FractureSet(density=8.0, shortest=0.05), seed=2)
    made = mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.4, size_at_fractures=0.05,
                          fractures=network)
    assert made.left_out and "run together" in made.report() and not warned(recwarn)


def test_a_set_of_which_nothing_is_left_is_told(tmp_path, recwarn):
    region = mesh.box(2, 2)
    tiny = mesh.FractureSet(density=0.01, shortest=0.01, longest=0.02, group="tiny")
    network = mesh.fracture_network(region, [mesh.FractureSet(density=1.0), tiny], seed=1)
    made = mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.4, size_at_fractures=0.2,
                          fractures=network)
    assert made.lost_groups == ("tiny",)
    assert warned(recwarn) == ["group tiny: none of its fractures is left in the mesh; report() of "
                               "the mesh tells why"]


ADVICE = ("a smaller one keeps them as drawn where they are further apart than the tolerance, with "
          "thin triangles between them")


def crossing(angle_deg: float) -> list[mesh.Fracture]:
    """Two fractures of 0.5 m that cross in their middles."""
    ways = [0.25 * np.array([math.cos(way), math.sin(way)])
            for way in (math.radians(20), math.radians(20 + angle_deg))]
    middle = np.array([0.5, 0.2])
    return [line(middle - way, middle + way, group=name) for name, way in zip("ab", ways)]


def cross(tmp_path, fractures, **options) -> mesh.MadeMesh:
    return mesh.borehole(tmp_path / "m.msh", 2, 1, 0.1, size=0.1, size_at_fractures=0.03,
                         fractures=fractures, **options)


def test_a_fracture_that_follows_another_is_told_with_the_length(tmp_path, recwarn):
    made = cross(tmp_path, crossing(8))
    along = 2 * 1.2 * 0.015 / (2 * math.sin(math.radians(4)))
    assert warned(recwarn) == [
        f"fracture 1 of group b follows fracture 0 of group a over {along:.3g} m of its 0.5 m, "
        f"since they meet at less than smallest_angle_deg = 20; {ADVICE}"]
    assert made.report().splitlines()[1:] == [
        "run together from (0.5, 0.2) to (0.378761, 0.155872): fracture 0 (a) and 1 (b), 0.129 m",
        "run together from (0.5, 0.2) to (0.621239, 0.244128): fracture 0 (a) and 1 (b), 0.129 m"]


def test_a_smaller_angle_keeps_fractures_as_drawn(tmp_path, recwarn):
    made = cross(tmp_path, crossing(8), smallest_angle_deg=7.9)
    assert not warned(recwarn) and not made.changes
    assert math.isclose(made.meshed_length, 1.0, rel_tol=1e-9)


def test_a_small_share_is_only_reported(tmp_path, recwarn):
    fractures = [line((-0.9, 0.3), (0.9, 0.3)), line((-0.9, 0.13), (0.9, 0.47))]
    made = cross(tmp_path, fractures, smallest_angle_deg=11, tolerance=0.005)
    assert "run together" in made.report() and not warned(recwarn)


def test_a_fracture_that_follows_a_side_or_itself_is_told(tmp_path, recwarn):
    for points, what in [([(0.0, 0.0), (1.5, 0.1)], "side bottom"),
                         ([(0.2, 1.0), (1.8, 1.0), (0.3, 1.2)], "itself")]:
        mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.2, size_at_fractures=0.05,
                       fractures=[line(*points)])
        (told,) = warned(recwarn)
        assert told.startswith(f"fracture 0 of group fractures follows {what} over ")
        recwarn.clear()


def test_no_fracture_follows_over_more_than_its_length(tmp_path):
    long, short = line((0.2, 1.0), (1.8, 1.0)), line((0.2, 1.0), (0.4, 1.028))
    lines = mesh.arrange(mesh.box(2, 2), [long, short], 0.025)
    together = [change for change in lines.changes if change.kind == "run together"]
    assert together and together[0].fractures == (0, 1)
    assert 0.19 < sum(change.distance for change in together) <= short.length


def test_of_several_the_number_and_the_worst_are_told(tmp_path, recwarn):
    network = mesh.fracture_network(mesh.box(10, 10), [
        mesh.FractureSet(angle_deg=20, spread_deg=10, shortest=0.5, longest=8, density=1.5),
        mesh.FractureSet(density=1, shortest=0.3, longest=5)], 1)
    network = [replace(fracture, is_random=False) for fracture in network]
    made = mesh.rectangle(tmp_path / "m.msh", 10, 10, size=0.5, size_at_fractures=0.1,
                          fractures=network)
    (told,) = [text for text in warned(recwarn) if "follow others" in text]
    number, of_all, worst, length, whole = re.fullmatch(
        r"(\d+) of (\d+) fractures follow others or sides over more than 5 % of their length, since "
        r"they meet at less than smallest_angle_deg = 20; the worst: fracture (\d+) of group fractures "
        rf"follows .* over (\S+) m of its (\S+) m; {re.escape(ADVICE)}; report\(\) of the mesh "
        "tells of each",
        told).groups()
    assert int(of_all) == len(network) and 5 < int(number) < 0.3 * len(network)
    assert float(whole) == float(f"{network[int(worst)].length:.3g}")
    assert 0.5 < float(length) / float(whole) <= 1.0
    assert len(made.report().splitlines()) == len(set(made.report().splitlines()))
