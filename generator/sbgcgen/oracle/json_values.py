"""How texts and floats stand in JSON, so that every byte and bit comes back."""

from __future__ import annotations

import math
import struct
from typing import Any


def text_from_bytes(data: bytes) -> str:
    """Any bytes as text: a byte that is not UTF-8 stands as the character U+F700 + byte.

    Characters that would look like such a byte are taken apart, so that nothing is ambiguous.
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
    """The bytes that text_from_bytes() has written so."""
    return b"".join(
        bytes((ord(char) - 0xF700,)) if "\uf780" <= char <= "\uf7ff" else char.encode()
        for char in text
    )


def float_from_bits(bits: int) -> float | str:
    """A number; "inf", "-inf" and "nan:<bits>" for what JSON has no number for."""
    value = float(struct.unpack("<f", bits.to_bytes(4, "little"))[0])
    if math.isfinite(value):
        return value
    if math.isinf(value):
        return "inf" if value > 0 else "-inf"
    return f"nan:{bits:08x}"


def float_to_bits(value: Any) -> int:
    """The bits of what float_from_bits() has written; ValueError for anything else."""
    if isinstance(value, str) and value.startswith("nan:"):
        return int(value[4:], 16)
    if value not in ("inf", "-inf") and not isinstance(value, (int, float)):
        raise ValueError("no number")
    try:
        return int.from_bytes(struct.pack("<f", float(value)), "little")
    except OverflowError as error:
        raise ValueError("too large") from error
