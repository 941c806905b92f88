# SPDX-License-Identifier: BSD-3-Clause
"""`percolith check`."""

import re

from conftest import ROOT, STEADY, line_of


def limits(text: str) -> dict[str, float]:
    """Step (s) by mechanism, in the order printed."""
    rows = re.findall(r"^  (\D+?) +(\S+) s at \(", text, re.MULTILINE)
    return {mechanism: float(step) for mechanism, step in rows}


def test_prints_mesh_model_and_limits(percolith, six_fractures):
    done = percolith("check", six_fractures)
    assert done.returncode == 0, done.stderr
    assert "Six fractures in a block of porous rock" in done.stdout
    for word in ["triangles", "broken joints", "angles", "region rock: 1200 m2",
                 "fracture network: ", "pore nodes", "crack nodes"]:
        assert word in done.stdout
    assert done.stdout.endswith("The case can be run.\n")


def test_tells_what_each_kind_of_joint_means(percolith):
    done = percolith("check", ROOT / "examples/compression/case.toml")
    assert done.returncode == 0, done.stderr
    for kind in ["bonded joints (may break)", "closed joints (broken from the start, faces together)",
                 "tied joints (sides share nodes, cannot break)",
                 "rigid joints (within one rigid body)"]:
        assert re.search(rf"^  {re.escape(kind)} +\d+$", done.stdout, re.MULTILINE), kind


def test_the_case_of_the_readme_draws_no_warning(percolith):
    done = percolith("check", ROOT / "examples/brazilian/case.toml")
    assert (done.returncode, done.stderr) == (0, "")


def test_limits_come_smallest_first_and_one_rules(percolith, six_fractures):
    text = percolith("check", six_fractures).stdout
    found = limits(text)
    together = found.pop("all together")
    assert {"pore flow", "crack flow", "exchange"} <= set(found)
    assert list(found.values()) == sorted(found.values())
    assert together < min(found.values())
    assert text.count("<- rules") == 1
    ruling = next(line for line in text.splitlines() if "<- rules" in line)
    assert ruling.split(" s at ")[0].split()[0] == next(iter(found)).split()[0]


def test_a_steady_case_has_no_limits_of_the_step(percolith, strip):
    done = percolith("check", strip, *STEADY)
    assert done.returncode == 0, done.stderr
    assert "scheme steady: takes no time step" in done.stdout
    assert "Limits" not in done.stdout and not limits(done.stdout)


def test_limit_follows_the_case(percolith, strip):
    step = limits(percolith("check", strip).stdout)["pore flow"]
    other = limits(percolith("check", strip, "--set",
                             "material.rock.permeability=4e-13 m2").stdout)["pore flow"]
    assert abs(step / other - 2) < 1e-3


def test_writes_nothing(percolith, strip, tmp_path):
    before = sorted(tmp_path.rglob("*"))
    percolith("check", strip)
    assert sorted(tmp_path.rglob("*")) == before


def test_errors_of_the_model_are_located(percolith, strip):
    strip.write_text(strip.read_text().replace('groups = ["left"]', 'groups = ["lefft"]'))
    done = percolith("check", strip)
    assert done.returncode == 2
    where = f"{strip}:{line_of(strip, 'lefft')}:"
    assert done.stderr.startswith(where), done.stderr
    assert "boundary.left.groups" in done.stderr
    assert "lefft" in done.stderr
    assert done.stdout == ""


def test_missing_mesh_is_located(percolith, strip):
    strip.write_text(strip.read_text().replace("strip_05.msh", "none.msh"))
    done = percolith("check", strip)
    assert done.returncode == 2
    where = f"{strip}:{line_of(strip, 'none.msh')}:"
    assert done.stderr.startswith(where), done.stderr
    assert f"there is no file {strip.parent / 'none.msh'}" in done.stderr


def test_missing_case_file(percolith, tmp_path):
    done = percolith("check", "none.toml")
    assert done.returncode == 4
    assert "none.toml" in done.stderr
    assert done.stderr.startswith("error: ")


def test_units_that_were_forgotten_are_asked_for(percolith):
    case = ROOT / "examples/brazilian/case.toml"
    done = percolith("check", case, "--set", "material.rock.young_modulus=20")
    assert done.returncode == 0, done.stderr
    assert done.stderr.startswith(
        "--set: warning: material.rock.young_modulus = 20 is 20 Pa, less than the 1 MPa of a soft "
        'soil. Is that meant? A number without a unit is in Pa; 20 GPa is written "20 GPa"')
    done = percolith("check", case, "--set", "material.rock.mode_1_energy=1.5e6")
    assert "It is an energy: of a toughness K" in done.stderr
    done = percolith("check", case, "--set", "material.rock.friction_angle=30")
    assert done.returncode == 2
    assert 'degrees are written "30 deg"' in done.stderr


def test_missing_physics_is_the_one_message(percolith):
    done = percolith("check", ROOT / "examples/brazilian/case.toml", "--set", "model.physics=")
    assert done.returncode == 2
    assert done.stderr.count("error: ") == 1
    assert "model.physics: required but missing" in done.stderr
    for choice in ['"seepage"', '"mechanics"', '"coupled"']:
        assert choice in done.stderr


def test_elements_are_judged_where_cracks_start(percolith):
    done = percolith("check", ROOT / "examples/pressurised_well/case.toml")
    assert re.search(r"elements of \S+ m where cracks start, at boundary.wall \(", done.stderr)
    assert "into the rock at boundary.wall, less than one element" in done.stderr
