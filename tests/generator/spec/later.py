"""Compares the facts of the notes on the later protocol with the exported model."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from fnmatch import fnmatchcase
from typing import Any

from documents import SIZES, Check, Element, Json, Model, our_elements, version


def elements(
    fields: list[Json], structs: dict[str, Json], mask: int | None = None
) -> list[Element]:
    """Returns the elements of a list of fields; an array yields each of its elements."""
    found: list[Element] = []
    for fact in fields:
        count = fact["count"]
        if "group" in fact:
            inner = elements(fact["fields"], structs)
            if count is None:  # repeated to the end, or as often as a counter says
                inner = [_repeated(part) for part in inner]
            found += inner * (count or 1)
            continue
        name, type_, own = fact["name"], fact["type"], {**fact, "mask": fact.get("mask", mask)}
        if name in structs and type_ == "bytes":
            found += elements(structs[name]["fields"], structs, own["mask"])
        elif type_ in ("bytes", "text"):
            kind = "variable" if count is None else f"bytes {count}"
            found.append(Element(name, kind, count or 0, own))
        else:
            size = 0 if count is None else SIZES.get(type_, 0)
            found += [Element(name, type_, size, own)] * (count or 1)
    return found


def _repeated(part: Element) -> Element:
    type_ = "variable" if part.type.startswith("bytes") else part.type
    return replace(part, type=type_, size=0, fact={**part.fact, "count": None})


def _shape(message: Json) -> list[tuple[Any, ...]]:
    keys = ("spec_name", "type", "count", "offset", "unit", "scale", "min", "max", "since")
    return [tuple(leaf.get(key) for key in keys) for leaf in message["layout"]]


class Later(Model):
    """All checks of the facts against the model."""

    def __init__(self, facts: Json, model: Json) -> None:
        super().__init__(model)
        self.facts = facts
        self.structs = {s["name"]: s for s in self.facts["structs"]}
        self.leaves = [
            (message["command"], leaf)
            for message in self.messages
            for top in message["layout"]
            for leaf in [top, *top.get("cases", [])]
        ]
        self.since = {c["name"]: c.get("since") for c in self.facts["commands"]}

    def run(self) -> Iterator[Check]:
        yield from self.all_commands()
        yield from self.all_bodies()
        yield from self.all_offsets()
        yield from self.all_enums()
        yield from self.all_parts()
        yield from self.all_streams()
        yield from self.all_variables()

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
            self.told.labels.add(("command", name))
            for message in messages if not fact["body"] else ():
                self.tell(message, our_elements(message))

    # Bodies

    def tell(self, message: Json, ours: list[Element]) -> None:
        self.told.add(message, [element.fact for element in ours])
        self.told.messages.add((message["name"], message["direction"]))
        self.told.labels |= {("field", f"{message['name']}.{element.name}") for element in ours}

    def find(self, fact: Json) -> list[Json]:
        """Returns the messages of a command, direction and form; without a form, the main one."""
        found = self.messages_of(fact["command"], fact["direction"])
        form = fact.get("form")
        if form is not None or len(found) == 1:
            return [m for m in found if form in (None, m.get("form_name"))]
        return [m for m in found if m.get("form_name") in (None, "simple")]

    def all_bodies(self) -> Iterator[Check]:
        for fact in self.facts["bodies"]:
            found = self.find(fact)
            label = f"{fact['command']} {fact['direction']}"
            yield Check("body", fact["line"], label, 1, len(found))
            for message in found:
                yield from self.body(fact, message)

    def body(self, fact: Json, message: Json) -> Iterator[Check]:
        line, name = fact["line"], message["name"]
        since = fact.get("since") or self.since.get(fact["command"])
        if since:
            yield Check("since", line, name, since, version(message))
        said = elements(fact["fields"], self.structs)
        ours = our_elements(message)
        self.tell(message, ours)
        size = fact.get("size")
        if size is None and "tail" not in fact and "same_as" not in fact:
            sizes = [element.size for element in said]
            size = sum(sizes) if all(sizes) else None
        if size is not None:
            limits = size if isinstance(size, list) else [size] * 2
            yield Check("size", line, name, limits, [message["min_size"], message["max_size"]])
        if "same_as" in fact:
            other = self.messages_of(fact["same_as"], "from_board")[0]
            yield Check("same body", line, name, True, _shape(other) == _shape(message))
            for element in ours:  # what is said about the other is said about this one
                self.told.labels |= {
                    (kind, f"{name}.{element.name}") for kind in ("unit", "range", "since")
                }
            return
        offset: int | None = 0
        if fact.get("tail"):
            offset, ours = None, ours[len(ours) - len(said) :]
        yield Check("length", line, name, len(said), len(ours))
        for wanted, mine in zip(said, ours):
            if wanted.fact["mask"] is not None:
                offset = None
            if offset is not None and mine.offset is not None:
                yield Check("offset", wanted.line, f"{name}.{wanted.name}", offset, mine.offset)
            yield from self.element(wanted, mine, message)
            offset = offset + wanted.size if offset is not None and wanted.size else None

    def element(self, said: Element, ours: Element, message: Json) -> Iterator[Check]:
        line, leaf, fact = said.line, ours.fact, said.fact
        name = f"{message['name']}.{ours.name}"
        counted = (fact["count"] or 1) > 1 and re.fullmatch(rf"{said.name}\d+", ours.name)
        counted = counted and not said.type.startswith("bytes")
        yield Check("field", line, name, said.name, said.name if counted else ours.name)
        yield Check("type", line, name, said.type, ours.type)
        if fact["mask"] is not None:
            yield Check("when", line, name, fact["mask"], self.mask_of(leaf, message))
        unit, other = [leaf.get("scale_exact"), leaf["unit"]], leaf.get("alternative") or {}
        if fact.get("unit") == [str(other.get("scale")), other.get("unit")]:
            unit = fact["unit"]
        for kind, value in (
            ("unit", unit),
            ("range", [leaf["min"], leaf["max"]]),
            ("since", version(leaf)),
        ):
            if kind in fact:
                yield Check(kind, line, name, fact[kind], value)
                self.told.labels.add((kind, name))

    def mask_of(self, leaf: Json, message: Json) -> int | None:
        """Returns the flags that a leaf depends on."""
        when = leaf.get("when") or {}
        enum = next((f["enum"] for f in message["layout"] if f["path"] == when.get("field")), None)
        if "context" in when:
            enum = next(c["enum"] for c in message["context"] if c["name"] == when["context"])
        if enum is None:
            return None
        values = {v["name"]: v["value"] for v in self.enums[enum]["values"]}
        return sum(int(values[flag]) for flag in when["has"])

    # Fields at offsets

    def all_offsets(self) -> Iterator[Check]:
        for fact in self.facts["offsets"]:
            command = fact["command"]
            bodies = [
                m
                for m in self.messages
                if m["command"] in (command, command.replace("READ", "WRITE"))
                and (m["command"] != command or m["direction"] == fact["direction"])
                and m["form"] in (None, "extended")
                and m["max_size"] > fact["offset"]
            ]
            yield Check("body", fact["line"], command, True, bool(bodies))
            for message in bodies:
                yield from self.at_offset(fact["offset"], elements([fact], self.structs), message)

    def at_offset(self, offset: int, said: list[Element], message: Json) -> Iterator[Check]:
        by_offset = {element.offset: element for element in our_elements(message)}
        for wanted in said:
            ours = by_offset.get(offset)
            label = f"{message['name']}.{wanted.name}"
            yield Check("offset", wanted.line, label, offset, ours.offset if ours else None)
            if ours is not None:
                yield from self.element(wanted, ours, message)
                self.tell(message, [ours])
            offset += wanted.size

    # Named numbers

    def leaves_at(self, place: str) -> list[Json]:
        """Returns the leaves that a place names.

        'FIELD' of any command, 'CMD.FIELD', 'CMD.path', 'CMD.FIELD CASE' in a tagged union.
        """
        command, _, name = place.partition(":")[0].rpartition(".")
        name, _, case = name.partition(" ")
        key = "path" if name == name.lower() else "spec_name"
        return [
            leaf
            for owner, leaf in self.leaves
            if command in ("", owner)
            and fnmatchcase(leaf[key], name)
            and (not case or case in (leaf.get("when") or {}).get("is", []))
        ]

    def numbers(self, leaf: Json, of_part: str = "") -> dict[int, tuple[str, Json, str]]:
        """Returns what the numbers of a leaf, or of a part of it, mean: name, value and type."""
        found: dict[int, tuple[str, Json, str]] = {}
        packed = self.packed.get(leaf.get("packed", ""), {})
        enums = [(leaf["enum"], 0)]
        for part in packed.get("parts", []):
            if of_part:
                enums += [(part["enum"], 0)] if part["name"] == of_part else []
            elif part["enum"]:
                enums.append((part["enum"], part["shift"]))
            elif part["mask"] and part["mask"].bit_count() == 1:
                found[part["mask"]] = (part["name"], {}, packed["name"])
        for name, shift in [*enums, (packed.get("names"), 0)]:
            for value in self.enums[name]["values"] if name else ():
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
        line, said, label = fact["line"], fact["name"], f"{place}.{fact['name']}"
        checked = set()
        for leaf in leaves:
            if leaf["type"] in SIZES and number >= 1 << (8 * SIZES[leaf["type"]]):
                continue  # a value of a wider form
            known = self.numbers(leaf, place.partition(":")[2])
            ours, value, type_ = known.get(number, ("None", {}, leaf["path"]))
            if type_ in checked:
                continue
            checked.add(type_)
            described = said != said.upper()
            same = number in known and (described or f"_{ours}".upper().endswith(f"_{said}"))
            had = f"{number} {said if same else ours}"
            yield Check("value", line, label, f"{number} {said}", had)
            if "since" in fact and value:
                yield Check("since", line, label, fact["since"], version(value))
            if value:
                self.told.labels.add(("value", f"{type_}.{value['name']}"))

    def all_parts(self) -> Iterator[Check]:
        for fact in self.facts["parts"]:
            for leaf in self.leaves_at(fact["place"]):
                parts = {part["name"]: part for part in self.parts(leaf)}
                for name, (first, last) in fact["parts"].items():
                    label, ours = f"{fact['place']}.{name}", parts.get(name, {"mask": None})
                    mask = ((1 << (last - first + 1)) - 1) << first
                    yield Check("bits", fact["line"], label, mask, ours["mask"])
                    if name in fact.get("signs", {}):
                        sign = 1 << fact["signs"][name]
                        yield Check("sign", fact["line"], label, sign, ours.get("sign"))

    def all_streams(self) -> Iterator[Check]:
        (config,) = self.leaves_at("CMD_DATA_STREAM_INTERVAL.CONFIG")
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
            limits = [ours.get("min"), ours.get("max")]
            yield Check("variable", line, name, name, ours.get("name"))
            yield Check("variable range", line, name, fact["range"], limits)
            if "since" in fact:
                yield Check("variable since", line, name, fact["since"], version(ids.get(name)))
            self.told.labels |= {("variable", name), ("value", f"VariableId.{name}")}
