"""Compares two lists of fields: their order and positions on the wire, and additions and deletions.

Reserved bytes are not part of the C++ interface; they are members only to preserve their values. So new
fields in reserved bytes are a compatible addition, although the member `reserved` shrinks, moves or
disappears. The same holds for unnamed bytes that get names, except that the C++ member is lost. A tagged
union may get further cases that exclude its existing ones.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

from sbgcgen.compat.changes import COMPATIBLE, MEANING, SOURCE, WIRE, Level
from sbgcgen.compat.difference import Pair
from sbgcgen.compat.wire import Fields, Place, case_places, places, wire_form
from sbgcgen.compat.words import form_text, place_text, when_text
from sbgcgen.model import Blob, Condition, Field, Struct
from sbgcgen.spec.resolve.leaves import expand_name

_Places = Callable[[Fields], list[Place]]


def compare_structs(structs: Pair) -> None:
    """Compare the fields and rules of two structs."""
    compare_rules(structs)
    old, new = structs.both("fields")
    if structs.old.is_region and structs.new.is_region:
        _Lists(structs, old, new, case_places).compare_cases()
    else:
        compare_fields(structs, old, new)


def compare_rules(structs: Pair) -> None:
    """Report rules that make previously valid values invalid."""
    before, now = structs.both(lambda struct: {rule.text("") for rule in struct.rules})
    what, changes = f"{structs.what}: rule", structs.changes
    for rule in sorted(now - before):
        changes.added(what, structs.new.at, rule, MEANING)
    for rule in sorted(before - now):
        changes.deleted(COMPATIBLE, what, structs.old.at, rule)


def compare_fields(owner: Pair, old: Fields, new: Fields, open_ended: bool = False) -> None:
    """Compare two lists of fields; `open_ended` if the old one accepts longer bodies."""
    old, new = _unfolded(old, new), _unfolded(new, old)
    _Lists(owner, old, new).compare(open_ended)


class _Lists:
    """Two lists of fields; `pairs` are the matching ones, `gone` and `come` the other named ones."""

    def __init__(self, owner: Pair, old: Fields, new: Fields, places_of: _Places = places) -> None:
        self.owner, self.changes, self.old, self.new = owner, owner.changes, old, new
        self.where = {
            id(field): place for side in (old, new) for field, place in zip(side, places_of(side))
        }
        self.pairs = _pairs(old, new)
        self.kept = {id(field) for pair in self.pairs for field in pair}
        self.gone, self.come = (
            [f for f in side if id(f) not in self.kept and not _is_padding(f)]
            for side in (old, new)
        )

    def compare_cases(self) -> None:
        """Compare tagged unions."""
        self._compare_pairs()
        for before, now in self._moved():
            was, is_ = (f"after {len(self.where[id(field)])} others" for field in (before, now))
            self.changes.add(WIRE, f"{self._label(now)}: place", was, is_, now.at)
        self._report_deleted(self.gone)
        for field in self.come:
            form = f"{form_text(field)} if {when_text(field.when)}"
            self.changes.added(self._label(field), field.at, form)

    def compare(self, open_ended: bool) -> None:
        """Compare consecutive fields of a body."""
        self._compare_pairs()
        named = [field for field in self.gone if self._has_names_now(field)]
        self._report_deleted(named, SOURCE, ", which has names now")
        gone = [field for field in self.gone if field not in named]
        self._report_deleted(gone)
        free = [field for field in self.old if _is_padding(field) or field in named]
        end, new_end = places(self.old)[-1], places(self.new)[-1]
        is_explained = self._compare_additions(free, end, open_ended)
        is_explained |= self._compare_places() or bool(gone)
        is_explained |= any(wire_form(before) != wire_form(now) for before, now in self.pairs)
        if end != new_end and not is_explained:  # only reserved bytes at the end differ
            is_longer = end[:-1] == new_end[:-1] and new_end[-1] > end[-1]
            level = COMPATIBLE if is_longer and open_ended else WIRE
            what, at = f"{self.owner.what}: end", (self.new or self.old)[-1].at
            self.changes.add(level, what, place_text(end), place_text(new_end), at)

    def _compare_pairs(self) -> None:
        names = {before.name: now.name for before, now in self.pairs}
        for before, now in self.pairs:
            what = f".{now.spec_name}"
            self.owner.inner(what, before, now, at=now.at, names=names).compare()

    def _report_deleted(self, gone: list[Field], level: Level = WIRE, more: str = "") -> None:
        for field in gone:
            self.changes.deleted(level, self._label(field), field.at, form_text(field) + more)

    def _compare_additions(self, free: list[Field], end: Place, open_ended: bool) -> bool:
        """Report new fields: in free bytes, at the end, or in between.

        Returns true if they move the end of the list.
        """
        is_longer = False
        for field in self.come:
            place, level = self.where[id(field)], COMPATIBLE
            is_behind = len(place) > len(end) or place[-1] >= end[-1]
            if any(_is_within(field, one) for one in free):
                where = "in reserved bytes"
            elif place[: len(end) - 1] != end[:-1] or not is_behind:
                where, level = "in between", WIRE
            elif open_ended or field.optional or field.appended or field.dim == "rest":
                where = "at the end"
            elif field.when is not None and field.when.may_be_missing:
                where = "at the end"
            else:
                where, level = "at the end, where no tail is accepted", WIRE
            is_longer |= where != "in reserved bytes"
            self.changes.added(self._label(field), field.at, f"{form_text(field)} {where}", level)
        return is_longer

    def _compare_places(self) -> bool:
        """Report the first field with a different offset, and the number of others."""
        moved = sorted(self._moved(), key=lambda pair: self.old.index(pair[0]))
        for before, now in moved[:1]:
            more = f" (and {len(moved) - 1} more fields)" if len(moved) > 1 else ""
            was, is_ = (place_text(self.where[id(field)]) for field in (before, now))
            self.changes.add(WIRE, f"{self._label(now)}: place", was, is_ + more, now.at)
        return bool(moved)

    def _moved(self) -> list[tuple[Field, Field]]:
        where = self.where
        return [(old, new) for old, new in self.pairs if where[id(old)] != where[id(new)]]

    def _has_names_now(self, field: Field) -> bool:
        """True for unnamed bytes that were replaced by new fields only."""
        if not isinstance(field.type, Blob) or field.offset is None or not field.size:
            return False
        if field.type.kind != "bytes" or field.may_be_absent:
            return False
        end = field.offset + field.size
        inside = [f for f in self.new if f.offset is not None and field.offset <= f.offset < end]
        sizes = [f.size for f in inside if f.size is not None and not f.may_be_absent]
        return sum(sizes) == field.size and self.kept.isdisjoint(map(id, inside))

    def _label(self, field: Field) -> str:
        return f"{self.owner.what}.{field.spec_name}"


# Matching fields


def _pairs(old: Fields, new: Fields) -> list[tuple[Field, Field]]:
    """Match fields: by protocol name, or by position and form.

    A former name of the new field counts, too.
    """
    by_name = _by_name(new)
    formerly = {alias.name: key for key, f in by_name.items() for alias in f.aliases}
    pairs, left = [], []
    for name, field in _by_name(old).items():
        twin = by_name.pop(name if name in by_name else formerly.get(field.name, name), None)
        if twin is None:
            left.append(field)
        else:
            pairs.append((field, twin))
    forms = {
        id(field): (place, wire_form(field))
        for side in (old, new)
        for field, place in zip(side, places(side))
    }
    for field in left:
        alike = [name for name, f in by_name.items() if forms[id(f)] == forms[id(field)]]
        if alike:
            pairs.append((field, by_name.pop(alike[0])))
    return pairs


def _by_name(fields: Fields) -> dict[tuple[str, int], Field]:
    """Fields by the protocol's name and a number, which distinguishes fields with the same name."""
    found: dict[tuple[str, int], Field] = {}
    for field in fields:
        if not _is_padding(field):
            number = sum(name == field.spec_name for name, _ in found)
            found[(field.spec_name, number)] = field
    return found


def _is_padding(field: Field) -> bool:
    return field.reserved and isinstance(field.type, Blob)


def _is_within(field: Field, other: Field) -> bool:
    """True if a field is inside the bytes of another."""
    if field.offset is None or field.size is None or field.may_be_absent:
        return False
    if other.offset is None or other.size is None:
        return False
    return other.offset <= field.offset and field.offset + field.size <= other.offset + other.size


# Groups of fields


def _unfolded(fields: Fields, others: Fields) -> Fields:
    """Return the fields; a group that the other version lacks is replaced by its fields."""
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
            yield replace(
                field,
                name=path + field.name,
                spec_name=expand_name(field.spec_name, word),
                when=_seen_outside(field.when.of(word), path) if field.when else None,
                alternative=other,
                axis=field.axis or (word if field.directions else ""),
                offset=None,
            )


def _seen_outside(when: Condition, path: str) -> Condition:
    """The condition of a member of a group, as one of a field of the message."""
    terms = tuple(_seen_outside(term, path) for term in when.terms)
    source = when.source if when.is_outside or not when.source else path + when.source
    return replace(when, source=source, is_outside=False, terms=terms)
