"""A dissector for Wireshark: the protocol as Lua tables, and the program that interprets them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from sbgcgen.model import Enum, Layout, Leaf, Message, Packed, Part, Position, Quantity
from sbgcgen.spec.diagnostics import Diagnostics
from sbgcgen.spec.load import Spec
from sbgcgen.targets import Target, View
from sbgcgen.targets.wireshark import tables
from sbgcgen.targets.wireshark.tables import kind_of, path_of

# A longer name, with its value, does not fit into a line of the tree (ITEM_LABEL_LENGTH).
LONGEST_NAME = 128
# Names that the dissector reserves, which no message may have.
OWN = frozenset(
    """id command message direction framing size body checksum expert skipped request_in response_in
    response_time undecoded""".split()
)
_NAME = re.compile(r"[a-z0-9_]+(\.[a-z0-9_]+)*\Z")
# Lua's numbers are C doubles, and its bit operations have 32 bits.
_BITS = 32


def check_limits(layout: Layout, found: Diagnostics) -> None:
    """Report names that are impossible in the dissector; findings go into `found`."""
    namespace = layout.protocol.get("namespace", "sbgc")
    seen: dict[str, tuple[str, Position]] = {}
    for message in layout.messages:
        if message.identifier in OWN:
            text = f"the display filter '{namespace}.{message.identifier}' is the dissector's own"
            found.add(message.at, "SBGC022", text, "choose another name, with 'as'")
        for path, kind, at in filters(message):
            name = f"{namespace}.{message.identifier}.{path}"
            # Names with other letters have their own finding.
            if not _NAME.match(name.lower()):
                found.add(at, "SBGC022", f"'{name}' cannot be a display filter of Wireshark")
            if len(name) > LONGEST_NAME:
                text = f"the display filter '{name}' has over {LONGEST_NAME} characters"
                found.add(at, "SBGC022", text, "choose shorter names")
            known, other = seen.setdefault(name, (kind, at))
            if known != kind:
                text = f"the display filter '{name}' would be a {kind} and a {known}"
                found.add(at, "SBGC022", text, f"choose another name here or at {other}")
    for part in (part for packed in layout.packed for part in packed.parts):
        if part.mask >> part.shift >> _BITS:
            text = f"the part '{part.name}' has over {_BITS} bits"
            found.add(part.at, "SBGC022", text, f"Lua calculates with the bits of {_BITS}")


def filters(message: Message) -> Iterator[tuple[str, str, Position]]:
    """The display filters of a message, without its own name: path, kind and position in the spec."""
    yield "tail", "bytes", message.at
    for leaf in message.leaves:
        for one in leaf.cases or (leaf,):
            yield from _of_leaf(one)


def _of_leaf(leaf: Leaf) -> Iterator[tuple[str, str, Position]]:
    field, type_, path = leaf.field, leaf.field.type, path_of(leaf)
    types = [type_, *(later.type for later in field.later)]
    kind = "real" if any(kind_of(one, field) == "real" for one in types) else kind_of(type_, field)
    yield path, kind, field.at
    if kind == "real" and isinstance(type_, Quantity):
        yield f"{path}.raw", "number", field.at
    if isinstance(type_, Enum) and type_.kind == "flags":
        for value in type_.values:
            yield f"{path}.{value.identifier}", "flag", field.at
    if isinstance(type_, Packed):
        for part in type_.parts:
            yield f"{path}.{part.name}", _kind_of_part(part), field.at
            if part.enum and part.enum.kind == "flags":
                for value in part.enum.values:
                    yield f"{path}.{part.name}.{value.identifier}", "flag", field.at


def _kind_of_part(part: Part) -> str:
    if part.quantity and not part.quantity.is_plain:
        return "real"
    return "flag" if part.is_bool else "number"


class Wireshark(Target):
    """One Lua file, which Wireshark loads from its plugin folder."""

    def view(self, layout: Layout, project: Path) -> View:
        structs, names = tables.structs(layout)
        return View(
            filters={"lua": tables.lua},
            names={
                "tables": tables,
                "namespace": layout.protocol.get("namespace", "sbgc"),
                "structs": structs,
                "struct_names": names,
            },
        )

    def lint(self, spec: Spec, layout: Layout, found: Diagnostics) -> None:
        check_limits(layout, found)
