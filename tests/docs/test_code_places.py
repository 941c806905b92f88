# SPDX-License-Identifier: BSD-3-Clause
"""What the documents name of the code is found on its line; what is not there is told."""

import re

import equations
import links
import mentions
import pytest
import site_map

from conftest import ROOT

SITE = links.open_site()
PAGE = equations.THEORY


@pytest.fixture(scope="module")
def names():
    return mentions.collect(SITE.files)


def read(names, text: str, file: str = PAGE) -> tuple[str, list[str]]:
    problems: list[str] = []
    return mentions.with_places(SITE, names, file, text, problems), problems


@pytest.mark.parametrize("file, name, begins", [
    ("src/percolith/seepage/content.hpp", "fluid_state", "PERCOLITH_DEVICE FluidState<Real>"),
    ("src/percolith/mechanics/motion.hpp", "Move", "struct Move"),
    ("src/percolith/coupling/coupled_step.cpp", "CoupledStep::flow_implicitly", "void CoupledStep::"),
    ("tests/unit/mechanics/test_motion.cpp", "Motion.FreeFallIsExact", "TEST(Motion, FreeFall"),
    ("verification/formulas.py", "strip", "def strip("),
])
def test_a_name_leads_to_the_line_of_its_definition(names, file, name, begins):
    line = names.symbols.line(file, name)
    assert (ROOT / file).read_text(encoding="utf-8").splitlines()[line - 1].startswith(begins)


def test_names_behind_a_link_become_links_to_their_lines(names):
    text = "See [`seepage/content.hpp`](../src/percolith/seepage/content.hpp) `fluid_state`.\n"
    made, problems = read(names, text)
    line = names.symbols.line("src/percolith/seepage/content.hpp", "fluid_state")
    assert problems == []
    assert f'href="sources/src/percolith/seepage/content.hpp.html#L-{line}"' in made


@pytest.mark.parametrize("text, told", [
    ("See [`a`](../src/percolith/seepage/content.hpp) `no_such_name`.\n", "`no_such_name`"),
    ("It is `Nowhere::nothing`.\n", "`Nowhere::nothing`"),
    ("In `seepage/no_such_file.cpp`.\n", "`seepage/no_such_file.cpp`"),
    ("In `verification/no_such_folder`.\n", "`verification/no_such_folder`"),
    ("By `some_word_of_nothing`.\n", "`some_word_of_nothing`"),
    ("| | what | code |\n|---|---|---|\n| 1 | a | `no_such_name` |\n", "`no_such_name`"),
])
def test_what_is_not_there_is_a_problem_with_its_line(names, text, told):
    _, problems = read(names, "# Title\n\n" + text)
    assert len(problems) == 1
    assert re.match(rf"{PAGE}:\d+: ", problems[0]) and told in problems[0]


def test_options_and_results_are_words_not_code(names):
    made, problems = read(names, "By `time.tolerance` and `joint_stress`, in `energy_error`.\n")
    assert problems == [] and "<a" not in made


def row(number: str, code: str) -> str:
    return f"| | equation | code |\n|---|---|---|\n| {number} | $a$ | {code} |\n"


def test_an_equation_without_code_is_a_problem():
    problems: list[str] = []
    places = {equations.THEORY: {"P1"}, equations.PAPER: set()}
    equations.with_numbers(PAGE, row("P1", "see there"), places, problems)
    assert problems == [f"{PAGE}:3: no function is named for P1"]


def test_numbers_of_equations_are_places_and_links():
    code = '<a class="source"><span class="line">:1</span></a>'
    text = row("M2, (8)", code) + "\nBy (8), (39), M2 and `(8)`.\n\n**Limit**, P6: small, see P6.\n"
    places = {equations.THEORY: equations.own_places(text), equations.PAPER: {"8", "39"}}
    problems: list[str] = []
    made = equations.with_numbers(PAGE, text, places, problems)
    assert problems == []
    assert 'id="eq-M2"' in made and 'id="eq-8"' in made and 'id="eq-P6">P6</span>: small' in made
    assert '<a class="equation" href="theory.html#eq-8">(8)</a>, ' in made
    assert '<a class="equation" href="equations.html#eq-39">(39)</a>' in made
    assert "`(8)`" in made and 'href="theory.html#eq-P6">P6</a>.' in made


def test_every_numbered_equation_of_the_documents_has_its_row():
    theory = (ROOT / equations.THEORY).read_text(encoding="utf-8")
    own = {name for name in equations.own_places(theory) if not name.isdigit()}
    assert {*(f"P{i}" for i in range(1, 8)), *(f"M{i}" for i in range(1, 13)),
            *(f"C{i}" for i in range(1, 7))} <= own
    paper = (ROOT / equations.PAPER).read_text(encoding="utf-8")
    assert {str(i) for i in range(1, 46)} == equations.own_places(paper)


def test_ranges_of_numbers():
    assert equations.numbers(" (14)–(16), (19) ") == ["14", "15", "16", "19"]
    assert site_map.page_name("docs/decisions/a.md") == "decisions/a"
    assert site_map.page_name("examples/strip/README.md") == "examples/strip/index"
    assert site_map.page_name("CHANGELOG.md") == "changelog"
