# SPDX-License-Identifier: BSD-3-Clause
"""The page on the package: its code runs. And what is documented, and how, in the package itself."""

import inspect
import re
import subprocess
import sys
from pathlib import Path

import percolith
import pytest
from percolith import _core

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/python.md"


def test_the_code_of_the_page_runs(tmp_path):
    pytest.importorskip("gmsh")
    pytest.importorskip("pandas")
    blocks = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), re.MULTILINE | re.DOTALL)
    assert len(blocks) > 10
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    (tmp_path / "page.py").write_text("\n".join(blocks))
    done = subprocess.run([sys.executable, "page.py"], cwd=tmp_path, capture_output=True, text=True,
                          check=False, timeout=300)
    assert done.returncode == 0, done.stderr
    assert 'the unit "MPa" is not one of time' in done.stdout
    assert "Young's modulus" in done.stdout


def test_the_page_names_what_there_is():
    words = set(re.findall(r"`(?:mesh|flow|motion)\.(\w+)`", PAGE.read_text()))
    known = {name for kind in (_core.Mesh, _core.Flow, _core.Motion) for name in dir(kind)}
    assert words and words <= known | set(dir(percolith.mesh))


def test_every_public_name_has_a_docstring():
    for name in percolith.__all__:
        thing = getattr(percolith, name)
        if callable(thing):
            assert inspect.getdoc(thing), name
    for kind in (percolith.Case, percolith.Simulation, percolith.RunDirectory, percolith.Sweep):
        for name, member in inspect.getmembers(kind):
            if not name.startswith("_") and (callable(member) or isinstance(member, property)):
                assert inspect.getdoc(member), f"{kind.__name__}.{name}"


def test_arrays_say_their_shape_and_unit():
    for kind, name, parts in [(_core.Flow, "pressure", ("(blocks, 8, 3)", "Pa")),
                              (_core.Flow, "aperture", ("(joints,)", " m")),
                              (_core.Motion, "displacement_x", ("(blocks, 8, 3)", "m")),
                              (_core.Mesh, "vertices", ("(vertices, 2)", "m"))]:
        for part in parts:
            assert part in getattr(kind, name).__doc__


def test_stubs_tell_the_types():
    folder = Path(_core.__file__).parent
    stub = (folder / "_core.pyi").read_text()
    for name in ("class Run", "class Flow", "class CheckReport", "def quantity"):
        assert name in stub
    assert (folder / "py.typed").is_file()


def test_results_are_read_without_the_extension(tmp_path):
    code = ("import sys; sys.modules['percolith._core'] = None\n"
            "import percolith\n"
            "print(percolith.RunDirectory)\n"
            "try: percolith.Case\n"
            "except ImportError as error: print(error)")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "pip install ." in done.stdout


def test_a_processor_that_is_too_old_is_told_before_it_fails():
    from percolith.processor import missing_features

    new = "processor : 0\nflags\t\t: fpu avx2 bmi1 bmi2 f16c fma movbe\n"
    assert missing_features("x86-64-v3", new) == []
    assert missing_features("x86-64-v3", new.replace("fma ", "")) == ["fma"]
    assert missing_features("x86-64-v3", "Features : asimd\n") == []
    assert missing_features("", "flags : fpu\n") == []
