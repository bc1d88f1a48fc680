"""The parts of worked examples in C++; templates/example.jinja writes them.

A message is built by steps, and printed by looks at some of its values.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from sbgcgen.model import Announced, Blob, Enum, EnumValue, Field, Packed, Part, Quantity, Scalar
from sbgcgen.model import Struct, Type
from sbgcgen.model.packed_text import part_of
from sbgcgen.oracle.codec import Fields, is_bytes, keys_of
from sbgcgen.oracle.example import Example, Piece, physical
from sbgcgen.oracle.typical import typical_number
from sbgcgen.views.code import decimal, flags_of, parts_that_make, unit_name, value_named

# The maximum number of changed bytes that are assigned one by one.
_SINGLE_BYTES = 8
_WIDTH = 100
# The printf formats for types other than int.
_FORMS = {
    "u24": "%u",
    "u32": "%u",
    "u64": "%llu",
    "i64": "%lld",
    "f32": "%g",
    "f64": "%g",
}


@dataclass(frozen=True)
class Step:
    """One or two statements that build a message. `to` is their target.

    `kind`: "emplace", "resize" (to `value` elements), "append" (the bytes `value`), "byte", "number"
    (of the announced `type`, its bits), or "assign" (a value of `type`).
    """

    kind: str
    to: str
    value: Any = None
    type: Type | None = None
    name: str = ""
    is_optional: bool = False


@dataclass(frozen=True)
class Look:
    """A statement that prints something about a value, and its output.

    The output of a `printf` begins with `text`; `value` is the enumerator or flag to look for.
    """

    kind: str
    printed: str
    access: str
    is_optional: bool
    type: Type
    text: str = ""
    part: Part | None = None
    value: EnumValue | None = None


def access_of(path: str, missing: frozenset[str]) -> str:
    """The C++ expression for a value of `message`; `missing` are the paths that may be missing."""
    text, arrow, at = "message", ".", ""
    for word in re.findall(r"\w+|\[\d+\]", path):
        is_index = word.startswith("[")
        if is_index:
            text = f"(*{text})" if arrow == "->" else text
            arrow = ""
        text += arrow + word
        at += word if is_index or not at else f".{word}"
        arrow = "->" if at in missing else "."
    return text


# Building


def steps_of(example: Example) -> list[Step]:
    """The steps that give a message its values.

    Zeros need none; nor do values that are unchanged since reading.
    """
    return list(_Builder(example).fields(example.message.fields, example.fields, ""))


class _Builder:
    def __init__(self, example: Example) -> None:
        self.example = example
        self.pieces = {piece.path: piece for piece in example.pieces}
        self.changed = example.changed if example.read else None

    def fields(self, fields: tuple[Field, ...], values: Fields, path: str) -> Iterator[Step]:
        for field in fields:
            name = path + field.name
            if field.name in values and not field.is_counter and self._is_changed(name):
                yield from self._field(field, values[field.name], name)

    def _is_changed(self, path: str) -> bool:
        """True if something at a path, or below it, differs from what was read."""
        starts = (f"{path}.", f"{path}[")
        return self.changed is None or any(
            other == path or other.startswith(starts) for other in self.changed
        )

    def _access(self, path: str) -> str:
        return access_of(path, self.example.missing)

    def _field(self, field: Field, value: Any, path: str) -> Iterator[Step]:
        to = self._access(path)
        is_one = field.dim == "one" and not isinstance(field.type, Struct)
        if field.may_be_absent and not is_one:
            yield Step("emplace", to)
            to = f"(*{to})"
        if is_bytes(field):
            if value:
                yield from self._bytes(field, to, bytes.fromhex(value))
        elif field.dim == "one":
            yield from self._one(field, value, path)
        elif field.dim in ("fixed", "counted", "rest"):
            if field.dim != "fixed" and value:
                yield Step("resize", to, len(value))
            for i, item in enumerate(value):
                yield from self._one(field, item, f"{path}[{i}]")
        else:
            for key in keys_of(field):
                yield from self._one(field, value[key], f"{path}.{key}")

    def _bytes(self, field: Field, to: str, data: bytes) -> Iterator[Step]:
        if self.changed is not None:
            yield Step("resize", to, 0)
        if any(data):
            yield Step("append", to, data, name=field.name)
        else:
            yield Step("resize", to, len(data))

    def _one(self, field: Field, value: Any, path: str) -> Iterator[Step]:
        if isinstance(field.type, Struct):
            yield from self.fields(field.type.fields, value, f"{path}.")
            return
        piece, to = self.pieces[path], self._access(path)
        whole = Step("assign", to, value, piece.type, is_optional=piece.may_be_missing)
        if isinstance(field.type, Announced):
            yield Step("number", to, int.from_bytes(piece.data, "little"), piece.type)
        elif self.changed is not None:
            if path in self.changed:
                yield from list(self._single_bytes(piece, to)) or [whole]
        elif piece.may_be_missing or any(piece.data):
            yield whole

    def _single_bytes(self, piece: Piece, to: str) -> Iterator[Step]:
        """Assignments to single bytes, if few of the bytes that were read change."""
        changed = {} if piece.may_be_missing else self.example.changed_bytes(piece)
        if len(changed) <= _SINGLE_BYTES:
            yield from (Step("byte", f"{to}[{i}]", byte) for i, byte in changed.items())


# Looking


def looks_at(example: Example) -> list[Look]:
    """Looks at the values that examples show."""
    return [look for piece in example.shown for look in _looks(piece, example.missing)]


def _looks(piece: Piece, missing: frozenset[str]) -> Iterator[Look]:
    type_, path, value = piece.type, piece.path, piece.value

    def look(kind: str, printed: str, **more: Any) -> Look:
        access = access_of(path, missing)
        return Look(kind, printed, access, piece.may_be_missing, type_, **more)

    def number(kind: str, shown: str) -> Look:
        return look(kind, f"{path}: {shown}", text=f"{path}: ")

    if isinstance(piece.field.type, Announced):
        yield number("number", f"{value:g}")
    elif isinstance(type_, Quantity):
        yield number("quantity", physical(value, type_))
    elif isinstance(type_, Enum) and type_.kind == "flags":
        for flag in type_.values:
            if flag.value and value & flag.value == flag.value:
                yield look("flag", f"{path} has {flag.name}", value=flag)
    elif isinstance(type_, Enum):
        found = value_named(type_, value)
        if found:
            yield look("value", f"{path} is {found.name}", value=found)
    elif isinstance(type_, Packed):
        for part in type_.parts:
            held = part_of(part, value)
            start = f"{path}: {part.name} "
            if part.quantity:
                shown = f"{start}{physical(held, part.quantity)}"
                yield look("quantity", shown, text=start, part=part)
            elif part.enum is None:
                yield look("part", f"{start}{held}", text=start, part=part)
            elif part.enum.kind == "enum" and (found := value_named(part.enum, held)):
                yield look("part value", f"{start}is {found.name}", part=part, value=found)
    elif isinstance(type_, Blob) and type_.kind == "bytes":
        yield number("bytes", f"{len(piece.data)} bytes")
    elif isinstance(type_, Blob):
        yield number("text", value)
    else:
        assert isinstance(type_, Scalar)
        yield number("scalar", f"{value:g}" if type_.is_float else str(value))


# Quantities


def number_and_output(quantity: Quantity) -> tuple[int | float, tuple[str, str]]:
    """An ordinary raw number, and the output for it: itself, and its physical value."""
    raw = typical_number(quantity)
    line = f"on the line: {raw:g}" if quantity.scalar.is_float else f"on the line: {raw}"
    return raw, (line, f"real value: {physical(raw, quantity)}")


# Functions for the templates


def has_literal(code: str) -> bool:
    """True if the code contains a literal of a quantity, such as 45_deg."""
    return re.search(r"\b[0-9.]+_[A-Za-z]", code) is not None


def in_width(line: str) -> str:
    """An assignment, on two lines if it is too long for one."""
    return line if len(line) <= _WIDTH else line.replace(" = ", " =\n    ", 1)


def quoted(text: str) -> str:
    """Text between quotation marks."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


FILTERS: dict[str, Callable[..., Any]] = {
    "decimal": decimal,
    "flags_of": flags_of,
    "has_literal": has_literal,
    "hex_list": lambda data: ", ".join(f"0x{byte:02X}" for byte in data),
    "in_width": in_width,
    "parts_that_make": parts_that_make,
    "printf_form": lambda scalar: _FORMS.get(scalar.name, "%d"),
    "quoted": quoted,
    "unhex": bytes.fromhex,
    "unit_name": unit_name,
    "value_named": value_named,
}
