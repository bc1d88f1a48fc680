"""Parses versions: those of `since` and `until`, and the newest firmware."""

from __future__ import annotations

import re

from sbgcgen.model import Packed, Position, Versions
from sbgcgen.model.packed_text import raw_of, text_of
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map

KINDS = ("firmware", "board")


class VersionReader:
    """Parses versions by the display texts of the packed integers under `versions`.

    Findings go into `found`.
    """

    def __init__(self, node: Map, found: Diagnostics) -> None:
        self.node = node  # the value of `versions:` in the main file
        self.found = found
        self.versions = Versions()

    @property
    def names(self) -> list[str]:
        """The names of the packed integers."""
        return [str(self.node[kind]) for kind in KINDS if kind in self.node]

    def use(self, packed: dict[str, Packed], names: list[str]) -> None:
        """Use these packed integers; `names` are the names of all, including unresolved ones."""
        found = {}
        for kind in KINDS:
            if kind not in self.node:
                continue
            name = str(self.node[kind])
            type_ = packed.get(name)
            if name not in names:
                hint = did_you_mean(name, names) or "name one under 'packed'"
                text = f"there is no packed integer '{name}'"
                self.found.add(self.node.at(kind), "SBGC010", text, hint)
            elif type_ is not None and _is_written(type_):
                found[kind] = type_
            else:
                text = f"the display text of {name} cannot represent a version"
                hint = "it has each part once, and no part is an enum"
                self.found.add(self.node.at(kind), "SBGC070", text, hint)
        self.versions = Versions(**found)

    def version(self, kind: str, text: str, at: Position) -> int:
        """The number of a version; reports text that is not a version and returns 0."""
        type_ = self.versions.of(kind)
        value = raw_of(type_, text) if type_ else None
        if value is None and (type_ or kind not in self.node):
            hint = f"say under 'versions' in the main file how a {kind} version is written"
            if type_:
                hint = f"write it like {text_of(type_, _example(type_))}"
            self.found.add(at, "SBGC030", f"'{text}' is not a {kind} version", hint)
        return value or 0


def _is_written(packed: Packed) -> bool:
    displays = [packed.display, *([packed.later_display] if packed.later_display else [])]
    names = sorted(part.name for part in packed.parts)
    return all(sorted(re.findall(r"\{(\w+)", display)) == names for display in displays)


def _example(packed: Packed) -> int:
    """A version with no zero parts."""
    number = 0
    for count, part in enumerate(sorted(packed.parts, key=lambda p: -p.divide), start=2):
        number += count * part.divide << part.shift
    return number
