# SPDX-License-Identifier: BSD-3-Clause
"""The check of the rooms finds what it must find, and nothing else."""

import check_rooms

DECLARATIONS = """
# percolith_room(ignored)
percolith_room(core LIBRARIES fmt::fmt)
percolith_room(mesh DEPENDS core)
percolith_room(seepage DEPENDS core mesh
               LIBRARIES Eigen3::Eigen)
"""


def write(folder, name, text):
    file = folder / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


def test_declarations_are_read_across_lines_and_without_comments():
    assert check_rooms.declared_rooms(DECLARATIONS) == {
        "core": set(), "mesh": {"core"}, "seepage": {"core", "mesh"}}


def test_declared_and_own_includes_pass(tmp_path):
    write(tmp_path, "core/a.hpp", '#include "percolith/version.hpp"\n')
    write(tmp_path, "mesh/b.cpp", '#include "percolith/core/a.hpp"\n#include <percolith/mesh/b.hpp>\n')
    assert check_rooms.include_problems(
        tmp_path, check_rooms.declared_rooms(DECLARATIONS)) == []


def test_an_undeclared_include_is_located(tmp_path):
    write(tmp_path, "mesh/b.cpp", '\n  #  include "percolith/seepage/pore.hpp"\n')
    problems = check_rooms.include_problems(tmp_path, check_rooms.declared_rooms(DECLARATIONS))
    assert problems == [f"{tmp_path}/mesh/b.cpp:2: room mesh includes seepage/pore.hpp; "
                        "allowed: core"]


def test_folders_within_a_room_are_part_of_it(tmp_path):
    write(tmp_path, "mesh/grid/b.cpp",
          '#include "percolith/mesh/grid/b.hpp"\n#include "percolith/seepage/pore.hpp"\n')
    problems = check_rooms.include_problems(tmp_path, check_rooms.declared_rooms(DECLARATIONS))
    assert len(problems) == 1 and "b.cpp:2: room mesh includes seepage/pore.hpp" in problems[0]


def test_a_folder_that_is_no_room_is_found(tmp_path):
    write(tmp_path, "lost/a.cpp", "")
    problems = check_rooms.include_problems(tmp_path, check_rooms.declared_rooms(DECLARATIONS))
    assert len(problems) == 1 and "no percolith_room(lost ...)" in problems[0]


def test_a_dependency_on_a_later_room_is_found():
    rooms = check_rooms.declared_rooms("percolith_room(core DEPENDS mesh)\npercolith_room(mesh)")
    assert check_rooms.order_problems(rooms) == [
        "room core depends on mesh, which is not declared before it"]


def test_physics_may_not_know_the_outside():
    rooms = {"io": set(), "seepage": {"io"}}
    assert check_rooms.order_problems(rooms) == ["physics room seepage depends on io"]


def test_mechanics_and_seepage_stay_apart():
    rooms = {"seepage": set(), "mechanics": {"seepage"}}
    assert check_rooms.order_problems(rooms) == [
        "room mechanics depends on seepage; they meet in coupling only"]
