# SPDX-License-Identifier: BSD-3-Clause
"""The cases and the commands that the documents show pass `percolith check`."""

import re
import shlex
import shutil
import subprocess

import markdown_text
import pytest
import site_map

from conftest import ROOT

FILES = sorted(file for file in site_map.pages(site_map.tracked()))
# The start page is run as it stands, by test_start.py.
RUN = "docs/start.md"
# Which mesh a case of the documents means that no file of that name lies beside.
MESHES = {"strip.msh": "examples/strip/strip_05.msh",
          "brazilian.msh": "examples/brazilian/brazilian.msh"}


def whole_cases() -> list[tuple[str, markdown_text.Block]]:
    """The blocks that are a case by themselves."""
    tables = ("format = 1", "[mesh]", "[material.", "[time]")
    return [(file, block) for file in FILES if file != RUN
            for block in markdown_text.blocks(site_map.text_of(file))
            if block.language == "toml" and all(table in block.text for table in tables)]


def geometry_named(name: str) -> str:
    """The geometry that the README gives for its first case; the block of the start page, with its
    notch as long as the guide's."""
    found = {"wall.geo": (block.text for block in markdown_text.blocks(site_map.text_of("README.md"))
                          if "Physical Curve" in block.text),
             "block.geo": (re.sub(r"notch = 0\.3;", "notch = 0.4;", block.text)
                           for block in markdown_text.blocks(site_map.text_of(RUN)) if block.language == "c")}
    return next(found[name])


def make_mesh(name: str, folder) -> None:
    if name in MESHES:
        shutil.copyfile(ROOT / MESHES[name], folder / name)
        return
    geometry = folder / name.replace(".msh", ".geo")
    geometry.write_text(geometry_named(geometry.name), encoding="utf-8")
    if name.endswith(".msh"):
        subprocess.run(["gmsh", "-2", "-v", "0", geometry.name, "-o", name], cwd=folder, check=True)


def check(program, folder, arguments) -> subprocess.CompletedProcess:
    return subprocess.run([program, "check", *arguments], cwd=folder, capture_output=True, text=True,
                          check=False, timeout=120)


@pytest.mark.parametrize("file, block", [pytest.param(file, block, id=f"{file}:{block.line}")
                                         for file, block in whole_cases()])
def test_whole_cases_are_valid(file, block, program, tmp_path):
    (tmp_path / "case.toml").write_text(block.text, encoding="utf-8")
    make_mesh(re.search(r'^file = "(.*)"', block.text, re.MULTILINE)[1], tmp_path)
    done = check(program, tmp_path, ["case.toml"])
    assert done.returncode == 0, done.stderr


def test_there_are_such_cases():
    assert {file for file, _ in whole_cases()} == {"README.md", "docs/case-file.md"}
    assert len(whole_cases()) >= 4


def commands(text: str) -> list[str]:
    """The commands `percolith run` and `percolith check` in blocks of code, continued lines joined."""
    code = "\n".join(line.text.strip() for line in markdown_text.read_lines(text) if line.code)
    return re.findall(r"^percolith (?:run|check) (.*)$", code.replace("\\\n", " "), re.MULTILINE)


def changed_cases() -> list[tuple[str, str]]:
    """Commands with options of their own, each with the folder it is meant for. Those without are
    of cases that other tests run; names such as my_case are of nothing that exists."""
    found = {}
    for file in FILES:
        for command in commands(site_map.text_of(file)) if file != RUN else []:
            case = shlex.split(command, comments=True)[0]
            here = (ROOT / file).parent
            folder = next((place for place in (here, ROOT) if (place / case).is_file()), None)
            if folder and "--set" in command:
                found[str(folder.relative_to(ROOT)), command] = None
    return list(found)


@pytest.mark.parametrize("folder, command", changed_cases(), ids=lambda text: text[:60])
def test_commands_name_options_that_exist(folder, command, program):
    parts = iter(shlex.split(command, comments=True))
    arguments = []
    for part in parts:
        if part == "--output":
            next(parts)
        elif part != "--force":
            arguments.append(part)
    done = check(program, ROOT / folder, arguments)
    assert done.returncode == 0, done.stderr


def test_there_are_such_commands():
    assert len(changed_cases()) >= 8
