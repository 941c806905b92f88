# SPDX-License-Identifier: BSD-3-Clause
"""Notebooks become pages of the site with all that they hold."""

import json

import markdown_text
import notebook_pages
import pytest
import site_map

from conftest import ROOT

NOTEBOOKS = sorted(file for file in site_map.tracked() if file.endswith(notebook_pages.SUFFIX))


@pytest.mark.parametrize("file", NOTEBOOKS)
def test_a_page_has_text_code_and_output_of_its_notebook(file):
    text = notebook_pages.markdown(file)
    pictures = notebook_pages.pictures(file)
    cells = json.loads((ROOT / file).read_text(encoding="utf-8"))["cells"]
    for cell in cells:
        assert "".join(cell["source"]) in text
    printed = [output for cell in cells for output in cell.get("outputs", []) if "text" in output]
    assert text.count(":class: printed") == len(printed)
    assert len(pictures) >= 3 and all(data.startswith(b"\x89PNG") for data in pictures.values())
    assert [name for name in pictures if f"{{image}} {name}\n" not in text] == []
    assert sum(1 for line in markdown_text.read_lines(text)
               if not line.code and line.text.startswith("# ")) == 1


def test_all_notebooks_are_in_the_guide():
    assert NOTEBOOKS and set(NOTEBOOKS) <= set(site_map.GUIDE)
