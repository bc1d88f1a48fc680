"""Rules for the spelling of the protocol's own names."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterator

from sbgcgen.model import COMMAND_IDS, Position
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Map, Spec
from sbgcgen.spec.resolve.types import VARIABLE_ID

# Types of the spec begin with an upper-case letter, built-in ones do not.
_BUILT_IN = re.compile(r"[a-z]")
# Parts of a field's name that are not the protocol's: index and placeholder.
_BRACKETS = re.compile(r"\[.*?\]|\{.*?\}")
# The similarity from which the beginning of a name counts as a misspelled prefix.
_SIMILAR = 0.85


def lint_spelling(spec: Spec, found: Diagnostics) -> None:
    """Check the names of commands, fields and named values; findings go into `found`."""
    for _, name, _, at in spec.entries("commands"):
        if not name.startswith(spec.command_prefix):
            text = f"the command {name} does not begin with '{spec.command_prefix}'"
            hint = "the 'command_prefix' of the protocol is not a part of names in code"
            found.add(at, "SBGC054", text, hint)
    leaf_types = {*COMMAND_IDS.values(), VARIABLE_ID}
    for section in ("quantities", "enums", "flags", "packed"):
        leaf_types.update(name for _, name, _, _ in spec.entries(section))
    for nodes in spec.maps.values():
        for field in _fields(nodes):
            type_ = str(field.get("type", ""))
            if type_ in leaf_types or _BUILT_IN.match(type_):
                name = _BRACKETS.sub("", str(field["name"]))
                _check_case(name, field, field.at("name"), found)
    for section in ("enums", "flags"):
        for _, name, node, _ in spec.entries(section):
            for value, content in node["values"].items():
                _check_case(value, content, node["values"].at(value), found)
            _check_prefix(name, node, found)


def _fields(nodes: list[Map]) -> Iterator[Map]:
    """The named fields of all lists of fields."""
    for node in nodes:
        fields = node.get("fields")
        for item in fields if isinstance(fields, list) else ():
            if isinstance(item, Map) and "name" in item:
                yield item


def _check_case(name: str, node: Map, at: Position, found: Diagnostics) -> None:
    is_upper = name == name.upper()
    if not is_upper and not node.get("verbatim"):
        hint = f"write {name.upper()}, or 'verbatim: true' if the protocol spells it like this"
        found.add(at, "SBGC053", f"'{name}' is not in upper case", hint)
    elif is_upper and node.get("verbatim"):
        message = f"'verbatim' is redundant on {name}, which is in upper case"
        found.add(node.at("verbatim"), "SBGC053", message, "leave it out")


def _check_prefix(name: str, node: Map, found: Diagnostics) -> None:
    prefix = str(node.get("prefix", ""))
    values = node["values"]
    if not prefix:
        return
    if not any(value.startswith(prefix) for value in values):
        message = f"no value of {name} starts with '{prefix}'"
        found.add(node.at("prefix"), "SBGC054", message, "leave 'prefix' out, or correct it")
        return
    for value in values:
        begin = value[: len(prefix)]
        alike = difflib.SequenceMatcher(None, begin, prefix).ratio()
        if begin != prefix and alike >= _SIMILAR:
            message = f"{value} almost begins with '{prefix}'"
            found.add(values.at(value), "SBGC054", message, "the other values begin with it")
