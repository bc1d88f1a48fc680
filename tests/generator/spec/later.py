"""Compares the facts of the notes on the later protocol with the exported model."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase
from typing import Any

from documents import DATA, SIZES, Check, Json, Model, Ours, Table, loaded, our_elements, version
from fidelity import Comparison

Limits = tuple[int, int]


@dataclass(frozen=True)
class Said:
    """An element of a body in the notes."""

    name: str
    type: str
    fact: Json
    line: int
    several: bool = False


def elements(fields: list[Json], structs: dict[str, Json], mask: int | None = None) -> list[Said]:
    """Returns the elements of a list of fields; an array yields each of its elements."""
    found: list[Said] = []
    for fact in fields:
        if "group" in fact:
            inner = elements(fact["fields"], structs)
            if fact["count"] is None:  # repeated to the end, or as often as a counter says
                inner = [_repeated(part) for part in inner]
            found += [part for _ in range(fact["count"] or 1) for part in inner]
            continue
        own = {**fact, "mask": fact.get("mask", mask)}
        count, type_ = fact["count"], fact["type"]
        if fact["name"] in structs and type_ == "bytes":
            found += elements(structs[fact["name"]]["fields"], structs, own["mask"])
        elif type_ in ("bytes", "text"):
            kind = "variable" if count is None else f"bytes {count}"
            found.append(Said(fact["name"], kind, own, fact["line"]))
        else:
            one = Said(fact["name"], type_, own, fact["line"], (count or 1) > 1)
            found += [one] * (count or 1)
    return found


def _shape(message: Json) -> list[tuple[Any, ...]]:
    keys = ("spec_name", "type", "count", "offset", "unit", "scale", "min", "max", "since")
    return [tuple(leaf.get(key) for key in keys) for leaf in message["layout"]]


def _repeated(part: Said) -> Said:
    type_ = "variable" if part.type.startswith("bytes") else part.type
    return Said(part.name, type_, {**part.fact, "count": None}, part.line)


def said_size(element: Said) -> int | None:
    """Returns the size in bytes, or None if it varies."""
    if element.type == "variable" or element.type == "string" or element.fact["count"] is None:
        return None
    if element.type.startswith("bytes"):
        return int(element.type.split()[1])
    return int(element.type[1:]) // 8


class Later(Model):
    """All checks of the facts against the model; `told` are the leaves that facts are about.

    `values` are the enum values and `known` the additions to rev. 0.15 that the facts know.
    """

    def __init__(self, facts: Json, model: Json) -> None:
        super().__init__(model)
        self.facts = facts
        self.told: set[tuple[str, str, str]] = set()
        self.values: set[tuple[str, int]] = set()
        self.known: set[tuple[str, str]] = set()
        self.structs = {s["name"]: s for s in self.facts["structs"]}
        self.leaves = [
            (message["command"], leaf)
            for message in self.messages
            for top in message["layout"]
            for leaf in [top, *top.get("cases", [])]
        ]
        self.since = {c["name"]: c.get("since") for c in self.facts["commands"]}

    def run(self) -> list[Check]:
        return [
            *self.all_commands(),
            *self.all_bodies(),
            *self.all_offsets(),
            *self.all_enums(),
            *self.all_parts(),
            *self.all_streams(),
            *self.all_variables(),
        ]

    # Commands

    def all_commands(self) -> Iterator[Check]:
        for fact in self.facts["commands"]:
            name, line = fact["name"], fact["line"]
            command = self.commands.get(name, {})
            yield Check("id", line, name, fact["id"], command.get("id"))
            for key, kind in (("since", "firmware"), ("board", "board")):
                yield Check(key, line, name, fact.get(key), version(command, kind))
            messages = [m for m in self.messages if m["command"] == name]
            known = any(len(m["layout"]) != 1 or m["min_size"] for m in messages)
            yield Check("body", line, name, fact["body"], known)
            self.known.add(("extra command", name))
            if not fact["body"]:
                for message in messages:
                    self.tell(message, our_elements(message))

    # Bodies

    def tell(self, message: Json, ours: list[Ours]) -> None:
        key = (message["name"], message["direction"])
        self.told |= {(*key, element.path) for element in ours}
        self.known.add(("extra message", message["name"]))
        for element in ours:
            self.known.add(("extra field", f"{message['name']}.{element.name}"))

    def find(self, fact: Json) -> list[Json]:
        """Returns the messages of a command, direction and form; without a form, the main one."""
        found = self.messages_of(fact["command"], fact["direction"])
        form = fact.get("form")
        if form is not None or len(found) == 1:
            return [m for m in found if form in (None, m.get("form_name"))]
        return [m for m in found if m.get("form_name") in (None, "simple")]

    def all_bodies(self) -> Iterator[Check]:
        for fact in self.facts["bodies"]:
            line = fact["line"]
            found = self.find(fact)
            label = f"{fact['command']} {fact['direction']}"
            yield Check("body", line, label, 1, len(found))
            for message in found:
                yield from self.body(fact, message)

    def body(self, fact: Json, message: Json) -> Iterator[Check]:
        line, name = fact["line"], message["name"]
        self.known.add(("extra message", name))
        since = fact.get("since") or self.since.get(fact["command"])
        if since:
            yield Check("since", line, name, since, version(message))
        if "size" in fact:
            limits = fact["size"] if isinstance(fact["size"], list) else [fact["size"]] * 2
            yield Check("size", line, name, limits, [message["min_size"], message["max_size"]])
        said = elements(fact["fields"], self.structs)
        ours = our_elements(message)
        if "same_as" in fact:
            other = self.messages_of(fact["same_as"], "from_board")[0]
            yield Check("same body", line, name, True, _shape(other) == _shape(message))
            for element in ours:  # what is said about the other is said about this one
                label = f"{name}.{element.name}"
                self.known |= {(f"extra {kind}", label) for kind in ("unit", "range", "since")}
            self.tell(message, ours)
            return
        if fact.get("tail"):
            ours = ours[len(ours) - len(said) :]
        elif "size" not in fact:
            sizes = [said_size(element) for element in said]
            if None not in sizes:
                total = sum(size or 0 for size in sizes)
                yield Check(
                    "size", line, name, [total] * 2, [message["min_size"], message["max_size"]]
                )
        yield Check("length", line, name, len(said), len(ours))
        offset: int | None = None if fact.get("tail") else 0
        for wanted, mine in zip(said, ours):
            if wanted.fact["mask"] is not None:
                offset = None
            if offset is not None and mine.offset is not None:
                yield Check("offset", wanted.line, f"{name}.{wanted.name}", offset, mine.offset)
            yield from self.element(wanted, mine, message)
            size = said_size(wanted)
            offset = None if offset is None or size is None else offset + size
        self.tell(message, ours)

    def element(self, said: Said, ours: Ours, message: Json) -> Iterator[Check]:
        line, leaf = said.line, ours.leaf
        name = f"{message['name']}.{ours.name}"
        counted = said.several and re.fullmatch(rf"{said.name}\d+", ours.name)
        yield Check("field", line, name, said.name, said.name if counted else ours.name)
        yield Check("type", line, name, said.type, ours.type)
        fact = said.fact
        if fact["mask"] is not None:
            yield Check("when", line, name, fact["mask"], self.mask_of(leaf, message))
        yield from self.remarks(fact, line, name, leaf)

    def remarks(self, fact: Json, line: int, name: str, leaf: Json) -> Iterator[Check]:
        unit = [leaf.get("scale_exact"), leaf["unit"]]
        if "unit" in fact:
            other = leaf.get("alternative") or {}
            options = [unit, [str(other.get("scale")), other.get("unit")]]
            yield Check(
                "unit", line, name, fact["unit"], fact["unit"] if fact["unit"] in options else unit
            )
            self.known.add(("extra unit", name))
        if "range" in fact:
            yield Check("range", line, name, fact["range"], [leaf["min"], leaf["max"]])
            self.known.add(("extra range", name))
        if "since" in fact:
            yield Check("since", line, name, fact["since"], version(leaf))
            self.known.add(("extra since", name))

    def mask_of(self, leaf: Json, message: Json) -> int | None:
        """Returns the flags that a leaf depends on."""
        when = leaf.get("when") or {}
        source = when.get("field") or when.get("context")
        enum = next((f["enum"] for f in message["layout"] if f["path"] == source), None)
        if "context" in when:
            enum = next((c["enum"] for c in message["context"] if c["name"] == source), None)
        if enum is None:
            return None
        values = {v["name"]: v["value"] for v in self.enums[enum]["values"]}
        return sum(int(values[flag]) for flag in when["has"])

    # Fields at offsets

    def all_offsets(self) -> Iterator[Check]:
        for fact in self.facts["offsets"]:
            said = elements([fact], self.structs)
            bodies = [
                m
                for m in self.messages
                if m["command"] in (fact["command"], fact["command"].replace("READ", "WRITE"))
                and (m["command"] != fact["command"] or m["direction"] == fact["direction"])
                and (m["form"] in (None, "extended"))
                and m["max_size"] > fact["offset"]
            ]
            yield Check("body", fact["line"], fact["command"], True, bool(bodies))
            for message in bodies:
                yield from self.at_offset(fact["offset"], said, message)

    def at_offset(self, offset: int, said: list[Said], message: Json) -> Iterator[Check]:
        by_offset = {element.offset: element for element in our_elements(message)}
        for wanted in said:
            ours = by_offset.get(offset)
            label = f"{message['name']}.{wanted.name}"
            yield Check("offset", wanted.line, label, offset, ours.offset if ours else None)
            if ours is not None:
                yield from self.element(wanted, ours, message)
                self.tell(message, [ours])
            offset += said_size(wanted) or 0

    # Named numbers

    def leaves_at(self, place: str) -> list[Json]:
        """Returns the leaves that a place names.

        'FIELD' of any command, 'CMD.FIELD', 'CMD.path', 'CMD.FIELD CASE' in a tagged union.
        """
        place = place.partition(":")[0]
        command, _, name = place.rpartition(".")
        name, _, case = name.partition(" ")
        found = [leaf for owner, leaf in self.leaves if command in ("", owner)]
        key = "path" if name == name.lower() else "spec_name"
        found = [leaf for leaf in found if fnmatchcase(leaf[key], name)]
        if case:
            found = [leaf for leaf in found if case in (leaf.get("when") or {}).get("is", [])]
        return found

    def numbers(self, leaf: Json, of_part: str = "") -> dict[int, tuple[str, Json, str]]:
        """Returns what the numbers of a leaf, or of a part of it, mean: name, value and type."""
        found: dict[int, tuple[str, Json, str]] = {}
        packed = self.packed.get(leaf.get("packed", ""))
        enums = [(leaf["enum"], 0)] if leaf["enum"] else []
        for part in packed["parts"] if packed else []:
            if of_part:
                enums += [(part["enum"], 0)] if part["name"] == of_part else []
            elif part["enum"]:
                enums.append((part["enum"], part["shift"]))
            elif part["mask"] and part["mask"].bit_count() == 1:
                found[part["mask"]] = (part["name"], {}, packed["name"] if packed else "")
        if packed and packed["names"]:
            enums.append((packed["names"], 0))
        for name, shift in enums:
            for value in self.enums[name]["values"]:
                found[value["value"] << shift] = (value["name"], value, name)
        for number, meaning in leaf.get("special", {}).items():
            found.setdefault(int(number), (meaning, {}, ""))
        return found

    def all_enums(self) -> Iterator[Check]:
        for fact in self.facts["enums"]:
            leaves = self.leaves_at(fact["place"])
            yield Check("place", fact["line"], fact["place"], True, bool(leaves))
            for value in fact["values"]:
                number = 1 << value["value"] if fact["kind"] == "flags" else value["value"]
                if fact.get("signed") and number >= 1 << (fact["signed"] - 1):
                    number -= 1 << fact["signed"]
                yield from self.value(fact["place"], leaves, number, value)

    def value(self, place: str, leaves: list[Json], number: int, fact: Json) -> Iterator[Check]:
        line, said = fact["line"], fact["name"]
        checked = set()
        for leaf in leaves:
            if leaf["type"] in SIZES and number >= 1 << (8 * SIZES[leaf["type"]]):
                continue  # a value of a wider form
            known = self.numbers(leaf, place.partition(":")[2])
            ours, value, type_ = known.get(number, ("None", {}, leaf["path"]))
            if (type_, number) in checked:
                continue
            checked.add((type_, number))
            label = f"{place}.{said}"
            described = said != said.upper()
            same = number in known and (described or f"_{ours}".upper().endswith(f"_{said}"))
            yield Check(
                "value", line, label, f"{number} {said}", f"{number} {said if same else ours}"
            )
            if "since" in fact and value:
                yield Check("since", line, label, fact["since"], version(value))
            self.values.add((type_, number))
            if value:
                self.known.add(("extra constant", f"{type_}.{value['name']}"))

    def all_parts(self) -> Iterator[Check]:
        for fact in self.facts["parts"]:
            for leaf in self.leaves_at(fact["place"]):
                parts = {part["name"]: part for part in self.parts(leaf)}
                for name, (first, last) in fact["parts"].items():
                    mask = ((1 << (last - first + 1)) - 1) << first
                    ours = parts.get(name, {"mask": None})
                    yield Check("bits", fact["line"], f"{fact['place']}.{name}", mask, ours["mask"])
                    if name in fact.get("signs", {}):
                        sign = 1 << fact["signs"][name]
                        yield Check(
                            "sign", fact["line"], f"{fact['place']}.{name}", sign, ours.get("sign")
                        )

    def all_streams(self) -> Iterator[Check]:
        (config,) = [f for f in self.leaves_at("CMD_DATA_STREAM_INTERVAL.CONFIG")]
        for fact in self.facts["streams"]:
            cases = [c for c in config["cases"] if fact["command"] in c["when"]["is"]]
            ours = [(c["spec_name"], c["type"]) for c in cases]
            said = [(f["name"], f["type"]) for f in fact["fields"]]
            yield Check("stream", fact["line"], fact["command"], said, ours)

    # Adjustable variables

    def all_variables(self) -> Iterator[Check]:
        by_id = {v["id"]: v for v in self.model["adjustable_variables"]}
        ids = {v["name"]: v for v in self.enums["VariableId"]["values"]}
        for fact in self.facts["variables"]:
            line, name = fact["line"], fact["name"]
            ours = by_id.get(fact["id"], {})
            yield Check("variable", line, name, name, ours.get("name"))
            yield Check(
                "variable range", line, name, fact["range"], [ours.get("min"), ours.get("max")]
            )
            if "since" in fact:
                yield Check("variable since", line, name, fact["since"], version(ids.get(name)))
            self.known.add(("extra variable", name))
            self.known.add(("extra constant", f"VariableId.{name}"))

    def knows(self, check: Check, older: Comparison) -> bool:
        """Returns True if an addition to rev. 0.15 is a fact of the notes, or is in additions()."""
        if (check.kind, check.name) in self.known:
            return True
        if check.kind == "extra constant":
            return not re.search(r"L\d", self.enums[check.name.partition(".")[0]]["source"])
        if check.kind not in ("extra unit", "extra range"):
            return False
        owner, _, name = check.name.partition(".")
        paths = [
            (m["name"], m["direction"], leaf["path"])
            for m in self.messages
            for leaf in m["layout"]
            if (m["name"], leaf["spec_name"]) == (owner, name)
        ]
        return all(path in self.told and path not in older.compared for path in paths)

    # What the model has beyond both documents

    def additions(self, older: Comparison) -> Iterator[Check]:
        for message in self.messages:
            yield from self.additions_to(message, older)
        named = {name for name, _ in older.named}
        for enum in self.model["enums"]:
            if enum["name"].startswith("Command"):
                continue
            for value in enum["values"]:
                known = (enum["name"], value["value"]) in self.values
                known = known or ("extra constant", f"{enum['name']}.{value['name']}") in self.known
                old = not value["named_by_specification"] and re.search(r"L\d", enum["source"])
                if not known and not old and value["name"] not in named:
                    label = f"{enum['name']}.{value['name']}"
                    yield Check("extra value", 0, label, None, value["value"])

    def additions_to(self, message: Json, older: Comparison) -> Iterator[Check]:
        key = (message["name"], message["direction"])
        seen = set()
        if key not in older.met and ("extra message", message["name"]) not in self.known:
            yield Check("extra message", 0, message["name"], None, message["direction"])
        for leaf in message["layout"]:
            name, path = f"{message['name']}.{leaf['spec_name']}", (*key, leaf["path"])
            if path not in self.told:
                if path not in older.compared and "when" in leaf:
                    label = f"{message['name']}.{leaf['path']}"
                    yield Check("extra field", 0, label, None, leaf["type"])
                continue
            if name in seen:
                continue
            seen.add(name)
            if leaf.get("since") and ("extra since", name) not in self.known:
                yield Check("extra since", 0, name, None, leaf["since"]["firmware"])
            if path in older.compared:
                continue  # the comparison with the text of 2016 has its unit and range
            if leaf["min"] is not None and ("extra range", name) not in self.known:
                yield Check("extra range", 0, name, None, f"{leaf['min']}..{leaf['max']}")
            if leaf["scale"] is not None and ("extra unit", name) not in self.known:
                yield Check("extra unit", 0, name, None, leaf["quantity"])


FACTS = {name: loaded(DATA / f"{name}_facts.json") for name in ("specification", "later")}


def compare(model: Json, exceptions: Table) -> tuple[list[Check], list[Check]]:
    """Compares the model with the text of 2016 and with the notes; what either knows is no addition.

    `exceptions` are those of the text.
    """
    later = Later(FACTS["later"], model)
    newer = later.run()
    older = Comparison(FACTS["specification"], model, exceptions, later.told)
    old = [
        check
        for check in older.run()
        if not check.is_addition
        or exceptions.find(check.kind, check.line, check.name)
        or not later.knows(check, older)
    ]
    return old, newer + list(later.additions(older))
