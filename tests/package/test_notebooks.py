# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks run in a kernel of Jupyter, and show what they are committed with."""

import re
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import nbformat
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

import notebooks as tool

PATHS = tool.notebooks()
NAMES = [path.stem for path in PATHS]
MOST_BYTES = 300_000


@pytest.fixture(scope="module")
def executed(tmp_path_factory):
    """The notebooks as they are now, by name, run side by side in folders of their own."""
    pytest.importorskip("gmsh")
    pytest.importorskip("pandas")
    folders = [tmp_path_factory.mktemp(name) for name in NAMES]
    with ThreadPoolExecutor(len(PATHS)) as pool:
        return dict(zip(NAMES, pool.map(tool.executed, PATHS, folders)))


def outputs(notebook, kind=None) -> list:
    return [output for cell in notebook.cells for output in cell.get("outputs", [])
            if kind in (None, output.output_type)]


def words(notebook) -> set[str]:
    """Of all that is printed; numbers may differ from machine to machine."""
    texts = [output.get("text") or output.get("data", {}).get("text/plain", "")
             for output in outputs(notebook)]
    return {word for text in texts for word in re.findall(r"[A-Za-z_]{3,}", text)}


def pictures(notebook) -> list[int]:
    """Numbers of the cells that show one."""
    return [number for number, cell in enumerate(notebook.cells)
            if any("image/png" in output.get("data", {}) for output in cell.get("outputs", []))]


@pytest.mark.parametrize("path", PATHS, ids=NAMES)
def test_a_notebook_runs_and_shows_what_it_is_committed_with(path, executed):
    now, committed = tool.tidy(executed[path.stem]), nbformat.read(path, as_version=4)
    assert not [output.text for output in outputs(now, "stream") if output.name == "stderr"]
    assert words(now) == words(committed)
    assert pictures(now) == pictures(committed) and len(pictures(now)) >= 3


@pytest.mark.parametrize("path", PATHS, ids=NAMES)
def test_a_notebook_is_light_and_tidy(path):
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    assert path.stat().st_size < MOST_BYTES
    assert notebook.metadata == tool.METADATA
    assert not any(cell.metadata for cell in notebook.cells)


def test_of_lines_that_were_written_over_the_last_is_kept():
    cell = nbformat.v4.new_code_cell(outputs=[
        nbformat.v4.new_output("stream", name="stdout", text=text)
        for text in ("\r0 of 2, 1 s left", "\r1 of 2          ", "\r2 of 2\ndone\n")])
    (output,) = tool.tidy(nbformat.v4.new_notebook(cells=[cell])).cells[0].outputs
    assert output.text == "2 of 2\ndone\n"


def links(text: str) -> list[str]:
    return [link.split("#")[0] for link in re.findall(r"\]\(([^)]+)\)", text)]


@pytest.mark.parametrize("path", PATHS, ids=NAMES)
def test_a_notebook_ends_with_links_that_lead_somewhere(path):
    cells = nbformat.read(path, as_version=4).cells
    assert cells[-1].source.startswith("## Go on") and len(links(cells[-1].source)) >= 3
    for cell in cells:
        if cell.cell_type == "markdown":
            assert all((path.parent / link).exists() for link in links(cell.source))


def test_readme_and_page_lead_to_all_notebooks():
    for page in (ROOT / "README.md", ROOT / "docs/python.md"):
        found = {(page.parent / link).resolve() for link in links(page.read_text())
                 if link.endswith(".ipynb")}
        assert found == set(PATHS), page


def test_a_notebook_that_fails_is_left_as_it_was(tmp_path, capsys):
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell("1 / 0", id="wrong")])
    nbformat.write(notebook, tmp_path / "wrong.ipynb")
    before = (tmp_path / "wrong.ipynb").read_bytes()
    assert tool.main([str(tmp_path / "wrong.ipynb")]) == 1
    assert "ZeroDivisionError" in capsys.readouterr().err
    assert (tmp_path / "wrong.ipynb").read_bytes() == before
