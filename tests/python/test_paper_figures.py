# SPDX-License-Identifier: BSD-3-Clause
"""The section with the figures of the paper: complete, not run, incomplete; and its table."""

import base64
import json
import sys

import matplotlib
import pytest

matplotlib.use("Agg")


def chapter(pictures=("curve", "mesh"), rows=("error.a", "error.b", "other")):
    import report

    made = report.Chapter("fake", "A fake chapter")
    png = base64.b64encode(b"PNG").decode()
    made.pictures = [report.Picture(name, f"Caption of {name}", png) for name in pictures]
    for name in rows:
        made.at_most(name, f"quantity {name}", 0.5, 1.0)
    return made


def figures():
    from paper_figures import PaperFigure

    return [PaperFigure(13, "an error", "fake", ("curve",), ("error.*",), reference="a formula",
                        differs="not quite <the same>"),
            PaperFigure(14, "a mesh", "fake", ("mesh",), set_up="our mesh"),
            PaperFigure(15, "a run", "absent", ("field",), ("row",), reference="a table")]


def entry(page: str, number: int) -> str:
    return page.split(f'<article class="paper" id="figure_{number}">')[1].split("</article>")[0]


def test_an_entry_shows_its_pictures_beside_its_reference_and_rows(tmp_path):
    import report

    assert report.write([chapter()], tmp_path, figures()) == []
    page = (tmp_path / "index.html").read_text()
    shown = entry(page, 13)
    assert "Figure 13: an error" in shown and ">pass<" in shown and "a formula" in shown
    assert "Caption of curve" in shown and 'href="#fake.curve"' in shown
    assert "Caption of mesh" not in shown
    assert "quantity error.a" in shown and "quantity error.b" in shown
    assert "quantity other" not in shown
    assert "not quite &lt;the same&gt;" in shown
    assert ">set-up<" in entry(page, 14) and "our mesh" in entry(page, 14)
    # The chapter knows which figures its pictures stand for.
    assert '<figure id="fake.curve">' in page
    assert page.count('<a href="#figure_13">figure 13</a>') == 1


def test_a_chapter_that_was_not_run_is_said_to_be_so(tmp_path):
    import report

    assert report.write([chapter()], tmp_path, figures()) == []
    shown = entry((tmp_path / "index.html").read_text(), 15)
    assert ">not run<" in shown and "python verification/run.py absent" in shown
    assert "a table" in shown


@pytest.mark.parametrize("made, what", [
    ({"pictures": ("mesh",)}, "figure_13: fake has no picture curve"),
    ({"rows": ("other",)}, "figure_13: fake has no row error.*")])
def test_what_a_chapter_that_ran_lacks_is_a_failure(tmp_path, made, what):
    import report

    assert report.write([chapter(**made)], tmp_path, figures()) == [what]
    shown = entry((tmp_path / "index.html").read_text(), 13)
    assert ">fail<" in shown and "Missing: " + what.split(": ")[1] in shown
    failed = [row for row in json.loads((tmp_path / "report.json").read_text()) if not row["pass"]]
    assert [(row["id"], row["quantity"]) for row in failed] == [tuple(what.split(": "))]


def test_a_figure_that_names_nothing_is_a_failure(tmp_path):
    import report
    from paper_figures import PaperFigure

    empty = PaperFigure(13, "nothing", "fake", (), (), reference="none")
    assert report.write([chapter()], tmp_path, [empty]) == ["figure_13: it names no picture",
                                                            "figure_13: it names no row"]


def test_a_row_beyond_its_limit_fails_the_figure(tmp_path):
    import report

    made = chapter()
    made.at_most("error.c", "too large", 2.0, 1.0)
    assert report.write([made], tmp_path, figures()) == []
    assert ">fail<" in entry((tmp_path / "index.html").read_text(), 13)


@pytest.mark.parametrize("pictures, code", [(("curve", "mesh"), 0), (("mesh",), 1)])
def test_a_missing_picture_fails_the_whole_run(tmp_path, monkeypatch, capsys, pictures, code):
    import report
    import run

    monkeypatch.setattr(run, "OUTPUT", tmp_path)
    monkeypatch.setattr(run, "available", lambda: ["fake"])
    monkeypatch.setattr(run, "program", lambda: "fake program")
    monkeypatch.setattr(run, "verify", lambda name: chapter(pictures))
    write = report.write
    monkeypatch.setattr(report, "write", lambda found, folder: write(found, folder, figures()))
    monkeypatch.setattr(sys, "argv", ["run.py"])
    assert run.main() == code
    lacks = "FAIL  the paper's figure_13: fake has no picture curve" in capsys.readouterr().out
    assert lacks == bool(code)


def test_the_table_is_complete_and_in_order():
    import run
    from paper_figures import FIGURES

    assert [figure.number for figure in FIGURES] == list(range(13, 38))
    for figure in FIGURES:
        assert figure.shows and figure.pictures
        assert figure.chapter in run.available()
        assert bool(figure.rows) == bool(figure.reference) == (not figure.is_set_up)
