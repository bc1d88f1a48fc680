"""The quick check of the schema agrees with the package jsonschema."""

from __future__ import annotations

import json
from typing import Any

import jsonschema
import pytest

from sbgcgen.spec.quick_check import QuickCheck
from sbgcgen.spec.schema import SCHEMA_FILE

VALUES: list[Any] = [
    *(None, True, False, 0, 1, 2, 256, -1, "", "a", "ab", "A", "none", "u8"),
    *([], [1], [1, 2], [1, 1], [[1], [1]], ["a", 1], {}, {"a": 1}, {"a": "x"}, {"b": 1}),
    *({"a": 1, "b": 2}, {"a": 1, "c": True}, {"A": 1}, {"a": {"a": {"a": 1}}}, {"a": {"a": "x"}}),
]
RULES: list[dict[str, Any]] = [
    *({"type": kind} for kind in ("array", "boolean", "integer", "null", "object", "string")),
    *(
        {"type": ["integer", "null"]},
        {"type": ["boolean", "integer"]},
        {"type": ["string", "object"]},
    ),
    *({"minimum": 1, "type": "integer"}, {"maximum": 1, "type": "integer"}, {"pattern": "^a"}),
    *(
        {"enum": [1, "a", "none"]},
        {"enum": [True]},
        {"const": True},
        {"const": 1},
        {"const": "none"},
    ),
    *({"minItems": 1}, {"minLength": 1}, {"minProperties": 1}, {"uniqueItems": True}),
    *({"items": {"type": "integer"}}, {"required": ["a"]}, {"dependentRequired": {"a": ["b"]}}),
    *({"propertyNames": {"pattern": "^[ab]$"}}, {"additionalProperties": False}),
    {"properties": {"a": {"type": "integer"}}},
    {"properties": {"a": {"type": "integer"}}, "additionalProperties": False},
    {"properties": {"a": {"type": "integer"}}, "additionalProperties": {"type": "boolean"}},
    {"patternProperties": {"^[a-c]$": {"type": "integer"}}, "additionalProperties": False},
    {"properties": {"a": True}, "patternProperties": {"a": {"type": "string"}}},
    {"anyOf": [{"type": "string", "minLength": 2}, {"type": "array", "minItems": 2}]},
    {"description": "words", "examples": [1], "type": "string"},
    {"$ref": "#/$defs/nested"},
    {"type": "array", "items": {"$ref": "#/$defs/nested"}},
]
NESTED = {
    "anyOf": [
        {"type": "integer"},
        {"type": "object", "properties": {"a": {"$ref": "#/$defs/nested"}}},
    ]
}


@pytest.mark.parametrize("rules", RULES, ids=json.dumps)
def test_each_keyword_against_jsonschema(rules: dict[str, Any]) -> None:
    schema = {"$defs": {"nested": NESTED, "it": rules}}
    check = QuickCheck(schema).definition("it")
    reference = jsonschema.Draft202012Validator({**schema, "$ref": "#/$defs/it"})
    assert [check(value) for value in VALUES] == [reference.is_valid(value) for value in VALUES]
    if "description" not in rules:
        assert False in map(check, VALUES), "the values do not violate these rules"


def test_every_keyword_of_the_schema_is_known() -> None:
    schema = json.loads(SCHEMA_FILE.read_text(encoding="utf-8"))
    check = QuickCheck(schema)
    for name in schema["$defs"]:
        check.definition(name)


def test_unknown_keyword_is_an_error() -> None:
    with pytest.raises(NotImplementedError, match="multipleOf"):
        QuickCheck({"$defs": {"it": {"multipleOf": 2}}}).definition("it")
