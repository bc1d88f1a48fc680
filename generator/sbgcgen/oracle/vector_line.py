"""Test vectors as lines of JSON, for codecs in any language.

A line is {"message", "command", "id", "direction", "hex", "fields", "why"}. It may also have:

- "context": raw values that the body needs for decoding;
- "after": the messages with these values, or the request that tells the message from others of its size;
- "error": without "fields", the error of decoding "hex"; without "hex", that of encoding "fields";
- "chosen": the name of the form that the size of the body selects, null for none, if it is not
  "message".

Lines of `unknown.jsonl` are bodies of no known message; they lack "message" and "command".
"""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Context, Field, Message, Struct, satisfying
from sbgcgen.oracle.announced import announced_types, announcing
from sbgcgen.oracle.codec import CodecError, Fields
from sbgcgen.oracle.compose import Choice, Places, compose
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
    """The request that tells a message from others of its size; None if a body is it without a request."""
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
