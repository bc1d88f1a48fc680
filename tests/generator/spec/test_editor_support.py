"""Editors get the schema from the first line of each spec file, and explanations from the schema."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from sbgcgen.spec.schema import SCHEMA_FILE
from support import PROJECT

SPECS = sorted((PROJECT / "spec").glob("*.yaml"))
SCHEMA = json.loads(SCHEMA_FILE.read_text(encoding="utf-8"))


def name_of(path: Path) -> str:
    return path.stem


@pytest.mark.parametrize("path", SPECS, ids=name_of)
def test_the_first_line_names_the_schema(path: Path) -> None:
    first = path.read_text(encoding="utf-8").splitlines()[0]
    match = re.fullmatch(r"# yaml-language-server: \$schema=(\S+)", first)
    assert match, first
    assert (path.parent / match[1]).resolve() == SCHEMA_FILE


def test_new_files_of_the_guide_name_the_schema() -> None:
    guide = (PROJECT / "docs/10-new-commands.md").read_text(encoding="utf-8")
    files = [text for text in re.findall(r"```yaml\n(.*?)```", guide, re.S) if "\nfamily:" in text]
    assert files
    for text in files:
        assert text.splitlines()[0] == SPECS[0].read_text(encoding="utf-8").splitlines()[0]


def keys_of(node: Any, path: str) -> Iterator[tuple[str, Any]]:
    """Yields every key that a spec file may have, with its rules."""
    if isinstance(node, dict):
        for key, rules in node.get("properties", {}).items():
            yield f"{path}.{key}", rules
        for key, value in node.items():
            yield from keys_of(value, path if key == "properties" else f"{path}.{key}")
    elif isinstance(node, list):
        for item in node:
            yield from keys_of(item, path)


def resolved(rules: Any) -> Any:
    """Returns the definition that a key refers to, or its own rules."""
    return SCHEMA["$defs"][rules["$ref"].rpartition("/")[2]] if "$ref" in rules else rules


KEYS = [found for name, rules in SCHEMA["$defs"].items() for found in keys_of(rules, name)]


def test_every_key_has_a_description() -> None:
    assert len(KEYS) > 200
    for path, rules in KEYS:
        described = resolved(rules)
        explained = "description" in described or re.search(r"main\.|forms\.", path)
        assert explained or described.get("type") == "object", path


def test_examples_of_the_schema_are_valid() -> None:
    found = 0
    for path, rules in KEYS:
        checker = jsonschema.Draft202012Validator({**rules, "$defs": SCHEMA["$defs"]})
        for example in resolved(rules).get("examples", ()):
            found += 1
            assert not list(checker.iter_errors(example)), f"{path}: {example}"
    assert found > 20
