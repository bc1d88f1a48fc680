"""Resolves the named types of the spec: quantities, enums, flags and packed integers."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import log
from typing import Any

from sbgcgen.model import COMMAND_IDS, SCALARS, Enum, EnumValue, Former, Packed, Part, Position
from sbgcgen.model import Quantity, Scalar
from sbgcgen.model.names import singular, snake_case
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map, Spec, directions_of
from sbgcgen.spec.resolve.entries import Entries

# An enum derived from the section `variables`, as COMMAND_IDS are from `commands`.
VARIABLE_ID = "VariableId"


@dataclass
class Types:
    """The named types that `type:` can refer to, except structs."""

    quantities: dict[str, Quantity] = field(default_factory=dict)
    enums: dict[str, Enum] = field(default_factory=dict)
    packed: dict[str, Packed] = field(default_factory=dict)


class TypeResolver(Entries):
    """Resolves the type sections of a spec; findings go into `found`."""

    def __init__(self, spec: Spec, found: Diagnostics) -> None:
        super().__init__(spec, found)
        self.types = Types()
        self.broken: set[str] = set()  # packed integers with an unknown enum

    def run(self) -> Types:
        for _, name, value, at in self.spec.entries("quantities"):
            self.types.quantities[name] = self._quantity(name, value, at)
        self._read_versions()
        for direction, enum in COMMAND_IDS.items():
            self.types.enums[enum] = self._command_ids(direction)
        self.types.enums[VARIABLE_ID] = self._variable_ids()
        for section, kind in (("enums", "enum"), ("flags", "flags")):
            entries = {name: (value, at) for _, name, value, at in self.spec.entries(section)}
            for name, (value, at) in entries.items():
                values = self._enum_values(name, entries, ())
                self.types.enums[name] = self._enum(name, value, at, kind, values)
        for _, name, value, at in self.spec.entries("packed"):
            if name not in self.types.packed:
                self.types.packed[name] = self._packed(name, value, at)
        self._check_unique_names()
        return self.types

    def _read_versions(self) -> None:
        """Resolve the packed integers of versions first: any other entry may have a version."""
        names = []
        for _, name, value, at in self.spec.entries("packed"):
            names.append(name)
            has_enums = "names" in value or any("type" in part for part in value["parts"])
            if name in self.versions.names and not has_enums:
                self.types.packed[name] = self._packed(name, value, at)
        self.versions.use(self.types.packed, names)

    def _quantity(self, name: str, node: Map, at: Position) -> Quantity:
        accessor = str(node.get("accessor", "value"))
        self.identifier(name, at)
        self.identifier(accessor, node.at("accessor"))
        scale = Fraction(str(node.get("scale", 1)))
        offset = Fraction(str(node.get("offset", 0)))
        for key, number in (("scale", scale), ("offset", offset)):
            if max(abs(number.numerator), number.denominator) >= 1 << 63:
                message = f"the {key} of {name} is not a fraction of two 64-bit integers"
                self.found.add(node.at(key), "SBGC017", message, "give it with fewer digits")
        if scale <= 0:
            message = f"the scale of {name} is not positive"
            hint = "the real value is raw * scale + offset"
            self.found.add(node.at("scale"), "SBGC017", message, hint)
            scale = Fraction(1)
        ratio, over = self._exponential(name, node)
        if "directed" in node and SCALARS[node["type"]].minimum == 0:
            message = f"{name} counts in a direction, but has no sign"
            self.found.add(node.at("directed"), "SBGC072", message, "use a type with a sign")
        return Quantity(
            name=name,
            scalar=SCALARS[node["type"]],
            unit=node.get("unit"),
            accessor=accessor,
            scale=scale,
            scale_text=str(node.get("scale", 1)),
            offset=offset,
            summary=self.summary(node, at, name),
            errata=self.errata(node),
            is_directed=bool(node.get("directed", False)),
            at=at,
            ratio=ratio,
            over=over,
        )

    def _exponential(self, name: str, node: Map) -> tuple[Fraction, int]:
        """The ratio of an exponential quantity, or 0, and the number of raw steps for one ratio."""
        if "exponential" not in node:
            return Fraction(0), 1
        said = node["exponential"]
        ratio, over = Fraction(str(said["ratio"])), int(said["over"])
        scalar = SCALARS[node["type"]]
        problem = ""
        if scalar.is_float or scalar.size > 2:
            problem, hint = f"is of type {scalar.name}", "it is an integer of one or two bytes"
        elif ratio <= 1:
            problem, hint = "does not grow", "the ratio is above 1"
        elif log(ratio) * (scalar.maximum or 0) / over > log(1e9):
            problem, hint = "grows beyond 1e9", "say over how many raw values it grows by the ratio"
        if problem:
            text = f"{name} is exponential, but {problem}"
            self.found.add(node.at("exponential"), "SBGC017", text, hint)
            return Fraction(0), 1
        return ratio, over

    def _command_ids(self, direction: str) -> Enum:
        """The command ids of one direction; in the other one they may be other commands."""
        values = []
        prefix = self.spec.command_prefix
        for _, name, value, at in self.spec.entries("commands"):
            if value["id"] is None or direction not in directions_of(value):
                continue
            usual = snake_case(name.removeprefix(prefix))
            identifier = self.identifier(str(value.get("as", usual)), at)
            summary, aliases = str(value.get("summary", "")), self.aliases(value, prefix)
            values.append(EnumValue(name, identifier, value["id"], summary, at=at, aliases=aliases))
        way = "to" if direction == "to_board" else "from"
        summary = f"The commands of messages {way} the board."
        source = "Command ID definitions L75-L154"
        return _enum_of_ids(COMMAND_IDS[direction], summary, source, values)

    def _variable_ids(self) -> Enum:
        values = []
        for _, name, value, at in self.spec.entries("variables"):
            identifier = self.identifier(snake_case(name), at)
            entry = EnumValue(name, identifier, value["id"], str(value.get("summary", "")), at=at)
            unconfirmed = bool(value.get("unconfirmed", False))
            since = self.availability(value)
            values.append(replace(entry, since=since, unconfirmed=unconfirmed))
        source = "Appendix B L1274-L1329"
        return _enum_of_ids(VARIABLE_ID, "The adjustable variables.", source, values)

    def _enum_values(
        self, name: str, entries: dict[str, tuple[Map, Position]], on_the_way: tuple[str, ...]
    ) -> list[EnumValue]:
        """The values of an enum or flag set, after those of the one that it extends."""
        node, _ = entries[name]
        values = []
        base = str(node.get("extends", ""))
        if base and base not in entries:
            hint = did_you_mean(base, entries) or "name one of the same section"
            self.found.add(node.at("extends"), "SBGC010", f"there is no '{base}' to extend", hint)
        elif base in (name, *on_the_way):
            hint = "one of them must not extend another"
            self.found.add(node.at("extends"), "SBGC029", f"{name} extends itself", hint)
        elif base:
            values = self._enum_values(base, entries, (name, *on_the_way))
        return values + [
            self._enum_value(k, content, node) for k, content in node["values"].items()
        ]

    def _enum(self, name: str, node: Map, at: Position, kind: str, values: list[EnumValue]) -> Enum:
        scalar = SCALARS[node["type"]]
        self.identifier(name, at)
        self._check_values(name, kind, scalar, values)
        self._check_former(name, values)
        return Enum(
            name=name,
            member=singular(name) if kind == "flags" else name,
            scalar=scalar,
            kind=kind,
            summary=self.summary(node, at, name),
            source=self.source(node, at, name),
            errata=self.errata(node),
            values=tuple(values),
            at=at,
            success=self._success(name, node, values),
            are_errors=bool(node.get("errors") or node.get("success")),
        )

    def _success(self, name: str, node: Map, values: list[EnumValue]) -> EnumValue | None:
        by_name = {value.name: value for value in values}
        wanted = str(node.get("success", ""))
        if wanted and wanted not in by_name:
            hint = did_you_mean(wanted, by_name) or "name one of the values below"
            self.found.add(node.at("success"), "SBGC026", f"{name} has no value '{wanted}'", hint)
        return by_name.get(wanted)

    def _enum_value(self, key: str, content: Map, parent: Map) -> EnumValue:
        at = parent["values"].at(key)
        prefix = str(parent.get("prefix", ""))
        identifier = str(content.get("as", snake_case(key.removeprefix(prefix))))
        return EnumValue(
            name=key,
            identifier=self.identifier(identifier, at),
            value=content["value"],
            summary=self.summary(content, at, key),
            ours=bool(content.get("ours", False)),
            wire=str(content.get("wire", "")),
            since=self.availability(content),
            errata=self.errata(content),
            at=at,
            number=content.get("number"),
            aliases=self.aliases(content, prefix),
            unconfirmed=bool(content.get("unconfirmed", False)),
            former=self._former(content),
            needs=self.needs(content),
            saved_as=str(content.get("saved_as", "")),
        )

    def _former(self, content: Map) -> Former | None:
        """The earlier meanings of the value."""
        before = content.get("before")
        if not isinstance(before, Map):
            return None
        summary = self.summary(before, before.position, "the former meaning")
        return Former(self.availability(content, "before"), summary)

    def _check_values(self, name: str, kind: str, scalar: Scalar, values: list[EnumValue]) -> None:
        assert scalar.minimum is not None and scalar.maximum is not None
        by_value: dict[int, EnumValue] = {}
        by_identifier: dict[str, EnumValue] = {}
        used = 0
        for value in values:
            if not scalar.minimum <= value.value <= scalar.maximum:
                message = f"{value.name} = {value.value} does not fit into {scalar.name}"
                self.found.add(value.at, "SBGC016", message, f"widen the type of {name}")
            first = by_value.setdefault(value.value, value)
            if first is not value:
                message = f"{value.name} has the value {value.value} of {first.name}"
                self.found.add(value.at, "SBGC024", message, f"see {first.at}")
            elif kind == "flags" and used & value.value:
                message = f"{value.name} shares bits with an earlier flag of {name}"
                self.found.add(value.at, "SBGC015", message, "each flag has bits of its own")
            used |= value.value
            twin = by_identifier.setdefault(value.identifier, value)
            if twin is not value:
                message = f"{value.name} is called '{value.identifier}' in C++, as is {twin.name}"
                self.found.add(value.at, "SBGC012", message, "give one of them a name with 'as'")

    def _check_former(self, name: str, values: list[EnumValue]) -> None:
        """Former names must be unused; a meaning must change after the value was introduced."""
        taken = {value.identifier: value.name for value in values}
        for value in values:
            for alias in value.aliases:
                if alias.name in taken:
                    text = f"the former name '{alias.spec_name}' of {value.name} in {name}"
                    hint = "a former name belongs to one value, which now has another"
                    other = taken[alias.name]
                    self.found.add(alias.at, "SBGC012", f"{text} is that of {other}", hint)
                taken.setdefault(alias.name, value.name)
            former = value.former.firmware.firmware if value.former else 0
            if former and former < value.since.firmware:
                text = f"{value.name} changed its meaning before it came"
                hint = "'before' has the first firmware with the present meaning"
                self.found.add(value.at, "SBGC071", text, hint)

    def enum_named(self, name: str, at: Position) -> Enum | None:
        """The enum or flag set with this name; reports an unknown name and returns None."""
        enum = self.types.enums.get(name)
        if enum is None:
            hint = did_you_mean(name, self.types.enums) or "name one under 'enums' or 'flags'"
            self.found.add(at, "SBGC010", f"unknown enum or flag set '{name}'", hint)
        return enum

    def _packed(self, name: str, node: Map, at: Position) -> Packed:
        self.identifier(name, at)
        scalar = SCALARS[node["type"]]
        parts = tuple(self._part(part, scalar) for part in node["parts"])
        used = 0
        seen: set[str] = set()
        for part in parts:
            if part.name in seen:
                message = f"duplicate part '{part.name}' in {name}"
                self.found.add(part.at, "SBGC012", message, "give one of them another name")
            seen.add(part.name)
            if part.is_digits:
                continue
            if used & part.bits:
                message = f"part '{part.name}' of {name} overlaps an earlier one"
                self.found.add(part.at, "SBGC015", message, "each bit belongs to one part")
            used |= part.bits
        display = self._display(name, node, seen)
        later = node.get("later_display", {})
        later_display = self._display(name, later, seen) if later else ""
        names = self.enum_named(node["names"], node.at("names")) if "names" in node else None
        main = self._main_part(name, node, parts)
        wanted: list[tuple[str, Map, object]] = [
            ("names", node, names),
            *(("type", n, p.enum or p.quantity) for n, p in zip(node["parts"], parts)),
        ]
        if any(key in owner and type_ is None for key, owner, type_ in wanted):
            self.broken.add(name)
        return Packed(
            name=name,
            scalar=scalar,
            summary=self.summary(node, at, name),
            source=self.source(node, at, name),
            errata=self.errata(node),
            display=display,
            names=names,
            parts=parts,
            at=at,
            main=main,
            later_from=int(later.get("from", 0)),
            later_display=later_display,
        )

    def _display(self, name: str, node: Map, parts: set[str]) -> str:
        display = str(node.get("display", ""))
        literal = re.sub(r"\{\w+(:[0-9]+)?\}", "", display)
        if not re.fullmatch(r"[^][{}]*(\[[^][{}]*\][^][{}]*)*", literal):
            message = f"the display text of {name} has the wrong syntax"
            hint = "write {part} or {part:02}, and [b{part}] for text to omit if the part is 0"
            self.found.add(node.at("display"), "SBGC025", message, hint)
        for word in re.findall(r"\{(\w+)", display):
            if word not in parts:
                message = f"'{word}' in the display text is not a part of {name}"
                hint = did_you_mean(word, parts) or f"parts: {', '.join(sorted(parts))}"
                self.found.add(node.at("display"), "SBGC025", message, hint)
        return display

    def _main_part(self, name: str, node: Map, parts: tuple[Part, ...]) -> Part | None:
        if "main" not in node:
            return None
        by_name = {part.name: part for part in parts}
        part = by_name.get(node["main"])
        at = node.at("main")
        if part is None:
            hint = did_you_mean(node["main"], by_name) or f"parts: {', '.join(sorted(by_name))}"
            self.found.add(at, "SBGC026", f"{name} has no part '{node['main']}'", hint)
        elif part.enum is not None and part.enum.kind != "enum":
            text = f"'{part.name}' of {name} is a flag set, not an enum"
            self.found.add(at, "SBGC026", text, "the main part has the type of an enum")
        elif part.enum is None and "type" not in node["parts"][parts.index(part)]:
            text = f"'{part.name}' of {name} has no named values"
            self.found.add(at, "SBGC026", text, "the main part has the type of an enum")
        elif "names" in node:
            text = f"values of {name} have names already, under 'names'"
            self.found.add(at, "SBGC026", text, "delete 'names' or 'main'")
        else:
            return part
        return None

    def _part(self, node: Map, scalar: Scalar) -> Part:
        name = self.identifier(str(node["name"]), node.at("name"))
        whole = (1 << (8 * scalar.size)) - 1
        mask, shift = whole, 0
        if "bits" in node:
            first, last = parse_bits(node["bits"])
            mask, shift = ((1 << (last - first + 1)) - 1) << first, first
        elif "mask" in node:
            mask = node["mask"]
        if mask & ~whole or mask == 0:
            message = f"the bits of '{name}' do not fit into {scalar.name}"
            at = node.at("bits" if "bits" in node else "mask")
            hint = f"they are counted from 0 to {8 * scalar.size - 1}"
            self.found.add(at, "SBGC016", message, hint)
            mask &= whole
        quantity = self.types.quantities.get(str(node.get("type", "")))
        enum = None
        if "type" in node and quantity is None:
            enum = self.enum_named(node["type"], node.at("type"))
        sign = self._sign_of(node, name, mask, whole)
        for value in enum.values if enum else ():
            if value.value < 0 or (value.value << shift) & ~mask:
                message = f"{value.name} = {value.value} does not fit into the bits of '{name}'"
                hint = "use 'mask' for values in place, 'bits' for shifted ones"
                self.found.add(node.at("type"), "SBGC016", message, hint)
        is_digits = "divide" in node or "modulo" in node
        if node.get("signed") and (enum is not None or is_digits or mask & (mask - 1) == 0):
            text = f"'{name}' cannot be signed"
            hint = "'signed' is for two or more bits that hold a number"
            self.found.add(node.at("signed"), "SBGC016", text, hint)
        part = Part(
            name=name,
            mask=mask,
            shift=shift,
            divide=int(node.get("divide", 1)),
            modulo=int(node.get("modulo", 0)),
            enum=enum,
            summary=self.summary(node, node.position, f"part '{name}'"),
            at=node.position,
            signed=bool(node.get("signed", False)),
            sign=sign,
            quantity=quantity,
            saved_as=str(node.get("saved_as", "")),
        )
        fits = quantity is None or all(map(quantity.scalar.holds, part.limits))
        if quantity is not None and (quantity.scalar.is_float or not fits):
            text = f"'{name}' has numbers from {part.limits[0]} to {part.limits[1]}"
            hint = f"which {quantity.name} cannot hold: its type is {quantity.scalar.name}"
            self.found.add(node.at("type"), "SBGC016", text, hint)
        return part

    def _sign_of(self, node: Map, name: str, mask: int, whole: int) -> int:
        """The mask of the sign bit of a part; 0 if it has none."""
        if "sign" not in node:
            return 0
        sign = 1 << int(node["sign"])
        problem = ""
        if sign & ~whole:
            problem = "is outside the integer"
        elif sign & mask:
            problem = "is one of its own bits"
        elif "signed" in node or "type" in node and node["type"] not in self.types.quantities:
            problem = "is not possible here"
        if problem:
            text = f"the sign bit of '{name}' {problem}"
            hint = "'sign' is another bit; 'signed' is for two's complement"
            self.found.add(node.at("sign"), "SBGC016", text, hint)
            return 0
        return sign

    def _check_unique_names(self) -> None:
        seen: dict[str, Position] = {}
        for section in ("commands", "variables"):
            own: dict[str, Position] = {}
            for _, name, _, at in self.spec.entries(section):
                first = own.setdefault(name, at)
                if first is not at:
                    hint = "give one of them another name"
                    message = f"'{name}' is defined twice (first at {first})"
                    self.found.add(at, "SBGC028", message, hint)
            former = dict.fromkeys(own)
            for _, name, node, _ in self.spec.entries(section):
                for old in (str(old) for old, _ in node.listed("was")):
                    if old in former:
                        message = (
                            f"the former name '{old}' of {name} belongs to another, or to itself"
                        )
                        hint = "a former name belongs to one command, which now has another"
                        self.found.add(node.at("was"), "SBGC028", message, hint)
                    former[old] = None
        for section in ("quantities", "enums", "flags", "packed", "structs"):
            for _, name, _, at in self.spec.entries(section):
                if name in SCALARS or name in (*COMMAND_IDS.values(), VARIABLE_ID):
                    message = f"'{name}' is the name of a built-in type"
                    self.found.add(at, "SBGC028", message, "choose another one")
                first = seen.setdefault(name, at)
                if first is not at:
                    message = f"'{name}' is defined twice (first at {first})"
                    self.found.add(at, "SBGC028", message, "all types share one namespace")


def _enum_of_ids(name: str, summary: str, source: str, values: list[EnumValue]) -> Enum:
    in_order = tuple(sorted(values, key=lambda v: (v.value, v.name)))
    return Enum(name, name, SCALARS["u8"], "enum", summary, source, (), in_order)


def parse_bits(value: Any) -> tuple[int, int]:
    """3 -> (3, 3) and "0..2" -> (0, 2)."""
    first, _, last = str(value).partition("..")
    return int(first), int(last or first)
