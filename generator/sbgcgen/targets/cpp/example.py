"""A worked example as C++: building and encoding a message, or decoding one and looking at it."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from sbgcgen.oracle.example import Example, Piece, part_of, real
from sbgcgen.model import (
    Announced,
    Blob,
    Enum,
    Field,
    Message,
    Packed,
    Part,
    Quantity,
    Scalar,
    Struct,
    Type,
)
from sbgcgen.oracle.codec import Fields, is_bytes, keys_of
from sbgcgen.oracle.typical import typical_number
from sbgcgen.targets import Code

# How many values of a long message the example looks at.
_SHOWN = 8
# How many changed bytes are assigned one by one.
_SINGLE_BYTES = 8
# How printf prints what is no int.
_FORMS = {"u32": "%u", "f32": "%g"}


def _code(includes: tuple[str, ...], lines: list[str], output: list[str]) -> Code:
    return Code("C++", "cpp", "\n".join([*includes, "", *lines]), tuple(output))


def encoding(example: Example) -> Code:
    """Builds the message and writes its frame into `frame`, of which it uses `written.size` bytes."""
    message = example.message
    lines = [
        *(_reading(example.read, message.name) if example.read else ()),
        *([] if example.read else [f"sbgc::{message.name} message;"]),
        *_Builder(example).steps(),
        "std::array<std::uint8_t, sbgc::max_frame_size> frame{};",
        "const sbgc::WriteResult written = sbgc::encode_frame(message, frame);",
        f"// written.size is {len(example.frame)}: the first bytes of frame are the ones above.",
    ]
    used = "\n".join(lines)
    includes = ["<array>", "<cstdint>"]
    includes += ["<string_view>"] if "std::string_view" in used else []
    return _code(_includes(includes, ["message", f"messages/{message.family}"]), lines, [])


def _reading(read: Example, name: str) -> Iterator[str]:
    """Makes the message of what the board has said."""
    yield f"// The body of the {read.message.name} that the board has sent when it was asked."
    yield from _wrapped(f"constexpr std::array<std::uint8_t, {len(read.body)}> answer", read.body)
    yield f"sbgc::{read.message.name} read;"
    yield "if (!sbgc::decode(answer, read)) return;"
    yield "// All of it goes back, but for what is changed on purpose."
    yield f"sbgc::{name} message{{read}};"


def decoding(example: Example) -> Code:
    """Finds the frame among bytes, decodes it and prints some of its values."""
    message = example.message
    steps: list[str] = []
    output: list[str] = []
    for piece in _worth_showing(example):
        for statement, printed in _shown(piece):
            steps += statement.split("\n")
            output.append(printed)
    arguments = "frame.body, message"
    context: list[str] = []
    if example.context:
        arguments += ", context"
        context = "\n".join(_context(message, example.context)).split("\n")
    size = len(example.frame)
    lines = [
        *_wrapped(f"constexpr std::array<std::uint8_t, {size}> bytes", example.frame),
        "sbgc::Parser parser;",
        "parser.feed(bytes, [](const sbgc::Frame& frame) {",
        *(f"  {line}" for line in context),
        f"  sbgc::{message.name} message;",
        f"  if (!sbgc::decode({arguments})) return;",
        *(f"  {line}" for line in steps),
        "});",
    ]
    includes = ["<array>", "<cstdint>"] + (["<cstdio>"] if steps else [])
    ours = [f"messages/{message.family}", "parser"]
    return _code(_includes(includes, ours), lines, output)


def _includes(standard: list[str], ours: list[str]) -> tuple[str, ...]:
    return (
        *(f"#include {name}" for name in standard),
        "",
        *(f"#include <sbgc/{name}.hpp>" for name in ours),
    )


def _bytes(data: bytes) -> Iterator[str]:
    for start in range(0, len(data), 12):
        yield ", ".join(f"0x{byte:02X}" for byte in data[start : start + 12]) + ","


# Building


class _Builder:
    """The statements that give a message its values.

    What is zero needs none; nor does what is still as it was read.
    """

    def __init__(self, example: Example) -> None:
        self.example = example
        self.pieces = {piece.path: piece for piece in example.pieces}
        self.changed = example.changed if example.read else None

    def steps(self) -> Iterator[str]:
        message = self.example.message
        yield from self._fields(message.fields, self.example.fields, "", "message.")

    def _fields(
        self, fields: tuple[Field, ...], values: Fields, path: str, access: str
    ) -> Iterator[str]:
        for field in fields:
            if (
                field.name in values
                and not field.is_counter
                and self._is_changed(path + field.name)
            ):
                yield from self._field(field, values[field.name], path, access)

    def _is_changed(self, path: str) -> bool:
        """Whether something at a path, or in it, is not as it was read."""
        starts = (f"{path}.", f"{path}[")
        return self.changed is None or any(
            other == path or other.startswith(starts) for other in self.changed
        )

    def _field(self, field: Field, value: Any, path: str, access: str) -> Iterator[str]:
        name, cpp = path + field.name, access + field.name
        is_one = field.dim == "one" and not isinstance(field.type, Struct)
        dot = "."
        if field.when and not is_one:
            yield f"{cpp}.emplace();"
            dot = "->"
        if is_bytes(field):
            if value:
                target = f"(*{cpp})" if field.when else cpp
                if self.changed is not None:
                    yield f"{target}.resize(0);"
                yield from _fill(target, field.name, bytes.fromhex(value))
        elif field.dim == "one":
            yield from self._one(field, value, name, cpp, dot)
        elif field.dim in ("fixed", "counted", "rest"):
            list_ = f"(*{cpp})" if field.when else cpp
            if field.dim != "fixed" and value:
                yield f"{list_}.resize({len(value)});"
            for i, item in enumerate(value):
                yield from self._one(field, item, f"{name}[{i}]", f"{list_}[{i}]", ".")
        else:
            for key in keys_of(field):
                yield from self._one(field, value[key], f"{name}.{key}", f"{cpp}{dot}{key}", ".")

    def _one(self, field: Field, value: Any, path: str, cpp: str, dot: str) -> Iterator[str]:
        if isinstance(field.type, Struct):
            yield from self._fields(field.type.fields, value, f"{path}.", cpp + dot)
            return
        piece = self.pieces[path]
        if isinstance(field.type, Announced):
            assert isinstance(piece.type, Scalar)
            bits = int.from_bytes(piece.data, "little")
            yield f"{cpp} = {{sbgc::NumberType::{piece.type.name}, 0x{bits:X}U}};"
        elif self.changed is not None:
            if path in self.changed:
                single = list(self._changed_bytes(piece, cpp))
                yield from single or _assigned(piece.type, value, cpp, piece.may_be_missing)
        elif piece.may_be_missing or any(piece.data):
            yield from _assigned(piece.type, value, cpp, piece.may_be_missing)

    def _changed_bytes(self, piece: Piece, cpp: str) -> Iterator[str]:
        """Assignments to single bytes, if few of those that were read change."""
        is_bytes_ = isinstance(piece.type, Blob) and piece.type.kind == "bytes"
        if self.example.read is None or not is_bytes_ or piece.may_be_missing:
            return
        before = next(p.data for p in self.example.read.pieces if p.path == piece.path)
        places = [i for i, (old, new) in enumerate(zip(before, piece.data)) if old != new]
        if len(places) <= _SINGLE_BYTES:
            yield from (f"{cpp}[{i}] = 0x{piece.data[i]:02X};" for i in places)


def _fill(cpp: str, name: str, data: bytes) -> Iterator[str]:
    """Bytes into a list of them."""
    if not any(data):
        yield f"{cpp}.resize({len(data)});"
        return
    yield from _wrapped(f"constexpr std::array<std::uint8_t, {len(data)}> {name}", data)
    yield f"for (const std::uint8_t byte : {name}) {cpp}.push_back(byte);"


def _wrapped(before: str, data: bytes) -> Iterator[str]:
    """`before{0x01, 0x02};`, on several lines if need be."""
    lines = list(_bytes(data))
    if len(lines) == 1:
        yield f"{before}{{{lines[0].rstrip(',')}}};"
    else:
        yield f"{before}{{"
        yield from (f"    {line}" for line in lines)
        yield "};"


def _if(test: str, text: str) -> str:
    return f'if ({test}) {{\n  std::puts("{text}");\n}}'


def _assigned(type_: Type, value: Any, cpp: str, is_optional: bool) -> Iterator[str]:
    if isinstance(type_, Blob) and is_optional:
        yield f"{cpp}.emplace();"
    if isinstance(type_, Blob) and type_.kind == "bytes":
        if any(bytes.fromhex(value)):
            target = f"*{cpp}" if is_optional else cpp
            yield from _wrapped(f"{target} = ", bytes.fromhex(value))
    elif isinstance(type_, Blob):
        yield f"{cpp}{'->' if is_optional else '.'}assign(std::string_view({_quoted(value)}));"
    elif isinstance(type_, Packed):
        yield from _packed(type_, value, cpp, is_optional)
    else:
        expression = _expression(type_, value)
        if is_optional and " | " not in expression and isinstance(type_, (Quantity, Enum)):
            expression = f"sbgc::{type_.name}({expression})"  # one conversion, not two
        line = f"{cpp} = {expression};"
        yield line if len(line) <= 100 else line.replace(" = ", " =\n    ", 1)


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def _expression(type_: Type, value: Any) -> str:
    if isinstance(type_, Quantity):
        if type_.scalar.is_float:
            return f"sbgc::{type_.name}({value!r}F)"
        return f"sbgc::{type_.name}::from_{type_.accessor}({decimal(value, type_)})"
    if isinstance(type_, Enum) and type_.kind == "flags":
        return _flags(type_, value)
    if isinstance(type_, Enum):
        return _enumerator(type_, value)
    assert isinstance(type_, Scalar), f"no expression for {type_}"
    if type_.is_float:
        return f"{value!r}F"
    return f"{value}U" if value > 0x7FFFFFFF else str(value)


def _enumerator(enum: Enum, value: int) -> str:
    found = next((v for v in enum.values if v.value == value), None)
    name = f"sbgc::{enum.name}"
    return f"{name}::{found.identifier}" if found else f"static_cast<{name}>({value})"


def _flags(enum: Enum, value: int) -> str:
    names = [v for v in enum.values if v.value and value & v.value == v.value]
    covered = 0
    for flag in names:
        covered |= flag.value
    if not names or covered != value:
        return f"sbgc::{enum.name}({value})"
    return " | ".join(f"sbgc::{enum.member}::{flag.identifier}" for flag in names)


def _packed(packed: Packed, raw: int, cpp: str, is_optional: bool) -> Iterator[str]:
    named = [v for v in (packed.names.values if packed.names else ()) if v.value == raw]
    if named and packed.names:
        yield f"{cpp} = {_enumerator(packed.names, raw)};"
        return
    made = 0
    for part in packed.parts:
        made |= 0 if part.is_digits else part_of(part, raw) << part.shift
    if made != raw or is_optional or raw < 0:
        yield f"{cpp} = sbgc::{packed.name}({raw});"
        return
    for part in packed.parts:
        if part_of(part, raw):
            yield f"{cpp}.set_{part.name}({_part(part, part_of(part, raw))});"


def _part(part: Part, value: int) -> str:
    if part.enum:
        return (
            _flags(part.enum, value) if part.enum.kind == "flags" else _enumerator(part.enum, value)
        )
    return ("true" if value else "false") if part.is_bool else str(value)


def decimal(raw: int, quantity: Quantity) -> str:
    """The shortest decimal number to which this raw value is the nearest one."""
    exact = real(raw, quantity)
    for digits in range(12):
        text = f"{float(exact):.{digits}f}"
        steps = (Fraction(text) - quantity.offset) / quantity.scale
        if abs(steps - raw) < Fraction(1, 2):
            return text
    raise ValueError(f"no decimal for {raw} of {quantity.name}")


# Looking


def _worth_showing(example: Example) -> list[Piece]:
    """One value of each field, as far as there is room for them."""
    seen: set[int] = set()
    result = []
    for piece in example.pieces:
        is_new = id(piece.field) not in seen or isinstance(piece.field.type, Announced)
        if is_new and not piece.is_padding and not piece.field.is_counter:
            seen.add(id(piece.field))
            result.append(piece)
    return result[:_SHOWN]


def _shown(piece: Piece) -> Iterator[tuple[str, str]]:
    """Statements that print a value, each with what it prints."""
    dot = "->" if piece.may_be_missing else "."
    value = f"*{piece.access}" if piece.may_be_missing else piece.access
    type_, path = piece.type, piece.path

    def printf(form: str, expression: str, printed: str) -> tuple[str, str]:
        return f'std::printf("{form}\\n", {expression});', printed

    if isinstance(piece.field.type, Announced):
        yield printf(f"{path}: %g", f"{piece.access}.value()", f"{path}: {piece.value:g}")
    elif isinstance(type_, Quantity):
        number = f"{float(real(piece.value, type_)):g}"
        unit = f" {type_.unit}" if type_.unit else ""
        form = f"{path}: %g" + unit.replace("%", "%%")
        yield printf(form, f"{piece.access}{dot}{type_.accessor}()", f"{path}: {number}{unit}")
    elif isinstance(type_, Enum) and type_.kind == "flags":
        for flag in type_.values:
            if flag.value and piece.value & flag.value == flag.value:
                test = f"{piece.access}{dot}has(sbgc::{type_.member}::{flag.identifier})"
                text = f"{path} has {flag.name}"
                yield _if(test, text), text
    elif isinstance(type_, Enum):
        found = next((v for v in type_.values if v.value == piece.value), None)
        if found:
            text = f"{path} is {found.name}"
            test = f"{value} == sbgc::{type_.name}::{found.identifier}"
            yield _if(test, text), text
    elif isinstance(type_, Packed):
        yield from _shown_parts(type_, piece, dot)
    elif isinstance(type_, Blob) and type_.kind == "bytes":
        size = len(piece.data)
        yield printf(f"{path}: %zu bytes", f"{piece.access}{dot}size()", f"{path}: {size} bytes")
    elif isinstance(type_, Blob):
        text = f"static_cast<int>({piece.access}{dot}size()),\n"
        text += f"            {piece.access}{dot}data()"
        yield printf(f"{path}: %.*s", text, f"{path}: {piece.value}")
    else:
        assert isinstance(type_, Scalar)
        if type_.is_float:
            yield printf(f"{path}: %g", f"static_cast<double>({value})", f"{path}: {piece.value:g}")
        else:
            form = _FORMS.get(type_.name, "%d")
            yield printf(f"{path}: {form}", value, f"{path}: {piece.value}")


def _shown_parts(packed: Packed, piece: Piece, dot: str) -> Iterator[tuple[str, str]]:
    form = _FORMS.get(packed.scalar.name, "%d")
    for part in packed.parts:
        call = f"{piece.access}{dot}{part.name}()"
        number = part_of(part, piece.value)
        if part.enum and part.enum.kind == "flags":
            continue
        if part.enum:
            found = next((v for v in part.enum.values if v.value == number), None)
            if found:
                text = f"{piece.path}: {part.name} is {found.name}"
                test = f"{call} == sbgc::{part.enum.name}::{found.identifier}"
                yield _if(test, text), text
        else:
            text = f"{piece.path}: {part.name} "
            is_number = not part.is_bool
            yield (
                f'std::printf("{text}{form if is_number else "%d"}\\n", {call});',
                f"{text}{number}",
            )


def _context(message: Message, known: Fields) -> Iterator[str]:
    """What an earlier message has told, told by hand."""
    yield f"sbgc::{message.same_as or message.name}::Context context;"
    for context in message.contexts:
        value = known[context.name]
        if context.type:
            yield f"context.{context.name} =\n    {_expression(context.type, value)};"
        else:
            for word in value:
                yield f"context.{context.name}.push_back(sbgc::NumberType::{word});"


def code_of(example: Example) -> Code:
    """The example for whoever stands at the host: encode what goes to the board, else decode."""
    message = example.message
    both = message.in_both_directions
    return encoding(example) if both or message.direction == "to_board" else decoding(example)


def converting(quantity: Quantity) -> Code:
    """Turns a number into a quantity and back."""
    raw = typical_number(quantity)
    unit = f" {quantity.unit}" if quantity.unit else ""
    number = f"{float(real(raw, quantity)):g}"
    form = _FORMS.get(quantity.scalar.name, "%d")
    read = "static_cast<double>(value.raw())" if quantity.scalar.is_float else "value.raw()"
    lines = [
        f"const sbgc::{quantity.name} value =",
        f"    {_expression(quantity, raw)};",
        f'std::printf("on the line: {form}\\n", {read});',
        f'std::printf("real value: %g{unit.replace("%", "%%")}\\n", value.{quantity.accessor}());',
    ]
    printed = f"on the line: {raw:g}" if quantity.scalar.is_float else f"on the line: {raw}"
    includes = _includes(["<cstdio>"], ["units"])
    return _code(includes, lines, [printed, f"real value: {number}{unit}"])
