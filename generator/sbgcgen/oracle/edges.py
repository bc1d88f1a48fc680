"""Edge values of every kind of field, at which a codec is most likely to fail.

Named values are separate: the edges of an enum stay the same if it gets another value.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from sbgcgen.model import Blob, Enum, Field, Packed, Scalar, Type
from sbgcgen.oracle.codec import scalar_of
from sbgcgen.oracle.json_values import float_from_bits, float_to_bits, integer_of, text_from_bytes

# A readable name, and the value in JSON.
Edge = tuple[str, Any]

# Zeros of both signs, ordinary, largest, smallest, infinite; NaN quiet, signaling and negative.
_FLOAT_BITS = {
    4: (
        *(0x00000000, 0x80000000, 0x3FC00000, 0xC0490FDB, 0x7F7FFFFF, 0xFF7FFFFF, 0x00000001),
        *(0x7F800000, 0xFF800000, 0x7FC00000, 0x7F800001, 0xFFC12345),
    ),
    8: (
        *(0x0000000000000000, 0x8000000000000000, 0x3FF8000000000000, 0xC00921FB54442D18),
        *(0x7FEFFFFFFFFFFFFF, 0xFFEFFFFFFFFFFFFF, 0x0000000000000001, 0x7FF0000000000000),
        *(0xFFF0000000000000, 0x7FF8000000000000, 0x7FF0000000000001, 0xFFF8123456789ABC),
    ),
}
# Empty, ASCII, multi-byte, invalid UTF-8, an embedded NUL, a character like an escaped byte.
_TEXTS = (b"", b"A", "\u00e9\u20ac\U0001f4f7".encode(), b"a\xff\xc3", b"a\0b", "\uf7ff".encode())


def edges(field: Field, type_: Type) -> list[Edge]:
    """The distinct unnamed values, each of which must occur in a vector for the field."""
    if isinstance(type_, Blob):
        return _blob_edges(type_)
    scalar = scalar_of(type_)
    if scalar.is_float:
        found = _float_edges(field, scalar.size)
    else:
        found = _integer_edges(field, type_, scalar)
    unique: dict[str, Edge] = {}
    for name, value in found:
        whole = integer_of(value, scalar.size) if isinstance(value, int) else value
        unique.setdefault(repr(whole), (name, whole))
    return list(unique.values())


def _float_edges(field: Field, size: int) -> list[Edge]:
    limits = [("min", field.minimum), ("max", field.maximum)]
    found: list[Edge] = [
        (name, float_from_bits(float_to_bits(float(value), size), size))
        for name, value in limits
        if value is not None
    ]
    values = [float_from_bits(bits, size) for bits in _FLOAT_BITS[size]]
    return found + [(str(value), value) for value in values]


def _integer_edges(field: Field, type_: Type, scalar: Scalar) -> list[Edge]:
    found: list[Edge] = []
    for part in type_.parts if isinstance(type_, Packed) else ():
        if not part.is_digits:
            found.append((f"all bits of {part.name}", _signed(part.bits, scalar)))
        if part.sign:
            found.append((f"the sign of {part.name}", _signed(part.sign, scalar)))
    limits = [
        ("min", field.minimum),
        ("max", field.maximum),
        ("lowest", scalar.minimum),
        ("highest", scalar.maximum),
    ]
    found += [(name, int(Fraction(value))) for name, value in limits if value is not None]
    found += [(special.meaning, special.value) for special in field.special]
    return found + [("0", 0), ("1", 1)]


def named_numbers(type_: Type) -> frozenset[int]:
    """The numbers with a name in an enum, or in the enum of a part of a packed value.

    -1 is the value 0 of a whole packed integer, -2 the value 1, and so on.
    """
    enums = [type_] if isinstance(type_, Enum) else []
    whole: list[int] = []
    if isinstance(type_, Packed):
        enums = [part.enum for part in type_.parts if part.enum]
        whole = [-1 - value.value for value in type_.names.values] if type_.names else []
    return frozenset([*whole, *(value.value for enum in enums for value in enum.values)])


def with_number(type_: Type, number: int) -> int:
    """The enum value with a number, or the packed value with it in all parts that have names.

    The number may be unnamed, or too large.
    """
    scalar = scalar_of(type_)
    if isinstance(type_, Packed) and type_.names and number < 0:
        number = -1 - number
    elif isinstance(type_, Packed):
        parts = [part for part in type_.parts if part.enum]
        number = sum((number << part.shift) & part.mask for part in parts)
    return _signed(number % (1 << 8 * scalar.size), scalar)


def _signed(value: int, scalar: Scalar) -> int:
    """The bits as the number in JSON."""
    assert scalar.maximum is not None
    return value if value <= scalar.maximum else value - (1 << 8 * scalar.size)


def _blob_edges(type_: Blob) -> list[Edge]:
    assert type_.size is not None, "the rest of a body is a list of bytes"
    if type_.kind == "bytes":
        contents = (counting(type_.size), bytes(type_.size), b"\xff" * type_.size)
        return [(f"{data[:1].hex()}…", data.hex()) for data in contents]
    texts = [data[: type_.size] for data in _TEXTS]
    if type_.kind == "text":
        texts.append(b"A" * type_.size)
    return [(f"text of {len(data)} bytes", text_from_bytes(data)) for data in texts]


def counting(size: int) -> bytes:
    """Bytes that are all different, so that a misplaced byte is noticed."""
    return bytes((7 * i + 3) % 256 for i in range(size))
