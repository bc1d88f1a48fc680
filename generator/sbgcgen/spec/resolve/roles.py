"""Resolves the roles of messages in the conversation."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sbgcgen.model import COMMAND_IDS, Blob, Enum, Field, Message, Position, Quantity, Role, Struct
from sbgcgen.model import Versions
from sbgcgen.spec.diagnostics import Diagnostics, did_you_mean
from sbgcgen.spec.load import Map
from sbgcgen.spec.resolve.versions import KINDS

# Limit of the runtime in bytes.
MAX_CONFIG = 8
_UNITS = {"s": 1_000_000, "ms": 1000, "us": 1}
# The required and the optional fields of each role, followed by other keys.
_PARTS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "confirmation": (("command",), ()),
    "error": ((), ("code", "command")),
    "reset": ((), ()),
    "introduction": (("firmware", "board"), ()),
    "details": ((), ("serial_number", "eeprom_size")),
    "stream_request": (("command", "interval", "config"), ()),
    "angles": (("angle",), ()),
    "battery": (("voltage",), ()),
    "motors_on": ((), ()),
    "motors_off": ((), ()),
    "gyro_calibration": ((), ()),
}
_TO_BOARD = ("stream_request", "motors_on", "motors_off", "gyro_calibration")
_WORDS = {
    "reset": ("delay_ms",),
    "stream_request": ("end", "cycle", "cycle_us", "limit", "messages"),
}


class RoleResolver:
    """Resolves the `role` of messages; findings go into `found`.

    role() needs the message's own fields, check() all messages.
    """

    def __init__(self, versions: Versions, found: Diagnostics) -> None:
        self.versions = versions
        self.found = found
        self.nodes: dict[Position, Map] = {}  # resolved nodes, for positions of their keys

    def role(self, node: Any, direction: str, fields: tuple[Field, ...]) -> Role | None:
        """Resolve the value of `role:`; None if it is absent or not valid."""
        if not isinstance(node, Map):
            return None
        kind = str(node["is"])
        if (kind in _TO_BOARD) != (direction == "to_board"):
            message = f"a message {'to' if direction == 'to_board' else 'from'} the board is not a valid {kind}"
            self.found.add(node.at("is"), "SBGC037", message, "move it to the other direction")
            return None
        self.nodes[node.position] = node
        needed, possible = _PARTS[kind]
        words = _WORDS.get(kind, ())
        for word in node:
            if word not in ("is", *needed, *possible, *words):
                message = f"'{word}' does not belong to a role of kind {kind}"
                known = ", ".join((*needed, *possible, *words)) or "nothing else"
                self.found.add(node.at(word), "SBGC037", message, f"it has: {known}")
        parts: dict[str, Field] = {}
        for part in (*needed, *possible):
            if part in node:
                field = self._part(node, part, fields)
                if field is not None:
                    parts[part] = field
            elif part in needed:
                hint = f"{part}: NAME of the field"
                self.found.add(node.position, "SBGC037", f"a {kind} needs '{part}'", hint)
        if any(part not in parts for part in needed):
            return None
        role = Role(kind, parts, delay_ms=int(node.get("delay_ms", 0)), at=node.position)
        return self._stream_role(node, role) if kind == "stream_request" else role

    def _part(self, node: Map, part: str, fields: tuple[Field, ...]) -> Field | None:
        if part == "angle":  # of each axis
            fields = tuple(
                member
                for field in fields
                if field.dim == "axis" and isinstance(field.type, Struct)
                for member in field.type.fields
            )
        by_name = {field.spec_name: field for field in fields}
        wanted = str(node[part])
        field = by_name.get(wanted)
        if field is None:
            hint = did_you_mean(wanted, by_name) or f"known here: {', '.join(by_name) or 'none'}"
            self.found.add(node.at(part), "SBGC037", f"'{wanted}' is not a field here", hint)
            return None
        problem = self._why_not(str(node["is"]), part, field)
        if field.offset is None or field.may_be_absent:
            problem = "has no fixed offset"
        if problem:
            hint = f"{part}: a field that every body of the message has"
            self.found.add(node.at(part), "SBGC037", f"'{wanted}' {problem}", hint)
            return None
        return field

    def _why_not(self, kind: str, part: str, field: Field) -> str:
        """The reason that a field cannot be this part of a role; "" if it can."""
        type_, is_one = field.type, field.dim == "one"
        if part == "config":
            is_bytes = isinstance(type_, (Struct, Blob)) and is_one
            is_small = field.size is not None and field.size <= MAX_CONFIG
            return "" if is_bytes and is_small else f"does not have 1 to {MAX_CONFIG} bytes"
        if part == "command":
            wanted = COMMAND_IDS["from_board" if kind == "stream_request" else "to_board"]
            is_command = isinstance(type_, Enum) and type_.name == wanted
            return "" if is_command else f"is not a command: its type is not {wanted}"
        if part == "code":
            is_code = isinstance(type_, Enum) and type_.scalar.size == 1
            return "" if is_code else "is not an enum of one byte"
        if part in KINDS:
            is_version = is_one and type_ == self.versions.of(part)
            return "" if is_version else f"is not of the type that 'versions' names for {part}"
        if part == "serial_number":
            is_run = isinstance(type_, Blob) and type_.kind == "bytes" and field.size is not None
            return "" if is_one and is_run else "is not a run of bytes of fixed size"
        return "" if isinstance(type_, Quantity) and is_one else "is not a quantity"

    def _stream_role(self, node: Map, role: Role) -> Role | None:
        quantity = role.parts["interval"].type
        assert isinstance(quantity, Quantity)
        unit = _UNITS.get(quantity.unit or "", 0) * quantity.scale
        if not unit or unit.denominator != 1 or quantity.offset or quantity.ratio:
            message = f"'{node['interval']}' is not in whole microseconds"
            hint = "its unit is s, ms or us"
            self.found.add(node.at("interval"), "SBGC037", message, hint)
            return None
        if "messages" not in node or ("cycle" in node) != ("cycle_us" in node):
            hint = "messages: [NAME, …]; cycle and cycle_us come together or not at all"
            self.found.add(node.position, "SBGC037", "a stream_request is incomplete", hint)
            return None
        return replace(
            role,
            messages=tuple(str(name) for name in node["messages"]),
            interval_us=int(unit),
            end=int(node.get("end", 0)),
            cycle=node.get("cycle"),
            cycle_us=int(node.get("cycle_us", 0)),
            limit=int(node.get("limit", 0)),
        )

    def check(self, messages: list[Message]) -> None:
        """Each role must belong to one command."""
        first: dict[str, Message] = {}
        for message in messages:
            if message.role is None:
                continue
            other = first.setdefault(message.role.kind, message)
            if other.command != message.command or (
                other is not message and message.role.kind != "error"
            ):
                text = f"{message.name} has the role of {other.name}: {message.role.kind}"
                hint = f"see {other.role.at if other.role else other.at}"
                self.found.add(message.role.at, "SBGC037", text, hint)
            elif other.role and other is not message:
                codes = [role.parts.get("code") for role in (other.role, message.role)]
                types = [code.type if code else None for code in codes]
                if types[0] != types[1]:
                    text = f"{message.name} has no code of the type that {other.name} has"
                    self.found.add(message.role.at, "SBGC037", text, f"see {other.role.at}")
