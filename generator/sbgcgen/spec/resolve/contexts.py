"""Resolves the contexts of messages and their sources."""

from __future__ import annotations

from sbgcgen.model import Announcement, Context, Enum, Field, Packed, Scalar, Struct, Type
from sbgcgen.model.names import snake_case
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.types import TypeResolver


def context_of(node: Map, types: TypeResolver) -> Context:
    """Resolve a context of a message."""
    summary = types.summary(node, node.position, str(node["name"]))
    name = snake_case(str(node["name"]))
    if "announced_by" in node:
        message, _, list_name = str(node["announced_by"]).partition(".")
        kind = ".".join(snake_case(word) for word in str(node["kind"]).split("."))
        count = snake_case(str(node["count"]))
        announced = Announcement(message, snake_case(list_name), kind, count)
        return Context(name, None, summary, (), announced)
    enum = types.enum_named(str(node["type"]), node.at("type"))
    sources = []
    for entry in node.get("from", []):
        message, _, field = str(entry).partition(".")
        sources.append((message, ".".join(snake_case(p) for p in field.split("."))))
    return Context(name, enum, summary, tuple(sources))


def announceable_types(announcement: Announcement, fields: tuple[Field, ...]) -> tuple[str, ...]:
    """The types that a message can announce; none if it lacks the fields of the announcement."""

    def find(name: str, members: tuple[Field, ...], dim: str) -> Type | None:
        return next(
            (f.type for f in members if (f.name, f.dim) == (name, dim) and not f.may_be_absent),
            None,
        )

    element = find(announcement.list, fields, "counted")
    if not isinstance(element, Struct):
        return ()
    member, _, part = announcement.kind.partition(".")
    count = find(announcement.count, element.fields, "one")
    kind = find(member, element.fields, "one")
    if isinstance(kind, Packed):
        kind = next((p.enum for p in kind.parts if p.name == part), None)
    elif part:
        return ()
    counts = isinstance(count, Scalar) and count.minimum == 0
    return tuple(v.wire for v in kind.values if v.wire) if counts and isinstance(kind, Enum) else ()
