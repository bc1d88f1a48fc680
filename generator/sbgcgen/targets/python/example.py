"""The Python of worked examples."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Union

from sbgcgen.model import Announced, Blob, Enum, Field, Packed, Quantity, Scalar, Struct, Type
from sbgcgen.oracle.codec import Fields, is_bytes, keys_of
from sbgcgen.oracle.example import Example, Piece, physical
from sbgcgen.views.code import attribute_name, decimal, enum_name, flags_of, parts_that_make
from sbgcgen.views.code import value_named

_WIDTH = 80
# The number of bytes per line.
_RUN = 16
# The maximum number of changed bytes that are assigned one by one.
_SINGLE_BYTES = 8


@dataclass(frozen=True)
class Call:
    """An expression with nested ones, which get a line each if they do not fit on one."""

    head: str
    parts: tuple[tuple[str, Code], ...]
    tail: str = ")"
    separator: str = ","


Code = Union[str, Call]


def lines_of(before: str, code: Code, after: str = "", indent: int = 0) -> list[str]:
    """The lines of code between two texts."""
    margin = " " * indent
    whole = f"{margin}{before}{_one_line(code)}{after}"
    if isinstance(code, str) or (len(whole) <= _WIDTH and code.separator):
        return [whole]
    inside = [
        line
        for name, part in code.parts
        for line in lines_of(name, part, code.separator, indent + 4)
    ]
    return [f"{margin}{before}{code.head}", *inside, f"{margin}{code.tail}{after}"]


def _one_line(code: Code) -> str:
    if isinstance(code, str):
        return code
    parts = (name + _one_line(part) for name, part in code.parts)
    return f"{code.head}{f'{code.separator} '.join(parts)}{code.tail}"


def _hex(data: bytes) -> Code:
    """Bytes, split into several lines if there are many."""
    runs = [f'"{data[at : at + _RUN].hex(" ").upper()}"' for at in range(0, len(data), _RUN)]
    if len(runs) < 2:
        return f"bytes.fromhex({''.join(runs) or repr('')})"
    return Call("bytes.fromhex(", tuple(("", run) for run in runs), separator="")


def encoding(example: Example) -> str:
    """A program that makes the frame of an example."""
    message = example.message
    maker = _Maker(example)
    if example.read:
        lines = [
            f"# The body of a {example.read.message.name} that was requested from the board.",
            *lines_of("body = ", _hex(example.read.body)),
            "# Start from the values read, and change only those below.",
            f"message = msg.{message.name}.from_body(body)",
            *maker.changes(),
        ]
    else:
        made = Call(f"msg.{message.name}(", tuple(maker.arguments(message.fields, example.fields)))
        lines = [*lines_of("message = ", made), *maker.later]
    lines += [
        "frame = encode(message)",
        f"# The {len(example.frame)} bytes of `frame` are the ones above.",
    ]
    return "\n".join(["from sbgc import encode, msg", "", *lines])


def decoding(example: Example) -> tuple[str, tuple[str, ...]]:
    """A program that decodes the frame of an example, and its output."""
    names = {"decode"}
    lines, known = [], ""
    if example.before:
        names |= {"Contexts", "Direction"}
        known = ", contexts=contexts"
        lines.append("contexts = Contexts()")
    for earlier in example.before:
        lines += lines_of("earlier = ", _hex(earlier.frame))
        lines.append(f"contexts.learn(decode(earlier, Direction.{earlier.direction.upper()}))")
    lines += lines_of("frame = ", _hex(example.frame))
    lines.append(f"message = decode(frame{known})")
    output = []
    for piece in example.shown:
        shown, printed = _look(piece)
        lines.append(f'print(f"{piece.path}: {shown}")')
        output.append(f"{piece.path}: {printed}")
    return "\n".join([f"from sbgc import {', '.join(sorted(names))}", "", *lines]), tuple(output)


def _access(path: str) -> str:
    """The Python expression for a value of `message`."""
    return "message." + ".".join(map(attribute_name, path.split(".")))


def _is_raw(field: Field, value: Any) -> bool:
    """True if only the raw number expresses the meaning."""
    is_special = any(special.value == value for special in field.special)
    return bool(field.variable) or (isinstance(field.type, Quantity) and is_special)


class _Maker:
    """The expressions for the values of an example; `later` are statements after them."""

    def __init__(self, example: Example) -> None:
        self.example = example
        self.pieces = {piece.path: piece for piece in example.pieces}
        self.later: list[str] = []

    def arguments(
        self, fields: tuple[Field, ...], values: Fields, path: str = ""
    ) -> Iterator[tuple[str, Code]]:
        """The values that are not zero, by keywords."""
        for field in fields:
            name = path + field.name
            if field.name in values and not field.is_counter:
                code = self._field(field, values[field.name], name)
                if code:
                    yield f"{attribute_name(field.name)}=", code

    def changes(self) -> Iterator[str]:
        """Assignments of values that differ from what was read."""
        for piece in self.example.pieces:
            if piece.path in self.example.changed:
                to = _access(piece.path)
                single = list(self._single_bytes(piece, to))
                yield from single or lines_of(f"{to} = ", _value(piece.type, piece.value))

    def _single_bytes(self, piece: Piece, to: str) -> Iterator[str]:
        """Assignments to single bytes, if few of many change."""
        changed = self.example.changed_bytes(piece)
        if 0 < len(changed) <= _SINGLE_BYTES:
            yield f"data = bytearray({to})"
            yield from (f"data[{at}] = 0x{byte:02X}" for at, byte in changed.items())
            yield f"{to} = data"

    def _field(self, field: Field, value: Any, path: str) -> Code:
        """The value of a field; "" if it equals that of a new message."""
        if is_bytes(field):
            return _hex(bytes.fromhex(value)) if value else ""
        if field.dim == "one":
            return self._one(field, value, path)
        if field.dim in ("fixed", "counted", "rest"):
            elements = [self._one(field, v, f"{path}[{i}]", True) for i, v in enumerate(value)]
            is_empty = field.dim == "fixed" and not self._is_said(path)
            return "" if is_empty else Call("[", tuple(("", e) for e in elements), "]")
        name = "Axes" if field.dim == "axis" else "Xyz"
        codes = {key: self._one(field, value[key], f"{path}.{key}") for key in keys_of(field)}
        said = tuple((f"{key}=", code) for key, code in codes.items() if code)
        return Call(f"msg.{name}(", said) if said else ""

    def _one(self, field: Field, value: Any, path: str, is_element: bool = False) -> Code:
        if isinstance(field.type, Struct):
            inside = tuple(self.arguments(field.type.fields, value, f"{path}."))
            return Call(f"msg.{field.type.name}(", inside) if inside or is_element else ""
        piece = self.pieces[path]
        if not is_element and not piece.may_be_missing and not any(piece.data):
            return ""
        if _is_raw(field, value) and field.dim == "one":
            self.later.append(f"{_access(path)}_raw = {value}")
            return ""
        return _value(piece.type, value)

    def _is_said(self, path: str) -> bool:
        """True if something in a list is not zero."""
        return any(any(p.data) for name, p in self.pieces.items() if name.startswith(f"{path}["))


def _value(type_: Type, value: Any) -> Code:
    """The expression for one value."""
    if isinstance(type_, Quantity):
        return f"{float(type_.real(value)):.7g}" if type_.scalar.is_float else decimal(value, type_)
    if isinstance(type_, Enum):
        return _enum(type_, value)
    if isinstance(type_, Packed):
        return _packed(type_, value)
    if isinstance(type_, Blob):
        return _hex(bytes.fromhex(value)) if type_.kind == "bytes" else json.dumps(value)
    assert isinstance(type_, Scalar)
    return str(value)


def _enum(type_: Enum, value: int) -> str:
    if type_.kind == "flags":
        names = [f"msg.{type_.name}.{enum_name(flag)}" for flag in flags_of(type_, value)]
        return " | ".join(names) or f"msg.{type_.name}({value:#x})"
    named = value_named(type_, value)
    return f"msg.{type_.name}.{enum_name(named)}" if named else f"msg.{type_.name}({value})"


def _packed(type_: Packed, value: int) -> Code:
    parts = parts_that_make(type_, value)
    if parts is None or (type_.names and value_named(type_.names, value)):
        return f"msg.{type_.name}({value})"
    said = []
    for part, number in parts:
        code: Code = str(number)
        if part.enum or part.quantity:
            code = _value(part.enum or part.quantity, number)  # type: ignore[arg-type]
        elif part.is_bool:
            code = "True"
        said.append((f"{attribute_name(part.name)}=", code))
    return Call(f"msg.{type_.name}(", tuple(said))


def _look(piece: Piece) -> tuple[str, str]:
    """The expression in a formatted string for a value, and the resulting text."""
    type_, value, at = piece.type, piece.value, _access(piece.path)
    if isinstance(piece.field.type, Announced):
        return f"{{{at}:g}}", f"{value:g}"
    if piece.field.variable:
        return f"{{{at}_raw}}", str(value)
    if isinstance(type_, Quantity):
        unit = f" {type_.unit}" if type_.unit else ""
        return f"{{{at}:g}}{unit}", physical(value, type_)
    if isinstance(type_, Enum) and type_.kind == "flags":
        return f"{{{at}!r}}", _flags(type_, value)
    if isinstance(type_, Enum):
        named = value_named(type_, value)
        return f"{{{at}.name}}", enum_name(named) if named else str(value)
    if isinstance(type_, Packed):
        return f"{{{at}}}", piece.meaning or str(value)
    if isinstance(type_, Blob) and type_.kind == "bytes":
        return f"{{len({at})}} bytes", f"{len(piece.data)} bytes"
    if isinstance(type_, Blob):
        return f"{{{at}}}", value
    assert isinstance(type_, Scalar)
    return (f"{{{at}:g}}", f"{value:g}") if type_.is_float else (f"{{{at}}}", str(value))


def _flags(type_: Enum, bits: int) -> str:
    """Flags as Python shows them: the named ones, and the rest as a number."""
    said, rest = [], bits
    for flag in type_.values:
        if flag.value and rest & flag.value == flag.value:
            said.append(f"{type_.name}.{enum_name(flag)}")
            rest &= ~flag.value
    return " | ".join([*said, *([f"{type_.name}({rest:#x})"] if rest or not said else [])])
