"""The source that the spec names for a message or enum covers it, according to the facts of the text."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from typing import Any

import pytest

from documents import FACTS, LATER, Json, model_of_documents
from sbgcgen.model.names import parse_lines
from support import project_layout

TEXT = FACTS["specification"]
Lines = defaultdict[str, set[int]]


@pytest.fixture(scope="module")
def model() -> Json:
    return model_of_documents()


def touches(ranges: Iterable[tuple[int, int]], lines: set[int]) -> bool:
    return any(first <= line <= last for first, last in ranges for line in lines)


def test_the_source_of_a_message_is_about_its_command(model: Json) -> None:
    """Each range of lines names the command, or is in its list, its table or its errata."""
    mentioned, listed = Lines(set), Lines(set)
    for name, found in TEXT["mentions"].items():
        for command in {name, name.removesuffix("_3")}:
            mentioned[command] |= set(found)
    for fact in (*TEXT["bodies"], *TEXT["rows"]):
        for command in fact.get("commands", [fact.get("command")]):
            own = {one["line"] for one in (fact, *fact.get("fields", []))}
            listed[command.removesuffix("_3")] |= own
    codes = {code["line"] for code in TEXT["codes"]}
    errata = {e["number"]: e["lines"] for e in model["errata"]}
    with_codes = {
        message["command"]
        for message in model["messages"]
        if any(leaf["spec_name"] == "ERR_CODE" for leaf in message["layout"])
    } | {code["command"] for code in TEXT["codes"]}
    for message in model["messages"]:
        if message["source"] == LATER:  # test_documents.py compares those
            continue
        command = message["command"]
        ranges = parse_lines(message["source"])
        assert touches(ranges, mentioned[command]), f"{message['name']}: no line names {command}"
        wanted = mentioned[command] | listed[command.removesuffix("_3")]
        wanted |= codes if command in with_codes else set()
        wanted |= {int(line[1:]) for number in message["errata"] for line in errata[number]}
        for lines in ranges:
            assert touches([lines], wanted), f"{message['name']}: nothing about it in {lines}"


def test_the_source_of_an_enum_holds_its_values(model: Json) -> None:
    """One of its lines has a named value, or the field with the enum as its type."""
    constants, fields = Lines(set), Lines(set)
    in_rows = [constant for row in TEXT["rows"] for constant in row.get("constants", [])]
    for fact in (*in_rows, *TEXT["codes"], *TEXT["variables"], *TEXT["defines"]):
        constants[fact["name"]].add(fact["line"])
    in_bodies = [field for body in TEXT["bodies"] for field in body["fields"]]
    for fact in (*TEXT["rows"], *in_bodies):
        for name in fact.get("names", [fact.get("name", "")]):
            fields[name.partition("[")[0]] |= {fact["line"], *fact.get("more_lines", [])}
    users = _fields_by_enum(model)
    for enum in model["enums"]:
        if enum["source"] == LATER:  # test_documents.py compares those
            continue
        about = [constants[value["name"]] for value in enum["values"]]
        about += [fields[name] for name in users[enum["name"]]]
        inside = touches(parse_lines(enum["source"]), set().union(*about))
        assert inside, f"{enum['name']}: none of its values in '{enum['source']}'"


def _fields_by_enum(model: Json) -> defaultdict[str, set[str]]:
    """Returns the names of the fields that have an enum as their type, or as the type of a part."""
    users: defaultdict[str, set[str]] = defaultdict(set)
    parts = {p["name"]: p["parts"] for p in model["packed"]}
    leaves = [leaf for message in model["messages"] for leaf in message["layout"]]
    for leaf in [one for top in leaves for one in (top, *top.get("cases", []))]:
        packed = parts.get(leaf.get("packed", ""), [])
        for name in {leaf["enum"], *(part["enum"] for part in packed)} - {None}:
            users[name].add(leaf["spec_name"])
            if leaf["path"].startswith("config."):
                users[name].add("CONFIG")
    return users


def test_every_source_lies_in_the_text() -> None:
    layout = project_layout()
    last = TEXT["specification"]["lines"]
    things: list[Any] = [*layout.messages, *layout.enums, *layout.packed, *layout.commands]
    for thing in things:
        for first, end in parse_lines(thing.source):
            assert 1 <= first <= end <= last, f"{thing.name}: L{first}-L{end}"
