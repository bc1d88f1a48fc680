"""Tests of the names that a type of the spec cannot have in the Python package."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from sbgcgen.targets.python.lint import TAKEN
from support import PROJECT


def needed(source: str) -> Iterator[str]:
    """What a module imports from elsewhere, and what else it has beside the types of the spec."""
    for node in ast.parse(source).body:
        if isinstance(node, ast.ImportFrom) and node.module != "__future__":
            yield from (name.asname or name.name for name in node.names if name.name != "*")
        elif isinstance(node, ast.Assign):
            yield from (one.id for one in node.targets if isinstance(one, ast.Name))


def test_names_that_modules_need_are_complete() -> None:
    """A type of the same name would take the place of what the modules need."""
    modules = list((PROJECT / "generated/python/sbgc/msg").glob("*.py"))
    assert len(modules) > 10
    found = {name for path in modules for name in needed(path.read_text(encoding="utf-8"))}
    assert found - {"__all__"} | {"Framing"} == TAKEN
