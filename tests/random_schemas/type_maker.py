"""Makes the types and variables of a random spec."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any, Optional

from spec_parts import INTEGERS, SIZES, UNSIGNED, WIDE, Body, Kind, Node, scalar

# Names that must not break the generated code: its locals and parameters, and names of the runtime.
AWKWARD = """OUT IN READER WRITER BODY VALUE DATA SIZE STATUS RAW TO FROM REST N M T CONTEXT VISITOR
FIELDS INFO NAME DECODE ENCODE GET PUT READ WRITE VISIT ANSWERS STD DETAIL mixedCase B2B""".split()
TEXTS = (
    "An ordinary summary.",
    'With "quotes", a \\ backslash, 100 % and {braces}.',
    "Ends with a backslash \\",
    "Grüße, 温度 µ°; // no comment /* none */ either?",
    "A summary that is much too long for one line of a comment, so that it has to be wrapped " * 3,
)


class TypeMaker:
    """Makes types; `size` is the approximate number of commands of the spec."""

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
        self.parts: dict[str, Kind] = {}
        self.structs: list[Kind] = []
        self.has_reset = False
        self.bodies: list[Body] = []
        self.sources: list[tuple[str, Kind]] = []
        self.announced: list[Node] = []
        directions = ("from_board", "to_board")
        self.ids = {way: self.random.sample(range(1, 256), 200) for way in directions}

    # Helpers

    def chance(self, share: float) -> bool:
        """Returns True with probability `share`."""
        return self.random.random() < share

    def perhaps(self, share: float, **keys: Any) -> Node:
        """Returns these keys with probability `share`, else none."""
        return keys if self.chance(share) else {}

    def unique(self, word: str) -> str:
        """Returns a unique name."""
        self.number += 1
        return f"{word}{self.number}"

    def field_name(self) -> str:
        """Returns the name of a field."""
        if self.awkward and self.chance(0.3):
            return self.awkward.pop()
        shape = self.random.choice(("F{}", "FIELD_{}", "f{}_lower", "LONG_NAME_OF_A_FIELD_{}"))
        return shape.format(self.unique(""))

    def said(self, node: Node, decided: bool = True) -> Node:
        """Adds the required keys of every entry to the node, and perhaps an erratum."""
        node["summary"] = self.random.choice(TEXTS)
        if decided and self.chance(0.1):
            node["errata"] = ["E001"]
        return node

    def since(self) -> Node:
        """Returns a version."""
        versions = {"firmware": self.random.choice(("2.55b5", "2.59")), "board": "3.0"}
        return dict(self.random.sample(sorted(versions.items()), self.random.randint(1, 2)))

    def sourced(self, node: Node) -> Node:
        """Like said(), but also adds a source."""
        node["source"] = f"Somewhere L{self.random.randint(1, 99)}"
        return self.said(node)

    def section(self, family: str, name: str) -> Node:
        """Returns a section of a family file."""
        sections: Node = self.families[family].setdefault(name, {})
        return sections

    def any_family(self) -> str:
        """Returns a family."""
        return self.random.choice(list(self.families))

    # Types

    def make_types(self) -> None:
        """Makes types of every kind, some over each integer."""
        for number in (*SIZES, *WIDE):
            for _ in range(self.random.choice((0, 1, 2, 2))):
                self.quantities.append(self.make_quantity(number))
        for number in INTEGERS:
            if self.chance(0.7):
                self.enums.append(self.make_enum(number))
        for number in UNSIGNED:
            self.flag_sets.append(self.make_flags(number))
            self.packed += [self.make_packed(number)] if self.chance(0.7) else []
        self.packed.append(self.make_wide_packed())
        self.packed.append(self.make_digits())
        self.make_versions()

    def make_quantity(self, number: str) -> Kind:
        """Makes a physical quantity."""
        name = self.unique("Quantity")
        scales = (1, 5, "1/3", "360/16384", "0.02", "0.000000001", "123456789012/7")
        offsets = (0, "-1/2", "0.1", "-12345", "1/3")
        units = [(None, "value"), (None, "degrees"), ("deg", "degrees"), ("°C", "value")]
        unit, accessor = self.random.choice([*units, ("a/b", "in_words")])
        scaled = {"scale": self.random.choice(scales), "offset": self.random.choice(offsets)}
        node: Node = {"type": number, "unit": unit, "accessor": accessor, **scaled}
        if number in INTEGERS and SIZES[number] <= 2 and self.chance(0.3):
            steps = ((52, 255), ("3/2", 40)) if SIZES[number] == 1 else (("3/2", 40000), (7, 65535))
            ratio, over = self.random.choice(steps)
            node["exponential"] = {"ratio": ratio, "over": over}
        self.section(self.any_family(), "quantities")[name] = self.said(node)
        kind = replace(scalar(number), name=name, number=number)
        return replace(kind, is_quantity=True, unit=unit)

    def make_enum(self, number: str, highest: Optional[int] = None) -> Kind:
        """Makes an enum with the extremes of its type; no value exceeds `highest`."""
        low, high = INTEGERS[number] if highest is None else (0, highest)
        values = {low, high, 0, *(self.random.randint(low, high) for _ in range(2))}
        name = self.unique("Enum")
        chosen = sorted(values)
        self.random.shuffle(chosen)
        named = self.make_values(name, number, "enums", chosen)
        return replace(scalar(number), name=name, values=named)

    def make_flags(self, number: str, bits: Optional[int] = None) -> Kind:
        """Makes a flag set in the lowest `bits`: some flags have several bits, one may have none."""
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
        return self.flag_set(name, number, masks)

    def flag_set(self, name: str, number: str, masks: list[int]) -> Kind:
        """Makes a flag set with these flags."""
        named = self.make_values(name, number, "flags", masks)
        return replace(scalar(number), name=name, values=named, is_flags=True)

    def make_values(
        self, name: str, number: str, section: str, values: list[int]
    ) -> tuple[tuple[str, int], ...]:
        """Adds the entry of an enum or flag set; returns its named values."""
        prefix = f"P{name.upper()}_"
        content: Node = {}
        for value in values:
            key = self.unique(self.random.choice((prefix, "OTHER-" if self.chance(0.1) else "V")))
            before = {"firmware": "2.60", "summary": "Something else."}
            content[key] = {
                **self.said({"value": value}),
                **({"as": self.unique("other_name_")} if "-" in key else {}),
                **self.perhaps(0.2, ours=True),
                **(self.perhaps(0.2, since=self.since()) or self.perhaps(0.1, before=before)),
                **self.perhaps(0.1, was=self.unique("FORMER_VALUE_")),
                **self.perhaps(0.1, unconfirmed=True),
                **self.perhaps(0.1, saved_as="savedValue"),
            }
        node = {"type": number, "values": content}
        if self.chance(0.5) and any(key.startswith(prefix) for key in content):
            node["prefix"] = prefix
            for key in content:
                content[key].setdefault("as", self.unique("named_"))
        self.section(self.any_family(), section)[name] = self.sourced(node)
        return tuple((key, entry["value"]) for key, entry in content.items())

    def make_packed(self, number: str) -> Kind:
        """Makes a packed integer with shifted bits, masks in place, enums and flags."""
        bits, parts, bit = 8 * SIZES[number], [], 0
        while bit < bits:
            width = min(self.random.choice((1, 1, 2, 3, 7, 16)), bits - bit)
            if self.chance(0.8):
                parts.append(self.make_part(number, bit, width))
            bit += width
        parts = parts or [self.make_part(number, 0, bits)]
        self.random.shuffle(parts)
        node: Node = {"type": number, "parts": parts}
        named = [part["name"] for part in parts if str(part.get("type", "")).startswith("Enum")]
        if self.chance(0.3):
            node["names"] = self.make_enum(number).name
        elif named and self.chance(0.5):
            node["main"] = self.random.choice(named)
        return self.add_packed(number, node)

    def part_kind(self, number: str, part: Node, type_: Optional[Kind], width: int) -> Kind:
        """Returns what conditions on a part may look at."""
        if type_ is not None:
            return type_
        most = (1 << width) - 1
        limits = (0, most)
        if {"signed", "sign"} & set(part):
            limits = (-(most >> 1) - ("signed" in part), most >> 1)
        is_in_place = "mask" in part  # the number is not shifted
        shift = (part["mask"] & -part["mask"]).bit_length() - 1 if is_in_place else 0
        is_plain = shift == 0 and not {"signed", "sign"} & set(part)
        return Kind("", 0, 0, number=number, limits=limits, is_count=is_plain and most > 1)

    def make_wide_packed(self) -> Kind:
        """Makes a packed integer of 64 bits."""
        parts = [
            self.part(bits="0..18", sign=19),
            self.part(bits="20..39", signed=True, type=self.make_quantity("i32").name),
            self.part(bits="40..63"),
        ]
        return self.add_packed("u64", {"type": "u64", "parts": parts})

    def part(self, name: str = "", **keys: Any) -> Node:
        """Returns a part of a packed integer."""
        return self.said({"name": name or self.unique("part_"), **keys}, False)

    def make_part(self, number: str, bit: int, width: int) -> Node:
        """Makes a part of an integer, `width` bits from `bit` on."""
        part: Node = {"name": self.unique("part_")}
        in_place = self.chance(0.4)
        if in_place:
            part["mask"] = ((1 << width) - 1) << bit
        else:
            part["bits"] = bit if width == 1 else f"{bit}..{bit + width - 1}"
        what = self.random.random()
        type_: Optional[Kind] = None
        if not in_place and what < 0.3:
            type_ = self.make_enum(number, (1 << width) - 1)
        elif not in_place and what < 0.5:
            type_ = self.make_flags(number, width)
        elif what < 0.5:
            type_ = self.make_flags_in_place(number, bit, width)
        elif what < 0.6 and not in_place and width > 1:
            part["signed"] = True
        elif what < 0.7 and not in_place and width > 1:
            part["bits"] = f"{bit}..{bit + width - 2}" if width > 2 else bit
            part["sign"] = bit + width - 1
        if type_ is not None:
            part["type"] = type_.name
        self.parts[part["name"]] = self.part_kind(number, part, type_, width)
        return self.said(part, False)

    def make_flags_in_place(self, number: str, bit: int, width: int) -> Kind:
        """Makes flags at some bits of an integer."""
        masks = [1 << (bit + self.random.randrange(width))]
        return self.flag_set(self.unique("Upper"), number, masks)

    def make_digits(self) -> Kind:
        """Makes decimal digits in one integer."""
        number = self.random.choice(UNSIGNED)
        high, middle, low = (self.unique(word) for word in ("high_", "middle_", "low_"))
        parts = [
            self.part(high, divide=10),
            self.part(middle, divide=10, modulo=10),
            self.part(low, modulo=10),
        ]
        for part in parts[1:]:
            self.parts[part["name"]] = Kind("", 0, 0, number=number, limits=(0, 9))
        display = "{%s}.{%s:02}" % (high, low)
        return self.add_packed(number, {"type": number, "display": display, "parts": parts})

    def make_versions(self) -> None:
        """Makes the format of versions."""
        parts = [
            self.part("major", divide=1000),
            self.part("minor", divide=10, modulo=100),
            self.part("beta", modulo=10),
        ]
        later = {"from": 2730, "display": "{major}.{minor:02}[.{beta}]"}
        firmware: Node = {"type": "u16", "display": "{major}.{minor:02}[b{beta}]", "parts": parts}
        firmware |= self.perhaps(0.5, later_display=later)
        parts = [self.part("major", divide=10), self.part("minor", modulo=10)]
        board = {"type": "u8", "display": "{major}.{minor}", "parts": parts}
        packed = self.section(self.any_family(), "packed")
        packed.update(FirmwareVersion=self.sourced(firmware), BoardVersion=self.sourced(board))

    def add_packed(self, number: str, node: Node) -> Kind:
        """Adds the entry of a packed integer."""
        name = self.unique("Packed")
        self.section(self.any_family(), "packed")[name] = self.sourced(node)
        names = [part["name"] for part in node["parts"]]
        known = tuple((name, self.parts[name]) for name in names if name in self.parts)
        return replace(scalar(number), name=name, parts=known)

    def make_variables(self) -> None:
        """Makes adjustable variables, or none at all."""
        for identity in self.random.sample(range(256), self.random.choice((0, 1, 3))):
            kinds = [scalar(n) for n in INTEGERS]
            kinds += [k for k in self.quantities if k.number in INTEGERS]
            kind = self.random.choice(kinds)
            low, high = sorted(self.random.randint(*INTEGERS[kind.number]) for _ in range(2))
            node = {"id": identity, "type": kind.name, "range": f"{low}..{high}"}
            node |= self.perhaps(0.3, since=self.since())
            self.section(self.any_family(), "variables")[self.unique("VARIABLE_")] = self.said(node)
