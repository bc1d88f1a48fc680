"""The positions and types of fields on the wire, regardless of their meaning."""

from __future__ import annotations

from typing import Any

from sbgcgen.model import Blob, Condition, Field, Part, Struct, Type, scalar_of

Fields = tuple[Field, ...]
Place = tuple[Any, ...]


def wire_type(type_: Type) -> Any:
    """The layout of a type."""
    scalar = scalar_of(type_)
    if scalar is not None:
        return scalar.name
    if isinstance(type_, Blob):
        return ("string",) if type_.kind == "string" else ("bytes", type_.size)
    if isinstance(type_, Struct):
        return ("struct", type_.is_region and type_.size, places(type_.fields)[-1])
    return ("bytes", None)  # a context has the types


def wire_form(field: Field) -> Any:
    """The layout of a field: its type, number of elements, and condition."""
    counting = (field.counting, cut(field.counter_part))
    return (wire_type(field.type), times(field), condition(field.when), counting)


def times(field: Field) -> str | int:
    """The number of elements, or the way to determine it."""
    return field.dim if field.dim in ("counted", "rest") else field.count


def cut(part: Part | None) -> tuple[int, ...] | None:
    """The bits of a part in its integer."""
    if part is None:
        return None
    return (part.mask, part.shift, part.divide, part.modulo, part.signed, part.sign)


def condition(when: Condition | None) -> Any:
    """The accepted values of a condition, and the part of its source that they refer to."""
    if when is None:
        return None
    flags = [sorted(f.value for f in some) for some in (when.flags, when.any_flags, when.no_flags)]
    numbers = (when.negated, sorted(when.numbers), when.at_least, when.at_most)
    terms = (when.joined, [(term.source, condition(term)) for term in when.terms])
    return (when.from_context, flags, numbers, when.may_be_missing, cut(when.part), terms)


def places(fields: Fields) -> list[Place]:
    """The position of each field, and of the end.

    A position is an offset in bytes, or several numbers of bytes separated by the variable parts.
    """
    found: list[Place] = [(0,)]
    for field in fields:
        *before, last = found[-1]
        if field.is_variable or field.size is None:
            found.append((*before, last, wire_form(field), 0))
        else:
            found.append((*before, last + field.size))
    return found


def case_places(fields: Fields) -> list[Place]:
    """The position of each field of a tagged union: what can precede it."""
    return [
        tuple(wire_form(before) for before in fields[:index] if not _exclude(before, field))
        for index, field in enumerate(fields)
    ]


def _exclude(one: Field, other: Field) -> bool:
    """True if no body has both fields, because their conditions require different values."""
    a, b = one.when, other.when
    if a is None or b is None or not (a.is_on_values and b.is_on_values):
        return False
    same = (a.subject, a.from_context) == (b.subject, b.from_context)
    return same and not set(a.numbers) & set(b.numbers)
