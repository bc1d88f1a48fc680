"""Test vectors: bodies and what they say, by the reference codec, for codecs in any language.

`generated/vectors/<family>.jsonl` has one vector a line: {"message", "command", "id", "direction",
"hex", "fields", "why"}. What else a line may have: "context", raw values without which the body can
not be read, with "after", the messages that tell them; and "error" in place of what there is none
of: without "fields" the body does not decode, without "hex" the fields do not encode. Of bodies
that are no message at all (`unknown.jsonl`) there is no "message" and no "command". Where the size
of a body makes it another form of the command, "chosen" is that form's name, or null for none.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from typing import Any

from sbgcgen.announced import announced_types, announcing
from sbgcgen.compose import Choice, Places, compose
from sbgcgen.model import Context, Layout, Message
from sbgcgen.reference_codec import (
    CodecError,
    Forms,
    choose_message,
    encode,
    forms_of,
)
from sbgcgen.vectors_of_message import Vector, vectors_of


def files(layout: Layout) -> Iterator[tuple[str, bytes]]:
    """The vector files by their path below generated/."""
    forms = forms_of(layout)
    bodies: set[int] = set()
    for family in layout.families:
        lines = []
        for message in family.messages:
            vectors = vectors_of(message, id(message.body) in bodies)
            bodies.add(id(message.body))
            lines += [line(vector, forms) for vector in vectors]
        if lines:
            yield f"vectors/{family.name}.jsonl", "".join(lines).encode()
    yield "vectors/unknown.jsonl", "".join(_of_no_message(forms)).encode()


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
    if vector.body is not None:
        result["hex"] = vector.body.hex()
        chosen = _chosen(forms, message, len(vector.body))
        if chosen is not message:
            result["chosen"] = chosen.name if chosen else None
    if vector.fields is not None:
        result["fields"] = vector.fields
    if vector.error:
        result["error"] = _error(vector.error)
    result["why"] = vector.why
    return json.dumps(result, separators=(",", ":")) + "\n"


def _chosen(forms: Forms, message: Message, size: int) -> Message | None:
    try:
        return choose_message(forms, message.direction, message.id, size)
    except CodecError:
        return None


def _error(error: CodecError) -> dict[str, Any]:
    return {"code": error.code, "field": error.field, "offset": error.offset}


def _telling(context: Context, value: Any, forms: Forms) -> dict[str, Any]:
    """A message that tells a context's value."""
    name, path = context.sources[0] if context.sources else ("", "")
    if context.announced:
        name = context.announced.message
    message = next(m for same_id in forms.values() for m in same_id if m.name == name)
    if context.announced:
        fields = announcing(context.announced, message, value)
        assert announced_types(context.announced, message, fields) == value
    else:
        fields = compose(message, Choice(Places(), short=True, forced={path: value}))
    return {
        "id": message.id,
        "direction": message.direction,
        "hex": encode(message, fields).hex(),
    }


def _of_no_message(forms: Forms) -> Iterator[str]:
    """Bodies that are no message: of sizes that fit no form, with ids that a direction has not."""
    for direction in ("from_board", "to_board"):
        known = {id_ for way, id_ in forms if way == direction}
        other = {id_ for way, id_ in forms if way != direction} - known
        unused = set(range(1, 256)) - known - other
        for number in (*sorted(other)[:1], *sorted(unused)[:1], *sorted(unused)[-1:]):
            yield from _refused(forms, direction, number, [0])
        for number in sorted(known):
            if len(forms[direction, number]) > 1:
                yield from _refused(forms, direction, number, range(256))


def _refused(forms: Forms, direction: str, number: int, sizes: Iterable[int]) -> Iterator[str]:
    """The shortest and the longest body of these sizes that is no message."""
    refused = []
    for size in sizes:
        try:
            choose_message(forms, direction, number, size)
        except CodecError as error:
            refused.append((size, error))
    for size, refusal in refused[:1] + refused[1:][-1:]:
        result: dict[str, Any] = {"id": number, "direction": direction, "hex": bytes(size).hex()}
        result.update(error=_error(refusal), why=f"no message of {size} bytes")
        yield json.dumps(result, separators=(",", ":")) + "\n"
