"""Compares the named types of two versions: quantities, enums, flag sets and packed integers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar, Union

from sbgcgen.compat.changes import COMPATIBLE, MEANING, SOURCE, WIRE, Changes, Pair
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
            changes.deleted(SOURCE, f"{kind} {thing.name}", thing.at)
            continue
        come.remove(twin)
        pairs.append((thing, twin))
        changes.add(SOURCE, f"{kind} {thing.name}: name", thing.name, twin.name, twin.at)
    for thing in come:
        changes.added(f"{kind} {thing.name}", thing.at)
    return pairs


# Quantities


def same_quantity(old: Quantity, new: Quantity) -> bool:
    """True if two quantities differ only in their names."""
    return (old.scalar, unit_of(old), old.summary) == (new.scalar, unit_of(new), new.summary)


def unit_of(quantity: Quantity) -> tuple[object, ...]:
    """Unit and conversion of a quantity."""
    return (quantity.unit, quantity.scale, quantity.offset, quantity.ratio, quantity.over)


def compare_quantity(old: Quantity, new: Quantity, changes: Changes) -> None:
    """Compare type, unit and scale of a quantity."""
    pair = changes.pair(f"quantity {new.name}", old, new)
    pair.compare(WIRE, "type", "scalar.name")
    compare_unit(pair)
    pair.compare(SOURCE, "accessor")
    pair.compare(COMPATIBLE, "summary")


def compare_unit(quantities: Pair) -> None:
    """Compare the conversions of raw values."""
    for key in ("unit", "scale", "offset", "ratio", "over"):
        quantities.compare(MEANING, key)


# Enums and flag sets


def same_enum(old: Enum, new: Enum) -> bool:
    """True if two enums differ only in their names."""
    values = [[(v.name, v.value) for v in e.values] for e in (old, new)]
    return old.scalar == new.scalar and old.kind == new.kind and values[0] == values[1]


def compare_enum(old: Enum, new: Enum, changes: Changes) -> None:
    """Compare type, kind and values of an enum or flag set."""
    pair = changes.pair(f"{new.kind} {new.name}", old, new)
    pair.compare(WIRE, "type", "scalar.name")
    pair.compare(SOURCE, "kind")
    if old.name == new.name:
        pair.compare(SOURCE, "C++ member", "member")
    compare_values(pair.what, old, new, changes)
    pair.compare(MEANING, "success", lambda e: e.success and e.success.name, added=COMPATIBLE)
    pair.compare(COMPATIBLE, "summary")


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
            changes.add(COMPATIBLE, label, value.name, other.name, other.at)
            _compare_value(label, value, replace(other, identifier=value.identifier), changes)
        elif other is not None:
            changes.add(MEANING, f"{what}: {value.value}", value.name, other.name, other.at)
        else:
            changes.deleted(SOURCE, label, value.at, value.value)
    names = {value.name for value in old.values}
    numbers = {value.value for value in old.values}
    for value in new.values:
        if value.name not in names and value.value not in numbers:
            changes.added(f"{what}.{value.name}", value.at, value.value)


def _compare_value(label: str, old: EnumValue, new: EnumValue, changes: Changes) -> None:
    changes.compare(MEANING, label, old.value, new.value, new.at)
    pair = changes.pair(label, old, new)
    pair.compare(SOURCE, "C++ name", "identifier")
    pair.compare(WIRE, "type it names", "wire", added=COMPATIBLE)
    pair.compare(COMPATIBLE if old.number is None else MEANING, "number")
    pair.compare_since()
    pair.compare_needs()
    level = MEANING if new.former else COMPATIBLE
    pair.compare(level, "before", lambda value: value.former and value.former.summary)
    pair.compare(COMPATIBLE, "unconfirmed")
    pair.compare(COMPATIBLE, "summary")


# Packed integers


def same_packed(old: Packed, new: Packed) -> bool:
    """True if two packed integers differ only in their names."""
    return old.scalar == new.scalar and _cuts(old) == _cuts(new)


def _cuts(packed: Packed) -> list[tuple[object, ...]]:
    return [(p.name, *cut(p), p.enum.name if p.enum else None) for p in packed.parts]


def cut(part: Part) -> tuple[int, ...]:
    """The place of a part in the integer."""
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
    pair = changes.pair(f"packed {new.name}", old, new)
    pair.compare(WIRE, "type", "scalar.name")
    compare_parts(pair.what, old, new, changes)
    pair.compare(COMPATIBLE, "display")
    pair.compare(COMPATIBLE, "later display", "later_display")
    pair.compare(COMPATIBLE, "first value of the later display", "later_from")
    pair.compare(COMPATIBLE, "summary")


def compare_parts(what: str, old: Packed, new: Packed, changes: Changes) -> None:
    """Compare the parts of two packed integers by name."""
    _compare_enums_of(f"{what}: names", old.names, new.names, new, changes)
    pair = changes.pair(what, old, new)
    pair.compare(SOURCE, "main part", lambda p: p.main and p.main.name, added=COMPATIBLE)
    by_name = {part.name: part for part in new.parts}
    come = [part for part in new.parts if part.name not in {p.name for p in old.parts}]
    for part in old.parts:
        label = f"{what}.{part.name}"
        now = by_name.get(part.name)
        if now is None:
            now = next((p for p in come if cut(p) == cut(part)), None)
            if now is None:
                changes.deleted(SOURCE, label, part.at, _cut_text(part))
                continue
            come.remove(now)
            changes.add(SOURCE, f"{label}: name", part.name, now.name, now.at)
        elif cut(part) != cut(now):
            changes.add(MEANING, label, _cut_text(part), _cut_text(now), now.at)
        _compare_enums_of(label, part.enum, now.enum, now, changes)
        pair = changes.pair(label, part, now)
        pair.compare(MEANING, "quantity", lambda p: p.quantity and p.quantity.name, added=SOURCE)
        pair.compare(COMPATIBLE, "summary")
    for part in come:
        changes.added(f"{what}.{part.name}", part.at, _cut_text(part))


def _compare_enums_of(
    label: str, old: Enum | None, new: Enum | None, owner: Union[Part, Packed], changes: Changes
) -> None:
    """Compare the enums of a part; enums with the same name are compared with the named types."""
    old_name, new_name = old.name if old else None, new.name if new else None
    if old_name == new_name:
        return
    changes.add(SOURCE, f"{label}: type", old_name, new_name, owner.at)
    if old and new:
        compare_values(label, old, new, changes)
