"""Reads and composes messages that announce the types of numbers in other messages."""

from __future__ import annotations

from sbgcgen.oracle.compose import Choice, Places, compose, compose_fields
from sbgcgen.model import Announcement, Enum, Message, Packed, Struct
from sbgcgen.oracle.codec import Fields


def announced_types(announcement: Announcement, message: Message, fields: Fields) -> list[str]:
    """The announced types in order, up to the first element of unknown type.

    A count of 0 means a single number, as 1 does.
    """
    result: list[str] = []
    for element in fields[announcement.list]:
        kind = _kind(announcement, message)
        raw = element[announcement.kind.partition(".")[0]]
        named = [v.wire for v in kind.enum.values if v.value == (raw & kind.mask) >> kind.shift]
        if not named or not named[0]:
            break
        result += named[:1] * max(1, element[announcement.count])
    return result


def announcing(announcement: Announcement, message: Message, types: list[str]) -> Fields:
    """A message that announces these types.

    Equal neighbors become one element. Single types alternate between the counts 0 and 1.
    """
    kind = _kind(announcement, message)
    values = {v.wire: v.value << kind.shift for v in kind.enum.values if v.wire}
    runs: list[tuple[str, int]] = []
    for name in types:
        if runs and runs[-1][0] == name:
            runs[-1] = (name, runs[-1][1] + 1)
        else:
            runs.append((name, 1))
    elements: list[Fields] = []
    for number, (name, count) in enumerate(runs):
        kind_name = announcement.kind.partition(".")[0]
        forced = {kind_name: values[name], announcement.count: count if count > 1 else number % 2}
        choice = Choice(Places(), short=True, forced=forced)
        elements.append(compose_fields(_element(announcement, message), choice))
    choice = Choice(Places(), short=True, forced={announcement.list: elements})
    return compose(message, choice)


class _Kind:
    """The place of the type in an element."""

    def __init__(self, enum: Enum, mask: int, shift: int) -> None:
        self.enum = enum
        self.mask = mask
        self.shift = shift


def _element(announcement: Announcement, message: Message) -> Struct:
    member = next(f for f in message.fields if f.name == announcement.list)
    assert isinstance(member.type, Struct)
    return member.type


def _kind(announcement: Announcement, message: Message) -> _Kind:
    name, _, part_name = announcement.kind.partition(".")
    member = next(f for f in _element(announcement, message).fields if f.name == name)
    if isinstance(member.type, Packed):
        part = next(p for p in member.type.parts if p.name == part_name)
        assert part.enum is not None
        return _Kind(part.enum, part.mask, part.shift)
    assert isinstance(member.type, Enum)
    return _Kind(member.type, -1, 0)
