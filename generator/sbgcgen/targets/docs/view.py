"""Facts for the pages that the Layout lacks: users of types and groups of fields."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from sbgcgen.oracle.example import example_of
from sbgcgen.model import (
    EFFECTS,
    Enum,
    Field,
    Layout,
    Leaf,
    Message,
    Packed,
    Quantity,
    Struct,
)
from sbgcgen.targets import codes_of
from sbgcgen.views.answers import asked_by, confirmation
from sbgcgen.views.firmware import History
from sbgcgen.views.history import Revisions


def names(layout: Layout) -> dict[str, Any]:
    """The names that templates see."""
    of_command: dict[str, list[Message]] = {command.name: [] for command in layout.commands}
    for message in layout.messages:
        of_command[message.command].append(message)
    by_name: dict[str, Message] = {}
    for message in layout.messages:
        by_name.setdefault(message.name, message)
    return {
        "by_name": by_name,
        "of_command": of_command,
        "users": users(layout),
        "packed_with": packed_with(layout),
        "requests": asked_by(layout),
        "confirmation": confirmation(layout),
        "history": History(layout),
        "revisions": Revisions(layout),
        "effects_of": effects_of,
        "groups": groups,
        "example": partial(example_of, layout=layout),
        "codes": codes_of,
    }


def users(layout: Layout) -> dict[str, tuple[Message, ...]]:
    """The messages whose bodies have a value of a quantity, enum, flag set or packed type, by name.

    An enum inside a packed type counts for the messages that have the packed type.
    """
    found: dict[str, dict[int, Message]] = {}
    for message in layout.messages:
        for name in _names(message):
            found.setdefault(name, {})[id(message)] = message
    return {name: tuple(messages.values()) for name, messages in found.items()}


def packed_with(layout: Layout) -> dict[str, tuple[Packed, ...]]:
    """The packed types that hold an enum, a flag set or a quantity, by its name."""
    found: dict[str, list[Packed]] = {}
    for packed in layout.packed:
        for name in dict.fromkeys(type_.name for type_ in _types_in(packed)):
            found.setdefault(name, []).append(packed)
    return {name: tuple(all_packed) for name, all_packed in found.items()}


def effects_of(messages: list[Message]) -> list[str]:
    """The effects of these requests; "reads" only if there is no other."""
    said = {word for message in messages if message.effect for word in message.effect.words}
    return [word for word in EFFECTS if word in said and (word != "reads" or len(said) == 1)]


@dataclass(frozen=True)
class Group:
    """A member of struct type, at any depth of a message."""

    path: str
    field: Field
    type: Struct


def groups(message: Message) -> list[Group]:
    """The groups of a message in wire order."""
    return list(_groups(message.fields, ""))


def _groups(fields: tuple[Field, ...], path: str) -> Iterator[Group]:
    for member in fields:
        if isinstance(member.type, Struct):
            yield Group(path + member.name, member, member.type)
            yield from _groups(member.type.fields, f"{path}{member.name}.")


def _names(message: Message) -> Iterator[str]:
    for leaf in message.leaves:
        for inner in (leaf, *leaf.cases):
            yield from _names_of_leaf(inner)
    for context in message.contexts:
        if context.type is not None:
            yield context.type.name


def _names_of_leaf(leaf: Leaf) -> Iterator[str]:
    type_ = leaf.field.type
    if isinstance(type_, (Quantity, Enum, Packed)):
        yield type_.name
    if isinstance(type_, Packed):
        yield from (inner.name for inner in _types_in(type_))
    if leaf.field.alternative is not None:
        yield leaf.field.alternative.quantity.name


def _types_in(packed: Packed) -> Iterator[Enum | Quantity]:
    if packed.names is not None:
        yield packed.names
    for part in packed.parts:
        inner = part.enum or part.quantity
        if inner is not None:
            yield inner
