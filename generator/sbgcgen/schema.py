"""Checks the shape of the YAML against the JSON Schema that editors use, too."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import jsonschema

from sbgcgen.diagnostics import Diagnostics, Position, did_you_mean
from sbgcgen.load import List, Map, Spec

SCHEMA_FILE = Path(__file__).resolve().parent.parent / "schema" / "sbgc-spec.schema.json"


def check_shape(spec: Spec, found: Diagnostics) -> None:
    """Report whatever the schema does not allow, each at its place in the YAML."""
    schema = json.loads(SCHEMA_FILE.read_text(encoding="utf-8"))
    parts = [("main", spec.main), ("errata", spec.errata)]
    parts += [("family", family) for family in spec.families.values()]
    for kind, content in parts:
        if not content:
            continue  # the file could not be read, which is reported already
        rules = {"$ref": f"#/$defs/{kind}", "$defs": schema["$defs"]}
        checker = jsonschema.Draft202012Validator(rules)
        _report_all(checker.iter_errors(content), content, found)


def _report_all(errors: Iterable[Any], content: Map, found: Diagnostics) -> None:
    """Errors of one file; a key that is missing is not reported beside one that is misspelt."""
    errors = list(errors)
    misspelt = [list(e.absolute_path) for e in errors if e.validator == "additionalProperties"]
    for error in errors:
        if error.validator != "required" or list(error.absolute_path) not in misspelt:
            _report(error, content, found)


def _report(error: Any, content: Map, found: Diagnostics) -> None:
    """One schema error; of alternatives, the one that fits best is reported."""
    closest = _closest_branch(error)
    if closest:
        _report_all(closest, content, found)
        return
    node: Any = content
    at = content.position
    for step in error.absolute_path:
        at = _child_position(node, step) or at
        node = node[step]
    if any(earlier.position == at and earlier.code == "SBGC001" for earlier in found.found):
        return  # a value that could not be read is reported as such
    hint = str(error.schema.get("description", ""))
    message = str(error.message)
    if error.validator == "additionalProperties" and isinstance(node, Map):
        _report_unknown_keys(error, node, found)
        return
    if error.validator == "required":
        key = message.split(" is a required")[0].strip("'")
        message = f"a key is missing: '{key}'"
        hint = str(error.schema.get("properties", {}).get(key, {}).get("description", hint))
    elif error.validator == "dependentRequired":
        message = "'replaced_by' stands only beside 'deprecated'"
    elif error.validator == "uniqueItems":
        message = "something stands twice here"
    elif error.validator in ("minProperties", "minItems", "minLength"):
        message = "this must not be empty"
    elif error.validator == "enum":
        hint = did_you_mean(str(node), [str(v) for v in error.validator_value])
        hint = hint or f"one of: {', '.join(str(v) for v in error.validator_value)}"
        message = f"'{node}' is not possible here"
    elif error.validator == "pattern":
        message = f"'{node}' is not written as it should be"
    elif error.validator == "type":
        message = f"this should be {_words(error.validator_value)}, not {_kind(node)}"
        if node is None:
            hint = "what belongs to a key stands behind it, or below it and further to the right"
        elif error.validator_value == "array":
            hint = "put each into a line of its own, behind '- '; or write [a, b]"
        elif error.validator_value == "object" and isinstance(node, list):
            hint = "write 'NAME:' without '- ' in front of it"
    elif error.validator in ("anyOf", "oneOf"):
        message = f"{_kind(node)} is none of the forms that are possible here"
    found.add(at, "SBGC004", message, hint)


def _closest_branch(error: Any) -> list[Any]:
    """Of the alternatives of an anyOf, the errors of the one that was probably meant."""
    branches: dict[Any, list[Any]] = {}
    for inner in error.context or ():
        branches.setdefault(inner.schema_path[0], []).append(inner)
    here = len(error.absolute_path)
    meant = [
        errors
        for errors in branches.values()
        if not any(
            e.validator in ("type", "const") and len(e.absolute_path) == here for e in errors
        )
    ]
    return min(meant, key=len) if meant else []


def _report_unknown_keys(error: Any, node: Map, found: Diagnostics) -> None:
    known = list(error.schema.get("properties", {}))
    patterns = list(error.schema.get("patternProperties", {}))
    for key in node:
        if key in known or any(re.search(pattern, key) for pattern in patterns):
            continue
        hint = did_you_mean(key, known) or f"known here: {', '.join(sorted(known))}"
        if patterns:
            hint = str(error.schema.get("propertyNames", {}).get("description", ""))
        found.add(node.at(key), "SBGC004", f"unknown key '{key}'", hint)


def _child_position(node: Any, step: Any) -> Position | None:
    if isinstance(node, Map):
        return node.at(str(step))
    if isinstance(node, List):
        return node.items_at[int(step)]
    return None


def _words(kind: Any) -> str:
    kinds = kind if isinstance(kind, list) else [kind]
    names = {"object": "a mapping", "array": "a list", "string": "text", "integer": "a number"}
    return " or ".join(names.get(k, str(k)) for k in kinds)


def _kind(node: Any) -> str:
    if node is None:
        return "empty"
    if isinstance(node, dict):
        return "a mapping"
    return "a list" if isinstance(node, list) else f"'{node}'"
