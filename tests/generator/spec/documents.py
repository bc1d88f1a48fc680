"""The facts of the documents, the exported model, and the exceptions from their comparison.

A comparison makes Checks: the statement of a document and that of the model. The deviations are not in the
code but in tests/data/*_exceptions.yaml, each with its erratum or reason.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass, field
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

import yaml

from sbgcgen.model.export import export
from sbgcgen.model.names import parse_lines
from support import PROJECT, project_layout

Json = dict[str, Any]
DATA = PROJECT / "tests" / "data"
LATER = "Later firmware"  # the source of what the text of 2016 lacks


def loaded(path: Path) -> Json:
    """Returns the content of a JSON or YAML file."""
    text = path.read_text(encoding="utf-8")
    found: Json = json.loads(text) if path.suffix == ".json" else yaml.safe_load(text)
    return found


FACTS = {name: loaded(DATA / f"{name}_facts.json") for name in ("specification", "later")}


def model_of_documents() -> Json:
    """Returns the exported model without what has other sources than the two documents, such as release notes."""
    model: Json = json.loads(json.dumps(export(project_layout())))
    others = set()
    for kind in ("messages", "enums", "packed"):
        for thing in list(model[kind]):
            if thing["source"] != LATER and not parse_lines(thing["source"]):
                model[kind].remove(thing)
                others.add(thing.get("command"))
    newer = loaded(DATA / "later_exceptions.yaml")["newer"]
    flags = set()
    for enum in model["enums"]:
        for value in list(enum["values"]):
            if any(fnmatchcase(f"{enum['name']}.{value['name']}", pattern) for pattern in newer):
                enum["values"].remove(value)
                flags.add(value["name"])
    for message in model["messages"]:
        message["layout"] = [
            leaf
            for leaf in message["layout"]
            if "fits" not in leaf and flags.isdisjoint((leaf.get("when") or {}).get("has", ()))
        ]
    others -= {message["command"] for message in model["messages"]}
    model["commands"] = [command for command in model["commands"] if command["name"] not in others]
    return model


SIZES = {"u8": 1, "i8": 1, "u16": 2, "i16": 2, "u32": 4, "i32": 4, "f32": 4, "float": 4}
SIZES |= {"u24": 3, "i24": 3, "u64": 8, "i64": 8, "f64": 8}


@dataclass(frozen=True)
class Check:
    """A fact: the statement of the text, its line, and the statement of the model."""

    kind: str
    line: int
    name: str
    said: Any
    ours: Any

    @property
    def holds(self) -> bool:
        return bool(self.said == self.ours) and not self.is_addition

    @property
    def fact(self) -> tuple[str, int, str, str]:
        """Identifies a statement of the text, however often it is compared."""
        return (self.kind, self.line, self.name.rpartition(".")[2], str(self.said))

    @property
    def is_addition(self) -> bool:
        """True if the model has a fact that the text lacks."""
        return self.kind.startswith("extra")

    def __str__(self) -> str:
        return f"L{self.line} {self.kind} {self.name}: said {self.said}, we have {self.ours}"


def entry_lines(entry: Json, line: int) -> tuple[int, int]:
    """Returns the range of lines that an entry applies to; without lines, it applies to any."""
    lines = entry.get("line", line)
    return (lines[0], lines[1]) if isinstance(lines, list) else (lines, lines)


@dataclass
class Table:
    """The exceptions; `used` records which were needed, for which of its names."""

    entries: list[Json]
    used: set[tuple[int, str]] = field(default_factory=set)

    def find(self, kind: str, line: int, name: str) -> Json | None:
        """Returns the entry for a fact and marks it as used."""
        for number, entry in enumerate(self.entries):
            first, last = entry_lines(entry, line)
            if entry["kind"] == kind and first <= line <= last:
                patterns = [p for p in str(entry["name"]).split() if fnmatchcase(name, p)]
                self.used |= {(number, pattern) for pattern in patterns}
                if patterns:
                    return entry
        return None

    def explains(self, check: Check) -> bool:
        """Returns True if an entry says what the model has; one without `ours` accepts anything."""
        entry = self.find(check.kind, check.line, check.name)
        return entry is not None and str(entry.get("ours", check.ours)) == str(check.ours)

    def unneeded(self) -> list[tuple[str, str]]:
        """Returns the kinds and names of the exceptions that no check needed."""
        return [
            (entry["kind"], pattern)
            for number, entry in enumerate(self.entries)
            for pattern in str(entry["name"]).split()
            if (number, pattern) not in self.used
        ]


@dataclass(frozen=True)
class Element:
    """An element of a body: a number, a run of bytes, or a variable part; `fact` is the field or leaf."""

    name: str
    type: str
    size: int  # 0 if it varies
    fact: Json
    offset: int | None = None

    @property
    def line(self) -> int:
        return int(self.fact["line"])

    @property
    def path(self) -> str:
        return str(self.fact["path"])

    @property
    def is_reserved(self) -> bool:
        return self.name.upper() == "RESERVED"


def our_elements(message: Json) -> list[Element]:
    """Returns the elements of a layout; in the text, strings and bytes are both runs of bytes."""
    found = []
    for leaf in message["layout"]:
        count = leaf["count"]
        type_, size = leaf["type"], SIZES.get(leaf["type"], 0)
        if type_ in ("bytes", "text"):
            type_ = f"bytes {count}" if count is not None else "variable"
            size, count = count or 0, 1
        for i in range(1 if count is None else count):
            offset = None if leaf["offset"] is None else leaf["offset"] + i * size
            found.append(Element(leaf["spec_name"], type_, size, leaf, offset))
    return found


class Told:
    """The subjects that a document covers."""

    def __init__(self) -> None:
        self.labels: set[tuple[str, str]] = set()  # a kind of fact, and what it is about
        self.messages: set[tuple[str, str]] = set()  # by name and direction
        self.leaves: set[tuple[str, str, str]] = set()  # message, direction, path
        self.paths: set[tuple[str, str, str]] = set()  # a kind of fact, message, path

    def add(self, message: Json, leaves: Iterable[Json]) -> None:
        self.leaves |= {(message["name"], message["direction"], leaf["path"]) for leaf in leaves}

    def says(self, kind: str, leaves: list[tuple[Json, Json]]) -> None:
        """Notes a kind of fact about leaves, each with its message."""
        self.paths |= {(kind, message["name"], leaf["path"]) for message, leaf in leaves}


class Model:
    """The exported model by names, and what a document tells about it."""

    def __init__(self, model: Json) -> None:
        self.told = Told()
        self.model = model
        self.messages: list[Json] = model["messages"]
        self.enums = {e["name"]: e for e in model["enums"]}
        self.packed = {p["name"]: p for p in model["packed"]}
        self.commands = {c["name"]: c for c in model["commands"]}

    def parts(self, leaf: Json) -> list[Json]:
        """Returns the parts of the packed type of a leaf; none for other types."""
        found: list[Json] = self.packed.get(leaf.get("packed", ""), {}).get("parts", [])
        return found

    def messages_of(self, command: str, direction: str) -> list[Json]:
        return [m for m in self.messages if (m["command"], m["direction"]) == (command, direction)]


def version(thing: Json | None, kind: str = "firmware") -> Any:
    """Returns the first version that has a thing; None if there is no such fact."""
    return ((thing or {}).get("since") or {}).get(kind)
