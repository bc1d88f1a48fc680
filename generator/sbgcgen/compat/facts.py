"""Facts about the protocol, its types and fields that need more than a row of a table."""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from sbgcgen.compat.changes import COMPATIBLE, MEANING, SOURCE, WIRE, Level
from sbgcgen.compat.difference import Each, Getter, Pair
from sbgcgen.compat.wire import condition, cut, places, wire_type
from sbgcgen.compat.words import type_text, when_text
from sbgcgen.model import Enum, EnumValue, Field, Later, Packed, Quantity, Revision, Struct, Type
from sbgcgen.model import scalar_of

# The whole protocol


def compare_line(layouts: Pair) -> None:
    old, new = layouts.both("line")
    at = new.at if new.at.file else layouts.at
    layouts.inner("line", old, new, at=at).compare()


def compare_checksums(framings: Pair) -> None:
    """Compare checksums of the same name; the header and the trailer list all names."""
    for checksum in framings.new.checksums:
        old = framings.old.checksum(checksum.name)
        if old is not None:
            framings.inner(f": {checksum.name}", old, checksum).compare()


def revision_of(revision: Revision | None) -> tuple[object, ...] | None:
    """The content of a revision."""
    if revision is None:
        return None
    return (revision.date, [added.text for added in revision.adds], revision.changes)


# Named types


def _content(thing: Quantity | Enum | Packed | Struct) -> Any:
    """The content of a type that a renaming does not change."""
    if isinstance(thing, Quantity):
        return (thing.scalar, unit_of(thing), thing.summary)
    if isinstance(thing, Enum):
        return (thing.scalar, thing.kind, [(v.name, v.value) for v in thing.values])
    if isinstance(thing, Packed):
        return (thing.scalar, [(p.name, cut(p), p.enum and p.enum.name) for p in thing.parts])
    return ([(f.spec_name, f.name) for f in thing.fields], places(thing.fields))


@dataclass(frozen=True)
class Types(Each):
    """Named types. Renamings are reported first, so that others use the new names."""

    content: Getter = _content

    def __call__(self, pair: Pair) -> None:
        for both in list(self.pairs(pair)):
            replace(both, what=f"{both.new.kind} {both.new.name}").compare()


def unit_of(quantity: Quantity | None) -> tuple[object, ...] | None:
    """Unit and conversion of a quantity."""
    if quantity is None:
        return None
    return (quantity.unit, quantity.scale, quantity.offset, quantity.ratio, quantity.over)


def is_alias(old: EnumValue, new: EnumValue) -> bool:
    """True if C++ keeps the former name of a value."""
    return old.identifier in {alias.name for alias in new.aliases}


# Fields


def if_type_is_another(old: Type, new: Type) -> Level | None:
    """The type has another name or class; two versions of one named type are compared elsewhere."""
    name = getattr(old, "name", None)
    is_known = name is not None and name == getattr(new, "name", None) and type(old) is type(new)
    return None if is_known else WIRE


def if_unit_is_lost(old: Type, new: Type) -> Level | None:
    """True if a number loses its unit; `Replaced` compares the units of two quantities."""
    is_lost = isinstance(old, Quantity) and not isinstance(new, Quantity)
    return MEANING if is_lost and wire_type(old) == wire_type(new) else None


def unit_text(type_: Type) -> str | None:
    return f"{type_.scale} {type_.unit}" if isinstance(type_, Quantity) else None


def range_of(field: Field) -> tuple[Fraction, Fraction] | None:
    """The range of valid values, which is that of the type by default."""
    if field.minimum is not None and field.maximum is not None:
        return (field.minimum, field.maximum)
    scalar = scalar_of(field.type)
    if scalar is None or scalar.minimum is None or scalar.maximum is None:
        huge = Fraction(1 << 200)
        return (-huge, huge) if scalar is not None else None
    return (Fraction(scalar.minimum), Fraction(scalar.maximum))


def capacity(field: Field) -> int:
    """The largest number of elements."""
    return field.capacity if field.max_count is None else field.max_count


def compare_conditions(fields: Pair) -> None:
    """Compare the conditions for the presence of a field."""
    old, new = fields.both("when")
    sources = (fields.names.get(old.source, old.source) if old else "", new.source if new else "")
    if condition(old) != condition(new) or sources[0] != sources[1]:
        fields.add(WIRE, "when", when_text(old), when_text(new))


def compare_special_values(fields: Pair) -> None:
    """Compare the special values; one that was in the range before had an ordinary meaning."""
    before, now = ({one.value: one for one in side} for side in fields.both("special"))
    low, high = range_of(fields.old) or (0, -1)
    for value in (*before, *(value for value in now if value not in before)):
        old, new = before.get(value), now.get(value)
        label = f"special {value}"
        level = MEANING if old or low <= value <= high else COMPATIBLE
        fields.mark(level, label, old and old.meaning, new and new.meaning)
        if old is not None:
            level = SOURCE if old.name else COMPATIBLE
            fields.mark(level, f"{label}: C++ name", old.name, new.name if new else "")


def compare_alternatives(fields: Pair) -> None:
    """Compare the quantities of an alternative unit, and the flags that select it."""
    old, new = fields.both("alternative")
    label = "alternative unit"
    if old is None and new is not None:
        fields.add(COMPATIBLE, label, None, f"{new.quantity.name} with {new.flag.name}")
    elif old is not None and new is None:
        what = f"{fields.what}: {label}"
        fields.changes.deleted(MEANING, what, fields.old.at, old.quantity.name)
    elif old is not None:
        fields.mark(SOURCE, label, old.quantity.name, new.quantity.name)
        source = fields.names.get(old.source, old.source)
        chosen = (f"{source} & {old.mask:#x}", f"{new.source} & {new.mask:#x}")
        fields.mark(MEANING, f"{label}, chosen by", *chosen)


def compare_later_meanings(fields: Pair) -> None:
    """Compare the meanings that later firmware gives a field."""
    meanings = ([_later(fields, f, one) for one in f.later] for f in (fields.old, fields.new))
    fields.mark(MEANING, "later", *meanings)


def _later(fields: Pair, field: Field, later: Later) -> str:
    """A later meaning: "firmware 2.73.1: Gain (u8), 0..200, How strong it is."."""
    words = [type_text(later.type)] if later.type != field.type else []
    if (later.minimum, later.maximum) != (field.minimum, field.maximum):
        words.append(f"{later.minimum}..{later.maximum}")
    words += [later.summary] if later.summary != field.summary else []
    return f"{fields.changes.versions(later.since)}: {', '.join(words)}"
