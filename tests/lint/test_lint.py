# SPDX-License-Identifier: BSD-3-Clause
"""tools/lint.sh reports mistakes wherever they stand, though it reads a room as one source."""

import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COPIED = (".clang-tidy", "CMakePresets.json", "cmake/PercolithRooms.cmake", "tools/lib.sh",
          "tools/lint.sh")
FILES = {
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.22)
project(seeded LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
include(cmake/PercolithRooms.cmake)
add_library(percolith_compile INTERFACE)
target_include_directories(percolith_compile INTERFACE src)
add_custom_target(percolith_version)
add_subdirectory(src/percolith)
""",
    "src/percolith/CMakeLists.txt": "percolith_room(seeded)\n",
    "src/percolith/seeded/seeded.hpp": """\
#pragma once
namespace seeded {
struct Thing {
  int number = 0;
};
inline bool is_first(int number) { return number == 1; }
int first(int number);
int second(int number);
}
""",
    "src/percolith/seeded/first.cpp": """\
#include "percolith/seeded/seeded.hpp"
namespace {
int one() { return 1; }
}
int seeded::first(int number) { return is_first(number) ? one() : 2; }
""",
    "src/percolith/seeded/second.cpp": """\
#include "percolith/seeded/seeded.hpp"
using seeded::Thing;
namespace short_name = seeded;
namespace {
int number_of(const Thing& thing) { return thing.number; }
}
int seeded::second(int number) { return number_of({number}) + short_name::first(number); }
""",
}
# The file, the text in it, the mistake in its place, the check that must see it.
MISTAKES = (
    ("seeded.hpp", "number == 1", "number == 1 || number == 1", "misc-redundant-expression"),
    ("first.cpp", "one()", "One()", "readability-identifier-naming"),
    ("second.cpp", "({number})", "({number - number})", "misc-redundant-expression"),
    ("second.cpp", "const Thing&", "const seeded::Thing&", "misc-unused-using-decls"),
    ("second.cpp", "short_name::first", "first", "misc-unused-alias-decls"),
)


def lint(folder: Path, files: dict[str, str]) -> subprocess.CompletedProcess:
    """Lays out a project of one room with the tools of this one, and reads it."""
    for name in COPIED:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return subprocess.run([folder / "tools/lint.sh"], capture_output=True, text=True, check=False)


def test_calm_sources_pass(tmp_path):
    outcome = lint(tmp_path, FILES)
    assert outcome.returncode == 0, outcome.stdout + outcome.stderr
    # Both sources were read as one.
    assert len(list(tmp_path.glob("build/lint/**/unity_*.cxx"))) == 1


def test_every_mistake_is_reported(tmp_path):
    files = dict(FILES)
    for name, text, mistake, _ in MISTAKES:
        path = f"src/percolith/seeded/{name}"
        assert text in files[path]
        files[path] = files[path].replace(text, mistake)
    outcome = lint(tmp_path, files)
    assert outcome.returncode == 1, outcome.stdout + outcome.stderr
    lines = outcome.stdout.splitlines()
    for name, _, _, check in MISTAKES:
        assert any(f"/seeded/{name}:" in line and check in line for line in lines), (
            f"{check} in {name} is not among\n{outcome.stdout}")
