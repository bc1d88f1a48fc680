"""Sizes of types and lists of fields in bytes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sbgcgen.model import Announced, Blob, Field, Struct, Type, scalar_of


def size_of(type_: Type) -> int | None:
    """Size of a type; None if it varies."""
    scalar = scalar_of(type_)
    if scalar is not None:
        return scalar.size
    if isinstance(type_, Announced):
        return None
    assert isinstance(type_, (Blob, Struct))
    return None if isinstance(type_, Blob) and type_.kind == "string" else type_.size


def min_size_of(type_: Type) -> int:
    """Smallest size of a type."""
    if isinstance(type_, Struct):
        return type_.min_size
    if isinstance(type_, Blob) and type_.kind == "string":
        return 1
    return size_of(type_) or 0


def total_size(fields: tuple[Field, ...]) -> int | None:
    """Size of a list of fields; None if it varies."""
    total = 0
    for field in fields:
        if field.is_variable or field.size is None:
            return None
        total += field.size
    return total


def min_size(fields: tuple[Field, ...]) -> int:
    """Smallest size of a list of fields."""
    return sum(_min_field(field) for field in fields if not field.may_be_absent)


def _min_field(field: Field) -> int:
    if field.dim in ("counted", "rest"):
        return field.min_count * (min_size_of(field.type) or 1)
    return min_size_of(field.type) * field.count


def max_size(fields: tuple[Field, ...], limit: int) -> int:
    """Largest size that the specification describes, at most `limit`."""
    total = 0
    by_name = {field.name: field for field in fields}
    for field in fields:
        if field.dim in ("counted", "rest"):
            is_limited = field.counting == "bits" or field.counter_part is not None
            count = field.capacity if is_limited else field.max_count
            if field.has_hidden_counter and by_name[field.counter].maximum is not None:
                maximum = by_name[field.counter].maximum
                assert maximum is not None
                count = int(maximum) + (field.counting == "minus_1")
                if field.counting == "bytes":
                    total += int(maximum)
                    continue
            if count is None:
                return limit
            total += count * max_size_of(field.type, limit)
        else:
            total += field.count * max_size_of(field.type, limit)
    return min(total, limit)


def max_size_of(type_: Type, limit: int) -> int:
    """Largest size of a type, at most `limit`."""
    if isinstance(type_, Blob):
        return (type_.size or 0) + 1 if type_.kind == "string" else type_.size or 1
    size = size_of(type_)
    if size is None:
        return max_size(type_.fields, limit) if isinstance(type_, Struct) else limit
    return size


def offsets_in_union(members: tuple[Field, ...]) -> Iterator[Field]:
    """The fields of a tagged union, with their offsets if these are the same in all its cases."""
    for index, member in enumerate(members):
        shared = [_is_beside(other, member) for other in members[:index]]
        sizes = [other.size or 0 for other, is_beside in zip(members, shared) if is_beside]
        yield replace(member, offset=None if None in shared else sum(sizes))


def _is_beside(other: Field, member: Field) -> bool | None:
    """True if every case with `member` has `other`, False if none has, None if some have."""
    if other.when == member.when:
        return True
    if other.when is None or member.when is None or other.when.source != member.when.source:
        return None
    if not member.when.is_on_values or member.when.part != other.when.part:
        return None
    found = {other.when.accepts(number) for number in member.when.numbers}
    return found.pop() if len(found) == 1 else None
