# SPDX-License-Identifier: BSD-3-Clause
"""`percolith new`."""

from conftest import ROOT, files_of


def test_lists_the_examples_with_their_titles(percolith):
    done = percolith("new")
    assert done.returncode == 0
    for case in (ROOT / "examples").glob("*/case.toml"):
        assert case.parent.name in done.stdout
    assert "Transient flow through a strip" in done.stdout
    assert "percolith new EXAMPLE DIR" in done.stdout


def test_copies_an_example_that_can_be_checked(percolith, tmp_path):
    done = percolith("new", "strip", "mine")
    assert done.returncode == 0
    assert done.stdout == ("Copied strip to mine. Next:\n"
                           "  percolith check mine/case.toml\n"
                           "  percolith run mine/case.toml\n")
    assert files_of(tmp_path / "mine")["case.toml"] == (
        ROOT / "examples/strip/case.toml").read_bytes()
    assert percolith("check", "mine/case.toml").returncode == 0


def test_takes_the_name_of_the_example_for_the_folder(percolith, tmp_path):
    assert percolith("new", "radial").returncode == 0
    assert (tmp_path / "radial/case.toml").is_file()


def test_refuses_a_folder_with_content(percolith, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/thesis.tex").write_text("mine")
    done = percolith("new", "strip", "mine")
    assert done.returncode == 2
    assert done.stderr == ("error: DIR = mine: exists and is not an empty folder; "
                           "allowed: a new or empty folder\n")
    assert list(files_of(tmp_path / "mine")) == ["thesis.tex"]


def test_unknown_example_names_the_nearest(percolith, tmp_path):
    done = percolith("new", "stripp", "mine")
    assert done.returncode == 2
    assert done.stderr.startswith(
        "error: EXAMPLE = stripp: no such example, did you mean strip?; allowed: ")
    assert not (tmp_path / "mine").exists()


def test_tells_where_the_copy_cannot_be_made(percolith, tmp_path):
    (tmp_path / "file").write_text("")
    done = percolith("new", "strip", "file/mine")
    assert done.returncode == 4
    assert "file/mine: cannot make the folder: Not a directory" in done.stderr
