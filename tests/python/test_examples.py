# SPDX-License-Identifier: BSD-3-Clause
"""Every example runs as shipped and meets its criteria."""

from pathlib import Path

import pytest

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
NAMES = sorted(file.parent.name for file in EXAMPLES.glob("*/expected.toml"))
LONG = {"brazilian", "breakout", "compression", "double_cantilever", "multi_stage",
        "natural_fractures", "perpendicular_cracks", "rubble", "slope", "slow_fracture",
        "three_cracks", "tunnel", "tunnel_damage"}  # see `make verify`
CHAPTERS = {"slow_fracture": "kgd"}  # of the verification, where they have another name


def test_every_example_has_criteria_and_a_page():
    folders = [folder for folder in EXAMPLES.iterdir() if folder.is_dir()]
    assert sorted(folder.name for folder in folders) == NAMES
    for folder in folders:
        for file in ("case.toml", "README.md", "picture.png"):
            assert (folder / file).is_file(), f"{folder.name} lacks {file}"
        assert (folder / "picture.png").stat().st_size < 200_000


def test_long_examples_are_verified():
    for name in LONG:
        check = EXAMPLES.parent / "verification" / CHAPTERS.get(name, name) / "check.py"
        assert f'check_criteria(chapter, "{name}"' in check.read_text(), f"{name} is run by nothing"


@pytest.mark.parametrize("name", [name for name in NAMES if name not in LONG])
def test_example_meets_its_criteria(name, run_example):
    import criteria

    failed = [f"{quantity}: {value:.4g} > {limit:.4g}"
              for quantity, value, limit in criteria.evaluate(name, run_example(name))
              if not value <= limit]
    assert not failed
