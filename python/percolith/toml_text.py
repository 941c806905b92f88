# SPDX-License-Identifier: BSD-3-Clause
"""Python values as TOML in one line, as the options of a case are set; and whole documents.

Libraries that write TOML write documents; here each value must stand alone, numbers of numpy and
paths included.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping
from typing import Any

import numpy as np

from percolith.errors import CaseError


def plain(value: Any, path: str = "") -> Any:
    """The value as TOML knows it: dict, list, str, bool, int or float. Raises CaseError, which
    names the option at the dotted path where that is given."""
    if isinstance(value, (bool, str)):
        return value
    if isinstance(value, np.generic):
        return plain(value.item(), path)
    if isinstance(value, (int, float)):
        return value
    if isinstance(value, np.ndarray):
        return plain(value.tolist(), path)
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Mapping):
        return {_name(key, path): plain(entry, f"{path}.{key}" if path else str(key))
                for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(entry, path) for entry in value]
    raise CaseError(f"error: {_of(path, ' = ')}{value!r}: a {type(value).__name__} is no value of "
                    "an option; allowed: numbers, texts such as \"2 MPa\", true or false, lists, "
                    "dictionaries")


def _of(path: str, mark: str) -> str:
    return f"{path}{mark}" if path else ""


def _name(key: Any, path: str) -> str:
    if not isinstance(key, str):
        raise CaseError(f"error: {_of(path, ': ')}{key!r}: names of options are texts")
    return key


def inline(value: Any) -> str:
    """A plain value as TOML in one line; reading it gives the same bits."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, float) and not math.isfinite(value):
        return "nan" if math.isnan(value) else ("inf" if value > 0 else "-inf")
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, list):
        return "[" + ", ".join(map(inline, value)) + "]"
    return "{ " + ", ".join(f"{_key(key)} = {inline(entry)}" for key, entry in value.items()) + " }"


def _key(name: str) -> str:
    bare = name.isascii() and name.replace("_", "").replace("-", "").isalnum()
    return name if bare else json.dumps(name, ensure_ascii=False)


def document(tree: Mapping[str, Any]) -> str:
    """Nested dictionaries of plain values as a TOML document."""
    lines: list[str] = []
    _add_table(tree, "", lines)
    return "\n".join(lines) + "\n"


def _add_table(tree: Mapping[str, Any], path: str, lines: list[str]) -> None:
    values = {key: entry for key, entry in tree.items() if not isinstance(entry, dict)}
    tables = {key: entry for key, entry in tree.items() if isinstance(entry, dict)}
    if path and (values or not tables):
        lines += ["", f"[{path}]"]
    lines += [f"{_key(key)} = {inline(entry)}" for key, entry in values.items()]
    for key, entry in tables.items():
        _add_table(entry, f"{path}.{_key(key)}" if path else _key(key), lines)
