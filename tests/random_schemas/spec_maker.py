"""Random spec folders that use everything the spec language can say and have no findings.

The same seed makes the same spec. Names of fields, flags and enum values are unique in a spec, so that
any two lists of fields can be put together; what they are is random.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Optional

import yaml

Node = dict[str, Any]

INTEGERS = {
    "u8": (0, 0xFF),
    "i8": (-0x80, 0x7F),
    "u16": (0, 0xFFFF),
    "i16": (-0x8000, 0x7FFF),
    "u32": (0, 0xFFFFFFFF),
    "i32": (-0x80000000, 0x7FFFFFFF),
}
SIZES = {"u8": 1, "i8": 1, "u16": 2, "i16": 2, "u32": 4, "i32": 4, "f32": 4}
UNSIGNED = ("u8", "u16", "u32")
# What a name must not break: locals and parameters of the generated code, and words of the runtime.
AWKWARD = """OUT IN READER WRITER BODY VALUE DATA SIZE STATUS RAW TO FROM REST N M T CONTEXT VISITOR
FIELDS INFO NAME DECODE ENCODE GET PUT READ WRITE VISIT ANSWERS STD DETAIL mixedCase B2B""".split()
TEXTS = (
    "An ordinary summary.",
    'With "quotes", a \\ backslash, 100 % and {braces}.',
    "Ends with a backslash \\",
    "Grüße, 温度 µ°; // no comment /* none */ either?",
    "A summary that is much too long for one line of a comment, so that it has to be wrapped " * 3,
)
MAX_BODY = 255
MAX_MEMORY = 100_000


@dataclass(frozen=True)
class Kind:
    """A type: `least` bytes on the wire, more if it is not `fixed`; `memory` bytes in C++.

    `number` is the scalar behind it; `values` are those of an enum or flag set (`is_flags`).
    """

    name: str
    least: int
    memory: int
    fixed: bool = True
    number: str = ""
    values: tuple[tuple[str, int], ...] = ()
    is_flags: bool = False
    is_quantity: bool = False
    takes_rest: bool = False
    needs_family: str = ""


@dataclass
class Scope:
    """A list of fields in the making.

    `known` are fields that conditions can be about; `flags` those whose flags choose a unit.
    """

    family: str
    budget: int
    in_message: bool
    depth: int = 0
    fields: list[Node] = field(default_factory=list)
    known: list[tuple[str, Kind]] = field(default_factory=list)
    flags: list[tuple[str, str]] = field(default_factory=list)
    variables: list[str] = field(default_factory=list)
    contexts: list[tuple[str, Kind]] = field(default_factory=list)
    least: int = 0
    memory: int = 0
    fixed: bool = True
    has_lists: bool = False
    takes_rest: bool = False
    has_region: bool = False

    def add(self, node: Node, least: int, memory: int, fixed: bool) -> None:
        """Add a field of at least so many bytes."""
        self.fields.append(node)
        self.least += least
        self.budget -= least
        self.memory += memory
        self.fixed = self.fixed and fixed


@dataclass(frozen=True)
class Body:
    """A message that others may refer to."""

    name: str
    family: str
    scope: Scope
    direction: str
    has_contexts: bool


class SpecMaker:
    """Makes one random spec; `size` is about how many commands it has."""

    def __init__(self, seed: int, size: int) -> None:
        self.random = random.Random(seed)
        self.size = size
        self.number = 0
        self.awkward = list(AWKWARD)
        self.random.shuffle(self.awkward)
        self.families: dict[str, Node] = {}
        self.quantities: list[Kind] = []
        self.enums: list[Kind] = []
        self.flag_sets: list[Kind] = []
        self.packed: list[Kind] = []
        self.structs: list[Kind] = []
        self.has_reset = False
        self.bodies: list[Body] = []
        self.sources: list[tuple[str, Kind]] = []
        self.announced: list[Node] = []
        self.ids: dict[str, list[int]] = {}
        for direction in ("from_board", "to_board"):
            ids = self.random.sample(range(1, 256), 200)
            self.ids[direction] = ids

    # Small things

    def chance(self, share: float) -> bool:
        """True so often."""
        return self.random.random() < share

    def unique(self, word: str) -> str:
        """A name that nothing else has."""
        self.number += 1
        return f"{word}{self.number}"

    def field_name(self) -> str:
        """The name of a field."""
        if self.awkward and self.chance(0.3):
            return self.awkward.pop()
        shape = self.random.choice(("F{}", "FIELD_{}", "f{}_lower", "LONG_NAME_OF_A_FIELD_{}"))
        return shape.format(self.unique(""))

    def said(self, node: Node, decided: bool = True) -> Node:
        """The node with what every entry must say, and perhaps what an erratum has decided."""
        node["summary"] = self.random.choice(TEXTS)
        if decided and self.chance(0.1):
            node["errata"] = ["E001"]
        return node

    def since(self) -> Node:
        """Some version."""
        versions = {"firmware": self.random.choice(("2.55b5", "2.59")), "board": "3.0"}
        return dict(self.random.sample(sorted(versions.items()), self.random.randint(1, 2)))

    def sourced(self, node: Node) -> Node:
        """As said(), and where it comes from."""
        node["source"] = f"Somewhere L{self.random.randint(1, 99)}"
        return self.said(node)

    def section(self, family: str, name: str) -> Node:
        """A section of a family file."""
        sections: Node = self.families[family].setdefault(name, {})
        return sections

    def any_family(self) -> str:
        """Some family."""
        return self.random.choice(list(self.families))

    # Types

    def make_types(self) -> None:
        """Types of every kind, some over each integer."""
        for number in SIZES:
            for _ in range(self.random.choice((0, 1, 2, 2))):
                self.quantities.append(self.make_quantity(number))
        for number in INTEGERS:
            if self.chance(0.7):
                self.enums.append(self.make_enum(number))
        for number in UNSIGNED:
            self.flag_sets.append(self.make_flags(number))
            self.packed += [self.make_packed(number)] if self.chance(0.7) else []
        self.packed.append(self.make_digits())

    def make_quantity(self, number: str) -> Kind:
        """A physical quantity."""
        name = self.unique("Quantity")
        scales = (1, 5, "1/3", "360/16384", "0.02", "0.000000001", "123456789012/7")
        offsets = (0, "-1/2", "0.1", "-12345", "1/3")
        node = {
            "type": number,
            "unit": self.random.choice((None, "deg", "°C", "a/b")),
            "accessor": self.random.choice(("degrees", "value", "in_words")),
            "scale": self.random.choice(scales),
            "offset": self.random.choice(offsets),
        }
        self.section(self.any_family(), "quantities")[name] = self.said(node)
        return Kind(name, SIZES[number], SIZES[number], number=number, is_quantity=True)

    def make_enum(self, number: str, highest: Optional[int] = None) -> Kind:
        """An enum, with the extremes of its type; no value over `highest`."""
        low, high = INTEGERS[number] if highest is None else (0, highest)
        values = {low, high, 0, *(self.random.randint(low, high) for _ in range(2))}
        name = self.unique("Enum")
        chosen = sorted(values)
        self.random.shuffle(chosen)
        named = self.make_values(name, number, "enums", chosen)
        return Kind(name, SIZES[number], SIZES[number], number=number, values=named)

    def make_flags(self, number: str, bits: Optional[int] = None) -> Kind:
        """A set of flags, some of several bits, perhaps one of none, in the lowest `bits`."""
        bits = bits or 8 * SIZES[number]
        masks = [0] if self.chance(0.3) else []
        bit = 0
        while bit < bits and len(masks) < 6:
            width = self.random.choice((1, 1, 1, 2))
            if bit + width <= bits and self.chance(0.6):
                masks.append(((1 << width) - 1) << bit)
            bit += width
        masks = masks if any(masks) else [1 << (bits - 1)]
        name = self.unique(self.random.choice(("Flag{}s", "Flags{}")).format(self.unique("")))
        named = self.make_values(name, number, "flags", masks)
        return Kind(name, SIZES[number], SIZES[number], True, number, named, True)

    def make_values(
        self, name: str, number: str, section: str, values: list[int]
    ) -> tuple[tuple[str, int], ...]:
        """The entry of an enum or flag set, and its named values."""
        prefix = f"P{name.upper()}_"
        content: Node = {}
        for value in values:
            key = self.unique(self.random.choice((prefix, "OTHER-" if self.chance(0.1) else "V")))
            content[key] = self.said({"value": value})
            if "-" in key:
                content[key]["as"] = self.unique("other_name_")
            if self.chance(0.2):
                content[key]["ours"] = True
            if self.chance(0.2):
                content[key]["since"] = self.since()
        node = {"type": number, "values": content}
        if self.chance(0.5):
            node["prefix"] = prefix
            for key in content:
                content[key].setdefault("as", self.unique("named_"))
        self.section(self.any_family(), section)[name] = self.sourced(node)
        return tuple((key, entry["value"]) for key, entry in content.items())

    def make_packed(self, number: str) -> Kind:
        """Several values in one integer: shifted bits, masks in place, enums and flags in them."""
        bits, parts, bit = 8 * SIZES[number], [], 0
        while bit < bits:
            width = min(self.random.choice((1, 1, 2, 3, 7, 16)), bits - bit)
            if self.chance(0.8):
                parts.append(self.make_part(number, bit, width))
            bit += width
        parts = parts or [self.make_part(number, 0, bits)]
        self.random.shuffle(parts)
        node: Node = {"type": number, "parts": parts}
        if self.chance(0.3):
            node["names"] = self.make_enum(number).name
        return self.add_packed(number, node)

    def make_part(self, number: str, bit: int, width: int) -> Node:
        """A part of an integer, `width` bits from `bit` on."""
        part: Node = {"name": self.unique("part_")}
        in_place = self.chance(0.4)
        if in_place:
            part["mask"] = ((1 << width) - 1) << bit
        else:
            part["bits"] = bit if width == 1 else f"{bit}..{bit + width - 1}"
        what = self.random.random()
        if not in_place and what < 0.3:
            part["type"] = self.make_enum(number, (1 << width) - 1).name
        elif not in_place and what < 0.5:
            part["type"] = self.make_flags(number, width).name
        elif what < 0.5:
            part["type"] = self.make_flags_in_place(number, bit, width).name
        return self.said(part, False)

    def make_flags_in_place(self, number: str, bit: int, width: int) -> Kind:
        """Flags at some bits of an integer."""
        name = self.unique("Upper")
        masks = [1 << (bit + self.random.randrange(width))]
        named = self.make_values(name, number, "flags", masks)
        return Kind(name, SIZES[number], SIZES[number], True, number, named, True)

    def make_digits(self) -> Kind:
        """Decimal digits in one integer."""
        number = self.random.choice(UNSIGNED)
        parts = [
            self.said({"name": self.unique("high_"), "divide": 10}, False),
            self.said({"name": self.unique("middle_"), "divide": 10, "modulo": 10}, False),
            self.said({"name": self.unique("low_"), "modulo": 10}, False),
        ]
        display = "{%s}.{%s:02}" % (parts[0]["name"], parts[2]["name"])
        return self.add_packed(number, {"type": number, "display": display, "parts": parts})

    def add_packed(self, number: str, node: Node) -> Kind:
        """Add the entry of a packed integer."""
        name = self.unique("Packed")
        self.section(self.any_family(), "packed")[name] = self.sourced(node)
        return Kind(name, SIZES[number], SIZES[number], number=number)

    def make_variables(self) -> None:
        """Adjustable variables, or none at all."""
        for identity in self.random.sample(range(256), self.random.choice((0, 1, 3))):
            integers = [k for k in self.quantities if k.number in INTEGERS]
            kinds = [Kind(n, SIZES[n], SIZES[n], number=n) for n in INTEGERS] + integers
            kind = self.random.choice(kinds)
            low, high = sorted(self.random.randint(*INTEGERS[kind.number]) for _ in range(2))
            node = {"id": identity, "type": kind.name, "range": f"{low}..{high}"}
            self.section(self.any_family(), "variables")[self.unique("VARIABLE_")] = self.said(node)

    # What a field may be made of

    def number_kind(self) -> Kind:
        """A type with a number on the wire."""
        scalars = [Kind(n, s, s, number=n) for n, s in SIZES.items()]
        named = [Kind("CommandId", 1, 1, number="u8"), Kind("VariableId", 1, 1, number="u8")]
        pools = (scalars, self.quantities, self.enums, self.flag_sets, self.packed, named)
        return self.random.choice(self.random.choice([pool for pool in pools if pool]))

    def blob_kind(self) -> Kind:
        """Bytes or text of some size."""
        size = self.random.choice((1, 2, 3, 7))
        return Kind(f"{self.random.choice(('bytes', 'text'))}[{size}]", size, size)

    def element_kind(self, scope: Scope) -> Kind:
        """Any type that has an end."""
        what = self.random.random()
        if what < 0.5:
            return self.number_kind()
        if what < 0.7:
            return self.blob_kind()
        if what < 0.8:
            return Kind("string", 1, MAX_BODY + 1, fixed=False)
        structs = [k for k in self.structs if self.can_use(scope, k)]
        return self.random.choice(structs) if structs else self.number_kind()

    def can_use(self, scope: Scope, kind: Kind) -> bool:
        """Whether a list of fields may hold a struct: it fits, and no families form a circle."""
        order = list(self.families)
        return (
            order.index(kind.needs_family) <= order.index(scope.family)
            and kind.least <= scope.budget // 2
            and kind.memory <= MAX_MEMORY
            and not kind.takes_rest
        )

    # Fields

    def make_fields(self, scope: Scope, count: int) -> None:
        """Fill a scope with up to `count` fields."""
        makers: list[tuple[float, Callable[[Scope], None]]] = [
            (6, self.add_number),
            (2, self.add_element),
            (2.5, self.add_conditional),
            (1, self.add_list),
            (0.6, self.add_reserved),
            (0.4, self.add_inline_struct),
            (0.3, self.add_variable_value),
            (0.8, self.add_condition_source),
        ]
        weights = [weight for weight, _ in makers]
        for _ in range(count):
            if scope.budget >= 8:
                self.random.choices(makers, weights)[0][1](scope)

    def dimension(self, scope: Scope, kind: Kind) -> tuple[str, int]:
        """What follows a field's name, and how often the field then stands."""
        choices = [("", 1)] * 6 + [("[axis]", 3), ("[xyz]", 3), ("[1]", 1), ("[4]", 4)]
        choices += [("_{AXIS}", 3 if scope.in_message else 1), ("{1..3}_END", 3), ("{5..5}", 1)]
        fitting = [
            (text, count)
            for text, count in choices
            if kind.least * count <= scope.budget and kind.memory * count <= MAX_MEMORY
        ]
        return self.random.choice(fitting or [("", 1)])

    def decorate(self, node: Node, kind: Kind, scope: Scope) -> Node:
        """Add limits and remarks to a field."""
        if kind.number in INTEGERS and self.chance(0.4):
            low, high = sorted(self.random.randint(*INTEGERS[kind.number]) for _ in range(2))
            node["range"] = f"{low}..{high}"
            if self.chance(0.3):
                node["special"] = {str(low): 'Lowest "of" all.'}
                node["special_in_range"] = True
                if low % 2:
                    named = {"as": self.unique("named_special_"), "summary": "Lowest of all."}
                    node["special"][str(low)] = named
        elif kind.number == "f32" and self.chance(0.4):
            node["range"] = self.random.choice(("-0.5..1.25", "0..1", "-1000000000..0.1"))
        if kind.number in INTEGERS and "special" not in node and self.chance(0.2):
            low, high = INTEGERS[kind.number]
            node["special"] = {str(low): "The lowest.", str(high): "The highest."}
            node["special_in_range"] = True
        if kind.number in INTEGERS and self.chance(0.1):
            node["align"] = self.random.choice((2, 64))
        if self.chance(0.1):
            node["since"] = self.since()
        if self.chance(0.1):
            node["deprecated"] = self.random.choice((True, {"since": self.since()}))
        others = [k for k in self.quantities if k.number == kind.number and k != kind]
        if kind.is_quantity and others and scope.flags and scope.in_message and self.chance(0.4):
            of, flag = self.random.choice(scope.flags)
            other = self.random.choice(others).name
            node["alternative"] = {"type": other, "of": of, "flag": flag}
        return self.said(node)

    def add_number(self, scope: Scope) -> None:
        """A number, once or several times."""
        kind = self.number_kind()
        name = self.field_name()
        dim, count = self.dimension(scope, kind)
        node = self.decorate({"name": name + dim, "type": kind.name}, kind, scope)
        scope.add(node, kind.least * count, kind.memory * count, True)
        if kind.values and not dim:
            self.depend_on(scope, name, kind)
        if kind.name == "VariableId" and not dim:
            scope.variables.append(name)

    def depend_on(self, scope: Scope, name: str, kind: Kind) -> None:
        """Let later fields depend on this one."""
        scope.known.append((name, kind))
        if kind.is_flags and scope.in_message:
            scope.flags += [(name, flag) for flag, mask in kind.values if mask]

    def add_condition_source(self, scope: Scope) -> None:
        """An enum or flag set that something may depend on."""
        kind = self.random.choice(self.enums + self.flag_sets)
        name = self.field_name()
        scope.add(self.said({"name": name, "type": kind.name}), kind.least, kind.memory, True)
        self.depend_on(scope, name, kind)

    def add_element(self, scope: Scope) -> None:
        """Something of any type."""
        kind = self.element_kind(scope)
        dim, count = self.dimension(scope, kind)
        node = self.said({"name": self.field_name() + dim, "type": kind.name})
        if kind.number:
            node = self.decorate(node, kind, scope)
        scope.add(node, kind.least * count, kind.memory * count, kind.fixed)

    def add_reserved(self, scope: Scope) -> None:
        """Reserved bytes, with or without a name."""
        if self.chance(0.6):
            size = self.random.randint(1, 5)
            scope.add({"reserved": size}, size, size, True)
        else:
            kind = self.blob_kind() if self.chance(0.5) else self.number_kind()
            node = {"name": self.field_name(), "type": kind.name, "reserved": True}
            scope.add(node, kind.least, kind.memory, True)

    def condition(self, scope: Scope) -> Optional[Node]:
        """A condition that fields of this scope can have."""
        sources = [("field", n, k) for n, k in scope.known]
        sources += [("context", n, k) for n, k in scope.contexts] * 3
        if not sources:
            return None
        key, name, kind = self.random.choice(sources)
        if kind.is_flags:
            flags = [flag for flag, mask in kind.values if mask]
            chosen = self.random.sample(flags, self.random.randint(1, min(2, len(flags))))
            return {key: name, "has": chosen if len(chosen) > 1 else chosen[0]}
        names = [value for value, _ in kind.values]
        chosen = self.random.sample(names, self.random.randint(1, min(3, len(names))))
        return {key: name, "is": chosen if len(chosen) > 1 else chosen[0]}

    def add_conditional(self, scope: Scope) -> None:
        """Something that is there only if some other field says so."""
        when = self.condition(scope)
        if when is None:
            return self.add_condition_source(scope)
        kind = self.element_kind(scope)
        dim, count = self.dimension(scope, kind)
        name = self.field_name()
        node = self.decorate({"name": name + dim, "type": kind.name, "when": when}, kind, scope)
        if "field" in when and kind.fixed and self.chance(0.3):
            when["may_be_missing"] = True
        scope.budget -= kind.least * count
        scope.add(node, 0, kind.memory * count + 4, False)
        if kind.values and not dim and self.chance(0.5):
            scope.known.append((name, kind))
        return None

    def add_list(self, scope: Scope) -> None:
        """A list behind the number of its elements."""
        kind = self.element_kind(scope)
        if scope.has_region:  # everything behind a counter would lose its fixed place
            return self.add_number(scope)
        if MAX_BODY // max(1, kind.least) * kind.memory > MAX_MEMORY:
            kind = self.number_kind()
        counter, number = self.field_name(), self.random.choice(UNSIGNED)
        node = {"name": counter, "type": number}
        if self.chance(0.5):
            node["range"] = f"0..{self.random.choice((1, 2, 3))}"
        scope.add(self.said(node), SIZES[number], 0, True)
        if self.chance(0.2):
            self.add_number(scope)
        node = self.said({"name": f"{self.field_name()}[{counter}]", "type": kind.name})
        scope.add(node, 0, MAX_BODY // max(1, kind.least) * kind.memory, False)
        scope.has_lists = True
        return None

    def add_inline_struct(self, scope: Scope) -> None:
        """A struct that is defined where it is used, and can be used again later."""
        if scope.depth >= 2:
            return self.add_number(scope)
        name = self.unique("Inline")
        kind, node = self.make_struct(name, scope.family, scope.budget // 3, scope.depth + 1)
        dim, count = self.dimension(scope, kind)
        node.update(name=self.field_name() + dim, struct=name)
        scope.add(self.said(node), kind.least * count, kind.memory * count, kind.fixed)
        self.structs.append(kind)
        return None

    def make_struct(
        self, name: str, family: str, budget: int, depth: int, rest: bool = False
    ) -> tuple[Kind, Node]:
        """A struct and its entry in the spec."""
        inner = Scope(family, max(8, budget), in_message=False, depth=depth)
        self.make_fields(inner, self.random.randint(1, 5))
        if rest:
            self.add_rest(inner)
        if not inner.fields:
            self.add_number(inner)
        kind = Kind(name, inner.least, inner.memory + 8, inner.fixed, needs_family=family)
        return replace(kind, takes_rest=inner.takes_rest), {"fields": inner.fields}

    def add_variable_value(self, scope: Scope) -> None:
        """The value of an adjustable variable."""
        if not scope.variables:
            scope.variables.append(self.field_name())
            node = {"name": scope.variables[-1], "type": "VariableId"}
            scope.add(self.said(node), 1, 1, True)
        name, number = self.field_name(), self.random.choice(list(INTEGERS))
        node = {"name": name, "type": number, "variable": self.random.choice(scope.variables)}
        scope.add(self.said(node), SIZES[number], SIZES[number], True)

    def add_region(self, scope: Scope) -> None:
        """Some bytes whose meaning depends on fields before them."""
        if scope.has_lists or not scope.fixed or scope.budget < 8:
            return
        here = {f.get("name") for f in scope.fields if "when" not in f}
        known = [(name, kind) for name, kind in scope.known if name in here]
        if not known:
            self.add_condition_source(scope)
            known = [scope.known[-1]]
        size = self.random.choice((4, 8))
        inner = Scope(scope.family, 99, in_message=False, depth=9, known=known)
        left = size  # several conditions may hold at once
        for _ in range(self.random.randint(1, 3)):
            kind = self.number_kind() if self.chance(0.7) else Kind("bytes[2]", 2, 2)
            if kind.least > left:
                continue
            left -= kind.least
            name = "REST_OF_IT" if (name := self.field_name()) == "REST" else name
            node: Node = {"name": name, "type": kind.name, "when": self.condition(inner)}
            inner.fields.append(self.decorate(node, kind, inner))
        node = {"name": self.field_name(), "struct": self.unique("Region"), "size": size}
        scope.add(self.said({**node, "fields": inner.fields}), size, 50, True)
        scope.has_region = True

    def add_rest(self, scope: Scope) -> None:
        """What takes the rest of the body."""
        node: Node = {"name": self.field_name(), "type": "bytes[]"}
        structs = [k for k in self.structs if k.fixed and k.least and self.can_use(scope, k)]
        what = self.random.random()
        least = 1
        if what < 0.3:
            node["align"] = self.random.choice((1, 2))
        elif what < 0.45 and scope.depth < 2:
            name = self.unique("Tail")
            kind, inner = self.make_struct(name, scope.family, 20, scope.depth + 1, rest=True)
            node = {"name": node["name"], "struct": name, **inner}
            scope.add(self.said(node), kind.least, kind.memory, False)
            scope.takes_rest = True
            return
        else:
            kind = self.number_kind() if self.chance(0.6) else self.blob_kind()
            kind = self.random.choice(structs) if structs and self.chance(0.3) else kind
            node = {"name": node["name"] + "[]", "type": kind.name}
            least = kind.least
        if self.chance(0.5) and scope.budget >= 3 * least:
            node["max_count"] = self.random.choice((1, 2, 3))
        scope.add(self.said(node), 0, MAX_BODY, False)
        scope.takes_rest = True

    # Messages

    def make_messages(self) -> None:
        """Commands of all kinds; those that others depend on come first."""
        for _ in range(2):
            self.add_flag_source()
        for _ in range(self.random.randint(1, 2)):
            self.add_announcement()
        makers = [self.add_forms, self.add_both_ways, self.add_same, self.add_including]
        makers += [self.add_dependent, self.add_gaps]
        for maker in makers:
            maker()
        makers += [self.add_command] * 5 + [self.add_undocumented]
        for _ in range(self.size):
            self.random.choice(makers)()

    def scope(self, family: str, budget: int = 150) -> Scope:
        """A new list of fields of a message."""
        return Scope(family, budget, in_message=True)

    def random_scope(self, family: str, rest: bool = True, budget: int = 150) -> Scope:
        """A list of fields of a message, perhaps with what takes the rest of the body."""
        scope = self.scope(family, budget)
        self.make_fields(scope, self.random.choice((0, 1, 2, 4, 8, 12)))
        if self.chance(0.3):
            self.add_region(scope)
            self.make_fields(scope, self.random.choice((0, 3)))
        if rest and self.chance(0.35):
            self.add_rest(scope)
        return scope

    def new_command(self, *directions: str, family: str = "") -> tuple[str, str, Node]:
        """A command: its name, its family, which is `family` or one behind it, and its entry."""
        shared = set(self.ids["from_board"]) & set(self.ids["to_board"])
        pool = sorted(shared) if len(directions) > 1 else self.ids[directions[0]]
        identity = self.random.choice(pool)
        for direction in directions:
            self.ids[direction].remove(identity)
        order = list(self.families)
        name = f"CMD_C{self.unique('')}"
        family = self.random.choice(order[order.index(family) if family else 0 :])
        node = self.said({"id": identity})
        if self.chance(0.2):
            node["since"] = self.since()
        if self.chance(0.2):
            node["deprecated"] = self.random.choice((True, {"since": self.since()}))
        self.section(family, "commands")[name] = node
        return name, family, node

    def side(self, direction: str, name: str, content: Node, scope: Optional[Scope] = None) -> Node:
        """One direction of a command, whose message is called `name` and has the fields of `scope`."""
        node = self.sourced({**content, "as": name})
        if self.chance(0.2):
            node["description"] = self.random.choice(TEXTS)
        if direction == "to_board":
            node["answer"] = self.answer(scope)
        elif not self.has_reset and self.chance(0.2):
            self.has_reset = True
            node["role"] = {"is": "reset", "delay_ms": 20}
        return node

    def answer(self, scope: Optional[Scope] = None) -> Any:
        """What answers a request, perhaps under a condition about the fields of `scope`."""
        plain = self.plain_answer()
        if scope is None or not scope.known or self.chance(0.3):
            return plain
        when = self.condition(replace(scope, contexts=[]))
        if when is None:
            return plain
        when.pop("may_be_missing", None)
        other = self.plain_answer()
        first = {"confirm": "possible"} if other == "none" else other
        return [{"when": when, **first}, plain]

    def plain_answer(self) -> Any:
        """What answers a request."""
        from_board = [b.name for b in self.bodies if b.direction == "from_board"]
        if from_board and self.chance(0.5):
            return {"message": self.random.choice(from_board), "retry": "safe"}
        if self.chance(0.5):
            return {"confirm": "always", "confirmations": 2, "timeout_ms": 70}
        return "none"

    def add_body(self, name: str, scope: Scope, direction: str, has_contexts: bool = False) -> None:
        """Remember a message."""
        self.bodies.append(Body(name, scope.family, scope, direction, has_contexts))

    def either(self) -> str:
        """A direction."""
        return self.random.choice(("from_board", "to_board"))

    def add_command(self) -> None:
        """A command in one direction, or with different bodies in both."""
        both = self.chance(0.3)
        directions = ("from_board", "to_board") if both else (self.either(),)
        command, family, node = self.new_command(*directions)
        for direction in directions:
            scope = self.random_scope(family)
            name = self.unique("Message")
            content: Node = {"fields": scope.fields} if scope.fields else {}
            if self.chance(0.3):
                content["tail"] = self.random.choice(("keep", "refuse"))
            if not scope.fixed and self.chance(0.2):
                content["max_size"] = MAX_BODY
            node[direction] = self.side(direction, name, content, scope)
            if self.chance(0.5):  # by the name of the command
                del node[direction]["as"]
                name = command.removeprefix("CMD_")
                name += "Request" if both and direction == "to_board" else ""
            self.add_body(name, scope, direction)

    def add_forms(self) -> None:
        """A command with several forms, told apart by size."""
        direction = self.either()
        _, family, node = self.new_command(direction)
        count = self.random.randint(2, 4)
        names = self.random.sample(("simple", "extended", "success", "error"), count)
        forms: Node = {}
        size = -1  # what the forms so far have at most
        for position, form in enumerate(names):
            last = position == count - 1
            scope = self.scope(family, 60)
            wanted = size + 1
            if wanted:  # more than any before
                longer = self.said({"name": self.field_name(), "type": f"bytes[{wanted}]"})
                scope.add(longer, wanted, wanted, True)
            self.make_fields(scope, self.random.randint(0, 6 if last else 2))
            if last and self.chance(0.4):
                self.add_rest(scope)
            name = self.unique("Form")
            content = self.said({"fields": scope.fields} if scope.fields else {})
            size = scope.least
            if not scope.fixed and not last:
                size = content["max_size"] = max(1, scope.least + self.random.randint(0, 3))
            if direction == "to_board":
                content["answer"] = self.answer(scope)
            forms[form] = {**content, "as": name}
            self.add_body(name, scope, direction)
        order = sorted(forms)
        self.random.shuffle(order)
        node[direction] = self.sourced({"forms": {form: forms[form] for form in order}})

    def add_both_ways(self) -> None:
        """A command with the same body in both directions."""
        _, family, node = self.new_command("from_board", "to_board")
        scope = self.random_scope(family)
        name = self.unique("Both")
        first, second = self.random.sample(("from_board", "to_board"), 2)
        content: Node = {"fields": scope.fields} if scope.fields else {}
        node[first] = self.side(first, name, content)
        node[second] = self.side(second, name, {"same_as": name})
        self.add_body(name, scope, "from_board")

    def add_same(self) -> None:
        """A command with the body of another."""
        body, direction = self.random.choice(self.bodies), self.either()
        _, family, node = self.new_command(direction, family=body.family)
        name = self.unique("Same")
        node[direction] = self.side(direction, name, {"same_as": body.name})
        self.bodies.append(replace(body, name=name, family=family, direction=direction))

    def add_gaps(self) -> None:
        """A message with values that may be missing in front of bytes that may be taken for them."""
        direction = self.either()
        _, family, node = self.new_command(direction)
        scope = self.scope(family)
        self.add_condition_source(scope)
        for _ in range(self.random.randint(1, 3)):
            when = {**(self.condition(scope) or {}), "may_be_missing": True}
            kind = self.number_kind() if self.chance(0.7) else self.blob_kind()
            gap = self.said({"name": self.field_name(), "type": kind.name, "when": when})
            scope.add(gap, 0, kind.memory + 4, False)
        scope.add(self.said({"name": self.field_name(), "type": "bytes[]"}), 0, MAX_BODY, False)
        scope.takes_rest = True
        name = self.unique("Gaps")
        node[direction] = self.side(direction, name, {"fields": scope.fields})
        self.add_body(name, scope, direction)

    def add_including(self) -> None:
        """A message that includes another."""
        direction = self.either()
        _, family, node = self.new_command(direction)
        order = list(self.families)
        fitting = [
            body
            for body in self.bodies
            if not body.scope.takes_rest
            and not body.has_contexts
            and body.scope.fields
            and body.scope.least < 120
            and order.index(body.family) <= order.index(family)
        ]
        scope = self.scope(family, 100)
        content: Node = {"fields": scope.fields}
        name = self.unique("Including")
        if fitting:
            body = self.random.choice(fitting)
            scope.has_region = body.scope.has_region
            if self.chance(0.5) and not scope.has_region:
                self.make_fields(scope, 2)
            scope.add({"include": body.name}, body.scope.least, body.scope.memory, body.scope.fixed)
            scope.has_lists = scope.has_lists or body.scope.has_lists
            self.make_fields(scope, 3)
        else:
            self.add_number(scope)
        node[direction] = self.side(direction, name, content)
        included = replace(scope, takes_rest=True)  # no second include of the same names
        self.bodies.append(Body(name, family, included, direction, False))

    def add_flag_source(self) -> None:
        """A message that tells the flags that others depend on."""
        direction = self.either()
        _, family, node = self.new_command(direction)
        kind = self.random.choice(
            self.flag_sets if self.chance(0.7) else self.enums or self.flag_sets
        )
        scope = self.scope(family, 40)
        self.make_fields(scope, self.random.randint(0, 2))
        told, name = self.field_name(), self.unique("Source")
        flags = self.said({"name": told, "type": kind.name})
        path = f"{name}.{told}"
        if self.chance(0.4):
            group = self.field_name()
            inner = {"name": group, "struct": self.unique("Group"), "fields": [flags]}
            scope.add(self.said(inner), kind.least, kind.memory, True)
            path = f"{name}.{group}.{told}"
        else:
            scope.add(flags, kind.least, kind.memory, True)
        if self.chance(0.5):
            self.make_fields(scope, 2)
        node[direction] = self.side(direction, name, {"fields": scope.fields})
        self.add_body(name, scope, direction)
        self.sources.append((path, kind))

    def add_announcement(self) -> None:
        """A message that announces the types of numbers in others."""
        direction = self.either()
        _, family, node = self.new_command(direction)
        name, enum_name, list_name = (
            self.unique("Announcing"),
            self.unique("Wire"),
            self.field_name(),
        )
        wires = self.random.sample(sorted(SIZES), self.random.choice((3, 7)))
        values: Node = {
            self.unique("WIRE_"): self.said({"value": number, "wire": wire})
            for number, wire in enumerate(wires)
        }
        if self.chance(0.5):
            values[self.unique("WIRE_")] = self.said({"value": 7})
        section = self.section(family, "enums")
        section[enum_name] = self.sourced({"type": "u8", "values": values})
        kind, kind_name = enum_name, self.field_name()
        path = kind_name
        if self.chance(0.5):
            part, shift = self.unique("part_"), self.random.choice((0, 3, 5))
            parts = [
                self.said({"name": part, "bits": f"{shift}..{shift + 2}", "type": enum_name}, False)
            ]
            kind = self.add_packed("u8", {"type": "u8", "parts": parts}).name
            path = f"{kind_name}.{part}"
        count = self.field_name()
        fields = [
            self.said({"name": kind_name, "type": kind}),
            self.said({"name": count, "type": self.random.choice(UNSIGNED)}),
            self.said({"name": self.field_name(), "type": self.random.choice(("string", "i16"))}),
        ]
        self.random.shuffle(fields)
        scope = self.scope(family, 40)
        counter = self.field_name()
        scope.add(self.said({"name": counter, "type": "u8"}), 1, 1, True)
        entry = {"name": f"{list_name}[{counter}]", "struct": self.unique("Element")}
        scope.add(self.said({**entry, "fields": fields}), 0, MAX_MEMORY, False)
        scope.has_lists = True
        node[direction] = self.side(direction, name, {"fields": scope.fields})
        self.add_body(name, scope, direction)
        context = {"announced_by": f"{name}.{list_name}", "kind": path, "count": count}
        self.announced.append(context)

    def add_dependent(self) -> None:
        """A message that can be read only with what earlier ones have told."""
        direction = self.either()
        _, family, node = self.new_command(direction)
        scope = self.scope(family)
        contexts = []
        if self.chance(0.7):
            path, kind = self.random.choice(self.sources)
            same = [other for other, its in self.sources if its == kind and other != path]
            context: Node = {
                "name": self.unique("CONTEXT_"),
                "type": kind.name,
                "from": [path, *same],
            }
            contexts.append(self.said(context, False))
            scope.contexts.append((context["name"], kind))
        self.make_fields(scope, 3)
        if scope.contexts:
            name = self.field_name()
            node_ = {"name": name, "type": "u16", "when": self.condition(replace(scope, known=[]))}
            scope.add(self.said(node_), 0, 4, False)
        for _ in range(self.random.randint(0, 4)):
            self.add_conditional(scope)
        if self.announced and (not contexts or self.chance(0.5)):
            context = {"name": self.unique("TYPES_"), **self.random.choice(self.announced)}
            contexts.append(self.said(context, False))
            node_ = {"name": f"{self.field_name()}[]", "type": f"announced({context['name']})"}
            scope.add(self.said(node_), 0, 8 * MAX_BODY, False)
            scope.takes_rest = True
        elif self.chance(0.3):
            self.add_rest(scope)
        name = self.unique("Dependent")
        content = {"context": contexts, "fields": scope.fields}
        node[direction] = self.side(direction, name, content)
        self.add_body(name, scope, direction, has_contexts=True)

    def add_undocumented(self) -> None:
        """A command of which nothing is known, or not even an id."""
        name = self.unique("CMD_UNKNOWN_")
        node: Node = self.sourced({"id": None, "undocumented": True})
        self.section(self.any_family(), "commands")[name] = node

    # The whole

    def make(self) -> dict[str, Node]:
        """The files of the spec."""
        count = self.random.randint(1, 4)
        self.families = {
            name: {"family": name, "summary": self.random.choice(TEXTS)}
            for name in ("alpha", "beta", "gamma", "delta")[:count]
        }
        self.make_types()
        self.make_variables()
        for _ in range(3):
            family, name = self.any_family(), self.unique("Struct")
            kind, node = self.make_struct(name, family, 30, 1)
            self.section(family, "structs")[name] = self.said(node, False)
            self.structs.append(kind)
        self.make_messages()
        self.use_structs()
        self.drop_unused()
        files = {f"{name}.yaml": content for name, content in self.families.items()}
        return {**files, "simplebgc.yaml": self.main_file(), "errata.yaml": self.errata_file()}

    def use_structs(self) -> None:
        """A message with the structs that no other has."""
        _, family, node = self.new_command("to_board", family=list(self.families)[-1])
        used = {inner.get("type") for inner in _nodes(self.families)}
        scope = self.scope(family)
        self.add_number(scope)
        for kind in self.structs:
            if kind.name.startswith("Struct") and kind.name not in used:
                field_ = self.said({"name": self.field_name(), "type": kind.name})
                scope.add(field_, kind.least, kind.memory, kind.fixed)
        node["to_board"] = self.side("to_board", self.unique("Using"), {"fields": scope.fields})

    def drop_unused(self) -> None:
        """Take out types that nothing refers to, which would be a finding."""
        while True:
            used = {
                node[key]
                for node in _nodes(self.families)
                for key in ("type", "names")
                if isinstance(node.get(key), str)
            }
            unused = [
                (content[section], name)
                for content in self.families.values()
                for section in ("quantities", "enums", "flags", "packed", "structs")
                for name in content.get(section, {})
                if name not in used
            ]
            for part, name in unused:
                del part[name]
            if not unused:
                return

    def main_file(self) -> Node:
        """simplebgc.yaml."""
        line = {
            "more_baud_rates": self.random.sample(range(1, 1_000_000), self.random.randint(1, 4)),
            "parities": self.random.sample(("none", "even"), self.random.randint(1, 2)),
            "pause_ms": "1..9",
            "source": "Line L1",
        }
        return {
            **({"line": line} if self.chance(0.7) else {}),
            "protocol": {"name": "Random", "revision": "1"},
            "framing": {
                "start": 0x3E,
                "header": ["start", "id", "size", "header_checksum"],
                "max_body": MAX_BODY,
                "trailer": ["body_checksum"],
                "checksum": "sum8",
                "source": "Framing L1",
                "errata": ["E001"],
            },
            "indices": {"axis": ["ROLL", "PITCH", "YAW"], "xyz": ["X", "Y", "Z"]},
            "families": list(self.families),
        }

    def errata_file(self) -> Node:
        """errata.yaml."""
        entry = {"kind": "text", "lines": ["L1"], "problem": "Something.", "reading": "Anything."}
        return {"errata": {"E001": entry}}


def _nodes(value: Any) -> list[Node]:
    """All mappings in a value."""
    if isinstance(value, dict):
        return [value, *(node for inner in value.values() for node in _nodes(inner))]
    if isinstance(value, list):
        return [node for inner in value for node in _nodes(inner)]
    return []


class _Dumper(yaml.SafeDumper):
    def ignore_aliases(self, data: Any) -> bool:
        """Anchors can not be used in a spec."""
        return True


def write_spec(folder: Path, seed: int, size: int) -> None:
    """Write the random spec of this seed."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, content in SpecMaker(seed, size).make().items():
        text = yaml.dump(content, Dumper=_Dumper, sort_keys=False, allow_unicode=True, width=100)
        (folder / name).write_text(text, encoding="utf-8")
