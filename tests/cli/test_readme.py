# SPDX-License-Identifier: BSD-3-Clause
"""What the README shows is what the program does."""

import json
import re
from pathlib import Path

README = (Path(__file__).resolve().parents[2] / "README.md").read_text(encoding="utf-8")


def _wall(folder: Path) -> Path:
    case, geometry = re.findall(r"^```(?:toml)?\n(.*?)^```", README, re.M | re.S)[:2]
    (folder / "wall.geo").write_text(geometry, encoding="utf-8")
    (folder / "case.toml").write_text(case, encoding="utf-8")
    return folder / "case.toml"


def test_the_first_case_runs(percolith, tmp_path):
    case = _wall(tmp_path)
    result = percolith("run", case)
    assert result.returncode == 0, result.stderr
    summary = json.loads((tmp_path / "case.results" / "summary.json").read_text())
    assert summary["end_time_s"] == 10 * 86400
    assert summary["mass_balance"]["relative_error"] < 1e-12


def test_the_mistake_it_shows_is_reported_as_shown(percolith, tmp_path):
    case = _wall(tmp_path)
    case.write_text(case.read_text().replace('"10 mdarcy" ', '"10 MPa"'), encoding="utf-8")
    result = percolith("check", case)
    assert result.returncode == 2
    shown = re.search(r"^    (case\.toml:\d+:\d+: error: .*?)\.\.\.$", README, re.M).group(1)
    assert shown in result.stderr


def test_every_linked_page_exists():
    root = Path(__file__).resolve().parents[2]
    for target in re.findall(r"\]\((?!http)([^)#]+)\)", README):
        assert (root / target).exists(), target
