"""Compares two lists of fields: layout on the wire, meaning, and names in C++.

Reserved bytes are not part of the C++ interface; they are members only to keep their values. So new
fields in reserved bytes are a compatible addition, although the member `reserved` shrinks, moves or
disappears. The same holds for bytes without a meaning that get names, except that the C++ member is
lost. A tagged union may get further cases, which do not hold together with those that it has.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from sbgcgen.compat.changes import Changes, Level
from sbgcgen.compat.types import compare_parts, compare_unit, compare_values
from sbgcgen.model import (
    scalar_of,
    Blob,
    Condition,
    Enum,
    Field,
    Packed,
    Quantity,
    Struct,
    Type,
)

Fields = tuple[Field, ...]
Place = tuple[Any, ...]


# Layout on the wire


def wire_type(type_: Type) -> Any:
    """The layout of a type, regardless of its meaning."""
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
    return (wire_type(field.type), _times(field), _condition(field.when), field.counting)


def _times(field: Field) -> Any:
    return field.dim if field.dim in ("counted", "rest") else field.count


def _condition(when: Condition | None) -> Any:
    if when is None:
        return None
    masks = [
        sorted(flag.value for flag in flags)
        for flags in (when.flags, when.any_flags, when.no_flags)
    ]
    numbers = (when.negated, sorted(when.numbers))
    return (when.from_context, masks, numbers, when.may_be_missing)


def places(fields: Fields) -> list[Place]:
    """The place of each field, and that of the end.

    A place is an offset in bytes, or several numbers of bytes with the variable parts between them.
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
    """The place of each field of a tagged union: what can be before it."""
    return [
        tuple(wire_form(before) for before in fields[:index] if not _exclude(before, field))
        for index, field in enumerate(fields)
    ]


def _exclude(one: Field, other: Field) -> bool:
    """True if no body has both fields, because of different values of one field."""
    a, b = one.when, other.when
    if a is None or b is None or a.is_on_flags or b.is_on_flags or a.negated or b.negated:
        return False
    same = (a.source, a.from_context) == (b.source, b.from_context)
    return same and not set(a.numbers) & set(b.numbers)


def _place_text(place: Place) -> str:
    if len(place) == 1:
        return f"byte {place[0]}"
    return f"byte {place[-1]} after {len(place) // 2} variable parts"


# Matching fields


def _is_padding(field: Field) -> bool:
    return field.reserved and isinstance(field.type, Blob)


def _pairs(old: Fields, new: Fields) -> list[tuple[Field, Field]]:
    """Corresponding fields: those with the same protocol name, or the same place and form.

    The same name, or that which the new one had before.
    """
    by_name = _by_name(new)
    formerly = {alias.name: key for key, f in by_name.items() for alias in f.aliases}
    pairs = []
    left = []
    for name, field in _by_name(old).items():
        twin = by_name.pop(name if name in by_name else formerly.get(field.name, name), None)
        if twin is None:
            left.append(field)
        else:
            pairs.append((field, twin))
    where_old = dict(zip((id(f) for f in old), places(old)))
    where_new = dict(zip((id(f) for f in new), places(new)))
    for field in left:
        for name, twin in by_name.items():
            same_place = where_old[id(field)] == where_new[id(twin)]
            if same_place and wire_form(field) == wire_form(twin):
                pairs.append((field, by_name.pop(name)))
                break
    return pairs


def _by_name(fields: Fields) -> dict[tuple[str, int], Field]:
    """Fields by the protocol's name and a number, which distinguishes fields with the same name."""
    found: dict[tuple[str, int], Field] = {}
    for field in fields:
        if not _is_padding(field):
            number = sum(name == field.spec_name for name, _ in found)
            found[(field.spec_name, number)] = field
    return found


def compare_cases(owner: str, old: Fields, new: Fields, changes: Changes) -> None:
    """Compare the fields of two tagged unions."""
    pairs = _pairs(old, new)
    for before, now in pairs:
        _compare_field(owner, before, now, pairs, changes)
    where_old = dict(zip((id(f) for f in old), case_places(old)))
    where_new = dict(zip((id(f) for f in new), case_places(new)))
    for before, now in pairs:
        if where_old[id(before)] != where_new[id(now)]:
            label = f"{owner}.{now.spec_name}: place"
            counts = (len(where_old[id(before)]), len(where_new[id(now)]))
            was, is_ = f"after {counts[0]} others", f"after {counts[1]} others"
            changes.add(Level.WIRE, label, was, is_, now.at)
    kept = {id(before) for before, _ in pairs}
    for field in old:
        if id(field) not in kept and not _is_padding(field):
            label = f"{owner}.{field.spec_name}"
            changes.deleted(Level.WIRE, label, field.at, _form_text(field))
    known = {id(now) for _, now in pairs}
    for field in new:
        if id(field) not in known and not _is_padding(field):
            form = f"{_form_text(field)} if {_when_text(field.when)}"
            changes.added(f"{owner}.{field.spec_name}", field.at, form)


def compare_structs(owner: str, old: Struct, new: Struct, changes: Changes) -> None:
    """Compare the fields and rules of two structs."""
    compare_rules(owner, old, new, changes)
    if old.is_region and new.is_region:
        compare_cases(owner, old.fields, new.fields, changes)
    else:
        compare_fields(owner, old.fields, new.fields, changes)


def compare_fields(
    owner: str, old: Fields, new: Fields, changes: Changes, open_ended: bool = False
) -> None:
    """Compare two lists of fields; `open_ended` if the old one accepts longer bodies."""
    pairs = _pairs(old, new)
    for before, now in pairs:
        _compare_field(owner, before, now, pairs, changes)
    kept = {id(before) for before, _ in pairs}
    named = [f for f in old if id(f) not in kept and _is_named_now(f, new, pairs)]
    for field in named:
        label = f"{owner}.{field.spec_name}"
        changes.deleted(Level.SOURCE, label, field.at, f"{_form_text(field)}, which has names now")
    gone = [f for f in old if id(f) not in kept and not _is_padding(f) and f not in named]
    for field in gone:
        label = f"{owner}.{field.spec_name}"
        changes.deleted(Level.WIRE, label, field.at, _form_text(field))
    free = [f for f in old if _is_padding(f) or f in named]
    explained = _compare_additions(owner, old, new, free, pairs, changes, open_ended)
    explained = _compare_places(owner, old, new, pairs, changes) or explained
    explained = explained or bool(gone) or any(wire_form(f) != wire_form(g) for f, g in pairs)
    end_old, end_new = places(old)[-1], places(new)[-1]
    if end_old != end_new and not explained:  # only reserved bytes at the end differ
        longer = end_old[:-1] == end_new[:-1] and end_new[-1] > end_old[-1]
        level = Level.COMPATIBLE if longer and open_ended else Level.WIRE
        at = (new or old)[-1].at
        changes.add(level, f"{owner}: end", _place_text(end_old), _place_text(end_new), at)


def _compare_additions(
    owner: str,
    old: Fields,
    new: Fields,
    free: list[Field],
    pairs: list[tuple[Field, Field]],
    changes: Changes,
    open_ended: bool,
) -> bool:
    """Compare new fields, which can be in free bytes, at the end, or in between.

    Returns true if they move the end of the list.
    """
    known = {id(now) for _, now in pairs}
    end = places(old)[-1]
    begins = places(new)
    longer = False
    for index, field in enumerate(new):
        if id(field) in known or _is_padding(field):
            continue
        label = f"{owner}.{field.spec_name}"
        form = _form_text(field)
        at_the_end = begins[index][: len(end) - 1] == end[:-1] and (
            len(begins[index]) > len(end) or begins[index][-1] >= end[-1]
        )
        if _takes(field, free):
            changes.added(label, field.at, f"{form} in reserved bytes")
            continue
        longer = True
        if at_the_end and (open_ended or field.optional or field.appended or _may_be_empty(field)):
            changes.added(label, field.at, f"{form} at the end")
        else:
            where = "at the end, where no tail is accepted" if at_the_end else "in between"
            changes.added(label, field.at, f"{form} {where}", Level.WIRE)
    return longer


def _may_be_empty(field: Field) -> bool:
    return field.dim == "rest" or (field.when is not None and field.when.may_be_missing)


def _is_named_now(field: Field, new: Fields, pairs: list[tuple[Field, Field]]) -> bool:
    """True for bytes without a meaning in whose place there are only new fields."""
    known = {id(now) for _, now in pairs}
    if not isinstance(field.type, Blob) or field.offset is None or not field.size:
        return False
    if field.type.kind != "bytes" or field.may_be_absent or field.reserved:
        return False
    end = field.offset + field.size
    inside = [f for f in new if f.offset is not None and field.offset <= f.offset < end]
    sizes = [f.size for f in inside if f.size is not None and not f.may_be_absent]
    return sum(sizes) == field.size and not any(id(f) in known for f in inside)


def _takes(field: Field, free: list[Field]) -> bool:
    """True if a field is inside bytes that were free."""
    if field.offset is None or field.size is None or field.may_be_absent:
        return False
    end = field.offset + field.size
    return any(
        f.offset is not None
        and f.size is not None
        and f.offset <= field.offset
        and end <= f.offset + f.size
        for f in free
    )


def _compare_places(
    owner: str, old: Fields, new: Fields, pairs: list[tuple[Field, Field]], changes: Changes
) -> bool:
    """Report the first field with a different offset, and the number of others."""
    where_old = dict(zip((id(f) for f in old), places(old)))
    where_new = dict(zip((id(f) for f in new), places(new)))
    moved = [(f, g) for f, g in pairs if where_old[id(f)] != where_new[id(g)]]
    moved.sort(key=lambda pair: old.index(pair[0]))
    for before, now in moved[:1]:
        more = f" (and {len(moved) - 1} more fields)" if len(moved) > 1 else ""
        was, is_ = _place_text(where_old[id(before)]), _place_text(where_new[id(now)])
        label = f"{owner}.{now.spec_name}: place"
        changes.add(Level.WIRE, label, was, f"{is_}{more}", now.at)
    return bool(moved)


# One field


def _compare_field(
    owner: str, old: Field, new: Field, pairs: list[tuple[Field, Field]], changes: Changes
) -> None:
    label = f"{owner}.{new.spec_name}"
    at = new.at
    is_alias = old.name in {alias.name for alias in new.aliases}
    level = Level.COMPATIBLE if is_alias else Level.SOURCE
    changes.compare(level, f"{label}: C++ name", old.name, new.name, at)
    changes.compare(Level.COMPATIBLE, f"{label}: name", old.spec_name, new.spec_name, at)
    _compare_types(label, old, new, changes)
    names = {before.name: now.name for before, now in pairs}
    if _times(old) != _times(new):
        changes.add(Level.WIRE, f"{label}: elements", _times(old), _times(new), at)
    elif (old.dim, old.index) != (new.dim, new.index):
        changes.add(Level.SOURCE, f"{label}: index", _index(old), _index(new), at)
    if names.get(old.counter, old.counter) != new.counter:
        changes.add(Level.WIRE, f"{label}: counted by", old.counter, new.counter, at)
    changes.compare(Level.WIRE, f"{label}: counted in", old.counting, new.counting, at)
    changes.compare(Level.WIRE, f"{label}: may be absent", old.appended, new.appended, at)
    _compare_conditions(label, old, new, names, changes)
    _compare_defaults(label, old, new, changes)
    _compare_limits(label, old, new, changes)
    _compare_alternatives(label, old, new, changes)
    changes.compare(Level.MEANING, f"{label}: variable", old.variable, new.variable, at)
    changes.compare(Level.MEANING, f"{label}: reserved", old.reserved, new.reserved, at)
    directed = [_directed(old), _directed(new)]
    level = Level.MEANING if old.directions else Level.COMPATIBLE
    changes.compare(level, f"{label}: directed", directed[0], directed[1], at)
    changes.since(label, old.since, new.since, at)
    marks = [bool(old.deprecated), bool(new.deprecated)]
    changes.compare(Level.COMPATIBLE, f"{label}: deprecated", marks[0], marks[1], at)
    changes.compare(Level.COMPATIBLE, f"{label}: summary", old.summary, new.summary, at)


def _directed(field: Field) -> str:
    """How the direction of a field is determined."""
    if field.directions is None:
        return ""
    return field.axis or ("as its axis" if field.directions else "unknown")


def _compare_defaults(label: str, old: Field, new: Field, changes: Changes) -> None:
    """A new default changes what a program sends that does not set the field."""
    changes.compare(Level.MEANING, f"{label}: default", old.default, new.default, new.at)
    level = Level.MEANING if new.constant else Level.COMPATIBLE
    changes.compare(level, f"{label}: constant", old.constant, new.constant, new.at)
    marks = (old.unconfirmed, new.unconfirmed)
    changes.compare(Level.COMPATIBLE, f"{label}: unconfirmed", *marks, new.at)


def compare_rules(what: str, old: Struct, new: Struct, changes: Changes) -> None:
    """Another rule makes values invalid that were valid."""
    before, now = [
        {f"{r.low} {'<' if r.is_strict else '<='} {r.high}" for r in s.rules} for s in (old, new)
    ]
    for rule in sorted(now - before):
        changes.added(f"{what}: rule", new.at, rule, Level.MEANING)
    for rule in sorted(before - now):
        changes.deleted(Level.COMPATIBLE, f"{what}: rule", old.at, rule)


def _index(field: Field) -> str:
    return ", ".join(field.index) or str(field.count)


def type_text(type_: Type) -> str:
    """A type as text for the report."""
    if isinstance(type_, Blob):
        return type_.kind if type_.kind == "string" else f"{type_.kind}[{type_.size or ''}]"
    name = str(getattr(type_, "name", type_.kind))
    scalar = scalar_of(type_)
    return f"{name} ({scalar.name})" if scalar is not None and scalar.name != name else name


def _form_text(field: Field) -> str:
    times = f"[{field.count or ''}]" if field.dim != "one" else ""
    return type_text(field.type) + times


def _compare_types(label: str, old: Field, new: Field, changes: Changes) -> None:
    before, now, at = old.type, new.type, new.at
    names = (getattr(before, "name", None), getattr(now, "name", None))
    if names[0] is not None and names[0] == names[1] and type(before) is type(now):
        return  # compared with the named types
    same_wire = wire_type(before) == wire_type(now)
    texts = (type_text(before), type_text(now))
    if not same_wire:
        changes.add(Level.WIRE, f"{label}: type", *texts, at)
    elif texts[0] != texts[1]:
        changes.add(Level.SOURCE, f"{label}: C++ type", *texts, at)
    if isinstance(before, Struct) and isinstance(now, Struct):
        compare_structs(label, before, now, changes)
    elif isinstance(before, Quantity) and isinstance(now, Quantity):
        compare_unit(label, before, now, changes)
    elif isinstance(before, Quantity) and same_wire:
        changes.add(Level.MEANING, f"{label}: unit", f"{before.scale} {before.unit}", None, at)
    elif isinstance(before, Enum) and isinstance(now, Enum):
        compare_values(label, before, now, changes)
    elif isinstance(before, Packed) and isinstance(now, Packed):
        compare_parts(label, before, now, changes)


def _compare_conditions(
    label: str, old: Field, new: Field, names: dict[str, str], changes: Changes
) -> None:
    before, now = old.when, new.when
    sources = [names.get(before.source, before.source) if before else "", now.source if now else ""]
    same = _condition(before) == _condition(now) and sources[0] == sources[1]
    if not same:
        changes.add(Level.WIRE, f"{label}: when", _when_text(before), _when_text(now), new.at)


def _when_text(when: Condition | None) -> str:
    if when is None:
        return "always"
    missing = ", may be missing" if when.may_be_missing else ""
    return f"{when.source} {_accepted(when)}{missing}"


def _accepted(when: Condition) -> str:
    """For example "has FLAG_A (0x1), not FLAG_B (0x2)"."""
    if not when.is_on_flags:
        names = {v.value: f"{v.name} ({v.value:#x})" for v in when.values}
        words = " ".join(names.get(number, f"{number:#x}") for number in when.numbers)
        return f"is not {words}" if when.negated else f"is {words}"
    parts = (("has", when.flags), ("any of", when.any_flags), ("not", when.no_flags))
    return ", ".join(
        f"{word} {' '.join(f'{f.name} ({f.value:#x})' for f in flags)}"
        for word, flags in parts
        if flags
    )


def _compare_limits(label: str, old: Field, new: Field, changes: Changes) -> None:
    """Compare range, alignment, role, numbers of elements, and special values."""
    before, now = _range(old), _range(new)
    if before and now and before != now:
        narrowed = now[0] > before[0] or now[1] < before[1]
        level = Level.MEANING if narrowed else Level.COMPATIBLE
        texts = (f"{before[0]}..{before[1]}", f"{now[0]}..{now[1]}")
        changes.add(level, f"{label}: range", *texts, new.at)
    if old.align != new.align:
        level = Level.MEANING if old.align % new.align else Level.COMPATIBLE
        changes.add(level, f"{label}: align", old.align, new.align, new.at)
    changes.compare(Level.MEANING, f"{label}: role", old.role or None, new.role or None, new.at)
    if old.dim == new.dim:
        level = Level.COMPATIBLE if new.min_count < old.min_count else Level.WIRE
        changes.compare(level, f"{label}: min_count", old.min_count, new.min_count, new.at)
    counts = [f.capacity if f.max_count is None else f.max_count for f in (old, new)]
    if old.max_count != new.max_count and old.dim == new.dim:
        level = Level.MEANING if counts[1] < counts[0] else Level.COMPATIBLE
        changes.add(level, f"{label}: max_count", old.max_count, new.max_count, new.at)
    meanings = {special.value: special.meaning for special in new.special}
    for special in old.special:
        what = f"{label}: special {special.value}"
        changes.compare(
            Level.MEANING, what, special.meaning, meanings.pop(special.value, None), new.at
        )
        name = next((s.name for s in new.special if s.value == special.value), "")
        level = Level.SOURCE if special.name else Level.COMPATIBLE
        changes.compare(level, f"{what}: C++ name", special.name, name, new.at)
    for value, meaning in meanings.items():
        was_ordinary = before is not None and before[0] <= value <= before[1]
        level = Level.MEANING if was_ordinary else Level.COMPATIBLE
        changes.added(f"{label}: special {value}", new.at, meaning, level)


def _range(field: Field) -> tuple[Fraction, Fraction] | None:
    """The range of valid values, which is that of the type by default."""
    if field.minimum is not None and field.maximum is not None:
        return (field.minimum, field.maximum)
    scalar = scalar_of(field.type)
    if scalar is None or scalar.minimum is None or scalar.maximum is None:
        huge = Fraction(1 << 200)
        return (-huge, huge) if scalar is not None else None
    return (Fraction(scalar.minimum), Fraction(scalar.maximum))


def _compare_alternatives(label: str, old: Field, new: Field, changes: Changes) -> None:
    before, now = old.alternative, new.alternative
    what = f"{label}: alternative unit"
    if before is None and now is not None:
        changes.added(what, new.at, f"{now.quantity.name} with {now.flag.name}")
    elif before is not None and now is None:
        changes.deleted(Level.MEANING, what, old.at, before.quantity.name)
    elif before is not None and now is not None:
        if before.quantity.name != now.quantity.name:
            changes.add(Level.SOURCE, what, before.quantity.name, now.quantity.name, new.at)
            compare_unit(what, before.quantity, now.quantity, changes)
        flags = [f"{a.source} & {a.mask:#x}" for a in (before, now)]
        changes.compare(Level.MEANING, f"{what}, chosen by", flags[0], flags[1], new.at)
