"""Compares two lists of fields: layout on the wire, meaning, and names in C++.

Reserved bytes are not part of the C++ interface; they are members only to keep their values. So new
fields in reserved bytes are a compatible addition, although the member `reserved` shrinks, moves or
disappears. The same holds for bytes without a meaning that get names, except that the C++ member is
lost. A tagged union may get further cases, which do not hold together with those that it has.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sbgcgen.compat.changes import COMPATIBLE, MEANING, SOURCE, WIRE, Changes, Pair
from sbgcgen.compat.types import compare_parts, compare_unit, compare_values, cut
from sbgcgen.spec.resolve.leaves import expand_name
from sbgcgen.model import scalar_of, Blob, Condition, Enum, Field, Later, Packed, Quantity
from sbgcgen.model import Struct, Type

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
    counting = (field.counting, field.counter_part and cut(field.counter_part))
    return (wire_type(field.type), _times(field), _condition(field.when), counting)


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
    rest = (when.part and cut(when.part), when.at_least, when.at_most)
    terms = (when.joined, [(term.source, _condition(term)) for term in when.terms])
    return (when.from_context, masks, numbers, when.may_be_missing, rest, terms)


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
    if a is None or b is None or not (a.is_on_values and b.is_on_values):
        return False
    same = (a.subject, a.from_context) == (b.subject, b.from_context)
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
            changes.add(WIRE, label, was, is_, now.at)
    kept = {id(before) for before, _ in pairs}
    for field in old:
        if id(field) not in kept and not _is_padding(field):
            label = f"{owner}.{field.spec_name}"
            changes.deleted(WIRE, label, field.at, _form_text(field))
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
    old, new = _unfolded(old, new), _unfolded(new, old)
    pairs = _pairs(old, new)
    for before, now in pairs:
        _compare_field(owner, before, now, pairs, changes)
    kept = {id(before) for before, _ in pairs}
    named = [f for f in old if id(f) not in kept and _is_named_now(f, new, pairs)]
    for field in named:
        label = f"{owner}.{field.spec_name}"
        changes.deleted(SOURCE, label, field.at, f"{_form_text(field)}, which has names now")
    gone = [f for f in old if id(f) not in kept and not _is_padding(f) and f not in named]
    for field in gone:
        label = f"{owner}.{field.spec_name}"
        changes.deleted(WIRE, label, field.at, _form_text(field))
    free = [f for f in old if _is_padding(f) or f in named]
    explained = _compare_additions(owner, old, new, free, pairs, changes, open_ended)
    explained = _compare_places(owner, old, new, pairs, changes) or explained
    explained = explained or bool(gone) or any(wire_form(f) != wire_form(g) for f, g in pairs)
    end_old, end_new = places(old)[-1], places(new)[-1]
    if end_old != end_new and not explained:  # only reserved bytes at the end differ
        longer = end_old[:-1] == end_new[:-1] and end_new[-1] > end_old[-1]
        level = COMPATIBLE if longer and open_ended else WIRE
        at = (new or old)[-1].at
        changes.add(level, f"{owner}: end", _place_text(end_old), _place_text(end_new), at)


def _unfolded(fields: Fields, others: Fields) -> Fields:
    """The fields, with those of a group that the other version lacks in its place."""
    groups = {f.name for f in others if isinstance(f.type, Struct)}
    result: list[Field] = []
    for field in fields:
        if isinstance(field.type, Struct) and field.type.looks_outside and field.name not in groups:
            result += _members(field, field.type)
        else:
            result.append(field)
    return tuple(result)


def _members(group: Field, struct: Struct) -> Iterator[Field]:
    """The fields in each element of a group, with their paths and own names."""
    for suffix, word in group.elements:
        path = f"{group.name}{suffix}."
        for field in struct.fields:
            other = field.alternative
            if other is not None and other.in_group:
                other = replace(other, source=path + other.source, in_group=False)
            when = field.when.of(word) if field.when else None
            yield replace(
                field,
                name=path + field.name,
                spec_name=expand_name(field.spec_name, word),
                when=_seen_outside(when, path) if when else None,
                alternative=other,
                axis=field.axis or (word if field.directions else ""),
                offset=None,
            )


def _seen_outside(when: Condition, path: str) -> Condition:
    """The condition of a member of a group, as one of a field of the message."""
    terms = tuple(_seen_outside(term, path) for term in when.terms)
    source = when.source if when.is_outside or not when.source else path + when.source
    return replace(when, source=source, is_outside=False, terms=terms)


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
            changes.added(label, field.at, f"{form} {where}", WIRE)
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
        changes.add(WIRE, label, was, f"{is_}{more}", now.at)
    return bool(moved)


# One field


def _compare_field(
    owner: str, old: Field, new: Field, pairs: list[tuple[Field, Field]], changes: Changes
) -> None:
    pair = changes.pair(f"{owner}.{new.spec_name}", old, new)
    pair.compare(SOURCE, "C++ name and key in JSON", "name")
    pair.compare(COMPATIBLE, "name", "spec_name")
    _compare_types(pair)
    names = {before.name: now.name for before, now in pairs}
    pair.compare(WIRE, "elements", _times)
    if _times(old) == _times(new) and (old.dim, old.index) != (new.dim, new.index):
        pair.mark(SOURCE, "index", _index(old), _index(new))
    pair.mark(WIRE, "counted by", names.get(old.counter, old.counter), new.counter)
    pair.compare(WIRE, "counted in", "counting")
    parts = [field.counter_part for field in (old, new)]
    if len({part and cut(part) for part in parts}) > 1:
        pair.mark(WIRE, "counted by part", *(part.name if part else "" for part in parts))
    pair.compare(WIRE, "may be absent", "appended")
    pair.compare(WIRE, "is present if it fits", "fits")
    pair.compare(MEANING, "is hidden in text and JSON", "secret")
    pair.compare(COMPATIBLE, "name in saved files", "saved_as")
    pair.compare(COMPATIBLE, "number in saved files", "saved_in")
    _compare_conditions(pair, names)
    # Values that were valid become invalid only if the board used the field less often.
    pair.compare(
        MEANING if old.used_when else COMPATIBLE, "used when", lambda f: _when_text(f.used_when)
    )
    # A new default changes what a program sends that does not set the field.
    pair.compare(MEANING, "default")
    pair.compare(MEANING if new.constant else COMPATIBLE, "constant")
    pair.compare(COMPATIBLE, "unconfirmed")
    _compare_limits(pair)
    _compare_alternatives(pair, names)
    pair.compare(
        MEANING, "later", lambda field: [_later(field, one, changes) for one in field.later]
    )
    pair.compare(MEANING, "variable")
    pair.compare(MEANING, "reserved")
    pair.compare(MEANING if old.directions else COMPATIBLE, "directed", _directed)
    pair.compare_since()
    pair.compare_needs()
    pair.compare(COMPATIBLE, "deprecated", lambda field: bool(field.deprecated))
    pair.compare(COMPATIBLE, "summary")


def _later(field: Field, later: Later, changes: Changes) -> str:
    """A later meaning: "firmware 2.73.1: Gain (u8), 0..200, How strong it is."."""
    words = [type_text(later.type)] if later.type != field.type else []
    if (later.minimum, later.maximum) != (field.minimum, field.maximum):
        words.append(f"{later.minimum}..{later.maximum}")
    words += [later.summary] if later.summary != field.summary else []
    return f"{changes.versions(later.since)}: {', '.join(words)}"


def _directed(field: Field) -> str:
    """How the direction of a field is determined."""
    if field.directions is None:
        return ""
    return field.axis or ("as its axis" if field.directions else "unknown")


def compare_rules(what: str, old: Struct, new: Struct, changes: Changes) -> None:
    """Another rule makes values invalid that were valid."""
    before, now = [{rule.text("") for rule in struct.rules} for struct in (old, new)]
    for rule in sorted(now - before):
        changes.added(f"{what}: rule", new.at, rule, MEANING)
    for rule in sorted(before - now):
        changes.deleted(COMPATIBLE, f"{what}: rule", old.at, rule)


def _index(field: Field) -> str:
    return ", ".join(field.index) or str(field.count)


def type_text(type_: Type) -> str:
    if isinstance(type_, Blob):
        return type_.kind if type_.kind == "string" else f"{type_.kind}[{type_.size or ''}]"
    name = str(getattr(type_, "name", type_.kind))
    scalar = scalar_of(type_)
    return f"{name} ({scalar.name})" if scalar is not None and scalar.name != name else name


def _form_text(field: Field) -> str:
    times = f"[{field.count or ''}]" if field.dim != "one" else ""
    return type_text(field.type) + times


def _compare_types(fields: Pair) -> None:
    label, before, now = fields.what, fields.old.type, fields.new.type
    names = (getattr(before, "name", None), getattr(now, "name", None))
    if names[0] is not None and names[0] == names[1] and type(before) is type(now):
        return  # compared with the named types
    same_wire = wire_type(before) == wire_type(now)
    if same_wire:
        fields.mark(SOURCE, "C++ type", type_text(before), type_text(now))
    else:
        fields.changes.add(WIRE, f"{label}: type", type_text(before), type_text(now), fields.at)
    if isinstance(before, Struct) and isinstance(now, Struct):
        compare_structs(label, before, now, fields.changes)
    elif isinstance(before, Quantity) and isinstance(now, Quantity):
        compare_unit(fields.changes.pair(label, before, now))
    elif isinstance(before, Quantity) and same_wire:
        fields.mark(MEANING, "unit", f"{before.scale} {before.unit}", None)
    elif isinstance(before, Enum) and isinstance(now, Enum):
        compare_values(label, before, now, fields.changes)
    elif isinstance(before, Packed) and isinstance(now, Packed):
        compare_parts(label, before, now, fields.changes)


def _compare_conditions(fields: Pair, names: dict[str, str]) -> None:
    before, now = fields.old.when, fields.new.when
    sources = [names.get(before.source, before.source) if before else "", now.source if now else ""]
    if _condition(before) != _condition(now) or sources[0] != sources[1]:
        what = f"{fields.what}: when"
        fields.changes.add(WIRE, what, _when_text(before), _when_text(now), fields.at)


def _when_text(when: Condition | None) -> str:
    if when is None:
        return "always"
    missing = ", may be missing" if when.may_be_missing else ""
    if when.terms:
        word = " and " if when.joined == "all" else " or "
        return word.join(_when_text(term) for term in when.terms) + missing
    return f"{when.subject} {_accepted(when)}{missing}"


def _accepted(when: Condition) -> str:
    """For example "has FLAG_A (0x1), not FLAG_B (0x2)"."""
    if not when.is_on_flags:
        names = {v.value: f"{v.name} ({v.value:#x})" for v in when.values}
        words = " ".join(names.get(number, f"{number:#x}") for number in when.numbers)
        limits = (("at least", when.at_least), ("at most", when.at_most))
        said = [f"{'is not' if when.negated else 'is'} {words}"] if words else []
        return ", ".join(said + [f"{word} {n}" for word, n in limits if n is not None])
    parts = (("has", when.flags), ("any of", when.any_flags), ("not", when.no_flags))
    return ", ".join(
        f"{word} {' '.join(f'{f.name} ({f.value:#x})' for f in flags)}"
        for word, flags in parts
        if flags
    )


def _compare_limits(fields: Pair) -> None:
    """Compare range, alignment, role, numbers of elements, and special values."""
    old, new = fields.old, fields.new
    before, now = _range(old), _range(new)
    if before and now:
        narrowed = now[0] > before[0] or now[1] < before[1]
        texts = (f"{before[0]}..{before[1]}", f"{now[0]}..{now[1]}")
        fields.mark(MEANING if narrowed else COMPATIBLE, "range", *texts)
    fields.compare(MEANING if old.align % new.align else COMPATIBLE, "align")
    fields.compare(MEANING, "role")
    if old.dim == new.dim:
        fields.compare(COMPATIBLE if new.min_count < old.min_count else WIRE, "min_count")
        counts = [f.capacity if f.max_count is None else f.max_count for f in (old, new)]
        fields.compare(MEANING if counts[1] < counts[0] else COMPATIBLE, "max_count")
    come = {special.value: special for special in new.special}
    for special in old.special:
        same = come.pop(special.value, None)
        pair = fields.inner(f": special {special.value}", special, same)
        meaning = same.meaning if same else None
        fields.mark(MEANING, f"special {special.value}", special.meaning, meaning)
        level = SOURCE if special.name else COMPATIBLE
        pair.mark(level, "C++ name", special.name, same.name if same else "")
    for value, special in come.items():
        was_ordinary = before is not None and before[0] <= value <= before[1]
        level = MEANING if was_ordinary else COMPATIBLE
        what = f"{fields.what}: special {value}"
        fields.changes.added(what, fields.at, special.meaning, level)


def _range(field: Field) -> tuple[Fraction, Fraction] | None:
    """The range of valid values, which is that of the type by default."""
    if field.minimum is not None and field.maximum is not None:
        return (field.minimum, field.maximum)
    scalar = scalar_of(field.type)
    if scalar is None or scalar.minimum is None or scalar.maximum is None:
        huge = Fraction(1 << 200)
        return (-huge, huge) if scalar is not None else None
    return (Fraction(scalar.minimum), Fraction(scalar.maximum))


def _compare_alternatives(fields: Pair, names: dict[str, str]) -> None:
    before, now, changes = fields.old.alternative, fields.new.alternative, fields.changes
    what = f"{fields.what}: alternative unit"
    if before is None and now is not None:
        changes.added(what, fields.at, f"{now.quantity.name} with {now.flag.name}")
    elif before is not None and now is None:
        changes.deleted(MEANING, what, fields.old.at, before.quantity.name)
    elif before is not None and now is not None:
        if before.quantity.name != now.quantity.name:
            changes.add(SOURCE, what, before.quantity.name, now.quantity.name, fields.at)
            compare_unit(changes.pair(what, before.quantity, now.quantity))
        sources = [names.get(before.source, before.source), now.source]
        flags = [f"{source} & {a.mask:#x}" for source, a in zip(sources, (before, now))]
        fields.mark(MEANING, "alternative unit, chosen by", *flags)
