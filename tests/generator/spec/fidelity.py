"""Compares the facts of the specification's text with the exported model."""

from __future__ import annotations

import re
from collections.abc import Callable, Generator, Iterable, Iterator
from fnmatch import fnmatchcase
from typing import Any

from documents import SIZES, Check, Element, Json, Model, Table, Told, our_elements, version

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
Owned = list[tuple[Json, Json]]  # leaves, each with its message
Test = Callable[[Json, Any], bool]


def text_elements(body: Json) -> Iterator[Element]:
    """Yields the elements of a body; an array yields each of its elements."""
    for field in body["fields"]:
        notation, count = field["type"], field["count"]
        if notation.endswith("b"):
            type_, size = f"bytes {notation[:-1]}", int(notation[:-1])
        else:
            type_ = TYPES.get(notation, notation)
            size = SIZES.get(type_, 0) if count else 0
        yield from [Element(field["name"], type_, size, field)] * (count or 1)


def same_name(said: str, ours: str) -> bool:
    """Returns True if the names are equal, except for the case of 'reserved'."""
    return said == ours or said.upper() == ours == "RESERVED"


def one(values: Iterable[Any]) -> Any:
    """Returns the value if all are equal, else the list of distinct values."""
    every = list(values)
    found = [value for place, value in enumerate(every) if value not in every[:place]]
    return found[0] if len(found) == 1 else found


class Comparison(Model):
    """All checks of the facts against the model.

    `later` is what the notes on the later protocol tell about; it may name bytes that are reserved in the text.
    """

    def __init__(self, facts: Json, model: Json, table: Table, later: Told) -> None:
        super().__init__(model)
        self.facts = facts
        self.table = table
        self.later = later

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

    # Ids, framing and notation

    def defines(self) -> Iterator[Check]:
        for define in self.facts["defines"]:
            name, line = define["name"], define["line"]
            command = self.commands.get(name, {})
            yield Check("id", line, name, define["value"], command.get("id"))
            yield Check("board", line, name, define.get("board"), version(command, "board"))
            self.told.labels.add(("command", name))

    def framing(self) -> Iterator[Check]:
        framing = self.model["framings"][0]  # v1, the only one of the text
        parts = [f for f in self.facts["framing"] if f["part"] != "example"]
        header = [f for f in parts if not f["part"].startswith("body")]
        first, last, trailer = parts[0]["line"], parts[-1]["line"], len(parts) - len(header)
        yield Check("framing", first, "start", parts[0]["value"], framing["start"])
        yield Check("framing", first, "header", len(header), framing["header_size"])
        yield Check("framing", last, "trailer", trailer, framing["trailer_size"])
        for example in (f for f in self.facts["framing"] if f["part"] == "example"):
            id_ = self.commands["CMD_READ_PARAMS"]["id"]
            ours = [framing["start"], id_, 1, (id_ + 1) % 256, 1, 1]
            yield Check("framing", example["line"], "example", example["bytes"], ours)

    def notation(self) -> Iterator[Check]:
        known = {fact["type"] for fact in self.facts["notation"]}
        seen = {"variable"}
        for field in (field for body in self.facts["bodies"] for field in body["fields"]):
            notation = re.sub(r"^\d+b$", "Nb", field["type"])
            if notation not in seen:
                seen.add(notation)
                said = "defined" if notation in known else "undefined"
                yield Check("notation", field["line"], notation, said, "defined")

    # Bodies

    def command_of(self, name: str, line: int) -> Generator[Check, None, str | None]:
        """Checks that a command has an id; returns its name in the model."""
        ours: str | None = name
        if self.commands.get(name, {}).get("id") is None:
            entry = self.table.find("command", line, name)
            ours = entry["ours"] if entry else None
        yield Check("command", line, name, name, ours)
        return ours

    def message_of(self, body: Json, command: str) -> Generator[Check, None, Json | None]:
        """Checks and returns the message for a body of the text, by direction and form."""
        forms = {m.get("form_name"): m for m in self.messages_of(command, body["direction"])}
        said, line = body["form"], body["line"]
        entry = self.table.find("form", line, command)
        wanted = entry["ours"] if entry else said
        if wanted not in forms and said in (None, "simple"):
            # The only form of a command, in the text or in the model, is the simple one.
            wanted = "simple" if said is None else None
        found = forms.get(wanted)
        ours = said if found else sorted(str(form) for form in forms)
        yield Check("form", line, command, said, entry["ours"] if entry else ours)
        return found

    def body(self, body: Json) -> Iterator[Check]:
        line, direction = body["line"], body["direction"]
        command = yield from self.command_of(body["command"], line)
        if command is None:
            return
        message = yield from self.message_of(body, command)
        yield Check("body", line, command, direction, message and message["direction"])
        if message is None:
            return
        self.told.messages.add((message["name"], direction))
        if "since" in body:
            yield Check("since", line, message["name"], body["since"], version(message))
        if "same_as" in body:
            yield from self.same_body(body, command, message)
        if body["fields"]:
            yield from self.fields(body, message)
        elif "same_as" not in body:
            grown = all("since" in f and self.is_later(message, f) for f in message["layout"])
            ours = message["min_size" if grown else "max_size"]
            yield Check("size", line, message["name"], 0, ours)

    def is_later(self, message: Json, leaf: Json) -> bool:
        """Returns True if the notes tell about a leaf."""
        return (message["name"], message["direction"], leaf["path"]) in self.later.leaves

    def same_body(self, body: Json, command: str, message: Json) -> Iterator[Check]:
        """'Same structure as': equal layouts; 'same meaning': equal fields of the same name."""
        line, direction, other = body["line"], body["direction"], body["same_as"]
        if other.endswith("_xx"):  # "the corresponding command"
            other = command.replace("WRITE", "READ")
        opposite = "from_board" if direction == "to_board" else "to_board"
        others = self.messages_of(other, direction if body["fields"] else opposite)
        if not others:
            yield Check("same body", line, command, other, None)
        elif body["fields"]:
            own = {leaf["spec_name"]: leaf for leaf in message["layout"]}
            for leaf in others[0]["layout"]:
                name = leaf["spec_name"]
                if name in own:
                    types = [(f["type"], f.get("packed")) for f in (leaf, own[name])]
                    yield Check("same field", line, name, *types)
        else:
            theirs, mine = (
                [(f["path"], f["type"], f["count"], f["offset"]) for f in m["layout"]]
                for m in (others[0], message)
            )
            ours = other if theirs == mine else "another body"
            self.told.add(message, message["layout"])
            yield Check("same body", line, command, other, ours)

    def fields(self, body: Json, message: Json) -> Iterator[Check]:
        """Checks names, order, types, offsets and remarks of the fields of one body."""
        where = message["name"]
        waiting = our_elements(message)
        offset: int | None = 0  # None after a part of varying size
        for element in text_elements(body):
            name, line = f"{where}.{element.name}", element.line
            index = str(element.fact.get("index", ""))
            extra, found, is_named = self.take(waiting, element, name, message)
            yield from self.extra(line, where, extra)
            offset = None if offset is None else offset + sum(ours.size for ours in extra)
            if not found:
                yield Check("field", line, name, element.name, None)
                continue
            ours = found[0]
            if index.startswith("<") or not element.size:
                offset = None
            if offset is not None:
                yield Check("offset", line, name, offset, ours.offset)
                offset += element.size
            if not is_named:
                for kind in ("field", "type"):
                    yield Check(kind, line, name, element.name, element.name)
                continue
            self.told.add(message, [ours.fact])
            said = element.name.upper() if ours.name == "RESERVED" else element.name
            yield Check("field", line, name, said, ours.name)
            is_variable = element.type == "variable" and ours.fact["count"] is None
            yield Check("type", line, name, element.type, "variable" if is_variable else ours.type)
            if index.isalpha():
                has = index if index.lower() in ours.path.split(".") else ours.path
                yield Check("index", line, name, index, has)
            yield from self.remarks(element.fact, name, [(message, ours.fact)])
        yield from self.extra(body["line"], where, (o for o in waiting if not o.fact.get("when")))
        if offset is not None:
            for key in ("max_size", "min_size"):
                yield Check("size", body["line"], where, offset, message[key])

    def extra(self, line: int, where: str, elements: Iterable[Element]) -> Iterator[Check]:
        """Yields the elements that neither the text nor the notes have."""
        for name, type_ in ((f"{where}.{ours.name}", ours.type) for ours in elements):
            if ("field", name) not in self.later.labels:
                yield Check("extra field", line, name, None, type_)

    def take(
        self, waiting: list[Element], element: Element, name: str, message: Json
    ) -> tuple[list[Element], list[Element], bool]:
        """Takes the elements of the model before an element of the text, then what is that element, by name or not.

        Reserved bytes may be several elements now, of the same size, which are reserved or known to the notes.
        The elements of a variable part are those under a condition, if none has its name.
        """
        ours = waiting[0] if waiting else element
        is_same = same_name(element.name, ours.name) and element.type == ours.type
        if element.type.startswith("bytes ") and element.is_reserved and not is_same:
            for start in range(min(2, len(waiting))):
                size = 0
                for end, ours in enumerate(waiting[start:], start + 1):
                    known = self.is_later(message, ours.fact) or ours.name == "RESERVED"
                    if not ours.size or not known:
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
            optional = [ours for ours in before if ours.fact.get("when")]
            before = [ours for ours in before if not ours.fact.get("when")]
            found = found or optional
        if place is None:
            before, rest = [], before
        waiting[:] = rest
        return before, found, place is not None

    # The table of variables

    def row(self, row: Json) -> Iterator[Check]:
        line, names, units = row["line"], row["names"], row.get("units", [])
        for number, said in enumerate(names):
            name = said.partition("[")[0]
            where = f"{row['commands'][0]}.{name}"
            found = yield from self.row_leaves(row, name, where)
            if not found:
                continue
            leaves = [leaf for _, leaf in found]
            type_ = TYPES.get(row["type"], row["type"].replace("8b", "bytes"))
            yield Check("row type", line, where, type_, one(f["type"] for f in leaves))
            for key in ("min", "max"):
                if key in row:
                    yield Check(key, line, where, row[key], one(f[key] for f in leaves))
            if {"min", "max", "ranges"} & set(row):
                self.told.says("range", found)
            if array := re.search(r"\[(\d+)\]", said):
                counts = [sum(f["count"] or 0 for n, f in found if n is m) for m, _ in found]
                yield Check("count", line, where, int(array[1]), one(counts))
            if "version" in row:
                yield Check("since", line, where, row["version"], one(version(m) for m, _ in found))
            own = {"units": [units[number]]} if len(units) == len(names) > 1 else {}
            yield from self.remarks({**row, **own}, where, found)

    def row_leaves(self, row: Json, name: str, where: str) -> Generator[Check, None, Owned]:
        """Returns the leaves that a name of the table refers to, and checks that they exist."""
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
        complete = {message["command"] for message, _ in found} == set(row["commands"])
        ours = entry["ours"] if entry else name
        yield Check("row", row["line"], where, name, ours if complete else None)
        for message, leaf in found:
            self.told.add(message, [leaf])
        return found

    def is_old(self, message: Json) -> bool:
        """Returns False for a form that only the notes have."""
        layout = message["layout"]
        is_met = (message["name"], message["direction"]) in self.told.messages
        return is_met or not (message["form"] and layout and self.is_later(message, layout[0]))

    # Remarks of fields and rows

    def remarks(self, fact: Json, name: str, found: Owned) -> Iterator[Check]:
        """Checks constants, values, bits, units etc., which every leaf must have."""
        line, leaves = fact["line"], [leaf for _, leaf in found]
        for constant in fact.get("constants", []):
            yield from self.constant(constant, constant.get("line", line), name, leaves)
        tests: tuple[tuple[str, str, str, Test], ...] = (
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
            limits = one((f["min"], f["max"]) for f in leaves)
            if low == 0 and leaves[0].get("max_count") is not None:
                limits = (low, leaves[0]["max_count"])
            yield Check("range", line, f"{name}[{low}..{high}]", (low, high), limits)
        for unit in fact.get("units", []):
            yield self.unit(unit, line, name, leaves)
        for align in fact.get("align", []):
            yield Check("align", line, name, align, one(f.get("align", 1) for f in leaves))
        for field, command in fact.get("references", []):
            messages = [m for m in self.messages if m["command"] == command]
            others = [f for m in messages for f in m["layout"] if f["spec_name"] == field]
            meaning = ("type", "enum", "packed", "unit", "scale", "min", "max")
            said, ours = (
                one([f.get(key) for key in meaning] for f in fs) for fs in (others, leaves)
            )
            yield Check("reference", line, name, said, ours)
        if {"units", "references"} & set(fact):
            self.told.says("unit", found)
        for part in fact.get("parts", []):
            cases = {c["spec_name"].lower(): c["type"] for f in leaves for c in f.get("cases", [])}
            ours = cases.get(part["name"])
            yield Check("part", line, f"{name}.{part['name']}", TYPES[part["type"]], ours)

    def constant(self, fact: Json, line: int, name: str, leaves: list[Json]) -> Iterator[Check]:
        label, number = f"{name}.{fact['name']}", fact["value"]
        entry = self.table.find("constant", line, f"{label}={number}")
        wanted = str(entry["ours"]).partition(" = ")[0] if entry else fact["name"]
        self.told.labels.add(("constant", wanted))
        found = [self.value_of(leaf, wanted, number) for leaf in leaves]
        ours = one(value and f"{wanted} = {value['value']}" for value in found)
        yield Check("constant", line, f"{label}={number}", f"{fact['name']} = {number}", ours)
        if "board" in fact:
            boards = one(version(value, "board") for value in found)
            yield Check("board", line, label, fact["board"], boards)

    def enums_of(self, leaf: Json) -> list[Json]:
        """Returns the enums of a leaf that come from these sources."""
        packed = self.packed.get(leaf.get("packed", ""), {})
        names = [leaf["enum"], packed.get("names"), *(p["enum"] for p in packed.get("parts", []))]
        found = [self.enums[name] for name in names if name in self.enums]
        return found + [enum for case in leaf.get("cases", []) for enum in self.enums_of(case)]

    def values_of(self, leaf: Json) -> list[Json]:
        return [value for enum in self.enums_of(leaf) for value in enum["values"]]

    def value_of(self, leaf: Json, name: str, number: int) -> Json | None:
        """Returns the enum value of this name; a number such as 115200 may have a prefix."""
        found = None
        for value in self.values_of(leaf):
            is_number = name.isdigit() and value["name"].endswith(f"_{name}")
            if value["name"] == name or is_number:
                found = value if found is None or value["value"] == number else found
        return found

    def has_value(self, leaf: Json, value: int) -> bool:
        for enum in self.enums_of(leaf):
            flags = sum(v["value"] for v in enum["values"]) if enum["kind"] == "flags" else 0
            if flags and not value & ~flags:
                return True
        if self.is_special(leaf, value):
            return True
        if leaf["min"] is not None and not leaf["enum"]:
            return bool(leaf["min"] <= value <= leaf["max"])
        parts = self.parts(leaf)
        return any(not p["enum"] and 0 <= value <= p["mask"] >> p["shift"] for p in parts)

    def is_special(self, leaf: Json, value: int) -> bool:
        named = any(v["value"] == value for v in self.values_of(leaf))
        return named or str(value) in leaf.get("special", {})

    def has_bits(self, leaf: Json, bits: list[int]) -> bool:
        flags = {1 << bit for bit in range(bits[0], bits[1] + 1)}
        mask = sum(flags)
        masks = [p["mask"] for p in self.parts(leaf) if p["mask"] is not None]
        if sum(part for part in masks if not part & ~mask) == mask:
            return True
        named = {v["value"] for v in self.values_of(leaf)}
        reserved = len(flags) > 1 and not any(value & mask for value in named)
        return reserved or flags <= named

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
            options += [(1 / p["divide"], None, 0) for p in self.parts(leaf) if p["divide"]]
            near = [o for o in options if abs(o[0] / scale - 1) < 2e-6 and o[1:] == said[1:]]
            have.append(said if near else mine)
        return Check("unit", line, name, said, one(have))

    def versions(self, leaf: Json) -> set[str]:
        notes = [leaf, leaf.get("deprecated"), *self.values_of(leaf)]
        return {version(note) for note in notes} - {None}

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
        leaves = [leaf for message in self.messages for leaf in message["layout"]]
        enums = {leaf["enum"] for leaf in leaves if leaf["spec_name"] == "ERR_CODE"}
        values = {v["name"]: v["value"] for e in enums for v in self.enums[e]["values"]}
        for code in self.facts["codes"]:
            name = code["name"]
            self.told.labels.add(("constant", name))
            said, ours = (f"{name} = {value}" for value in (code["value"], values.get(name)))
            yield Check("constant", code["line"], name, said, ours)

    def answers(self) -> Iterator[Check]:
        command_of = {m["name"]: m["command"] for m in self.messages}
        for fact in self.facts["answers"]:
            answers = set()
            for message in self.messages:
                response = message["response"]
                if message["command"] == fact["command"] and response:
                    answers |= {command_of[name] for name in response["messages"]}
                    answers |= {"CMD_CONFIRM"} if response["confirm"] != "never" else set()
            said = fact["answer"]
            ours = said if said in answers else sorted(answers)
            yield Check("answer", fact["line"], fact["command"], said, ours)

    def variables(self) -> Iterator[Check]:
        by_name = {v["name"]: v for v in self.model["adjustable_variables"]}
        for fact in self.facts["variables"]:
            line, said = fact["line"], fact["name"]
            entry = self.table.find("variable", line, said)
            name = str(entry["ours"]) if entry else said
            self.told.labels |= {("variable", name), ("constant", name)}
            ours = by_name.get(name)
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
