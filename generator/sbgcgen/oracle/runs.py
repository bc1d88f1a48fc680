"""Consecutive integers of a body, which the codec reads and writes at once.

If one of them is missing, too large or not in the body, the codec takes them one after the other,
which finds the error.
"""

from __future__ import annotations

import struct
from functools import cache
from itertools import groupby
from typing import Optional

from sbgcgen.model import Field, Struct
from sbgcgen.oracle.remember import remember

# The codes of the module `struct`. It has none for 3 bytes; integers of 8 bytes become `Wide`.
_CODES = {"u8": "B", "i8": "b", "u16": "H", "i16": "h", "u32": "I", "i32": "i"}


class Run:
    """Consecutive fields; `format` is None unless all of them are integers in every body."""

    def __init__(self, fields: tuple[Field, ...], codes: str) -> None:
        self.fields = fields
        self.names = tuple(field.name for field in fields)
        self.format = struct.Struct(f"<{codes}") if codes else None


@remember
def runs_of(body: Struct) -> list[Run]:
    """The fields of a body or struct."""
    runs = []
    for is_plain, group in groupby(body.fields, lambda field: bool(_code(field))):
        fields = tuple(group)
        runs.append(Run(fields, "".join(map(_code, fields)) if is_plain else ""))
    return runs


def _code(field: Field) -> str:
    """The code of an integer in every body; "" for another field."""
    if field.scalar is None or field.dim != "one" or field.may_be_absent or field.is_counter:
        return ""
    return _CODES.get(field.scalar.name, "")


@cache
def array_format(name: str, count: int) -> Optional[struct.Struct]:
    """The format of integers of a scalar type; None for floats and unusual sizes."""
    return struct.Struct(f"<{count}{_CODES[name]}") if name in _CODES else None
