"""Validates the YAML against the JSON Schema, which editors use as well."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import jsonschema

from sbgcgen.model import Position
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import List, Map, Spec

SCHEMA_FILE = Path(__file__).resolve().parents[2] / "schema" / "sbgc-spec.schema.json"


@dataclass(frozen=True)
class ShapeError:
    """One violation of the schema."""

    error: Any  # of jsonschema
    content: Map  # of the file
    node: Any  # the invalid node, and the node that contains it
    parent: Map | List | None

    @property
    def validator(self) -> str:
        return str(self.error.validator)

    @property
    def step(self) -> Any:
        """The last step of the path."""
        return self.error.absolute_path[-1]

    @property
    def known(self) -> list[str]:
        """The allowed keys or values."""
        if self.validator == "enum":
            return [str(value) for value in self.error.validator_value]
        return list(self.error.schema.get("properties", {}))

    @property
    def unknown(self) -> list[str]:
        """The keys that are neither known nor fit a pattern."""
        patterns = self.error.schema.get("patternProperties", {})
        others = [key for key in self.node if key not in self.known]
        return [key for key in others if not any(re.search(pattern, key) for pattern in patterns)]

    @property
    def missing(self) -> str:
        """The required key that is missing."""
        return str(self.error.message).split(" is a required")[0].strip("'")


def check_shape(spec: Spec, found: Diagnostics) -> None:
    """Report every violation of the schema at its position in the YAML."""
    for error in shape_errors(spec):
        add_shape_error(error, found)


def shape_errors(spec: Spec) -> Iterator[ShapeError]:
    """All violations of the schema."""
    parts = [("main", spec.main), ("errata", spec.errata)]
    parts += [("family", family) for family in spec.families.values()]
    for kind, content in parts:
        if not content:
            continue  # the file could not be read, which has been reported
        yield from _relevant_errors(_validator(kind).iter_errors(content), content)


@cache
def definitions() -> dict[str, Any]:
    """The definitions of the schema. A form is a message without forms, so hints do not offer that key."""
    found: dict[str, Any] = json.loads(SCHEMA_FILE.read_text(encoding="utf-8"))["$defs"]
    keys = {key: schema for key, schema in found["message"]["properties"].items() if key != "forms"}
    found["form"] = {**found["message"], **found["form"], "properties": keys}
    del found["form"]["$ref"]
    return found


@cache
def _validator(kind: str) -> jsonschema.Draft202012Validator:
    schema = {"$ref": f"#/$defs/{kind}", "$defs": definitions()}
    return jsonschema.Draft202012Validator(schema)


def _relevant_errors(errors: Iterable[Any], content: Map) -> Iterator[ShapeError]:
    """The errors of one file; for alternatives, those of the best match.

    Drops a missing key if the same node has a misspelled one, which may be the missing key.
    """
    errors = list(errors)
    misspelt = [list(e.absolute_path) for e in errors if e.validator == "additionalProperties"]
    for error in errors:
        if error.validator == "required" and list(error.absolute_path) in misspelt:
            continue
        branch = _closest_branch(error)
        if branch:
            yield from _relevant_errors(branch, content)
            continue
        node: Any = content
        parent: Any = None
        for step in error.absolute_path:
            node, parent = node[step], node
        yield ShapeError(error, content, node, parent)


def add_shape_error(shape: ShapeError, found: Diagnostics) -> None:
    """Report one violation."""
    error, node = shape.error, shape.node
    at = shape.content.position
    inner: Any = shape.content
    for step in error.absolute_path:
        at = _child_position(inner, step) or at
        inner = inner[step]
    if any(earlier.position == at and earlier.code == "SBGC001" for earlier in found.found):
        return  # the value could not be read, which has been reported
    hint = str(error.schema.get("description", ""))
    message = str(error.message)
    if error.validator == "additionalProperties" and isinstance(node, Map):
        _report_unknown_keys(shape, found)
        return
    if error.validator == "required":
        key = shape.missing
        message = f"a key is missing: '{key}'"
        hint = str(error.schema.get("properties", {}).get(key, {}).get("description", hint))
    elif error.validator == "dependentRequired":
        message = "'replaced_by' is valid only with 'deprecated'"
    elif error.validator == "uniqueItems":
        message = "an item occurs twice here"
    elif error.validator in ("minProperties", "minItems", "minLength"):
        message = "this must not be empty"
    elif error.validator == "enum":
        hint = did_you_mean(str(node), shape.known) or f"one of: {', '.join(shape.known)}"
        message = f"'{node}' is not possible here"
    elif error.validator == "pattern":
        message = f"'{node}' has the wrong syntax"
    elif error.validator == "type":
        message = f"this should be {_words(error.validator_value)}, not {_kind(node)}"
        if node is None:
            hint = "the value of a key follows it, or is below it and indented further"
        elif error.validator_value == "array":
            hint = "put each on its own line after '- ', or write [a, b]"
        elif error.validator_value == "object" and isinstance(node, list):
            hint = "write 'NAME:' without '- ' before it"
    elif error.validator in ("anyOf", "oneOf"):
        message = f"{_kind(node)} has none of the valid forms"
    found.add(at, "SBGC004", message, hint)


def _closest_branch(error: Any) -> list[Any]:
    """The errors of the probably intended alternative of an anyOf."""
    branches: dict[Any, list[Any]] = {}
    for inner in error.context or ():
        branches.setdefault(inner.schema_path[0], []).append(inner)
    here = len(error.absolute_path)
    meant = [
        errors
        for errors in branches.values()
        if not any(_is_of_another_kind(e) and len(e.absolute_path) == here for e in errors)
    ]
    return min(meant, key=len) if meant else []


def _is_of_another_kind(error: Any) -> bool:
    """True if a value has the wrong kind, such as a list in place of a word."""
    if error.validator == "enum":
        return isinstance(error.instance, (dict, list))
    return error.validator in ("type", "const")


def _report_unknown_keys(shape: ShapeError, found: Diagnostics) -> None:
    for key in shape.unknown:
        hint = did_you_mean(key, shape.known) or f"known here: {', '.join(sorted(shape.known))}"
        if ":" in key:
            hint = "put an ordinary space after the colon"
        elif shape.node[key] is None and not re.fullmatch(r"[A-Za-z_]+", key):
            hint = "a comma separates keys here: put quotes around a text that contains one"
        elif "patternProperties" in shape.error.schema:
            hint = str(shape.error.schema.get("propertyNames", {}).get("description", ""))
        found.add(shape.node.at(key), "SBGC004", f"unknown key '{key}'", hint)


def _child_position(node: Any, step: Any) -> Position | None:
    if isinstance(node, Map):
        return node.at(str(step))
    if isinstance(node, List):
        return node.items_at[int(step)]
    return None


def _words(kind: Any) -> str:
    kinds = kind if isinstance(kind, list) else [kind]
    names = {"object": "a mapping", "array": "a list", "string": "text", "integer": "a number"}
    names["boolean"] = "true or false"
    return " or ".join(names.get(k, str(k)) for k in kinds)


def _kind(node: Any) -> str:
    if node is None:
        return "empty"
    if isinstance(node, dict):
        return "a mapping"
    return "a list" if isinstance(node, list) else f"'{node}'"
