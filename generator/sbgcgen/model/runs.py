"""Consecutive integers of a body, which Python's module `struct` can read and write at once."""

from __future__ import annotations

import struct
from functools import cache
from itertools import groupby
from typing import TYPE_CHECKING, Optional

if TYPE_CHECKING:
    from sbgcgen.model.bodies import Field

# The codes of the module `struct`; it has none for 3 bytes. Numbers of 8 bytes are rare.
_CODES = {"u8": "B", "i8": "b", "u16": "H", "i16": "h", "u32": "I", "i32": "i"}


class Run:
    """Consecutive fields; `format` is None unless all of them are integers in every body."""

    def __init__(self, fields: tuple[Field, ...], codes: str) -> None:
        self.fields = fields
        self.names = tuple(field.name for field in fields)
        self.format = struct.Struct(f"<{codes}") if codes else None


def runs_of(fields: tuple[Field, ...]) -> list[Run]:
    """The fields of a body or struct, in order."""
    runs = []
    for is_plain, group in groupby(fields, lambda field: bool(_code(field))):
        found = tuple(group)
        runs.append(Run(found, "".join(map(_code, found)) if is_plain else ""))
    return runs


def _code(field: Field) -> str:
    """The code of an integer in every body; "" for another field."""
    if field.scalar is None or field.dim != "one" or field.may_be_absent or field.is_counter:
        return ""
    return _CODES.get(field.scalar.name, "")


@cache
def array_format(name: str, count: int) -> Optional[struct.Struct]:
    """The format of integers of a scalar type; None for floats and integers without a code."""
    return struct.Struct(f"<{count}{_CODES[name]}") if name in _CODES else None
