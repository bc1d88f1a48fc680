"""Compares the facts of the specification's text with the exported model."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import Any

from documents import SIZES, Check, Json, Model, Ours, Table, our_elements, version

TYPES = {"1u": "u8", "1s": "i8", "2u": "u16", "2s": "i16", "4u": "u32", "4s": "i32", "4f": "f32"}
UNITS = {
    "degree": "deg",
    "degrees": "deg",
    "degree/sec": "deg/s",
    "degrees/sec²": "deg/s^2",
    "degrees/sec ²": "deg/s^2",
    "volt": "V",
    "Celsius": "degC",
    "G": "g",
    "milliseconds": "ms",
    "percents": "%",
    "bytes": "byte",
    "gyro sensor unit": "gyro unit",
    "of gyro sensor's units": "gyro unit",
    "of gyro sensor units": "gyro unit",
}


@dataclass(frozen=True)
class Element:
    """An element of a body in the text: a number, a run of bytes, or a variable part."""

    name: str
    type: str
    size: int
    line: int
    index: str
    fact: Json

    @property
    def is_reserved(self) -> bool:
        return self.type.startswith("bytes ") and self.name.upper() == "RESERVED"

    def is_same(self, ours: Ours) -> bool:
        """Returns True for an element of the model with this name and type."""
        return same_name(self.name, ours.name) and self.type == ours.type


def text_elements(body: Json) -> list[Element]:
    """Returns the elements of a body; an array yields each of its elements."""
    found = []
    for field in body["fields"]:
        notation = field["type"]
        size = 0
        if notation.endswith("b"):
            size = int(notation[:-1])
            type_ = f"bytes {size}"
        elif notation in TYPES or notation == "float":
            type_ = TYPES.get(notation, notation)
            size = SIZES[type_] if field["count"] else 0
        else:
            type_ = notation
        for _ in range(field["count"] or 1):
            index = str(field.get("index", ""))
            found.append(Element(field["name"], type_, size, field["line"], index, field))
    return found


def same_name(said: str, ours: str) -> bool:
    """Returns True if the names are equal, except for the case of 'reserved'."""
    return said == ours or said.upper() == ours == "RESERVED"


def body_paths(message: Json) -> list[str]:
    """Returns the paths of a body's leaves; included reserved ones have other numbers."""
    return [re.sub(r"reserved_\d", "reserved", leaf["path"]) for leaf in message["layout"]]


class Comparison(Model):
    """All checks of the facts against the model.

    `later` are the leaves that the notes on the later protocol tell about: by message, direction and
    path. They may have names for bytes that are reserved in the text.
    """

    def __init__(
        self, facts: Json, model: Json, table: Table, later: Collection[tuple[str, str, str]] = ()
    ) -> None:
        super().__init__(model)
        self.facts = facts
        self.table = table
        self.later = later
        self.described: set[tuple[str, str]] = set()  # (message, path) with a range in the text
        self.measured: set[tuple[str, str]] = set()  # (message, path) with a unit in the text
        self.named: set[tuple[str, int]] = set()  # constants of the text
        self.met: set[tuple[str, str]] = set()  # (message, direction) with a body in the text
        self.compared: set[tuple[str, str, str]] = set()  # leaves: message, direction, path

    def run(self) -> Iterator[Check]:
        yield from self.defines()
        yield from self.framing()
        yield from self.notation()
        for body in self.facts["bodies"]:
            yield from self.body(body)
        for row in self.facts["rows"]:
            yield from self.row(row)
        yield from self.codes()
        yield from self.answers()
        yield from self.variables()
        yield from self.additions()

    # Ids, framing and notation

    def defines(self) -> Iterator[Check]:
        for define in self.facts["defines"]:
            name, line = define["name"], define["line"]
            command = self.commands.get(name, {})
            yield Check("id", line, name, define["value"], command.get("id"))
            yield Check("board", line, name, define.get("board"), version(command, "board"))

    def framing(self) -> Iterator[Check]:
        framing = self.model["framings"][0]  # v1, the only one of the text
        parts = [f for f in self.facts["framing"] if f["part"] != "example"]
        header = [f for f in parts if not f["part"].startswith("body")]
        yield Check("framing", parts[0]["line"], "start", parts[0]["value"], framing["start"])
        yield Check("framing", parts[0]["line"], "header", len(header), framing["header_size"])
        trailer = len(parts) - len(header)
        yield Check("framing", parts[-1]["line"], "trailer", trailer, framing["trailer_size"])
        for example in (f for f in self.facts["framing"] if f["part"] == "example"):
            said = example["bytes"]
            id_ = self.commands["CMD_READ_PARAMS"]["id"]
            ours = [framing["start"], id_, 1, (id_ + 1) % 256, 1, 1]
            yield Check("framing", example["line"], "example", said, ours)

    def notation(self) -> Iterator[Check]:
        known = {fact["type"] for fact in self.facts["notation"]}
        seen = set()
        for body in self.facts["bodies"]:
            for field in body["fields"]:
                notation = re.sub(r"^\d+b$", "Nb", field["type"])
                if notation not in seen and notation != "variable":
                    seen.add(notation)
                    said = "defined" if notation in known else "undefined"
                    yield Check("notation", field["line"], notation, said, "defined")

    # Bodies

    def command_of(self, name: str, line: int) -> tuple[Check, str | None]:
        """Checks that a command has an id; returns its name in the model otherwise."""
        known = self.commands.get(name, {}).get("id") is not None
        check = Check("command", line, name, name, name if known else None)
        if known:
            return check, name
        entry = self.table.find("command", line, name)
        ours = entry["ours"] if entry else None
        return Check("command", line, name, name, ours), ours

    def message_of(self, body: Json, command: str) -> tuple[Check, Json | None]:
        """Returns the message for a body of the text, by direction and form."""
        forms = {m.get("form_name"): m for m in self.messages_of(command, body["direction"])}
        said = body["form"]
        entry = self.table.find("form", body["line"], command)
        if entry:
            return Check("form", body["line"], command, said, entry["ours"]), forms[entry["ours"]]
        if said in forms:
            return Check("form", body["line"], command, said, said), forms[said]
        # The only form of a command, in the text or in the model, is the simple one.
        simple = forms.get("simple" if said is None else None) if said in (None, "simple") else None
        ours = said if simple else sorted(str(form) for form in forms)
        return Check("form", body["line"], command, said, ours), simple

    def body(self, body: Json) -> Iterator[Check]:
        check, command = self.command_of(body["command"], body["line"])
        yield check
        if command is None:
            return
        check, message = self.message_of(body, command)
        yield check
        if message is None:
            yield Check("body", body["line"], command, body["direction"], None)
            return
        yield Check("body", body["line"], command, body["direction"], message["direction"])
        self.met.add((message["name"], message["direction"]))
        if "since" in body:
            since = version(message)
            yield Check("since", body["line"], message["name"], body["since"], since)
        if "same_as" in body:
            yield from self.same_body(body, command, message)
        if body["fields"]:
            yield from self.fields(body, message)
        elif "same_as" not in body:
            grown = all(self.is_later(message, leaf) for leaf in message["layout"])
            ours = message["min_size" if grown else "max_size"]
            yield Check("size", body["line"], message["name"], 0, ours)

    def is_later(self, message: Json, leaf: Json) -> bool:
        """Returns True if a leaf is newer than the text, according to the notes."""
        key = (message["name"], message["direction"], leaf["path"])
        return "since" in leaf and key in self.later

    def same_body(self, body: Json, command: str, message: Json) -> Iterator[Check]:
        """'Same structure as': equal layouts; 'same meaning': equal fields of the same name."""
        other = body["same_as"]
        if other.endswith("_xx"):  # "the corresponding command"
            other = command.replace("WRITE", "READ")
        opposite = "from_board" if body["direction"] == "to_board" else "to_board"
        direction = body["direction"] if body["fields"] else opposite
        models = self.messages_of(other, direction)
        own = {leaf["spec_name"]: leaf for leaf in message["layout"]}
        direction_of = message["direction"]
        if not models:
            yield Check("same body", body["line"], command, other, None)
        elif not body["fields"]:
            shape, theirs = (
                [(f["path"], f["type"], f["count"], f["offset"]) for f in one["layout"]]
                for one in (message, models[0])
            )
            ours = other if shape == theirs else "another body"
            self.compared |= {(message["name"], direction_of, f["path"]) for f in message["layout"]}
            yield Check("same body", body["line"], command, other, ours)
        else:
            for leaf in models[0]["layout"]:
                mine = own.get(leaf["spec_name"])
                if mine:
                    said = (leaf["type"], leaf.get("packed"))
                    have = (mine["type"], mine.get("packed"))
                    yield Check("same field", body["line"], leaf["spec_name"], said, have)

    def fields(self, body: Json, message: Json) -> Iterator[Check]:
        """Checks names, order, types, offsets and remarks of the fields of one body."""
        where = message["name"]
        waiting = our_elements(message)
        offset: int | None = 0  # None after a part of varying size
        for element in text_elements(body):
            name, line = f"{where}.{element.name}", element.line
            extra, found, is_named = self.take(waiting, element, name, message)
            for ours in extra:
                yield Check("extra field", line, f"{where}.{ours.name}", None, ours.type)
                offset = None if offset is None else offset + ours.size
            if not found:
                yield Check("field", line, name, element.name, None)
                continue
            ours = found[0]
            if element.index.startswith("<") or not element.size:
                offset = None
            if offset is not None:
                yield Check("offset", line, name, offset, ours.offset)
                offset += element.size
            if not is_named:
                for kind in ("field", "type"):
                    yield Check(kind, line, name, element.name, element.name)
                continue
            self.compared.add((where, message["direction"], ours.path))
            said = element.name.upper() if ours.name == "RESERVED" else element.name
            yield Check("field", line, name, said, ours.name)
            yield Check("type", line, name, element.type, self.type_said(element, ours))
            if element.index and element.index.isalpha():
                word = element.index.lower()
                has = element.index if word in ours.path.split(".") else ours.path
                yield Check("index", line, name, element.index, has)
            yield from self.remarks(element.fact, line, name, [ours.leaf], where)
        for ours in waiting:
            if not ours.leaf.get("when"):
                name = f"{where}.{ours.name}"
                yield Check("extra field", body["line"], name, None, ours.type)
        if offset is not None:
            for key in ("max_size", "min_size"):
                yield Check("size", body["line"], where, offset, message[key])

    def take(
        self, waiting: list[Ours], element: Element, name: str, message: Json
    ) -> tuple[list[Ours], list[Ours], bool]:
        """Takes the elements of the model before an element of the text, then what is that element, by name or not.

        Reserved bytes may be several elements now, of the same size, which are reserved or known to the notes.
        The elements of a variable part are those under a condition, if none has its name.
        """
        if element.is_reserved and waiting and not element.is_same(waiting[0]):
            for start in range(min(2, len(waiting))):
                size = 0
                for end, ours in enumerate(waiting[start:], start + 1):
                    known = (message["name"], message["direction"], ours.path) in self.later
                    if not ours.size or not (known or ours.name == "RESERVED"):
                        break
                    size += ours.size
                    if size == element.size:
                        taken, waiting[:] = waiting[:end], waiting[end:]
                        return taken[:start], taken[start:], False
        entry = self.table.find("field", element.line, name)
        wanted = entry["ours"] if entry else element.name
        places = (i for i, o in enumerate(waiting) if wanted and same_name(wanted, o.name))
        place = next(places, None)
        before = waiting[:place]
        found = [] if place is None else [waiting[place]]
        rest = [] if place is None else waiting[place + 1 :]
        if element.type == "variable":
            optional = [ours for ours in before if ours.leaf.get("when")]
            before = [ours for ours in before if not ours.leaf.get("when")]
            found = found or optional
        if place is None:
            before, rest = [], before
        waiting[:] = rest
        return before, found, place is not None

    def type_said(self, element: Element, ours: Ours) -> str:
        if element.type == "variable" and ours.leaf["count"] is None:
            return "variable"
        return ours.type

    # The table of variables

    def row(self, row: Json) -> Iterator[Check]:
        several = row.get("units", []) if len(row["names"]) > 1 else []
        for number, said in enumerate(row["names"]):
            name = re.sub(r"\[.*", "", said)
            commands = row["commands"]
            where = f"{commands[0]}.{name}"
            leaves, check = self.row_leaves(row, name, where)
            yield check
            self.compared |= {(m["name"], m["direction"], leaf["path"]) for m, leaf in leaves}
            if not leaves:
                continue
            line = row["line"]
            type_ = TYPES.get(row["type"], row["type"].replace("8b", "bytes"))
            yield Check("row type", line, where, type_, self.one(f["type"] for _, f in leaves))
            for key in ("min", "max"):
                if key in row:
                    ours = self.one(leaf[key] for _, leaf in leaves)
                    yield Check(key, line, where, row[key], ours)
            if "min" in row or "max" in row or "ranges" in row:
                self.described |= {(m["name"], leaf["path"]) for m, leaf in leaves}
            array = re.search(r"\[(\d+)\]", said)
            if array:
                counts = self.one(
                    sum(f["count"] or 0 for n, f in leaves if n is m) for m, _ in leaves
                )
                yield Check("count", line, where, int(array[1]), counts)
            if "version" in row:
                versions = self.one(version(m) for m, _ in leaves)
                yield Check("since", line, where, row["version"], versions)
            remark = dict(row)
            if len(several) == len(row["names"]) > 1:
                remark["units"] = [several[number]]
            yield from self.remarks(remark, line, where, [leaf for _, leaf in leaves], "", leaves)

    def row_leaves(self, row: Json, name: str, where: str) -> tuple[list[tuple[Json, Json]], Check]:
        """Returns the leaves that a name of the table refers to, and the check that they exist."""
        entry = self.table.find("row", row["line"], where)
        wanted = [name] if entry is None else str(entry["ours"] or "").split()
        found = [
            (message, leaf)
            for message in self.messages
            if message["command"] in row["commands"]
            and self.is_old(message)
            and row.get("direction", message["direction"]) == message["direction"]
            for leaf in message["layout"]
            if any(fnmatchcase(leaf["spec_name"], pattern) for pattern in wanted)
        ]
        commands = {message["command"] for message, _ in found}
        complete = commands == set(row["commands"])
        ours = (entry["ours"] if entry else name) if complete else None
        return found, Check("row", row["line"], where, name, ours)

    def is_old(self, message: Json) -> bool:
        """Returns False for a form that only the notes have."""
        key = (message["name"], message["direction"])
        return (
            key in self.met
            or message["form"] is None
            or not message["layout"]
            or ((*key, message["layout"][0]["path"]) not in self.later)
        )

    def one(self, values: Iterable[Any]) -> Any:
        """Returns the value if all are equal, else the list of distinct values."""
        found: list[Any] = []
        for value in values:
            if value not in found:
                found.append(value)
        return found[0] if len(found) == 1 else found

    # Remarks of fields and rows

    def remarks(
        self,
        fact: Json,
        line: int,
        name: str,
        leaves: list[Json],
        message: str,
        owners: list[tuple[Json, Json]] | None = None,
    ) -> Iterator[Check]:
        """Checks constants, values, bits, units etc., which every leaf must have."""

        for constant in fact.get("constants", []):
            at = constant.get("line", line)
            label = f"{name}.{constant['name']}"
            said = f"{constant['name']} = {constant['value']}"
            entry = self.table.find("constant", at, f"{label}={constant['value']}")
            wanted = str(entry["ours"]).partition(" = ")[0] if entry else constant["name"]
            known = [self.constant(f, wanted, constant["value"]) for f in leaves]
            ours = self.one(v and f"{wanted} = {v['value']}" for v in known)
            self.named.add((wanted, constant["value"]))
            yield Check("constant", at, f"{label}={constant['value']}", said, ours)
            if "board" in constant:
                board = self.one(version(v, "board") for v in known)
                yield Check("board", at, label, constant["board"], board)
        tests: tuple[tuple[str, str, str, Callable[[Json, Any], bool]], ...] = (
            ("values", "value", "={}", self.has_value),
            ("special", "special", "={}", self.is_special),
            ("bits", "bits", "[{0[0]}..{0[1]}]", self.has_bits),
            ("since", "since", "", lambda leaf, said: said in self.versions(leaf)),
            ("digits", "digits", ".{0[0]}", self.digits_agree),
        )
        for key, kind, suffix, test in tests:
            for said in fact.get(key, []):
                ours = said if all(test(leaf, said) for leaf in leaves) else None
                yield Check(kind, line, name + suffix.format(said), said, ours)
        for low, high in fact.get("ranges", []):
            limits = self.one((f["min"], f["max"]) for f in leaves)
            if low == 0 and leaves[0].get("max_count") is not None:
                limits = (low, leaves[0]["max_count"])
            yield Check("range", line, f"{name}[{low}..{high}]", (low, high), limits)
        for unit in fact.get("units", []):
            yield self.unit(unit, line, name, leaves)
            pairs = owners or [({"name": message}, leaf) for leaf in leaves]
            self.measured |= {(m["name"], leaf["path"]) for m, leaf in pairs}
        for align in fact.get("align", []):
            yield Check("align", line, name, align, self.one(f.get("align", 1) for f in leaves))
        for field, command in fact.get("references", []):
            others = [
                leaf
                for message in self.messages
                if message["command"] == command
                for leaf in message["layout"]
                if leaf["spec_name"] == field
            ]
            pairs = owners or [({"name": message}, leaf) for leaf in leaves]
            self.measured |= {(m["name"], leaf["path"]) for m, leaf in pairs}
            meaning = ("type", "enum", "packed", "unit", "scale", "min", "max")
            said = self.one([f.get(key) for key in meaning] for f in others)
            have = self.one([f.get(key) for key in meaning] for f in leaves)
            yield Check("reference", line, name, said, have)
        for part in fact.get("parts", []):
            cases = {c["spec_name"].lower(): c["type"] for f in leaves for c in f.get("cases", [])}
            said = TYPES[part["type"]]
            yield Check("part", line, f"{name}.{part['name']}", said, cases.get(part["name"]))

    def enums_of(self, leaf: Json) -> list[tuple[Json, int]]:
        """Returns the enums of a leaf that come from these sources, each with the shift of its values."""
        found = [(self.enums[leaf["enum"]], 0)] if leaf["enum"] in self.enums else []
        packed = self.packed.get(leaf.get("packed", ""))
        if packed:
            if packed["names"]:
                found.append((self.enums[packed["names"]], 0))
            parts = [p for p in packed["parts"] if p["enum"]]
            found += [(self.enums[p["enum"]], p["shift"]) for p in parts]
        for case in leaf.get("cases", []):
            found += self.enums_of(case)
        return found

    def constant(self, leaf: Json, name: str, number: int) -> Json | None:
        """Returns the enum value of this name; a number such as 115200 may have a prefix."""
        found = None
        for value in [v for enum, _ in self.enums_of(leaf) for v in enum["values"]]:
            is_number = name.isdigit() and value["name"].endswith(f"_{name}")
            if value["name"] == name or is_number:
                found = value if found is None or value["value"] == number else found
        return found

    def has_value(self, leaf: Json, value: int) -> bool:
        if str(value) in leaf.get("special", {}):
            return True
        for enum, shift in self.enums_of(leaf):
            values = [v["value"] for v in enum["values"]]
            union = 0
            for one in values:
                union |= one
            if value in values or (enum["kind"] == "flags" and not value & ~union):
                return True
        if leaf["min"] is not None and not leaf["enum"]:
            return bool(leaf["min"] <= value <= leaf["max"])
        parts = self.parts(leaf)
        return any(not p["enum"] and 0 <= value <= p["mask"] >> p["shift"] for p in parts)

    def is_special(self, leaf: Json, value: int) -> bool:
        named = any(v["value"] == value for enum, _ in self.enums_of(leaf) for v in enum["values"])
        return named or str(value) in leaf.get("special", {})

    def has_bits(self, leaf: Json, bits: list[int]) -> bool:
        first, last = bits
        mask = ((1 << (last - first + 1)) - 1) << first
        parts = self.parts(leaf)
        masks = [p["mask"] for p in parts if p["mask"] is not None]
        union = 0
        for one in masks:
            union |= one if not one & ~mask else 0
        if union == mask:
            return True
        flags = [1 << i for i in range(first, last + 1)]
        named = {v["value"] for enum, _ in self.enums_of(leaf) for v in enum["values"]}
        reserved = len(flags) > 1 and not any(value & mask for value in named)
        return reserved or all(flag in named for flag in flags)

    def unit(self, unit: Json, line: int, name: str, leaves: list[Json]) -> Check:
        """Checks scale and unit, of the field itself or of the alternative that a flag chooses."""
        scale = float(unit.get("number", 1)) / float(unit.get("divisor", 1))
        word = unit.get("unit")
        said = (scale, UNITS.get(str(word), word), float(unit.get("add", 0)))
        have = []
        for leaf in leaves:
            mine = (leaf["scale"] or 1, leaf["unit"], leaf.get("add", 0))
            other = leaf.get("alternative")
            options = [mine] + ([(other["scale"], other["unit"], 0)] if other else [])
            for part in self.parts(leaf):
                if part["divide"]:
                    options.append((1 / part["divide"], None, 0))
            near = [o for o in options if abs(o[0] / scale - 1) < 2e-6 and o[1:] == said[1:]]
            have.append(said if near else mine)
        return Check("unit", line, name, said, self.one(have))

    def versions(self, leaf: Json) -> set[str]:
        notes = [leaf.get("since"), (leaf.get("deprecated") or {}).get("since")]
        notes += [v["since"] for enum, _ in self.enums_of(leaf) for v in enum["values"]]
        return {note["firmware"] for note in notes if note and "firmware" in note}

    def digits_agree(self, leaf: Json, digits: tuple[str, list[str]]) -> bool:
        """Returns True if a part of a decimal number matches the formula."""
        name, operations = digits
        part = next((p for p in self.parts(leaf) if p["name"] == name), None)
        if part is None:
            return False
        for raw in (0, 2305, 2439, 2550, 2599, 3129):
            value = raw
            for operation in operations:
                number = int(operation[1:])
                value = value // number if operation[0] == "/" else value % number
            ours = raw // part["divide"]
            if value != (ours % part["modulo"] if part["modulo"] else ours):
                return False
        return True

    # Codes, responses, variables

    def codes(self) -> Iterator[Check]:
        enums = {
            leaf["enum"]
            for message in self.messages
            for leaf in message["layout"]
            if leaf["spec_name"] == "ERR_CODE"
        }
        values = {v["name"]: v["value"] for e in enums for v in self.enums[e]["values"]}
        for code in self.facts["codes"]:
            name, value = code["name"], code["value"]
            self.named.add((name, value))
            ours = f"{name} = {values.get(name)}"
            yield Check("constant", code["line"], name, f"{name} = {value}", ours)

    def answers(self) -> Iterator[Check]:
        command_of = {m["name"]: m["command"] for m in self.messages}
        for fact in self.facts["answers"]:
            answers = set()
            for message in self.messages:
                response = message["response"]
                if message["command"] == fact["command"] and response:
                    answers |= {command_of[name] for name in response["messages"]}
                    if response["confirm"] != "never":
                        answers.add("CMD_CONFIRM")
            said = fact["answer"]
            ours = said if said in answers else sorted(answers)
            yield Check("answer", fact["line"], fact["command"], said, ours)

    def variables(self) -> Iterator[Check]:
        by_name = {v["name"]: v for v in self.model["adjustable_variables"]}
        for fact in self.facts["variables"]:
            line, said = fact["line"], fact["name"]
            entry = self.table.find("variable", line, said)
            name = str(entry["ours"]) if entry else said
            ours = by_name.get(name)
            self.named.add((name, fact["id"]))
            yield Check("variable", line, said, said, name if ours else None)
            if ours is None:
                continue
            for key in ("id", "type", "min", "max"):
                number = TYPES.get(fact[key], fact[key])
                yield Check(f"variable {key}", line, name, number, ours[key])
            for unit in fact.get("units", []):
                yield self.unit(unit, line, name, [ours])
            for value in fact.get("values", []) + fact.get("special", []):
                inside = value if ours["min"] <= value <= ours["max"] else None
                yield Check("value", line, f"{name}={value}", value, inside)

    # Facts of the model beyond the text

    def additions(self) -> Iterator[Check]:
        """Checks messages, limits, units and names without a fact in the text."""
        bodies = [(message["name"], body_paths(message)) for message in self.messages]
        for message, (name, paths) in zip(self.messages, bodies):
            if (name, message["direction"]) not in self.met:
                yield Check("extra message", 0, name, None, message["direction"])
            # Other messages that have the same body, or whose body starts this one.
            same = [
                other
                for other, theirs in bodies
                if theirs == paths or (len(theirs) > 9 and paths[: len(theirs)] == theirs)
            ]
            seen: set[str] = set()
            for leaf in message["layout"]:
                keys = {(n, leaf["path"]) for n in same} | {(name, leaf["path"])}
                label = f"{name}.{leaf['spec_name']}"
                if label in seen:
                    continue
                seen.add(label)
                if leaf["min"] is not None and not keys & self.described:
                    limits = f"{leaf['min']}..{leaf['max']}"
                    yield Check("extra range", 0, label, None, limits)
                if leaf["scale"] is not None and not keys & self.measured:
                    yield Check("extra unit", 0, label, None, leaf["quantity"])
        names = {name for name, _ in self.named}
        for enum in self.model["enums"]:
            for value in enum["values"] if not enum["name"].startswith("Command") else []:
                if value["named_by_specification"] and value["name"] not in names:
                    label = f"{enum['name']}.{value['name']}"
                    yield Check("extra constant", 0, label, None, value["value"])
        known = {d["name"] for d in self.facts["defines"]}
        for command in self.model["commands"]:
            if command["name"] not in known:
                yield Check("extra command", 0, command["name"], None, command["id"])
        variables = {name for name, _ in self.named}
        for variable in self.model["adjustable_variables"]:
            if variable["name"] not in variables:
                yield Check("extra variable", 0, variable["name"], None, variable["id"])
