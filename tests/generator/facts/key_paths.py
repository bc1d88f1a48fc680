"""The key paths of the JSON Schema of the YAML, and their uses in the spec.

A path is a definition of the schema and the keys below it: `field.range`, `packed.parts`,
`main.line.pause_ms`. `*` is a name that the spec chooses, `[]` an item of a list.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import jsonschema

from sbgcgen.spec.load import Spec
from sbgcgen.spec.schema import definitions

Schema = dict[str, Any]
DEFS: dict[str, Schema] = definitions()
_ROOTS = ("main", "family", "errata")


@dataclass(frozen=True)
class Place:
    """A value of the spec with its parent, its key and its schema."""

    path: str
    parent: Any
    key: Any
    schema: Schema
    is_required: bool

    @property
    def value(self) -> Any:
        return self.parent[self.key]


def resolved(schema: Schema) -> tuple[str, Schema]:
    """Returns the name and schema of a referenced definition; the name is "" without a reference."""
    if "$ref" in schema:
        name = schema["$ref"].rpartition("/")[2]
        return name, DEFS[name]
    return "", schema


def validator(schema: Schema) -> Any:
    """Returns a validator for a part of the schema."""
    return jsonschema.Draft202012Validator({**schema, "$defs": DEFS})


def key_paths() -> set[str]:
    found: set[str] = set()
    done: set[str] = set()

    def walk(schema: Schema, path: str) -> None:
        name, schema = resolved(schema)
        if name in done:
            return
        done.update({name} - {""})
        path = name or path
        for branch in schema.get("anyOf", ()):
            walk(branch, path)
        for step, inner in _steps(schema):
            if step != "[]":
                found.add(f"{path}.{step}")
            walk(inner, path + (step if step == "[]" else f".{step}"))

    for root in _ROOTS:
        walk({"$ref": f"#/$defs/{root}"}, "")
    return found


def _steps(schema: Schema) -> Iterator[tuple[str, Schema]]:
    yield from schema.get("properties", {}).items()
    for inner in schema.get("patternProperties", {}).values():
        yield "*", inner
    if isinstance(schema.get("additionalProperties"), dict):
        yield "*", schema["additionalProperties"]
    if "items" in schema:
        yield "[]", schema["items"]


def places(spec: Spec) -> Iterator[Place]:
    """Yields the values of a spec that have a key."""
    files = [("main", spec.main), ("errata", spec.errata)]
    files += [("family", content) for content in spec.families.values()]
    for kind, content in files:
        yield from _walk(DEFS[kind], content, kind)


def nodes(spec: Spec, definition: str) -> Iterator[Any]:
    """Yields the mappings of a spec that have a definition of the schema."""
    for place in places(spec):
        _, schema = resolved(place.schema)
        if isinstance(place.value, list) and "items" in schema:
            found = [(schema["items"], item) for item in place.value]
        else:
            found = [(place.schema, place.value)]
        for own, value in found:
            name, inner = resolved(own)
            names = (name, *(resolved(branch)[0] for branch in inner.get("anyOf", ())))
            if definition in names and isinstance(value, dict):
                yield value


def _walk(schema: Schema, node: Any, path: str) -> Iterator[Place]:
    name, schema = resolved(schema)
    path = name or path
    if "anyOf" in schema:
        branch = next(b for b in schema["anyOf"] if validator(b).is_valid(node))
        yield from _walk(branch, node, path)
    elif isinstance(node, dict) and any(True for _ in _steps(schema)):
        for key, value in list(node.items()):
            inner, step = _of_key(schema, key)
            is_required = key in schema.get("required", ())
            yield Place(f"{path}.{step}", node, key, inner, is_required)
            yield from _walk(inner, value, f"{path}.{step}")
    elif isinstance(node, list) and "items" in schema:
        for item in list(node):
            yield from _walk(schema["items"], item, f"{path}[]")


def _of_key(schema: Schema, key: str) -> tuple[Schema, str]:
    if key in schema.get("properties", {}):
        return schema["properties"][key], key
    for pattern, inner in schema.get("patternProperties", {}).items():
        if re.search(pattern, key):
            return inner, "*"
    return schema["additionalProperties"], "*"
