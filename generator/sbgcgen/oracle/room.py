"""Checks whether values fit into a C++ message."""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Announced, Blob, Field, Struct
from sbgcgen.oracle.codec import LISTS, Fields, is_bytes
from sbgcgen.oracle.json_values import text_to_bytes


def has_room(fields: tuple[Field, ...], values: Fields) -> bool:
    """True if no list and no text exceeds the capacity of its member."""
    return all(_fits(f, values[f.name]) for f in fields if f.name in values)


def _fits(member: Field, value: Any) -> bool:
    if is_bytes(member):
        return len(value) // 2 <= member.capacity
    if isinstance(member.type, Announced):
        return len(value) <= member.capacity
    if member.dim == "one":
        return _holds(member, value)
    elements = value if member.dim in LISTS else list(value.values())
    if member.dim in ("counted", "rest") and len(elements) > member.capacity:
        return False
    return all(_holds(member, element) for element in elements)


def _holds(member: Field, value: Any) -> bool:
    if isinstance(member.type, Struct):
        return has_room(member.type.fields, value)
    if isinstance(member.type, Blob) and member.type.kind != "bytes":
        return member.type.size is None or len(text_to_bytes(value)) <= member.type.size
    return True
