"""A second codec that interprets the Layout model: slow, small, and obviously correct.

It shares no source or template with the generated code, so an agreement of both confirms the model.
decoding.py and encoding.py are its two halves and frames.py adds the framing; this module has their
common parts. The test vectors come from this codec (vectors.py). Bodies are `bytes`. Messages are
the `fields` of `sbgc decode --format jsonl`: objects for structs and axes, lists for arrays,
lower-case hex for bytes, strings for texts, raw integers for everything else, and {"i16": -5} for a
number of announced type.
"""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Blob, Enum, Field, Packed, Quantity, Scalar, Type

Fields = dict[str, Any]


class CodecError(Exception):
    """The same facts as sbgc::Status: the code by its name in JSON, the field, and the offset."""

    def __init__(self, code: str, field: str = "", offset: int = 0) -> None:
        super().__init__(f"{code} at {offset}" + (f" ({field})" if field else ""))
        self.code = code
        self.field = field
        self.offset = offset


def scalar_of(type_: Type) -> Scalar:
    """The wire type of a numeric type."""
    if isinstance(type_, Scalar):
        return type_
    assert isinstance(type_, (Quantity, Enum, Packed)), f"no number: {type_}"
    return type_.scalar


def is_bytes(field: Field) -> bool:
    """True if the member is a run of bytes, which JSON represents as hex."""
    type_ = field.type
    return isinstance(type_, Blob) and type_.kind == "bytes" and type_.size is None


def keys_of(field: Field) -> tuple[str, ...]:
    """The keys of a value with one element per axis: roll, pitch, yaw."""
    return tuple(word.lower() for word in field.index)


def fixed_part(fields: tuple[Field, ...]) -> tuple[Field, ...]:
    """The leading fields with a fixed offset and size in every body.

    The generated codec checks their total size once, which determines the field and offset of an
    error.
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
