"""Lossless representation of texts and floats in JSON."""

from __future__ import annotations

import json
import math
import struct
from typing import Any


def text_from_bytes(data: bytes) -> str:
    """Any bytes as text. A byte that is not UTF-8 becomes the character U+F700 + byte.

    Each byte of a character in that range is escaped as well, so that the result is unambiguous.
    """
    result = ""
    for char in data.decode("utf-8", "surrogateescape"):
        if "\udc80" <= char <= "\udcff":
            result += chr(0xF700 + ord(char) - 0xDC00)
        elif "\uf780" <= char <= "\uf7ff":
            result += "".join(chr(0xF700 + byte) for byte in char.encode())
        else:
            result += char
    return result


def text_to_bytes(text: str) -> bytes:
    """The inverse of text_from_bytes()."""
    return b"".join(
        bytes((ord(char) - 0xF700,)) if "\uf780" <= char <= "\uf7ff" else char.encode()
        for char in text
    )


_FORMATS = {4: "<f", 8: "<d"}


def float_from_bits(bits: int, size: int = 4) -> float | str:
    """A number of `size` bytes, or "inf", "-inf" or "nan:<bits>", for which JSON has no numbers."""
    value = float(struct.unpack(_FORMATS[size], bits.to_bytes(size, "little"))[0])
    if math.isfinite(value):
        return value
    if math.isinf(value):
        return "inf" if value > 0 else "-inf"
    return f"nan:{bits:0{2 * size}x}"


def float_to_bits(value: Any, size: int = 4) -> int:
    """The inverse of float_from_bits(). Raises ValueError for any other value."""
    if isinstance(value, str) and value.startswith("nan:"):
        return int(value[4:], 16)
    if value not in ("inf", "-inf") and not isinstance(value, (int, float)):
        raise ValueError("no number")
    try:
        return int.from_bytes(struct.pack(_FORMATS[size], float(value)), "little")
    except OverflowError as error:
        raise ValueError("too large") from error


class Wide(int):
    """A 64-bit integer, which is text in JSON, because many JSON readers round it."""


def integer_of(value: int, size: int) -> int:
    """An integer of `size` bytes."""
    return Wide(value) if size == 8 else value


def plain(value: Any) -> Any:
    """Fields for json.dumps."""
    if isinstance(value, dict):
        return {
            key: inner if type(inner) in _PLAIN else plain(inner) for key, inner in value.items()
        }
    if isinstance(value, list):
        return [inner if type(inner) in _PLAIN else plain(inner) for inner in value]
    return str(value) if isinstance(value, Wide) else value


_PLAIN = {int, float, str}


def to_json(value: Any) -> str:
    """A line of compact JSON."""
    return _ENCODER.encode(value) + "\n"


_ENCODER = json.JSONEncoder(check_circular=False, separators=(",", ":"))
