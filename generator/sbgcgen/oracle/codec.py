"""A second codec, read straight off the Layout model: slow, small, and meant to be obviously right.

It shares no template and no line with the generated C++, so what both agree on is what the model
says. decoding.py and encoding.py are its two halves, frames.py is what is around them; here is what
they have in common. The test vectors come from it (vectors.py). Bodies are `bytes`; messages are the `fields` of
`sbgc decode --format jsonl`: objects for structs and axes, lists for arrays, lower-case hex for
bytes, strings for texts, raw integers for everything else; a number of announced type stands as
{"i16": -5}.
"""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Blob, Condition, Enum, Field, Packed, Quantity, Scalar, Type

Fields = dict[str, Any]


class CodecError(Exception):
    """What sbgc::Status says: `code` by its name in JSON, the field, and the byte of the body."""

    def __init__(self, code: str, field: str = "", offset: int = 0) -> None:
        super().__init__(f"{code} at {offset}" + (f" ({field})" if field else ""))
        self.code = code
        self.field = field
        self.offset = offset


def scalar_of(type_: Type) -> Scalar:
    """The number on the wire behind a type that has one."""
    if isinstance(type_, Scalar):
        return type_
    assert isinstance(type_, (Quantity, Enum, Packed)), f"no number: {type_}"
    return type_.scalar


def is_bytes(field: Field) -> bool:
    """Whether the member is a run of bytes, which stands as hex."""
    type_ = field.type
    return isinstance(type_, Blob) and type_.kind == "bytes" and type_.size is None


def keys_of(field: Field) -> tuple[str, ...]:
    """The members of a value for each axis: roll, pitch, yaw."""
    return tuple(word.lower() for word in field.index)


def holds(when: Condition, value: int | None) -> bool:
    """Whether a condition holds for the value of what it depends on, None if that is missing."""
    if value is None:
        return False
    if when.mask:
        return value & when.mask == when.mask
    return value in [v.value for v in when.values]


def fixed_part(fields: tuple[Field, ...]) -> tuple[Field, ...]:
    """The leading fields that have their place whatever the message holds.

    Their size is checked once for all of them, which shows in what an error says.
    """
    if any(f.is_counter for f in fields):
        return ()
    result = []
    for field in fields:
        if field.offset is None or field.is_variable:
            break
        result.append(field)
    return tuple(result)


LISTS = ("fixed", "counted", "rest")
