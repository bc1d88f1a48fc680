"""Resolves lists of fields (types, dimensions, offsets) and structs."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

from sbgcgen.model import SCALARS, Announced, Availability, Blob, Context, Enum, Field, FieldRule
from sbgcgen.model import Packed, Part, Position, Quantity, Scalar, Struct, Type, scalar_of
from sbgcgen.model.names import FieldName, parse_field_name, snake_case, type_advice
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map, Spec
from sbgcgen.spec.resolve.axis_directions import DirectionResolver, axis_directions_of
from sbgcgen.spec.resolve.sizes import grown, min_size, min_size_of, offsets_in_union, size_of
from sbgcgen.spec.resolve.sizes import total_size
from sbgcgen.spec.resolve.examples import ExampleReader
from sbgcgen.spec.resolve.limits import LaterResolver, LimitResolver
from sbgcgen.spec.resolve.references import Outside, ReferenceResolver
from sbgcgen.spec.resolve.types import TypeResolver, parse_bits

_BLOB = re.compile(r"(bytes|text(?=\[[0-9]))\[([1-9][0-9]{0,5})?\]$")
_STRING = re.compile(r"string\[([1-9][0-9]{0,2})\]$")
_ANNOUNCED = re.compile(r"announced\(([A-Z][A-Z0-9_]*)\)$")


class FieldResolver:
    """Resolves lists of fields; structs are resolved on first use."""

    def __init__(self, spec: Spec, types: TypeResolver, found: Diagnostics, max_body: int) -> None:
        self.spec = spec
        self.types = types
        self.found = found
        self.max_body = max_body
        self.examples = ExampleReader(found, types.broken)
        self.structs: dict[str, Struct] = {}
        self.references = ReferenceResolver(types, found)
        self.limits = LimitResolver(types, found)
        self.later = LaterResolver(types, self.limits, found)
        self.indices: dict[str, tuple[str, ...]] = {
            name: tuple(words) for name, words in spec.main.get("indices", {}).items()
        }
        axes = [word for words in self.indices.values() for word in words]
        directions = axis_directions_of(spec.main.get("directions", Map()), axes, types, found)
        self.directions = DirectionResolver(directions, found)
        self._nodes = {
            name: (family, node, at) for family, name, node, at in spec.entries("structs")
        }
        nodes = ((family, node) for family, all_ in spec.maps.items() for node in all_)
        for family, node in nodes:
            if "struct" not in node or "fields" not in node:
                continue
            name = str(node["struct"])
            if name in self._nodes:
                first = self._nodes[name][2]
                message = f"'{name}' is defined twice (first at {first})"
                self.found.add(node.at("struct"), "SBGC028", message, "refer to it with 'type'")
            if name in (*types.types.quantities, *types.types.enums, *types.types.packed):
                hint = "all types share one namespace"
                message = f"'{name}' is the name of another type"
                self.found.add(node.at("struct"), "SBGC028", message, hint)
            self._nodes.setdefault(name, (family, node, node.at("struct")))
        self._open: list[str] = []
        self._outside = Outside()
        self._broken: list[tuple[FieldName, Position]] = []  # fields of unknown types

    # Structs and types

    def struct(
        self, name: str, around: tuple[Field, ...] = (), words: tuple[str, ...] = ()
    ) -> Struct:
        """The resolved struct with this name.

        A tagged union, or a group with an element for each of the `words` of an index, may refer to
        surrounding fields (`around`).
        """
        if name not in self.structs:
            family, node, at = self._nodes[name]
            is_region = "size" in node
            self._open.append(name)
            outer = around if is_region else ()
            outside, self._outside = self._outside, Outside(() if is_region else around, words)
            fields = self.fields(node["fields"], name, (), in_struct=True, around=outer)
            self._outside = outside
            self._open.pop()
            if is_region:
                fields = (*offsets_in_union(fields), self._region_rest(node, fields))
            size = node["size"] if is_region else total_size(fields)
            self.structs[name] = Struct(
                name=self.types.identifier(name, at),
                summary=self.types.summary(node, at, name),
                fields=fields,
                size=size,
                min_size=size if size is not None else min_size(fields),
                family=family,
                is_region=is_region,
                rules=self.rules(node, fields),
                at=at,
            )
        return self.structs[name]

    def grown(self, struct: Struct, since: Availability) -> Struct:
        """The struct of a list's elements with all their historical sizes; see sizes.py."""
        result = grown(struct, since)
        known = self.structs[struct.name]
        self.structs[struct.name] = known if known == result else result
        return self.structs[struct.name]

    def rules(self, node: Map, fields: tuple[Field, ...]) -> tuple[FieldRule, ...]:
        """The rules across fields of a struct or message."""
        by_name = {f.spec_name: f for f in fields}
        result = []
        for text, at in node.listed("rules"):
            low, sign, high = str(text).split()
            unknown = [name for name in (low, high) if name not in by_name]
            for name in unknown:
                hint = did_you_mean(name, by_name) or "name two fields at the same level"
                self.found.add(at, "SBGC026", f"'{name}' is not a field here", hint)
            if unknown:
                continue
            first, second = by_name[low], by_name[high]
            is_number = isinstance(first.type, (Scalar, Quantity))
            one, other = ((f.type, f.dim, f.count) for f in (first, second))
            if first is second or not is_number or one != other:
                hint = "a rule is about two fields that hold numbers of the same type, equally many"
                self.found.add(at, "SBGC026", f"'{low}' and '{high}' cannot be compared", hint)
                continue
            result.append(FieldRule(first.name, second.name, sign == "<", at))
        return tuple(result)

    def all_structs(self) -> list[Struct]:
        """All structs, including those not used so far."""
        for name in self._nodes:
            self.struct(name)
        return list(self.structs.values())

    def _region_rest(self, node: Map, fields: tuple[Field, ...]) -> Field:
        """The member with the bytes of a tagged union that its conditional fields do not use."""
        size = int(node["size"])
        for field in fields:
            if field.when is None or (field.size or size + 1) > size:
                message = f"'{field.name}' is not a conditional field of at most {size} bytes"
                hint = "give it a 'when', or increase the size of the tagged union"
                self.found.add(field.at, "SBGC033", message, hint)
        return Field(
            name="rest",
            spec_name="",
            type=Blob("bytes", None),
            dim="rest",
            offset=None,
            size=None,
            capacity=size,
            summary=f"What is not used of the {size} bytes; filled up with zeros.",
            reserved=True,
            optional=True,
            at=node.position,
        )

    def _type(self, node: Map, around: tuple[Field, ...], name: FieldName | None) -> Type | None:
        if "fields" in node:
            kind = (name.expand or name.index or "").lower() if name else ""
            return self.struct(str(node["struct"]), around, self.indices.get(kind, ()))
        text = str(node.get("type", ""))
        at = node.at("type")
        if text in SCALARS:
            return SCALARS[text]
        blob = _BLOB.match(text)
        if blob:
            return Blob(blob[1], int(blob[2]) if blob[2] else None)
        if text == "string":
            return Blob("string", self.max_body)
        string = _STRING.match(text)
        if string:
            longest = SCALARS["u8"].maximum or 0
            if int(string[1]) > longest:
                hint = f"its length is a u8: write string[{longest}] or less"
                self.found.add(at, "SBGC042", f"'{text}' is longer than a length can say", hint)
            return Blob("string", min(int(string[1]), self.max_body))
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
            struct = self.struct(text)
            if struct.looks_outside:
                message = f"{text} depends on fields outside, so it has one place"
                self.found.add(at, "SBGC033", message, "write its fields out again")
            return struct
        words = [*SCALARS, "string", *named, *self._nodes]
        hint = type_advice(text) or did_you_mean(text, words)
        hint = hint or "built-in types: u8 … f64, bytes[N], text[N], string and string[N]"
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
        """Resolve a list of fields; `include(node)` returns the fields of another message."""
        result: list[Field] = []
        reserved: list[int] = []  # the places of unnamed bytes
        offset: int | None = 0
        broken_before = len(self._broken)
        for node in nodes:
            if "include" in node:
                added = include(node) if include else []
            else:
                one = self._field(node, owner, contexts, [*around, *result], in_struct, offset)
                added = [one] if one else []
            for field in added:
                if field.spec_name == "RESERVED" and field.reserved:
                    reserved.append(len(result))
                if field.offset != offset:
                    field = replace(field, offset=offset)
                size = None if field.is_variable else field.size
                offset = None if offset is None or size is None else offset + size
                result.append(field)
        for number, at in enumerate(reserved if len(reserved) > 1 else (), 1):
            result[at] = replace(result[at], name=f"reserved_{number}")
        self._check_names(result, broken_before, owner)
        self._check_former_names(result, owner)
        for field, following in zip(result, result[1:]):
            if field.dim == "rest":
                message = f"'{field.name}' of {owner} takes the rest of the body but is not last"
                self.found.add(following.at, "SBGC027", message, "move it to the end")
        counters = {f.counter for f in result if f.has_hidden_counter}
        return tuple(replace(f, is_counter=True) if f.name in counters else f for f in result)

    def _field(
        self,
        node: Map,
        owner: str,
        contexts: tuple[Context, ...],
        earlier: list[Field],
        in_struct: bool,
        offset: int | None,
    ) -> Field | None:
        shorthand = isinstance(node.get("reserved"), int) and not isinstance(node["reserved"], bool)
        text = "RESERVED" if shorthand else str(node.get("name", ""))
        at = node.at("reserved" if shorthand else "name")
        name = parse_field_name(text)
        type_: Type | None = Blob("bytes", node["reserved"]) if shorthand else None
        type_ = type_ or self._type(node, tuple(earlier), name)
        if name is None or type_ is None:
            self._broken_field(name, node, at, text, owner)
            return None
        extent = self._extent(name, type_, node, at, earlier, in_struct)
        minimum, maximum, special = self.limits.limits(node, type_, text)
        directions, axis = self.directions.direction(node, type_, name.base, extent["index"])
        is_reserved = shorthand or bool(node.get("reserved", False))
        field = Field(
            name=self.types.identifier(str(node.get("as", snake_case(name.base))), at),
            spec_name=name.spec_name,
            type=type_,
            offset=offset,
            minimum=minimum,
            maximum=maximum,
            special=special,
            variable=self.references.variable(node, earlier),
            align=int(node.get("align", 1)),
            reserved=is_reserved,
            when=self.references.condition(node, earlier, contexts, self._outside),
            used_when=self.references.use(node, earlier, extent["index"]),
            alternative=self.references.alternative(node, earlier if in_struct else []),
            since=self.types.availability(node),
            deprecated=self.types.deprecation(node),
            summary="Reserved; kept as it is."
            if is_reserved and not node.get("summary")
            else self.types.summary(node, at, f"{text} of {owner}"),
            errata=self.types.errata(node),
            role=str(node.get("role", "")),
            default=self._default(node, type_, text),
            constant="constant" in node,
            fits="fits" in node,
            needs=self.types.needs(node),
            secret="secret" in node,
            saved_as=node.get("saved_as", ""),
            saved_in=str(node.get("saved_in", "")),
            aliases=self.types.aliases(node),
            unconfirmed=bool(node.get("unconfirmed", False)),
            directions=directions,
            axis=axis,
            at=at,
            **extent,
        )
        self._check_default(field, node, text)
        if "used_when" in node and (in_struct or field.may_be_absent):
            hint = "it is for a field of a message that is always present"
            message = f"'{field.name}' cannot have 'used_when'"
            self.found.add(node.at("used_when"), "SBGC026", message, hint)
        if field.constant:
            value = Fraction(field.default)
            field = replace(field, minimum=value, maximum=value)
        field = replace(field, later=self.later.later(node, field))
        if "typical" in node:
            typical = self.examples.typical(field, node["typical"], node.at("typical"))
            field = replace(field, typical=typical)
        return field

    def _broken_field(
        self, name: FieldName | None, node: Map, at: Position, text: str, owner: str
    ) -> None:
        """Check the rest of a field without a valid name or type."""
        if name is None:
            hint = "NAME, NAME[axis], NAME[6], NAME[COUNT], NAME[], NAME_{AXIS} or NAME{1..5}"
            self.found.add(at, "SBGC031", f"'{text}' is not a field name", hint)
        else:
            identifier = str(node.get("as", snake_case(name.base)))
            self.types.identifier(identifier, at)
            self.examples.untyped.add(identifier)
            self._broken.append((name, at))
        self.limits.limits(node, SCALARS["f32"], text)
        self.types.availability(node)
        self.types.deprecation(node)
        if not node.get("reserved"):
            self.types.summary(node, at, f"{text} of {owner}")
        self.types.errata(node)

    def _extent(
        self,
        name: FieldName,
        type_: Type,
        node: Map,
        at: Position,
        earlier: list[Field],
        in_struct: bool,
    ) -> dict[str, Any]:
        """The numbers of elements and bytes of a field, as members of Field."""
        dim, count, index, counter = self._dimension(name, at, earlier, in_struct)
        by = next((f for f in earlier if f.name == counter), None)
        part = _counter_part(by, str(name.index))
        counting = self._counting(node, counter, earlier)
        if part is not None and counting == "bytes":
            hint = "only a field of its own counts bytes"
            self.found.add(at, "SBGC043", f"'{part.name}' is a part of a packed value", hint)
        size, max_count = size_of(type_), node.get("max_count")
        if isinstance(type_, Blob) and size is None and type_.kind != "string":
            dim = "rest"
        if dim == "fixed" and index and "min_count" in node:  # a variable number of named elements
            dim, count, max_count = "rest", 0, count
        capacity = self.capacity(type_, earlier, counting, counter, part)
        return {
            "dim": dim,
            "count": count,
            "index": index,
            "counter": counter,
            "counter_part": part,
            "counting": counting,
            "size": None if size is None or dim in ("counted", "rest") else size * count,
            "capacity": min(capacity, len(index)) if dim == "rest" and index else capacity,
            "min_count": int(node.get("min_count", counting == "minus_1")),
            "max_count": max_count,
        }

    def capacity(
        self,
        type_: Type,
        earlier: Sequence[Field],
        counting: str,
        counter: str,
        part: Part | None,
    ) -> int:
        """The maximum number of elements that fit into a body after the preceding fields."""
        most = self.room(earlier) // max(1, min_size_of(type_))
        if counting == "bits":
            flags = next(f.type for f in earlier if f.name == counter)
            most = min(most, 8 * (size_of(flags) or 0))
        if part is not None:
            most = min(most, part.limits[1] + (counting == "minus_1"))
        return most

    def room(self, earlier: Sequence[Field]) -> int:
        """The maximum number of bytes that remain in a body after these fields."""
        return max(0, self.max_body - sum(f.size or 0 for f in earlier if not f.is_variable))

    def _default(self, node: Map, type_: Type, text: str) -> int:
        """The raw value in a new message."""
        key = "constant" if "constant" in node else "default"
        if key not in node:
            return 0
        for other in ("default", "range", "special") if key == "constant" else ():
            if other in node:
                hint = f"no other value is valid: delete '{other}'"
                self.found.add(node.at(other), "SBGC017", f"{text} has a constant", hint)
        at = node.at(key)
        scalar = scalar_of(type_)
        said = node[key] if isinstance(node[key], list) else [node[key]]
        known = {v.name: v.value for v in type_.values} if isinstance(type_, Enum) else {}
        is_flags = isinstance(type_, Enum) and type_.kind == "flags"
        unknown = [name for name in said if not isinstance(name, int) and name not in known]
        if scalar is None or scalar.is_float or (len(said) > 1 and not is_flags):
            hint = "only an integer, an enum or a flag set has one; several names are flags"
            self.found.add(at, "SBGC017", f"the {key} of {text} is not a value of its type", hint)
            return 0
        if unknown:
            hint = did_you_mean(str(unknown[0]), known)
            hint = hint or ("name one of its values" if known else "give a raw integer")
            message = f"the {key} of {text} is not a value: '{unknown[0]}'"
            self.found.add(at, "SBGC017", message, hint)
            return 0
        value = sum(known.get(name, name) for name in dict.fromkeys(said))
        if not scalar.holds(value):
            hint = f"its type is {scalar.name}: {scalar.minimum} to {scalar.maximum}"
            self.found.add(at, "SBGC017", f"{text} cannot be {value}", hint)
        elif known and not is_flags and value not in known.values():
            hint = f"{getattr(type_, 'name')} has no such value; name one of its values"
            self.found.add(at, "SBGC017", f"the {key} of {text} has no name: {value}", hint)
        return value

    def _check_default(self, field: Field, node: Map, text: str) -> None:
        """A new message must be valid."""
        low, high = field.minimum, field.maximum
        if "default" not in node or low is None or high is None:
            return
        is_special = any(special.value == field.default for special in field.special)
        if not low <= field.default <= high and not is_special:
            hint = f"its range is {node.get('range')}"
            at = node.at("default")
            self.found.add(at, "SBGC017", f"the default of {text} is out of range", hint)

    def _counting(self, node: Map, counter: str, earlier: list[Field]) -> str:
        """The counting method of a list's counter."""
        words = [key for key in ("counted_in", "counted_from") if key in node]
        by_name = {f.name: f for f in earlier}
        type_ = by_name[counter].type if counter in by_name else None
        is_flags = isinstance(type_, Enum) and type_.kind == "flags"
        if words and (not counter or is_flags or len(words) > 1):
            text = f"'{words[-1]}' is not possible here"
            hint = "it is for a list with a number as its counter: NAME[COUNT]"
            self.found.add(node.at(words[-1]), "SBGC043", text, hint)
        if is_flags:
            return "bits"
        if not words:
            return "elements"
        return "bytes" if words[0] == "counted_in" else "minus_1"

    def _dimension(
        self, name: FieldName, at: Position, earlier: list[Field], in_struct: bool
    ) -> tuple[str, int, tuple[str, ...], str]:
        if name.expand is not None:
            if re.match(r"[0-9]", name.expand):
                first, last = parse_bits(name.expand)
                return "fixed", last - first + 1, tuple(str(n) for n in range(first, last + 1)), ""
            kind = name.expand.lower()
            if kind in self.indices:
                if in_struct:  # the index is that of the field that has the struct's type
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
        whole, _, part = name.index.partition(".")
        if part and whole in names and _counter_part(names[whole], name.index) is None:
            packed = names[whole].type
            parts = [p.name for p in packed.parts] if isinstance(packed, Packed) else []
            hint = did_you_mean(part, parts) or "a part is that of a packed value"
            self.found.add(at, "SBGC025", f"'{whole}' has no part '{part}'", hint)
            return "fixed", 1, (), ""
        if whole not in names:
            hint = did_you_mean(whole, [*names, *self.indices])
            hint = hint or "a list is counted by a field before it"
            message = f"'{name.index}' is neither an index nor an earlier field"
            self.found.add(at, "SBGC025", message, hint)
            return "fixed", 1, (), ""
        return "counted", 0, (), names[whole].name

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

    def _check_former_names(self, fields: list[Field], owner: str) -> None:
        taken = {field.name: f"the name of '{field.name}'" for field in fields}
        for field in fields:
            for alias in field.aliases:
                if alias.name in taken:
                    message = f"the former name '{alias.spec_name}' of '{field.name}' in {owner}"
                    hint = "a former name belongs to one field, which now has another"
                    text = f"{message} is {taken[alias.name]}"
                    self.found.add(alias.at, "SBGC012", text, hint)
                taken.setdefault(alias.name, f"a former name of '{field.name}'")


def _counter_part(counter: Field | None, index: str) -> Part | None:
    """The part of a packed counter that NAME[COUNTER.part] refers to."""
    wanted = index.partition(".")[2]
    if counter is None or not isinstance(counter.type, Packed):
        return None
    return next((part for part in counter.type.parts if part.name == wanted), None)
