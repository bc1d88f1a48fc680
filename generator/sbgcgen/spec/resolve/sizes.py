"""Sizes of types and lists of fields in bytes. Lists whose elements grew with a firmware."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations
from math import lcm

from sbgcgen.model import Announced, Availability, Blob, Field, Struct, Type, scalar_of


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
    """The fields of a tagged union, with their offsets if these are the same in all cases."""
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


def grown(struct: Struct, since: Availability) -> Struct:
    """The struct of a list that exists since `since`, with the historical sizes of its elements.

    It is the same struct if they did not grow, or grew in a way that a decoder cannot detect.
    """
    first = len(struct.fields)
    while first and struct.fields[first - 1].since.is_after(since):
        first -= 1
    kept, later = struct.fields[:first], struct.fields[first:]
    size = total_size(kept)
    if not kept or not later or size is None:
        return struct
    sizes = [size]
    for number, field in enumerate(later):
        following = later[number + 1].since if number + 1 < len(later) else None
        if field.is_variable or field.size is None or field.is_counter:
            return struct
        if following is not None and field.since.is_after(following):
            return struct
        size += field.size
        if following != field.since:
            sizes.append(size)
    fields = (*kept, *(replace(field, appended=True) for field in later))
    return replace(
        struct, fields=fields, size=None, min_size=min_size(fields), element_sizes=tuple(sizes)
    )


def may_grow(field: Field) -> bool:
    """True for a list of structs whose element size follows from the rest of the body."""
    is_list = field.dim in ("counted", "rest") and not field.index
    is_plain = field.when is None and field.counting != "bytes"
    return is_list and is_plain and isinstance(field.type, Struct)


def confused(sizes: tuple[int, ...], room: int) -> tuple[int, int, int] | None:
    """Two element sizes, and a number of bytes that is a list of either size."""
    for one, other in combinations(sizes, 2):
        if lcm(one, other) <= room:
            return one, other, lcm(one, other)
    return None
