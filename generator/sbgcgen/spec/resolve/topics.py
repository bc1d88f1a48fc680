"""Resolves the topics of parameters."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase

from sbgcgen.model import Message, Topic
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map


def topics_of(nodes: Map, messages: list[Message], found: Diagnostics) -> Iterator[Topic]:
    """Resolve the value of `topics:` in the main file; findings go into `found`."""
    stored = {message.stores for message in messages}
    parameters = {
        leaf.field.spec_name: leaf.field
        for message in messages
        for leaf in (message.leaves if message.name in stored else ())
        if not leaf.field.reserved and leaf.field.role in ("", "general")
    }
    filed: set[str] = set()
    for name, node in nodes.items():
        patterns = node["fields"]
        for pattern, at in zip(patterns, patterns.items_at):
            if not any(fnmatchcase(parameter, pattern) for parameter in parameters):
                hint = did_you_mean(pattern, list(parameters)) or "a * stands for any characters"
                found.add(at, "SBGC080", f"'{pattern}' is the name of no parameter", hint)
        fields = [p for p in parameters if any(fnmatchcase(p, pattern) for pattern in patterns)]
        filed.update(fields)
        words = tuple(str(word) for word in node.get("words", ()))
        changes_line = bool(node.get("changes_line"))
        yield Topic(name, str(node["summary"]), words, tuple(fields), changes_line, nodes.at(name))
    for parameter, field in parameters.items():
        if nodes and parameter not in filed:
            hint = "add its name to one of the 'topics' in the main file"
            found.add(field.at, "SBGC080", f"the parameter {parameter} has no topic", hint)
