"""A second codec that interprets the Layout model: slow, small, and obviously correct.

It shares no source or template with the generated code, so agreement of the two confirms the model.
decoding.py and encoding.py are its two halves and frames.py adds the framing; this module has their
common parts. The test vectors come from this codec (vectors.py). Bodies are `bytes`. Messages are
the `fields` of `sbgc decode --format jsonl`: objects for structs and axes, lists for arrays,
lower-case hex for bytes, strings for texts, raw integers for everything else, and {"i16": -5} for a
number of announced type.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from sbgcgen.model import Blob, Enum, Field, Packed, Quantity, Scalar, Type

Fields = dict[str, Any]


class CodecError(Exception):
    """The same facts as sbgc::Status: the code by its name in JSON, the field, and the offset."""

    def __init__(self, code: str, field: str = "", offset: int = 0) -> None:
        super().__init__(code, field, offset)
        self.code = code
        self.field = field
        self.offset = offset

    def __str__(self) -> str:
        return f"{self.code} at {self.offset}" + (f" ({self.field})" if self.field else "")


def scalar_of(type_: Type) -> Scalar:
    """The wire type of a numeric type."""
    if isinstance(type_, (Quantity, Enum, Packed)):
        return type_.scalar
    assert isinstance(type_, Scalar), f"no number: {type_}"
    return type_


def is_bytes(field: Field) -> bool:
    """True if the member is a run of bytes, which JSON represents as hex."""
    type_ = field.type
    return isinstance(type_, Blob) and type_.kind == "bytes" and type_.size is None


def keys_of(field: Field) -> tuple[str, ...]:
    """The keys of a value with one element per axis: roll, pitch, yaw."""
    return _lower(field.index)


@cache
def _lower(words: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(word.lower() for word in words)


LISTS = ("fixed", "counted", "rest")
