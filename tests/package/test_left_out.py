# SPDX-License-Identifier: BSD-3-Clause
"""Warnings of fractures that a mesh does not follow."""

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
    made = mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.4, size_at_fractures=0.2,
                          fractures=network)
    assert made.left_out and not warned(recwarn)


def test_a_set_of_which_nothing_is_left_is_told(tmp_path, recwarn):
    region = mesh.box(2, 2)
    tiny = mesh.FractureSet(density=0.01, shortest=0.01, longest=0.02, group="tiny")
    network = mesh.fracture_network(region, [mesh.FractureSet(density=1.0), tiny], seed=1)
    made = mesh.rectangle(tmp_path / "m.msh", 2, 2, size=0.4, size_at_fractures=0.2,
                          fractures=network)
    assert made.lost_groups == ("tiny",)
    assert warned(recwarn) == ["group tiny: none of its fractures is left in the mesh; report() of "
                               "the mesh tells why"]
