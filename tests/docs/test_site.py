# SPDX-License-Identifier: BSD-3-Clause
"""The parts of the site that are made from folders: gallery, criteria, comparisons; and the check of
what was built."""

import ast
import json

import criteria_text
import docstrings
import gallery
import links
import offline
import pytest
import python_page
import staging
import subscripts
import verification_table

from conftest import ROOT

SITE = links.open_site()
EXAMPLES = gallery.names(SITE.files)


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_example_has_what_the_gallery_shows(name):
    example = gallery.read(name)
    assert example.title and example.time and 5 < len(example.summary.split()) < 120
    assert criteria_text.read(name)


def test_criteria_are_those_of_the_verification():
    found = criteria_text.read("dam")
    assert [one.limit for one in found] == [1e-12, 0.01, 0.01]
    assert found[0].quantity == "mass balance error over fluid in place and throughput"
    assert found[1].reference == "2.3544e-05"


def test_every_example_is_in_the_gallery():
    made = gallery.gallery(SITE)
    assert [name for name in EXAMPLES if f"({name}/index.md)" not in made] == []
    assert "examples/strip/picture.png" in SITE.pictures


CHECK = '''
TITLE = "A check"
LIMIT = 0.5


def check(chapter, work):
    check_example(chapter, "dam", work)
    chapter.at_most("a", f"{work}: first "
                    "quantity", 1.0, LIMIT)
    for part in work:
        chapter.at_least(part, "second", 1.0, part.limit)
        shared(chapter)
'''


def test_comparisons_are_read_from_the_checks():
    shared = ast.parse('def shared(c):\n    c.at_most("b", "third", 1.0, -2)')
    rows = verification_table.rows_of(ast.parse(CHECK), {"shared": shared})
    assert [(row.quantity, row.limit) for row in rows[3:]] == [
        ("…: first quantity", "≤ 0.5"), ("second", "≥ …"), ("third", "≤ -2")]
    assert rows[0].limit == "≤ 1e-12"
    assert verification_table.title_of(ast.parse(CHECK)) == "A check"


def test_every_verification_has_comparisons():
    helpers = verification_table.shared_checks()
    for check in (ROOT / "verification").glob("*/check.py"):
        module = ast.parse(check.read_text(encoding="utf-8"))
        assert verification_table.title_of(module), check
        assert verification_table.rows_of(module, helpers), check


def test_values_of_the_last_verification_are_shown(tmp_path):
    assert verification_table.measured(tmp_path) == {}
    rows = [{"id": "dam.a", "quantity": "x < y", "value": 0.25, "limit": 1.0, "sense": "max",
             "pass": True},
            {"id": "dam.b", "quantity": "z", "value": None, "limit": 2.0, "sense": "min",
             "pass": False}]
    (tmp_path / "report.json").write_text(json.dumps(rows))
    table = verification_table.measured_table(verification_table.measured(tmp_path)["dam"])
    assert "| x &lt; y | 0.25 | ≤ 1 | pass |" in table
    assert "| z | no number | ≥ 2 | **FAIL** |" in table


def test_the_python_reference_lists_all_that_the_package_exports():
    made = python_page.page()
    for name in python_page.exported("python/percolith/__init__.py"):
        assert name == "mesh" or f":: percolith.{name}\n" in made, name
    assert ":: percolith.mesh.fracture_network\n" in made


def test_the_python_reference_has_what_a_simulation_hands_out():
    tree = ast.parse((ROOT / "python/percolith/simulation.py").read_text(encoding="utf-8"))
    (simulation,) = [part for part in tree.body if getattr(part, "name", "") == "Simulation"]
    handed = {part.attr for function in simulation.body if isinstance(function, ast.FunctionDef)
              and function.returns and not function.name.startswith("_")
              for part in ast.walk(function.returns) if isinstance(part, ast.Attribute)
              and getattr(part.value, "id", "") == "_core"}
    assert {"Mesh", "Flow", "Motion"} <= handed
    made = python_page.page()
    for name in handed:
        assert f":: percolith._core.{name}\n   :members:\n" in made, name


def test_what_a_page_loads_or_links_to_in_vain_is_found(tmp_path):
    (tmp_path / "a.html").write_text(
        '<p id="here"><img src="https://example.org/a.png"><a href="b.html#there">b</a>'
        '<a href="b.html#lost">b</a><a href="none.html">c</a><a href="#here">d</a>'
        '<a href="https://example.org">e</a><p style="background:url(//example.org/x)">')
    (tmp_path / "b.html").write_text('<p id="there">')
    (tmp_path / "a.css").write_text("@import 'https://example.org/x.css';")
    assert offline.problems(tmp_path) == [
        "a.html: loads https://example.org/a.png", "a.html: loads //example.org/x",
        'a.html: "b.html#lost" leads to no place on its page',
        'a.html: "none.html" leads to no file', "a.css: loads https://example.org/x.css"]
    assert offline.problems(tmp_path / "none") != []


def test_texts_are_changed_outside_code_only():
    assert subscripts.lowered("# K_w\nthe K_w of `K_w`, $K_w$ and case_file\n") == (
        "# K_w\nthe <i>K</i><sub>w</sub> of `K_w`, $K_w$ and case_file\n")
    assert staging.one_title("# A\n## B\n# C\n## D\n```\n# e\n```\n") == (
        "# A\n## B\n## C\n### D\n```\n# e\n```\n")
    assert docstrings.as_sphinx(["By `--set`, as in:", "", "    a = `b`"]) == [
        "By ``--set``, as in::", "", "    a = `b`"]
