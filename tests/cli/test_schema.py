# SPDX-License-Identifier: BSD-3-Clause
"""`percolith schema`."""

import json
import tomllib

import pytest

from conftest import ROOT

EXAMPLES = sorted(path.parent.name for path in (ROOT / "examples").glob("*/case.toml"))


def test_schema_is_json(percolith):
    done = percolith("schema")
    assert done.returncode == 0
    schema = json.loads(done.stdout)
    assert "mesh" in schema["properties"]


@pytest.mark.parametrize("name", EXAMPLES)
def test_examples_agree_with_the_schema(percolith, name):
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads(percolith("schema").stdout)
    case = tomllib.loads((ROOT / "examples" / name / "case.toml").read_text())
    jsonschema.validate(case, schema)


def test_reference_is_the_page_in_the_documentation(percolith):
    done = percolith("schema", "--reference")
    assert done.returncode == 0
    assert done.stdout == (ROOT / "docs/options.md").read_text()
