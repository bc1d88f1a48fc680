"""Test vectors as lines of JSON, for codecs in any language; and messages that announce the types of numbers in
other messages."""

from __future__ import annotations

from itertools import groupby
from typing import Any, NamedTuple

from sbgcgen.model import Announcement, Context, Enum, Field, Message, Packed, Struct, satisfying
from sbgcgen.oracle.codec import CodecError, Fields
from sbgcgen.oracle.compose import Choice, Places, compose, compose_fields
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.frames import Forms, choose_message
from sbgcgen.oracle.json_values import plain, to_json
from sbgcgen.oracle.vectors import Vector


def line(vector: Vector, forms: Forms) -> str:
    """A line of a vector file."""
    message = vector.message
    result: dict[str, Any] = {
        "message": message.name,
        "command": message.command,
        "id": message.id,
        "direction": message.direction,
    }
    if vector.context:
        result["context"] = vector.context
        result["after"] = [
            _telling(context, vector.context[context.name], forms)
            for context in message.contexts
            if context.name in vector.context
        ]
    asking = request_for(forms, message)
    if asking:
        result["after"] = [_sent(asking, compose(asking, Choice(Places(), short=True)))]
    if vector.body is not None:
        result["hex"] = vector.body.hex()
        chosen = _chosen(forms, message, len(vector.body))
        if asking and chosen and _sizes(chosen) == _sizes(message):
            chosen = message
        if chosen is not message:
            result["chosen"] = chosen.name if chosen else None
    if vector.fields is not None:
        result["fields"] = plain(vector.fields)
    if vector.error:
        result["error"] = error_words(vector.error)
    result["why"] = vector.why
    return to_json(result)


def _chosen(forms: Forms, message: Message, size: int) -> Message | None:
    try:
        return choose_message(forms, message.direction, message.id, size)
    except CodecError:
        return None


def request_for(forms: Forms, message: Message) -> Message | None:
    """The request that selects a message among others of its size; None if no request is needed."""
    same = [m for m in forms[message.direction, message.id] if _sizes(m) == _sizes(message)]
    if message.direction == "to_board" or message is same[0]:
        return None
    requests = (m for same_id in forms.values() for m in same_id if m.answer)
    return next(m for m in requests if m.answer and m.answer.messages == (message.name,))


def _sizes(message: Message) -> tuple[int, int]:
    return message.min_size, message.max_size


def error_words(error: CodecError) -> dict[str, Any]:
    """An error as part of a line."""
    return {"code": error.code, "field": error.field, "offset": error.offset}


def _telling(context: Context, value: Any, forms: Forms) -> dict[str, Any]:
    """A message that delivers a context's value."""
    name, path = context.sources[0] if context.sources else ("", "")
    if context.announced:
        name = context.announced.message
    message = next(m for same_id in forms.values() for m in same_id if m.name == name)
    if context.announced:
        fields = announcing(context.announced, message, value)
        assert announced_types(context.announced, message, fields) == value
    else:
        forced = {path: value, **_conditions_of(path, message.fields)}
        fields = compose(message, Choice(Places(), short=True, forced=forced))
    return _sent(message, fields)


def _sent(message: Message, fields: Fields) -> dict[str, Any]:
    return {
        "id": message.id,
        "direction": message.direction,
        "hex": encode(message, fields).hex(),
    }


def _conditions_of(path: str, fields: tuple[Field, ...]) -> dict[str, Any]:
    """Values of the fields on which the presence of a field depends."""
    name, _, rest = path.partition(".")
    field = next(f for f in fields if f.name == name)
    found: dict[str, Any] = {}
    if field.when and not field.when.from_context:
        found.update(satisfying(field.when)[0])
    if rest and isinstance(field.type, Struct):
        found.update(_conditions_of(rest, field.type.fields))
    return found


def announced_types(announcement: Announcement, message: Message, fields: Fields) -> list[str]:
    """The announced types in order, up to the first element of unknown type.

    A count of 0 means a single number, like 1.
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
    kind_name = announcement.kind.partition(".")[0]
    elements: list[Fields] = []
    for number, (name, run) in enumerate(groupby(types)):
        count = len(list(run))
        forced = {kind_name: values[name], announcement.count: count if count > 1 else number % 2}
        choice = Choice(Places(), short=True, forced=forced)
        elements.append(compose_fields(_element(announcement, message), choice))
    choice = Choice(Places(), short=True, forced={announcement.list: elements})
    return compose(message, choice)


class _Kind(NamedTuple):
    """The position of the type in an element."""

    enum: Enum
    mask: int
    shift: int


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
