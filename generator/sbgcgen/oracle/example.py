"""Worked examples of messages: an ordinary frame, split into its values."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from sbgcgen.model import SCALARS, Announced, Blob, Enum, Field, Layout, Message, Packed, Part
from sbgcgen.model import Quantity, Scalar, Struct, Type, value_at
from sbgcgen.model.packed_text import part_of, text_of
from sbgcgen.oracle.json_values import plain
from sbgcgen.oracle.codec import LISTS, Fields, is_bytes, keys_of, scalar_of
from sbgcgen.oracle.frames import write_frame
from sbgcgen.oracle.json_values import text_to_bytes
from sbgcgen.oracle.vector_line import line
from sbgcgen.oracle.vectors import typical_vector


# The maximum number of values of a long message that code prints.
_SHOWN = 8


@dataclass(frozen=True)
class Piece:
    """One value of a body: its position, type, bytes and meaning.

    `path` has all indices; `leaf` is the path of its Leaf in the model. `missing` are the paths of
    the value and its enclosing members, as far as they may be missing. `data` are its bytes.
    """

    path: str
    leaf: str
    missing: tuple[str, ...]
    field: Field
    type: Type
    value: Any
    offset: int
    data: bytes
    meaning: str

    @property
    def may_be_missing(self) -> bool:
        return self.path in self.missing

    @property
    def raw(self) -> str:
        """The raw value as `sbgc decode` prints it."""
        if isinstance(self.type, Blob) and self.type.kind in ("text", "string"):
            return json.dumps(plain(self.value), ensure_ascii=False)
        if isinstance(self.value, float):
            return f"{self.value:g}"
        return str(self.value)


@dataclass(frozen=True)
class Earlier:
    """A preceding frame, and the direction of its message."""

    direction: str
    frame: bytes


@dataclass(frozen=True)
class Example:
    """An ordinary frame of a message, and the earlier frames that it needs as context.

    For a message that stores settings, `read` is the example of the message that delivers them.
    """

    message: Message
    fields: Fields
    context: Fields
    before: tuple[Earlier, ...]
    header: bytes
    pieces: tuple[Piece, ...]
    trailer: bytes
    read: Example | None = None

    def changed_bytes(self, piece: Piece) -> dict[int, int]:
        """The bytes of a run that differ from those in `read`, if it has as many, by index."""
        pieces = self.read.pieces if self.read else ()
        before = next((p.data for p in pieces if p.path == piece.path), b"")
        is_run = isinstance(piece.type, Blob) and piece.type.kind == "bytes"
        if not is_run or len(before) != len(piece.data):
            return {}
        return {i: new for i, (old, new) in enumerate(zip(before, piece.data)) if old != new}

    @cached_property
    def changed(self) -> frozenset[str]:
        """The paths of the values that differ from those in `read`."""
        before = {piece.path: piece.data for piece in self.read.pieces} if self.read else {}
        return frozenset(p.path for p in self.pieces if before.get(p.path) != p.data)

    @property
    def missing(self) -> frozenset[str]:
        """The paths of all values and groups in the example that may be missing in other bodies."""
        return frozenset(path for piece in self.pieces for path in piece.missing)

    @property
    def shown(self) -> list[Piece]:
        """One value of each field, up to the limit for code."""
        seen: set[int] = set()
        found = []
        for piece in self.pieces:
            is_new = id(piece.field) not in seen or isinstance(piece.field.type, Announced)
            if is_new and not piece.field.reserved and not piece.field.is_counter:
                seen.add(id(piece.field))
                found.append(piece)
        return found[:_SHOWN]

    @property
    def body(self) -> bytes:
        return b"".join(piece.data for piece in self.pieces)

    @property
    def frame(self) -> bytes:
        return self.header + self.body + self.trailer

    @property
    def json_line(self) -> str:
        """The input from which `sbgc encode` makes the frame."""
        names = {"message": self.message.name, "direction": self.message.direction}
        return json.dumps({**names, "fields": plain(self.fields)})


def example_of(message: Message, layout: Layout) -> Example:
    """The example of a message, from its first readable test vector."""
    vector = typical_vector(message)
    assert vector.body is not None and vector.fields is not None
    vector_line = json.loads(line(vector, layout.messages_by_id))
    framing = layout.framing
    frame = write_frame(framing, message.id, vector.body)
    taker = _ValueReader(layout, vector.body, vector.fields)
    pieces = tuple(taker.fields(message.fields, vector.fields, _Place()))
    assert taker.at == len(vector.body), f"{message.name}: {taker.at} of {len(vector.body)} bytes"
    before = tuple(
        Earlier(one["direction"], write_frame(framing, one["id"], bytes.fromhex(one["hex"])))
        for one in vector_line.get("after", ())
    )
    return Example(
        message=message,
        fields=vector.fields,
        context=vector.context,
        before=before,
        header=frame[: framing.header_size],
        pieces=pieces,
        trailer=frame[len(frame) - framing.trailer_size :],
        read=_read_before(message, layout),
    )


def _read_before(message: Message, layout: Layout) -> Example | None:
    """The example of the message that a message stores; None unless their bodies are the same."""
    if not message.stores or message.same_as != message.stores or message.contexts:
        return None
    board = [m for m in layout.messages if m.direction == "from_board"]
    return next((example_of(m, layout) for m in board if m.name == message.stores), None)


@dataclass(frozen=True)
class _Place:
    """The position of a value: its path in the message, and that of its leaf in the model."""

    path: str = ""
    leaf: str = ""
    missing: tuple[str, ...] = ()

    def member(self, field: Field) -> _Place:
        dot = "." if self.path else ""
        path = f"{self.path}{dot}{field.name}"
        missing = (*self.missing, path) if field.may_be_absent else self.missing
        return _Place(path, f"{self.leaf}{dot}{field.name}", missing)

    def key(self, key: str) -> _Place:
        return _Place(f"{self.path}.{key}", f"{self.leaf}.{key}", self.missing)

    def item(self, field: Field, i: int) -> _Place:
        return _Place(f"{self.path}[{i}]", self.leaf + _index(field, i), self.missing)


class _ValueReader:
    """Takes the values of a body in order."""

    def __init__(self, layout: Layout, body: bytes, whole: Fields) -> None:
        self.layout = layout
        self.body = body
        self.whole = whole
        self.at = 0

    def fields(self, fields: tuple[Field, ...], values: Fields, at: _Place) -> Iterator[Piece]:
        variable: Any = None
        for field in fields:
            if field.name in values:
                yield from self._field(field, values[field.name], at.member(field), variable)
                if isinstance(field.type, Enum):
                    variable = values[field.name]

    def _field(self, field: Field, value: Any, at: _Place, variable: Any) -> Iterator[Piece]:
        if field.dim == "one":
            yield from self._one(field, field.type, value, at, variable)
        elif field.dim not in LISTS:
            for key in keys_of(field):
                yield from self._one(field, field.type, value[key], at.key(key))
        elif is_bytes(field):
            yield self._piece(field, field.type, value, at, len(value) // 2)
        elif isinstance(field.type, Announced):
            for i, number in enumerate(value):
                for word, item in number.items():
                    yield from self._one(field, SCALARS[word], item, at.item(field, i))
        else:
            for i, item in enumerate(value):
                yield from self._one(field, field.type, item, at.item(field, i))

    def _one(
        self, field: Field, type_: Type, value: Any, at: _Place, variable: Any = None
    ) -> Iterator[Piece]:
        if not isinstance(type_, Struct):
            yield self._piece(field, type_, value, at, _size(type_, value), variable)
            return
        for piece in self.fields(type_.fields, value, at):
            is_rest = type_.is_region and piece.field is type_.fields[-1]
            yield replace(piece, leaf=at.leaf) if is_rest else piece  # the rest has no own leaf

    def _piece(
        self, field: Field, type_: Type, value: Any, at: _Place, size: int, variable: Any = None
    ) -> Piece:
        piece = Piece(
            path=at.path,
            leaf=at.leaf,
            missing=at.missing,
            field=field,
            type=type_,
            value=value,
            offset=self.at,
            data=self.body[self.at : self.at + size],
            meaning=self._meaning(field, type_, value, at.path, variable),
        )
        self.at += size
        return piece

    # Meanings

    def _meaning(self, field: Field, type_: Type, value: Any, path: str, variable: Any) -> str:
        for special in field.special:
            if special.value == value:
                return special.meaning
        meaning = self._usual_meaning(field, type_, value, path, variable)
        known = next(
            (v for v in self.layout.variables if field.variable and v.id == variable), None
        )
        later = known.later if known else field.later
        if not later:
            return meaning
        return f"{meaning or value} (before firmware {later[0].since.firmware_text})"

    def _usual_meaning(
        self, field: Field, type_: Type, value: Any, path: str, variable: Any
    ) -> str:
        if field.variable:
            return self._variable(value, variable)
        if isinstance(field.type, Announced):
            return type_.name if isinstance(type_, Scalar) else ""
        if isinstance(type_, Quantity):
            quantity = self._quantity(field, type_, path)
            return physical(value, quantity) + _side(value, quantity, field, path)
        if isinstance(type_, Enum):
            return flag_names(type_, value) if type_.kind == "flags" else self._name(type_, value)
        return _packed_text(type_, value) if isinstance(type_, Packed) else ""

    def _name(self, enum: Enum, value: int) -> str:
        """The name of a value; for two commands with the same id, that of the request."""
        names = [v.name for v in enum.values if v.value == value]
        if len(names) < 2:
            return "".join(names)
        to_board = {m.command for m in self.layout.messages if m.direction == "to_board"}
        return next((name for name in names if name in to_board), names[0])

    def _variable(self, value: int, number: Any) -> str:
        known = next((v for v in self.layout.variables if v.id == number), None)
        if known is None or known.quantity is None:
            return ""
        is_bare = known.quantity.is_plain and not known.quantity.unit
        return "" if is_bare else physical(value, known.quantity)

    def _quantity(self, field: Field, type_: Quantity, path: str) -> Quantity:
        other = field.alternative
        if other is None:
            return type_
        axis = next((a for a in ("roll", "pitch", "yaw") if f".{a}." in f"{path}."), "")
        group = path.rpartition(".")[0] + "." if other.in_group else ""
        flags: Any = value_at(self.whole, group + other.source)
        flags = flags[axis] if isinstance(flags, dict) else flags
        return other.quantity if flags & other.mask else type_


def _index(field: Field, i: int) -> str:
    """The index of a list's element in the paths of leaves."""
    is_single = not field.index and not isinstance(field.type, (Struct, Blob))
    if field.dim == "fixed" or field.index:
        return "" if is_single else f"[{i}]"
    return "[]" if isinstance(field.type, Struct) else ""


def _size(type_: Type, value: Any) -> int:
    if isinstance(type_, Blob):
        if type_.kind == "string":
            return 1 + len(text_to_bytes(value))
        assert type_.size is not None
        return type_.size
    return scalar_of(type_).size


def physical(raw: int | float, quantity: Quantity) -> str:
    """The physical value with its unit: "-30 deg"."""
    number = f"{float(quantity.real(raw)):.6g}"
    return f"{number} {quantity.unit}" if quantity.unit else number


def _side(raw: int | float, quantity: Quantity, field: Field, path: str) -> str:
    """The direction of an angle: " down"; "" if it is unknown.

    A speed may belong to a motion to an angle, which determines the direction.
    """
    if not raw or "/" in (quantity.unit or ""):
        return ""
    found = filter(None, (field.direction(word.upper()) for word in path.split(".")))
    direction = next(found, None)
    word = direction and (direction.positive if raw > 0 else direction.negative)
    return f" {word}" if word else ""


def flag_names(enum: Enum, bits: int) -> str:
    """The flags that are set: "A | B | 0x40"; "" for none."""
    names = []
    bits &= (1 << 8 * enum.scalar.size) - 1
    for value in enum.values:
        if value.value and bits & value.value == value.value:
            names.append(value.name)
            bits &= ~value.value
    return " | ".join(names + ([f"0x{bits:x}"] if bits else []))


def _packed_text(packed: Packed, raw: int) -> str:
    if packed.display:
        return text_of(packed, raw)
    named = [v.name for v in (packed.names.values if packed.names else ()) if v.value == raw]
    if named:
        return named[0]
    return ", ".join(text for part in packed.parts if (text := _part_text(part, raw)))


def _part_text(part: Part, raw: int) -> str:
    value = part_of(part, raw)
    if part.quantity is not None:
        return f"{part.name} {physical(value, part.quantity)}"
    if part.enum is None:
        return f"{part.name} {value}"
    if part.enum.kind == "flags":
        return flag_names(part.enum, value)
    named = [v.name for v in part.enum.values if v.value == value]
    return named[0] if named else f"{part.name} {value}" if value else ""
