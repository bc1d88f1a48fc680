"""Resolves lists of fields: types, repetitions, offsets, conditions and limits."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sbgcgen.diagnostics import Diagnostics, Position, did_you_mean
from sbgcgen.load import Map, Spec
from sbgcgen.model import (
    SCALARS,
    Alternative,
    Announced,
    Announcement,
    Availability,
    Blob,
    Condition,
    Context,
    Enum,
    Field,
    Leaf,
    Packed,
    Quantity,
    Scalar,
    Special,
    Struct,
    Type,
)
from sbgcgen.names import FieldName, parse_field_name, snake_case, type_advice
from sbgcgen.resolve_examples import ExampleReader
from sbgcgen.resolve_types import VARIABLE_ID, TypeResolver, parse_bits

_BLOB = re.compile(r"(bytes|text(?=\[[0-9]))\[([1-9][0-9]{0,5})?\]$")
_ANNOUNCED = re.compile(r"announced\(([A-Z][A-Z0-9_]*)\)$")
_RANGE = re.compile(r"(-?[0-9]+(?:\.[0-9]+)?)\.\.(-?[0-9]+(?:\.[0-9]+)?)$")


def scalar_of(type_: Type) -> Scalar | None:
    """The number on the wire behind a type, None for bytes and structs."""
    if isinstance(type_, Scalar):
        return type_
    if isinstance(type_, (Quantity, Enum, Packed)):
        return type_.scalar
    return None


def _size_of(type_: Type) -> int | None:
    scalar = scalar_of(type_)
    if scalar is not None:
        return scalar.size
    if isinstance(type_, Announced):
        return None
    assert isinstance(type_, (Blob, Struct))
    return None if isinstance(type_, Blob) and type_.kind == "string" else type_.size


def _min_size_of(type_: Type) -> int:
    if isinstance(type_, Struct):
        return type_.min_size
    if isinstance(type_, Blob) and type_.kind == "string":
        return 1
    return _size_of(type_) or 0


class FieldResolver:
    """Turns field lists into model fields; structs are resolved when first used."""

    def __init__(self, spec: Spec, types: TypeResolver, found: Diagnostics, max_body: int) -> None:
        self.spec = spec
        self.types = types
        self.found = found
        self.max_body = max_body
        self.examples = ExampleReader(found, types.broken)
        self.structs: dict[str, Struct] = {}
        self._variable_ids = types.types.enums[VARIABLE_ID]
        self.indices: dict[str, tuple[str, ...]] = {
            name: tuple(words) for name, words in spec.main.get("indices", {}).items()
        }
        self._nodes = {
            name: (family, node, at) for family, name, node, at in spec.entries("structs")
        }
        for family, node in _inline_structs(spec):
            name = str(node["struct"])
            if name in self._nodes:
                first = self._nodes[name][2]
                message = f"'{name}' is defined twice (first at {first})"
                self.found.add(node.at("struct"), "SBGC028", message, "refer to it with 'type'")
            self._nodes.setdefault(name, (family, node, node.at("struct")))
        self._open: list[str] = []
        self._broken: list[tuple[FieldName, Position]] = []  # fields of unknown types

    # Structs and types

    def struct(self, name: str, around: tuple[Field, ...] = ()) -> Struct:
        """The struct of this name, resolved; a region may refer to the fields `around` it."""
        if name not in self.structs:
            family, node, at = self._nodes[name]
            is_region = "size" in node
            self._open.append(name)
            outer = around if is_region else ()
            fields = self.fields(node["fields"], name, (), in_struct=True, around=outer)
            self._open.pop()
            if is_region:
                fields = (*fields, self._region_rest(node, fields))
            size = node["size"] if is_region else total_size(fields)
            self.structs[name] = Struct(
                name=self.types.identifier(name, at),
                summary=self.types.summary(node, at, name),
                fields=fields,
                size=size,
                min_size=size if size is not None else min_size(fields),
                family=family,
                is_region=is_region,
                at=at,
            )
        return self.structs[name]

    def _region_rest(self, node: Map, fields: tuple[Field, ...]) -> Field:
        """The member that keeps what the conditional fields of a region do not use."""
        size = int(node["size"])
        for field in fields:
            if field.when is None or (field.size or size + 1) > size:
                message = f"'{field.name}' is not a conditional field of at most {size} bytes"
                self.found.add(
                    field.at, "SBGC033", message, "give it a 'when', or widen the region"
                )
        return Field(
            name="rest",
            spec_name="",
            type=Blob("bytes", None),
            dim="rest",
            count=0,
            index=(),
            counter="",
            is_counter=False,
            offset=None,
            size=None,
            capacity=size,
            minimum=None,
            maximum=None,
            special=(),
            min_count=0,
            max_count=None,
            variable="",
            align=1,
            reserved=True,
            optional=True,
            when=None,
            alternative=None,
            since=Availability(),
            deprecated=None,
            summary=f"What is not used of the {size} bytes; filled up with zeros.",
            errata=(),
            at=node.position,
        )

    def _type(self, node: Map, around: tuple[Field, ...]) -> Type | None:
        if "fields" in node:
            return self.struct(str(node["struct"]), around)
        text = str(node.get("type", ""))
        at = node.at("type")
        if text in SCALARS:
            return SCALARS[text]
        blob = _BLOB.match(text)
        if blob:
            return Blob(blob[1], int(blob[2]) if blob[2] else None)
        if text == "string":
            return Blob("string", self.max_body)
        announced = _ANNOUNCED.match(text)
        if announced:
            return Announced(snake_case(announced[1]))
        known = self.types.types
        named: dict[str, Type] = {**known.quantities, **known.enums, **known.packed}
        if text in named:
            return named[text]
        if text in self._nodes:
            if text in self._open:
                hint = "a struct has a fixed place for each field; write the inner ones out"
                self.found.add(at, "SBGC029", f"struct {text} contains itself", hint)
                return None
            return self.struct(text)
        words = [*SCALARS, "string", *named, *self._nodes]
        hint = type_advice(text) or did_you_mean(text, words)
        hint = hint or "built-in are u8 … f32, bytes[N], text[N] and string"
        self.found.add(at, "SBGC010", f"unknown type '{text}'", hint)
        return None

    # Fields

    def fields(
        self,
        nodes: list[Any],
        owner: str,
        contexts: tuple[Context, ...],
        in_struct: bool = False,
        include: Any = None,
        around: tuple[Field, ...] = (),
    ) -> tuple[Field, ...]:
        """Resolve one list of fields; `include(node)` supplies the fields of another message."""
        result: list[Field] = []
        reserved = 0
        offset: int | None = 0
        broken_before = len(self._broken)
        for node in nodes:
            if "include" in node:
                added = include(node) if include else []
            else:
                one = self._field(node, owner, contexts, [*around, *result], in_struct)
                added = [one] if one else []
            for field in added:
                if field.spec_name == "RESERVED" and field.reserved:
                    reserved += 1
                field = replace(field, offset=offset)
                size = None if field.is_variable else field.size
                offset = None if offset is None or size is None else offset + size
                result.append(field)
        if reserved > 1:
            result = _number_reserved(result)
        self._check_names(result, broken_before, owner)
        self._check_order(result, owner)
        return tuple(_mark_counters(result))

    def _with_typical(self, field: Field, node: Map) -> Field:
        if "typical" not in node:
            return field
        typical = self.examples.typical(field, node["typical"], node.at("typical"))
        return replace(field, typical=typical)

    def _field(
        self,
        node: Map,
        owner: str,
        contexts: tuple[Context, ...],
        earlier: list[Field],
        in_struct: bool,
    ) -> Field | None:
        shorthand = isinstance(node.get("reserved"), int) and not isinstance(node["reserved"], bool)
        text = "RESERVED" if shorthand else str(node.get("name", ""))
        at = node.at("reserved" if shorthand else "name")
        name = parse_field_name(text)
        if name is None:
            hint = "NAME, NAME[axis], NAME[6], NAME[COUNT], NAME[], NAME_{AXIS} or NAME{1..5}"
            self.found.add(at, "SBGC031", f"'{text}' is not a field name", hint)
            self._type(node, tuple(earlier))
            self._check_broken(node, at, text, owner)
            return None
        type_ = Blob("bytes", node["reserved"]) if shorthand else self._type(node, tuple(earlier))
        if type_ is None:
            identifier = str(node.get("as", snake_case(name.base)))
            self.types.identifier(identifier, at)
            self.examples.untyped.add(identifier)
            self._broken.append((name, at))
            self._check_broken(node, at, text, owner)
            return None
        is_reserved = shorthand or bool(node.get("reserved", False))
        dim, count, index, counter = self._dimension(name, at, earlier, in_struct)
        size = _size_of(type_)
        if isinstance(type_, Blob) and size is None and type_.kind != "string":
            dim = "rest"
        max_count = node.get("max_count")
        if dim == "fixed" and index and "min_count" in node:  # the first ones of those named
            dim, count, max_count = "rest", 0, count
        whole = None if size is None or dim in ("counted", "rest") else size * count
        when = self.condition(node, earlier, contexts)
        minimum, maximum, special = self._limits(node, type_, text)
        smallest = max(1, _min_size_of(type_))
        before = sum(f.size or 0 for f in earlier if not f.is_variable)
        capacity = max(0, (self.max_body - before) // smallest)
        field = Field(
            name=self.types.identifier(str(node.get("as", snake_case(name.base))), at),
            spec_name=name.spec_name,
            type=type_,
            dim=dim,
            count=count,
            index=index,
            counter=counter,
            is_counter=False,
            offset=None,
            size=whole,
            capacity=min(capacity, len(index)) if dim == "rest" and index else capacity,
            minimum=minimum,
            maximum=maximum,
            special=special,
            min_count=int(node.get("min_count", 0)),
            max_count=max_count,
            variable=self._variable(node, earlier),
            align=int(node.get("align", 1)),
            reserved=is_reserved,
            optional=False,
            when=when,
            alternative=self._alternative(node, earlier, in_struct),
            since=self.types.availability(node),
            deprecated=self.types.deprecation(node),
            summary="Reserved; kept as it is."
            if is_reserved and not node.get("summary")
            else self.types.summary(node, at, f"{text} of {owner}"),
            errata=self.types.errata(node),
            role=str(node.get("role", "")),
            at=at,
        )
        return self._with_typical(field, node)

    def _check_broken(self, node: Map, at: Position, text: str, owner: str) -> None:
        """What else is wrong with a field that has no name or type, whatever they should be."""
        self._limits(node, SCALARS["f32"], text)
        self.types.availability(node)
        self.types.deprecation(node)
        if not node.get("reserved"):
            self.types.summary(node, at, f"{text} of {owner}")
        self.types.errata(node)

    def _dimension(
        self, name: FieldName, at: Position, earlier: list[Field], in_struct: bool
    ) -> tuple[str, int, tuple[str, ...], str]:
        if name.expand is not None:
            if re.match(r"[0-9]", name.expand):
                first, last = parse_bits(name.expand)
                return "fixed", last - first + 1, tuple(str(n) for n in range(first, last + 1)), ""
            kind = name.expand.lower()
            if kind in self.indices:
                if in_struct:  # the name follows the index of whoever uses the struct
                    return "one", 1, (), ""
                return kind, len(self.indices[kind]), self.indices[kind], ""
            words = [i.upper() for i in self.indices]
            hint = did_you_mean(name.expand, words) or f"known: {', '.join(words)}"
            self.found.add(at, "SBGC025", f"unknown index '{{{name.expand}}}'", hint)
        if name.index is None:
            return "one", 1, (), ""
        if name.index == "":
            return "rest", 0, (), ""
        if name.index.isdigit():
            return "fixed", int(name.index), (), ""
        if name.index in self.indices:
            return name.index, len(self.indices[name.index]), self.indices[name.index], ""
        names = {f.spec_name: f for f in earlier}
        if name.index not in names:
            hint = did_you_mean(name.index, [*names, *self.indices])
            hint = hint or "a list is counted by a field before it"
            message = f"'{name.index}' is neither an index nor an earlier field"
            self.found.add(at, "SBGC025", message, hint)
            return "fixed", 1, (), ""
        return "counted", 0, (), names[name.index].name

    def _limits(
        self, node: Map, type_: Type, text: str
    ) -> tuple[Fraction | None, Fraction | None, tuple[Special, ...]]:
        at = node.at("range")
        special = self._special(node)
        minimum = maximum = None
        scalar = scalar_of(type_)
        if "range" in node:
            match = _RANGE.match(str(node["range"]))
            if match is None or scalar is None:
                hint = "write it like 0..100, for a number"
                self.found.add(at, "SBGC017", f"the range of {text} makes no sense", hint)
            else:
                minimum, maximum = Fraction(match[1]), Fraction(match[2])
                if minimum > maximum:
                    hint = f"write {match[2]}..{match[1]}"
                    self.found.add(at, "SBGC017", f"the range of {text} is upside down", hint)
                if not scalar.is_float and minimum.denominator * maximum.denominator != 1:
                    message = f"the range of {text} is not one of whole numbers"
                    self.found.add(at, "SBGC017", message, "the range is in raw wire values")
                if not scalar.is_float and not (_fits(scalar, minimum) and _fits(scalar, maximum)):
                    message = f"the range of {text} goes beyond {scalar.name}"
                    self.found.add(at, "SBGC017", message, "the range is in raw wire values")
        for entry in special:
            where = node["special"].at(str(entry.value)) if isinstance(node["special"], Map) else at
            if scalar is None or not _fits(scalar, Fraction(entry.value)):
                message = f"the special value {entry.value} of {text} does not fit its type"
                self.found.add(where, "SBGC017", message, "it is a raw wire value")
            elif minimum is not None and maximum is not None:
                if minimum <= entry.value <= maximum and not node.get("special_in_range"):
                    message = f"the special value {entry.value} of {text} lies inside its range"
                    hint = "narrow the range, or mark it with 'special_in_range: true'"
                    self.found.add(where, "SBGC018", message, hint)
        return minimum, maximum, special

    def _special(self, node: Map) -> tuple[Special, ...]:
        """The special values, which are texts, or mappings that give them a name in C++."""
        result = []
        for key, content in (node.get("special") or {}).items():
            if not isinstance(content, Map):
                result.append(Special(int(key), str(content), at=node["special"].at(key)))
                continue
            at = content.at("as")
            name = self.types.identifier(str(content["as"]), at)
            text = self.types.summary(content, content.position, f"the special value {key}")
            result.append(Special(int(key), text, name, at))
        return tuple(result)

    def _variable(self, node: Map, earlier: list[Field]) -> str:
        """The earlier field with the id of the adjustable variable that this is the value of."""
        wanted = str(node.get("variable", ""))
        for field in earlier:
            if wanted and field.spec_name == wanted and field.type == self._variable_ids:
                return field.name
        if wanted:
            message = f"'{wanted}' is not an earlier field of type {VARIABLE_ID}"
            self.found.add(node.at("variable"), "SBGC026", message)
        return ""

    def condition(
        self, node: Map, earlier: list[Field], contexts: tuple[Context, ...]
    ) -> Condition | None:
        """The `when` of a node, about a context or one of the `earlier` fields."""
        when = node.get("when")
        if not isinstance(when, Map):
            return None
        from_context = "context" in when
        key = "context" if from_context else "field"
        wanted = str(when.get(key))
        found: dict[str, tuple[str, Type, bool]] = (
            {c.name.upper(): (c.name, c.type, False) for c in contexts if c.type is not None}
            if from_context
            else {
                f.spec_name: (f.name, f.type, f.when is not None) for f in earlier if f.dim == "one"
            }
        )
        unknown = {c.name.upper() for c in contexts if c.type is None and c.announced is None}
        if from_context and wanted in unknown:
            return None  # its type is reported where it is named
        if wanted not in found:
            hint = did_you_mean(wanted, found) or f"known here: {', '.join(found) or 'none'}"
            self.found.add(when.at(key), "SBGC026", f"'{wanted}' is not an earlier {key}", hint)
            return None
        source, type_, conditional = found[wanted]
        if not isinstance(type_, Enum):
            message = f"'{wanted}' is neither an enum nor a flag set"
            self.found.add(when.at(key), "SBGC026", message, "a condition needs named values")
            return None
        word = "has" if type_.kind == "flags" else "is"
        if word not in when:
            message = f"'{wanted}' is {'a flag set' if word == 'has' else 'an enum'}"
            self.found.add(when.position, "SBGC026", message, f"use '{word}' for it")
            return None
        flags, values = (
            self._values(type_, when, word) if word in when else () for word in ("has", "is")
        )
        mask = 0
        for flag in flags:
            mask |= flag.value
        if flags and not mask:
            message = f"{flags[0].name} has no bits, so it is always set"
            self.found.add(when.at("has"), "SBGC026", message, "a condition needs bits to look at")
        missing = bool(when.get("may_be_missing", False))
        return Condition(source, from_context, mask, values, flags, type_, missing, conditional)

    def _values(self, enum: Enum, node: Map, key: str) -> tuple[Any, ...]:
        names = node[key] if isinstance(node[key], list) else [node[key]]
        by_name = {v.name: v for v in enum.values}
        for name in names:
            if name not in by_name:
                hint = did_you_mean(str(name), by_name) or f"see {enum.at}"
                self.found.add(node.at(key), "SBGC026", f"{enum.name} has no value '{name}'", hint)
        return tuple(by_name[n] for n in names if n in by_name)

    def _alternative(self, node: Map, earlier: list[Field], in_struct: bool) -> Alternative | None:
        other = node.get("alternative")
        if not isinstance(other, Map):
            return None
        quantity = self.types.types.quantities.get(str(other["type"]))
        if quantity is None:
            hint = did_you_mean(str(other["type"]), self.types.types.quantities)
            hint = hint or "name one under 'quantities'"
            self.found.add(other.at("type"), "SBGC010", f"unknown quantity '{other['type']}'", hint)
            return None
        for enum in self.types.types.enums.values():
            for value in enum.values if enum.kind == "flags" else ():
                if value.name == other["flag"]:
                    return Alternative(quantity, snake_case(str(other["of"])), value.value, value)
        flags = [v.name for e in self.types.types.enums.values() for v in e.values]
        hint = did_you_mean(str(other["flag"]), flags) or "name a value of a flag set"
        self.found.add(other.at("flag"), "SBGC026", f"there is no flag '{other['flag']}'", hint)
        return None

    # Checks

    def _check_names(self, fields: list[Field], broken_before: int, owner: str) -> None:
        names = [(field.name, field.at) for field in fields]
        names += [(snake_case(name.base), at) for name, at in self._broken[broken_before:]]
        seen: dict[str, Position] = {}
        for name, at in sorted(names, key=lambda entry: entry[1]) if self._broken else names:
            first = seen.setdefault(name, at)
            if first is not at:
                message = f"duplicate field name '{name}' in {owner} (first at {first})"
                self.found.add(at, "SBGC012", message, "give one of them a name with 'as'")

    def _check_order(self, fields: list[Field], owner: str) -> None:
        for field, following in zip(fields, fields[1:]):
            if field.dim == "rest":
                message = f"'{field.name}' of {owner} takes the rest of the body but is not last"
                self.found.add(following.at, "SBGC027", message, "move it to the end")


def _inline_structs(spec: Spec) -> Iterator[tuple[str, Map]]:
    def walk(node: Any) -> Iterator[Map]:
        if isinstance(node, Map):
            if "struct" in node and "fields" in node:
                yield node
            for value in node.values():
                yield from walk(value)
        elif isinstance(node, list):
            for value in node:
                yield from walk(value)

    for family, content in spec.families.items():
        for node in walk(content):
            yield family, node


def _fits(scalar: Scalar, value: Fraction) -> bool:
    if scalar.minimum is None or scalar.maximum is None:
        return True
    return scalar.minimum <= value <= scalar.maximum


def _number_reserved(fields: list[Field]) -> list[Field]:
    result = []
    number = 0
    for field in fields:
        if field.reserved and field.spec_name == "RESERVED":
            number += 1
            field = replace(field, name=f"reserved_{number}")
        result.append(field)
    return result


def _mark_counters(fields: list[Field]) -> list[Field]:
    counters = {f.counter for f in fields if f.counter}
    return [replace(f, is_counter=True) if f.name in counters else f for f in fields]


def announceable_types(announcement: Announcement, fields: tuple[Field, ...]) -> tuple[str, ...]:
    """The types that a message can announce; none if it does not have what announces them."""

    def find(name: str, members: tuple[Field, ...], dim: str) -> Type | None:
        return next((f.type for f in members if (f.name, f.dim, f.when) == (name, dim, None)), None)

    element = find(announcement.list, fields, "counted")
    if not isinstance(element, Struct):
        return ()
    member, _, part = announcement.kind.partition(".")
    count = find(announcement.count, element.fields, "one")
    kind = find(member, element.fields, "one")
    if isinstance(kind, Packed):
        kind = next((p.enum for p in kind.parts if p.name == part), None)
    elif part:
        return ()
    counts = isinstance(count, Scalar) and count.minimum == 0
    return tuple(v.wire for v in kind.values if v.wire) if counts and isinstance(kind, Enum) else ()


def total_size(fields: tuple[Field, ...]) -> int | None:
    """Size of a list of fields in bytes, None if it varies."""
    total = 0
    for field in fields:
        if field.is_variable or field.size is None:
            return None
        total += field.size
    return total


def min_size(fields: tuple[Field, ...]) -> int:
    """The fewest bytes that a list of fields takes."""
    return sum(_min_field(field) for field in fields if field.when is None)


def _min_field(field: Field) -> int:
    if field.dim in ("counted", "rest"):
        return field.min_count * (_size_of(field.type) or 1)
    return _min_size_of(field.type) * field.count


def max_size(fields: tuple[Field, ...], limit: int) -> int:
    """The most bytes that the specification describes, at most `limit`."""
    total = 0
    by_name = {field.name: field for field in fields}
    for field in fields:
        if field.dim in ("counted", "rest"):
            count = field.max_count
            if field.counter and by_name[field.counter].maximum is not None:
                maximum = by_name[field.counter].maximum
                assert maximum is not None
                count = int(maximum)
            if count is None:
                return limit
            total += count * (_size_of(field.type) or 1)
        elif field.size is None:
            return limit
        else:
            total += field.size
    return min(total, limit)


def expand_name(spec_name: str, word: str) -> str:
    """SPEED_{AXIS} with ROLL -> SPEED_ROLL."""
    return re.sub(r"\{[^}]*\}", word, spec_name)


def leaves(
    fields: tuple[Field, ...], path: str = "", base: int | None = 0, word: str = ""
) -> Iterator[Leaf]:
    """The leaves of a list of fields in wire order, every index written out."""
    for field in fields:
        offset = None if base is None or field.offset is None else base + field.offset
        yield from _field_leaves(field, path + field.name, offset, word)


def _field_leaves(field: Field, path: str, offset: int | None, word: str) -> Iterator[Leaf]:
    element = _size_of(field.type)

    def one(path: str, offset: int | None, word: str, count: int | None) -> Iterator[Leaf]:
        if isinstance(field.type, Struct) and field.type.is_region:
            cases = tuple(leaves(field.type.fields[:-1], f"{path}.", None, word))
            cases = tuple(replace(case, offset=offset) for case in cases)
            yield Leaf(path, field, field.spec_name, "bytes", field.type.size, offset, cases)
            return
        if isinstance(field.type, Struct):
            yield from leaves(field.type.fields, f"{path}.", offset, word)
            return
        scalar = scalar_of(field.type)
        if isinstance(field.type, Announced):
            yield Leaf(path, field, field.spec_name, "bytes", None, offset)
            return
        if isinstance(field.type, Blob):
            name, amount = field.type.kind, field.type.size if field.type.kind != "string" else None
        else:
            assert scalar is not None
            name, amount = scalar.name, count
        yield Leaf(path, field, expand_name(field.spec_name, word), name, amount, offset)

    def step(i: int) -> int | None:
        return None if offset is None or element is None else offset + i * element

    if field.dim in ("counted", "rest") and not field.index:
        suffix = "[]" if isinstance(field.type, Struct) else ""
        for leaf in one(path + suffix, offset, word, None):
            yield replace(leaf, count=None)
    elif field.dim in ("fixed", "rest"):
        if not field.index and not isinstance(field.type, (Struct, Blob)):
            yield from one(path, offset, word, field.count)
            return
        for i in range(len(field.index) or field.count):
            inner = field.index[i] if field.index else word
            may_be_missing = field.dim == "rest" and i >= field.min_count
            for leaf in one(f"{path}[{i}]", step(i), inner, 1):
                yield replace(leaf, optional=may_be_missing)
    elif field.dim == "one":
        yield from one(path, offset, word, 1)
    else:
        for i, inner in enumerate(field.index):
            yield from one(f"{path}.{inner.lower()}", step(i), inner, 1)
