"""What the spec names as the source of a message or enum is about it, according to the facts of the text."""

from __future__ import annotations

import pytest

from documents import LATER, Json, model_of_documents
from later import FACTS
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
    lines: dict[str, set[int]] = {}
    for body in facts["bodies"]:
        own = lines.setdefault(body["command"].removesuffix("_3"), set())
        own.update(field["line"] for field in body["fields"])
        own.add(body["line"])
    for row in facts["rows"]:
        for command in row["commands"]:
            lines.setdefault(command.removesuffix("_3"), set()).add(row["line"])
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
        wanted = about | lines.get(name.removesuffix("_3"), set())
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
    constants: dict[str, set[int]] = {}
    fields: dict[str, set[int]] = {}
    for row in facts["rows"]:
        spans = [row["line"], *row.get("more_lines", [])]
        for name in row["names"]:
            fields.setdefault(name.partition("[")[0], set()).update(spans)
        for constant in row.get("constants", []):
            constants.setdefault(constant["name"], set()).add(constant["line"])
    for code in facts["codes"]:
        constants.setdefault(code["name"], set()).add(code["line"])
    for body in facts["bodies"]:
        for field in body["fields"]:
            spans = [field["line"], *field.get("more_lines", [])]
            fields.setdefault(field["name"], set()).update(spans)
    for variable in facts["variables"]:
        constants.setdefault(variable["name"], set()).add(variable["line"])
    for define in facts["defines"]:
        constants.setdefault(define["name"], set()).add(define["line"])
    users = _fields_by_enum(model)
    for enum in model["enums"]:
        about: set[int] = set()
        for value in enum["values"]:
            about |= constants.get(value["name"], set())
        for name in users.get(enum["name"], set()):
            about |= fields.get(name, set())
        ranges = parse_lines(enum["source"])
        if not ranges and enum["source"] == LATER:  # test_documents.py compares those
            continue
        inside = any(first <= line <= last for first, last in ranges for line in about)
        assert inside, f"{enum['name']}: none of its values in '{enum['source']}'"


def _fields_by_enum(model: Json) -> dict[str, set[str]]:
    """Returns the names of the fields that have an enum as their type, or as the type of a part."""
    users: dict[str, set[str]] = {}
    parts = {p["name"]: p for p in model["packed"]}
    for message in model["messages"]:
        leaves = [leaf for top in message["layout"] for leaf in [top, *top.get("cases", [])]]
        for leaf in leaves:
            packed = parts.get(leaf.get("packed", ""), {"parts": []})
            names = {leaf["enum"], *(part["enum"] for part in packed["parts"])}
            for name in names - {None}:
                users.setdefault(name, set()).add(leaf["spec_name"])
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
