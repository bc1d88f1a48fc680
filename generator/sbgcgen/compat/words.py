"""Descriptions of fields and their types for the report."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sbgcgen.compat.wire import Place
from sbgcgen.model import Blob, Condition, Field, Part, Type, scalar_of


def type_text(type_: Type) -> str:
    """For example "u8", "Angle (i16)", "bytes[3]"."""
    if isinstance(type_, Blob):
        return type_.kind if type_.kind == "string" else f"{type_.kind}[{type_.size or ''}]"
    name = str(getattr(type_, "name", type_.kind))
    scalar = scalar_of(type_)
    return f"{name} ({scalar.name})" if scalar is not None and scalar.name != name else name


def form_text(field: Field) -> str:
    """Type and number of elements, for example "u8[4]"."""
    return type_text(field.type) + (f"[{field.count or ''}]" if field.dim != "one" else "")


def index_text(field: Field) -> str:
    """The names of the elements, or their number."""
    return ", ".join(field.index) or str(field.count)


def place_text(place: Place) -> str:
    """For example "byte 4", "byte 0 after 1 variable parts"."""
    after = f" after {len(place) // 2} variable parts" if len(place) > 1 else ""
    return f"byte {place[-1]}{after}"


def range_text(limits: Sequence[Any] | None) -> str:
    """For example "0..100"."""
    return f"{limits[0]}..{limits[1]}" if limits else ""


def direction_text(field: Field) -> str:
    """The source of the sign convention of a field."""
    if field.directions is None:
        return ""
    return field.axis or ("as its axis" if field.directions else "unknown")


def cut_text(part: Part) -> str:
    """For example "(value & 0x70) >> 4"."""
    if part.is_digits:
        return f"value / {part.divide}" + (f" % {part.modulo}" if part.modulo else "")
    sign = f", negative if {part.sign:#x} is set" if part.sign else ""
    return f"(value & {part.mask:#x}) >> {part.shift}{', signed' if part.signed else sign}"


def when_text(when: Condition | None) -> str:
    """For example "options has FLAG_A (0x1), not FLAG_B (0x2)"."""
    if when is None:
        return "always"
    missing = ", may be missing" if when.may_be_missing else ""
    if when.terms:
        word = " and " if when.joined == "all" else " or "
        return word.join(when_text(term) for term in when.terms) + missing
    accepted = ", ".join(_flags(when) if when.is_on_flags else _numbers(when))
    return f"{when.subject} {accepted}{missing}"


def _flags(when: Condition) -> list[str]:
    parts = (("has", when.flags), ("any of", when.any_flags), ("not", when.no_flags))
    said = [(word, " ".join(f"{f.name} ({f.value:#x})" for f in flags)) for word, flags in parts]
    return [f"{word} {flags}" for word, flags in said if flags]


def _numbers(when: Condition) -> list[str]:
    names = {v.value: f"{v.name} ({v.value:#x})" for v in when.values}
    words = " ".join(names.get(number, f"{number:#x}") for number in when.numbers)
    limits = (("at least", when.at_least), ("at most", when.at_most))
    said = [f"{'is not' if when.negated else 'is'} {words}"] if words else []
    return said + [f"{word} {number}" for word, number in limits if number is not None]
