"""Additions of the model that the documents lack."""

from __future__ import annotations

import re
from collections.abc import Iterator

from documents import Check, Json, Model, Told, version


def body_paths(message: Json) -> list[str]:
    """Returns the paths of a body's leaves; included reserved ones have other numbers."""
    return [re.sub(r"reserved_\d", "reserved", leaf["path"]) for leaf in message["layout"]]


def additions(model: Model, text: Told, notes: Told) -> Iterator[Check]:
    """Checks what neither the text nor the notes tell about."""
    labels = text.labels | notes.labels
    bodies = [(message["name"], body_paths(message)) for message in model.messages]
    for message, (owner, paths) in zip(model.messages, bodies):
        if (owner, message["direction"]) not in text.messages | notes.messages:
            yield Check("extra message", 0, owner, None, message["direction"])
        # Messages that have the same body, or whose body starts this one.
        same = [
            name
            for name, theirs in bodies
            if theirs == paths or (len(theirs) > 9 and paths[: len(theirs)] == theirs)
        ]
        yield from additions_to(message, same, text, notes)
    for enum in model.model["enums"]:
        of_text = re.search(r"L\d", enum["source"])
        for value in enum["values"] if not enum["name"].startswith("Command") else []:
            label = f"{enum['name']}.{value['name']}"
            told = {("constant", value["name"]), ("value", label)} & labels
            if not told and (value["named_by_specification"] or not of_text):
                yield Check("extra constant", 0, label, None, value["value"])
    for kind, things in (
        ("command", model.model["commands"]),
        ("variable", model.model["adjustable_variables"]),
    ):
        for thing in things:
            if (kind, thing["name"]) not in labels:
                yield Check(f"extra {kind}", 0, thing["name"], None, thing["id"])


def additions_to(message: Json, same: list[str], text: Told, notes: Told) -> Iterator[Check]:
    """Checks the leaves of a message. What the text says about `same` messages, it says about this one."""
    owner = message["name"]
    for leaf in message["layout"]:
        key, label = (owner, message["direction"], leaf["path"]), f"{owner}.{leaf['spec_name']}"
        is_new = key in notes.leaves - text.leaves
        if key not in text.leaves | notes.leaves and "when" in leaf:
            yield Check("extra field", 0, f"{owner}.{leaf['path']}", None, leaf["type"])
        for kind, ours in (
            ("range", leaf["min"] is not None and f"{leaf['min']}..{leaf['max']}"),
            ("unit", leaf["scale"] is not None and leaf["quantity"]),
            ("since", key in notes.leaves and version(leaf)),
        ):
            told = {(kind, name, leaf["path"]) for name in same if not is_new} & text.paths
            if ours and not told and (kind, label) not in notes.labels:
                yield Check(f"extra {kind}", 0, label, None, ours)
