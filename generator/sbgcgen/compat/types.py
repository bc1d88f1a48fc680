"""Compares the named types of two versions: quantities, enums, flag sets and packed integers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar, Union

from sbgcgen.compat.changes import Changes, Level
from sbgcgen.model import Enum, EnumValue, Packed, Part, Quantity, Struct

Named = TypeVar("Named", Quantity, Enum, Packed, Struct)


def pair_named(
    kind: str,
    old: tuple[Named, ...],
    new: tuple[Named, ...],
    same: Callable[[Named, Named], bool],
    changes: Changes,
) -> list[tuple[Named, Named]]:
    """Pair objects by name; a removed and an added one that are `same` count as renamed."""
    by_name = {thing.name: thing for thing in new}
    pairs = [(thing, by_name[thing.name]) for thing in old if thing.name in by_name]
    gone = [thing for thing in old if thing.name not in by_name]
    names = {thing.name for thing in old}
    come = [thing for thing in new if thing.name not in names]
    for thing in gone:
        twin = next((other for other in come if same(thing, other)), None)
        if twin is None:
            changes.deleted(Level.SOURCE, f"{kind} {thing.name}", thing.at)
            continue
        come.remove(twin)
        pairs.append((thing, twin))
        changes.add(Level.SOURCE, f"{kind} {thing.name}: name", thing.name, twin.name, twin.at)
    for thing in come:
        changes.added(f"{kind} {thing.name}", thing.at)
    return pairs


# Quantities


def same_quantity(old: Quantity, new: Quantity) -> bool:
    """True if two quantities differ only in their names."""
    return (old.scalar, _unit(old), old.summary) == (new.scalar, _unit(new), new.summary)


def _unit(quantity: Quantity) -> tuple[object, ...]:
    return (quantity.unit, quantity.scale, quantity.offset)


def compare_quantity(old: Quantity, new: Quantity, changes: Changes) -> None:
    """Compare type, unit and scale of a quantity."""
    what = f"quantity {new.name}"
    changes.compare(Level.WIRE, f"{what}: type", old.scalar.name, new.scalar.name, new.at)
    compare_unit(what, old, new, changes)
    changes.compare(Level.SOURCE, f"{what}: accessor", old.accessor, new.accessor, new.at)
    changes.compare(Level.COMPATIBLE, f"{what}: summary", old.summary, new.summary, new.at)


def compare_unit(what: str, old: Quantity, new: Quantity, changes: Changes) -> None:
    """Compare the conversions of raw values."""
    changes.compare(Level.MEANING, f"{what}: unit", old.unit, new.unit, new.at)
    changes.compare(Level.MEANING, f"{what}: scale", old.scale, new.scale, new.at)
    changes.compare(Level.MEANING, f"{what}: offset", old.offset, new.offset, new.at)


# Enums and flag sets


def same_enum(old: Enum, new: Enum) -> bool:
    """True if two enums differ only in their names."""
    values = [[(v.name, v.value) for v in e.values] for e in (old, new)]
    return old.scalar == new.scalar and old.kind == new.kind and values[0] == values[1]


def compare_enum(old: Enum, new: Enum, changes: Changes) -> None:
    """Compare type, kind and values of an enum or flag set."""
    what = f"{new.kind} {new.name}"
    changes.compare(Level.WIRE, f"{what}: type", old.scalar.name, new.scalar.name, new.at)
    changes.compare(Level.SOURCE, f"{what}: kind", old.kind, new.kind, new.at)
    if old.name == new.name:
        changes.compare(Level.SOURCE, f"{what}: C++ member", old.member, new.member, new.at)
    compare_values(what, old, new, changes)
    results = [e.success.name if e.success else "" for e in (old, new)]
    level = Level.MEANING if results[0] else Level.COMPATIBLE
    changes.compare(level, f"{what}: success", results[0], results[1], new.at)
    changes.compare(Level.COMPATIBLE, f"{what}: summary", old.summary, new.summary, new.at)


def compare_values(what: str, old: Enum, new: Enum, changes: Changes) -> None:
    """Compare the values of two enums by name; a number with another name has another meaning."""
    by_name = {value.name: value for value in new.values}
    by_number = {value.value: value for value in new.values}
    for value in old.values:
        label = f"{what}.{value.name}"
        now = by_name.get(value.name)
        if now is not None:
            _compare_value(label, value, now, changes)
            continue
        other = by_number.get(value.value)
        if other is not None and value.identifier in {a.name for a in other.aliases}:
            changes.add(Level.COMPATIBLE, label, value.name, other.name, other.at)
            _compare_value(label, value, replace(other, identifier=value.identifier), changes)
        elif other is not None:
            changes.add(Level.MEANING, f"{what}: {value.value}", value.name, other.name, other.at)
        else:
            changes.deleted(Level.SOURCE, label, value.at, value.value)
    names = {value.name for value in old.values}
    numbers = {value.value for value in old.values}
    for value in new.values:
        if value.name not in names and value.value not in numbers:
            changes.added(f"{what}.{value.name}", value.at, value.value)


def _compare_value(label: str, old: EnumValue, new: EnumValue, changes: Changes) -> None:
    changes.compare(Level.MEANING, label, old.value, new.value, new.at)
    changes.compare(Level.SOURCE, f"{label}: C++ name", old.identifier, new.identifier, new.at)
    level = Level.WIRE if old.wire else Level.COMPATIBLE
    changes.compare(level, f"{label}: type it names", old.wire, new.wire, new.at)
    level = Level.COMPATIBLE if old.number is None else Level.MEANING
    changes.compare(level, f"{label}: number", old.number, new.number, new.at)
    changes.since(label, old.since, new.since, new.at)
    formers = [v.former.summary if v.former else None for v in (old, new)]
    level = Level.MEANING if new.former else Level.COMPATIBLE
    changes.compare(level, f"{label}: before", formers[0], formers[1], new.at)
    marks = (old.unconfirmed, new.unconfirmed)
    changes.compare(Level.COMPATIBLE, f"{label}: unconfirmed", marks[0], marks[1], new.at)
    changes.compare(Level.COMPATIBLE, f"{label}: summary", old.summary, new.summary, new.at)


# Packed integers


def same_packed(old: Packed, new: Packed) -> bool:
    """True if two packed integers differ only in their names."""
    return old.scalar == new.scalar and _cuts(old) == _cuts(new)


def _cuts(packed: Packed) -> list[tuple[object, ...]]:
    return [(p.name, *_cut(p), p.enum.name if p.enum else None) for p in packed.parts]


def _cut(part: Part) -> tuple[int, ...]:
    return (part.mask, part.shift, part.divide, part.modulo, part.signed, part.sign)


def _cut_text(part: Part) -> str:
    if part.is_digits:
        modulo = f" % {part.modulo}" if part.modulo else ""
        return f"value / {part.divide}{modulo}"
    sign = (
        ", signed" if part.signed else f", negative if {part.sign:#x} is set" if part.sign else ""
    )
    return f"(value & {part.mask:#x}) >> {part.shift}{sign}"


def compare_packed(old: Packed, new: Packed, changes: Changes) -> None:
    """Compare type and parts of a packed integer."""
    what = f"packed {new.name}"
    changes.compare(Level.WIRE, f"{what}: type", old.scalar.name, new.scalar.name, new.at)
    compare_parts(what, old, new, changes)
    changes.compare(Level.COMPATIBLE, f"{what}: display", old.display, new.display, new.at)
    changes.compare(Level.COMPATIBLE, f"{what}: summary", old.summary, new.summary, new.at)


def compare_parts(what: str, old: Packed, new: Packed, changes: Changes) -> None:
    """Compare the parts of two packed integers by name."""
    _compare_enums_of(f"{what}: names", old.names, new.names, new, changes)
    mains = [packed.main.name if packed.main else "" for packed in (old, new)]
    level = Level.SOURCE if old.main else Level.COMPATIBLE
    changes.compare(level, f"{what}: main part", mains[0], mains[1], new.at)
    by_name = {part.name: part for part in new.parts}
    come = [part for part in new.parts if part.name not in {p.name for p in old.parts}]
    for part in old.parts:
        label = f"{what}.{part.name}"
        now = by_name.get(part.name)
        if now is None:
            now = next((p for p in come if _cut(p) == _cut(part)), None)
            if now is None:
                changes.deleted(Level.SOURCE, label, part.at, _cut_text(part))
                continue
            come.remove(now)
            changes.add(Level.SOURCE, f"{label}: name", part.name, now.name, now.at)
        elif _cut(part) != _cut(now):
            changes.add(Level.MEANING, label, _cut_text(part), _cut_text(now), now.at)
        _compare_enums_of(label, part.enum, now.enum, now, changes)
        units = [p.quantity.name if p.quantity else None for p in (part, now)]
        level = Level.MEANING if units[0] else Level.SOURCE
        changes.compare(level, f"{label}: quantity", units[0], units[1], now.at)
        changes.compare(Level.COMPATIBLE, f"{label}: summary", part.summary, now.summary, now.at)
    for part in come:
        changes.added(f"{what}.{part.name}", part.at, _cut_text(part))


def _compare_enums_of(
    label: str, old: Enum | None, new: Enum | None, owner: Union[Part, Packed], changes: Changes
) -> None:
    """Compare the enums of a part; enums with the same name are compared with the named types."""
    old_name, new_name = old.name if old else None, new.name if new else None
    if old_name == new_name:
        return
    changes.add(Level.SOURCE, f"{label}: type", old_name, new_name, owner.at)
    if old and new:
        compare_values(label, old, new, changes)
