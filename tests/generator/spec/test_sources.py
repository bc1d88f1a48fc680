"""What the spec names as the source of a message or enum is about it, according to the facts of the text."""

from __future__ import annotations

from collections import defaultdict

import pytest

from documents import FACTS, LATER, Json, model_of_documents
from sbgcgen.model.names import parse_lines
from support import project_layout


@pytest.fixture(scope="module")
def facts() -> Json:
    return FACTS["specification"]


@pytest.fixture(scope="module")
def model() -> Json:
    return model_of_documents()


def test_the_source_of_a_message_is_about_its_command(facts: Json, model: Json) -> None:
    """Each range of lines names the command, or is in its list, its table or its errata."""
    mentioned = {name: set(lines) for name, lines in facts["mentions"].items()}
    lines: defaultdict[str, set[int]] = defaultdict(set)
    for fact in (*facts["bodies"], *facts["rows"]):
        for command in fact.get("commands", [fact.get("command")]):
            own = {one["line"] for one in (fact, *fact.get("fields", []))}
            lines[command.removesuffix("_3")] |= own
    codes = {code["line"] for code in facts["codes"]}
    errata = {e["number"]: e["lines"] for e in model["errata"]}
    with_codes = {
        message["command"]
        for message in model["messages"]
        if any(leaf["spec_name"] == "ERR_CODE" for leaf in message["layout"])
    } | {code["command"] for code in facts["codes"]}
    for message in model["messages"]:
        name = message["command"]
        about = mentioned.get(name, set()) | mentioned.get(f"{name}_3", set())
        ranges = parse_lines(message["source"])
        if not ranges and message["source"] == LATER:  # test_documents.py compares those
            continue
        assert ranges, f"{message['name']}: no lines in '{message['source']}'"
        wanted = about | lines[name.removesuffix("_3")]
        if name in with_codes:
            wanted |= codes
        for number in message["errata"]:
            wanted = wanted | {int(line[1:]) for line in errata[number]}
        for first, last in ranges:
            inside = any(first <= line <= last for line in wanted)
            assert inside, f"{message['name']}: nothing about {name} in L{first}-L{last}"
        assert any(
            first <= line <= last for first, last in ranges for line in about
        ), f"{message['name']}: no line of its source names {name}"


def test_the_source_of_an_enum_holds_its_values(facts: Json, model: Json) -> None:
    """One of its lines has a named value, or the field with the enum as its type."""
    constants: defaultdict[str, set[int]] = defaultdict(set)
    fields: defaultdict[str, set[int]] = defaultdict(set)
    in_rows = [constant for row in facts["rows"] for constant in row.get("constants", [])]
    for fact in (*in_rows, *facts["codes"], *facts["variables"], *facts["defines"]):
        constants[fact["name"]].add(fact["line"])
    in_bodies = [field for body in facts["bodies"] for field in body["fields"]]
    for fact in (*facts["rows"], *in_bodies):
        for name in fact.get("names", [fact.get("name", "")]):
            fields[name.partition("[")[0]] |= {fact["line"], *fact.get("more_lines", [])}
    users = _fields_by_enum(model)
    for enum in model["enums"]:
        about: set[int] = set()
        for value in enum["values"]:
            about |= constants[value["name"]]
        for name in users[enum["name"]]:
            about |= fields[name]
        ranges = parse_lines(enum["source"])
        if not ranges and enum["source"] == LATER:  # test_documents.py compares those
            continue
        inside = any(first <= line <= last for first, last in ranges for line in about)
        assert inside, f"{enum['name']}: none of its values in '{enum['source']}'"


def _fields_by_enum(model: Json) -> defaultdict[str, set[str]]:
    """Returns the names of the fields that have an enum as their type, or as the type of a part."""
    users: defaultdict[str, set[str]] = defaultdict(set)
    parts = {p["name"]: p for p in model["packed"]}
    for message in model["messages"]:
        leaves = [leaf for top in message["layout"] for leaf in [top, *top.get("cases", [])]]
        for leaf in leaves:
            packed = parts.get(leaf.get("packed", ""), {"parts": []})
            names = {leaf["enum"], *(part["enum"] for part in packed["parts"])}
            for name in names - {None}:
                users[name].add(leaf["spec_name"])
                if leaf["path"].startswith("config."):
                    users[name].add("CONFIG")
    return users


def test_every_source_lies_in_the_text(facts: Json) -> None:
    layout = project_layout()
    last = facts["specification"]["lines"]
    things: list[tuple[str, str]] = [
        *((m.name, m.source) for m in layout.messages),
        *((e.name, e.source) for e in layout.enums),
        *((p.name, p.source) for p in layout.packed),
        *((c.name, c.source) for c in layout.commands),
    ]
    for name, source in things:
        for first, end in parse_lines(source):
            assert 1 <= first <= end <= last, f"{name}: L{first}-L{end}"
