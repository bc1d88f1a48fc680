"""Tells quickly whether a value fits a JSON Schema, but not why it does not.

schema.py asks the package jsonschema for the reasons, which takes ten times as long. This module knows
only the keywords that the schema of the spec uses.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

Check = Callable[[Any], bool]

_TYPES: dict[str, type] = {
    "array": list,
    "boolean": bool,
    "integer": int,
    "null": type(None),
    "object": dict,
    "string": str,
}
# Keywords for people, and those that another keyword or the whole schema handles.
_NO_CHECK = frozenset(("$defs", "$schema", "description", "examples", "title"))
_MEMBERS = frozenset(("properties", "patternProperties", "additionalProperties"))


class QuickCheck:
    """The checks for the definitions of a schema, made on first use."""

    def __init__(self, schema: Mapping[str, Any]) -> None:
        self._definitions = schema["$defs"]
        self._checks: dict[str, Check] = {}

    def definition(self, name: str) -> Check:
        """The check for values of a definition, which may contain themselves."""
        if name not in self._checks:
            self._checks[name] = lambda value: self._checks[name](value)
            self._checks[name] = self._all_of(self._definitions[name])
        return self._checks[name]

    def _all_of(self, rules: Mapping[str, Any] | bool) -> Check:
        """The check for a schema."""
        if isinstance(rules, bool):
            return _anything if rules else _nothing
        keywords = [word for word in rules if word not in _NO_CHECK and word not in _MEMBERS]
        checks = [self._keyword(word, rules[word]) for word in keywords]
        if not _MEMBERS.isdisjoint(rules):
            checks.append(self._members(rules))

        def check(value: Any) -> bool:
            for each in checks:
                if not each(value):
                    return False
            return True

        return checks[0] if len(checks) == 1 else check

    def _members(self, rules: Mapping[str, Any]) -> Check:
        """The check for the values in a mapping."""
        by_name = {key: self._all_of(r) for key, r in rules.get("properties", {}).items()}
        by_pattern = [
            (re.compile(pattern).search, self._all_of(r))
            for pattern, r in rules.get("patternProperties", {}).items()
        ]
        other = self._all_of(rules.get("additionalProperties", True))

        def check(value: Any) -> bool:
            if not isinstance(value, dict):
                return True
            for key, inner in value.items():
                checks = [by_name[key]] if key in by_name else []
                checks += [one for search, one in by_pattern if search(key)]
                for one in checks or (other,):
                    if not one(inner):
                        return False
            return True

        return check

    def _keyword(self, word: str, wanted: Any) -> Check:
        """The check for one keyword, which allows all values of types to which it does not apply."""
        if word == "$ref":
            return self.definition(wanted.removeprefix("#/$defs/"))
        if word == "type":
            return _is_one_of([wanted] if isinstance(wanted, str) else wanted)
        if word == "anyOf":
            choices = [self._all_of(rules) for rules in wanted]
            return lambda value: any(check(value) for check in choices)
        if word == "items":
            item = self._all_of(wanted)
            return lambda value: not isinstance(value, list) or all(map(item, value))
        if word == "propertyNames":
            name = self._all_of(wanted)
            return lambda value: not isinstance(value, dict) or all(map(name, value))
        return _simple_keyword(word, wanted)


def _anything(_: Any) -> bool:
    return True


def _nothing(_: Any) -> bool:
    return False


def _is_one_of(names: list[str]) -> Check:
    """A Boolean is an integer in Python, but not in JSON."""
    types = tuple(_TYPES[name] for name in names)
    if bool in types or int not in types:
        return lambda value: isinstance(value, types)
    return lambda value: isinstance(value, types) and not isinstance(value, bool)


def _simple_keyword(word: str, wanted: Any) -> Check:
    if word == "pattern":
        search = re.compile(wanted).search
        return lambda value: not isinstance(value, str) or search(value) is not None
    if word == "enum" or word == "const":
        allowed = {(type(one), one) for one in (wanted if word == "enum" else [wanted])}
        return lambda value: not isinstance(value, (dict, list)) and (type(value), value) in allowed
    if word == "minimum":
        return lambda value: not isinstance(value, int) or value >= wanted
    if word == "maximum":
        return lambda value: not isinstance(value, int) or value <= wanted
    if word == "required":
        return lambda value: not isinstance(value, dict) or all(key in value for key in wanted)
    if word == "dependentRequired":
        return lambda value: not isinstance(value, dict) or all(
            other in value for key in wanted if key in value for other in wanted[key]
        )
    if word == "uniqueItems":
        return lambda value: not isinstance(value, list) or _are_unique(value)
    if word in ("minItems", "minProperties", "minLength"):
        sized = {"minItems": list, "minProperties": dict, "minLength": str}[word]
        return lambda value: not isinstance(value, sized) or len(value) >= wanted
    raise NotImplementedError(f"the keyword '{word}' of the schema")


def _are_unique(items: list[Any]) -> bool:
    return all(one != other for i, one in enumerate(items) for other in items[:i])
