"""A second codec, read straight off the Layout model: slow, small, and meant to be obviously right.

It shares no template and no line with the generated C++, so what both agree on is what the model
says. The test vectors come from it (vectors.py). Bodies are `bytes`; messages are the `fields` of
`sbgc decode --format jsonl`: objects for structs and axes, lists for arrays, lower-case hex for
bytes, strings for texts, raw integers for everything else; a number of announced type stands as
{"i16": -5}.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from typing import Any

from sbgcgen.model import (
    SCALARS,
    Announced,
    Blob,
    Condition,
    Enum,
    Field,
    Framing,
    Layout,
    Message,
    Packed,
    Quantity,
    Scalar,
    Struct,
    Type,
)

Fields = dict[str, Any]
Forms = dict[tuple[str, int], list[Message]]


class CodecError(Exception):
    """What sbgc::Status says: `code` by its name in JSON, the field, and the byte of the body."""

    def __init__(self, code: str, field: str = "", offset: int = 0) -> None:
        super().__init__(f"{code} at {offset}" + (f" ({field})" if field else ""))
        self.code = code
        self.field = field
        self.offset = offset


# Texts and floats


def text_from_bytes(data: bytes) -> str:
    """Any bytes as text: a byte that is not UTF-8 stands as the character U+F700 + byte.

    Characters that would look like such a byte are taken apart, so that nothing is ambiguous.
    """
    result = ""
    for char in data.decode("utf-8", "surrogateescape"):
        if "\udc80" <= char <= "\udcff":
            result += chr(0xF700 + ord(char) - 0xDC00)
        elif "\uf780" <= char <= "\uf7ff":
            result += "".join(chr(0xF700 + byte) for byte in char.encode())
        else:
            result += char
    return result


def text_to_bytes(text: str) -> bytes:
    """The bytes that text_from_bytes() has written so."""
    return b"".join(
        bytes((ord(char) - 0xF700,)) if "\uf780" <= char <= "\uf7ff" else char.encode()
        for char in text
    )


def float_from_bits(bits: int) -> float | str:
    """A number; "inf", "-inf" and "nan:<bits>" for what JSON has no number for."""
    value = float(struct.unpack("<f", bits.to_bytes(4, "little"))[0])
    if math.isfinite(value):
        return value
    if math.isinf(value):
        return "inf" if value > 0 else "-inf"
    return f"nan:{bits:08x}"


def float_to_bits(value: Any) -> int:
    """The bits of what float_from_bits() has written; ValueError for anything else."""
    if isinstance(value, str) and value.startswith("nan:"):
        return int(value[4:], 16)
    if value not in ("inf", "-inf") and not isinstance(value, (int, float)):
        raise ValueError("no number")
    try:
        return int.from_bytes(struct.pack("<f", float(value)), "little")
    except OverflowError as error:
        raise ValueError("too large") from error


# What the model says about a field


def scalar_of(type_: Type) -> Scalar:
    """The number on the wire behind a type that has one."""
    if isinstance(type_, Scalar):
        return type_
    assert isinstance(type_, (Quantity, Enum, Packed)), f"no number: {type_}"
    return type_.scalar


def is_bytes(field: Field) -> bool:
    """Whether the member is a run of bytes, which stands as hex."""
    type_ = field.type
    return isinstance(type_, Blob) and type_.kind == "bytes" and type_.size is None


def keys_of(field: Field) -> tuple[str, ...]:
    """The members of a value for each axis: roll, pitch, yaw."""
    return tuple(word.lower() for word in field.index)


def holds(when: Condition, value: int | None) -> bool:
    """Whether a condition holds for the value of what it depends on, None if that is missing."""
    if value is None:
        return False
    if when.mask:
        return value & when.mask == when.mask
    return value in [v.value for v in when.values]


def fixed_part(fields: tuple[Field, ...]) -> tuple[Field, ...]:
    """The leading fields that have their place whatever the message holds.

    Their size is checked once for all of them, which shows in what an error says.
    """
    if any(f.is_counter for f in fields):
        return ()
    result = []
    for field in fields:
        if field.offset is None or field.is_variable:
            break
        result.append(field)
    return tuple(result)


LISTS = ("fixed", "counted", "rest")


# Decoding


class _Reader:
    """A place in a body; whoever reads says for which field."""

    def __init__(self, body: bytes, at: int = 0) -> None:
        self.body = body
        self.at = at

    def left(self) -> int:
        return len(self.body) - self.at

    def take(self, size: int, field: str) -> bytes:
        if self.left() < size:
            raise CodecError("too_short", field, len(self.body))
        self.at += size
        return self.body[self.at - size : self.at]


def decode(message: Message, body: bytes, context: Fields | None = None) -> Fields:
    """The fields of a body.

    `context` has what earlier messages have told: raw values, and lists of the names of types.
    """
    fixed = fixed_part(message.fields)
    size = sum(f.size or 0 for f in fixed)
    exact = len(fixed) == len(message.fields) and not message.keeps_tail
    if len(body) < size or (exact and len(body) != size):
        raise CodecError("too_short" if len(body) < size else "too_long", "", min(len(body), size))
    reader = _Reader(body)
    values = _read_fields(message.fields, reader, context or {})
    if message.keeps_tail:
        if reader.left() > message.tail_capacity:
            everything = len(fixed) == len(message.fields)
            raise CodecError("too_long", *(("", 255) if everything else ("tail", reader.at)))
        if reader.left():
            values["tail"] = reader.take(reader.left(), "tail").hex()
    elif reader.left():
        raise CodecError("too_long", "", reader.at)
    return values


def _read_fields(fields: tuple[Field, ...], reader: _Reader, context: Fields) -> Fields:
    values: Fields = {}
    for field in fields:
        if field.when:
            known = context if field.when.from_context else values
            if not holds(
                field.when, known.get(field.when.source, 0 if field.when.from_context else None)
            ):
                continue
            if field.when.may_be_missing and reader.left() < (field.size or 0):
                continue
        values[field.name] = _read_field(field, reader, values, context)
    return values


def _read_announced(types: list[str], reader: _Reader, field: Field) -> list[Fields]:
    """Numbers of announced types, as many as there are bytes for."""
    numbers = []
    for name in types:
        if reader.left() < SCALARS[name].size:
            break
        numbers.append({name: _read_value(SCALARS[name], reader, field.name)})
    return numbers


def _read_field(field: Field, reader: _Reader, values: Fields, context: Fields) -> Any:
    if field.dim == "one":
        if isinstance(field.type, Struct) and field.type.is_region:
            return _read_region(field.type, reader, values)
        return _read_value(field.type, reader, field.name)
    if field.dim not in LISTS:
        return {key: _read_value(field.type, reader, field.name) for key in keys_of(field)}
    if isinstance(field.type, Announced):
        return _read_announced(context.get(field.type.context, []), reader, field)
    count = _count(field, reader, values)
    if is_bytes(field):
        return reader.take(count, field.name).hex()
    return [_read_value(field.type, reader, field.name) for _ in range(count)]


def _count(field: Field, reader: _Reader, values: Fields) -> int:
    if field.dim == "fixed":
        return field.count
    if field.dim == "counted":
        count = int(values[field.counter])
        if count > field.capacity:  # so many elements would not fit into any body
            raise CodecError("too_short", field.name, reader.at)
        return count
    size = 1 if is_bytes(field) else _size_of(field.type)
    if reader.left() % size or reader.left() // size < field.min_count:
        raise CodecError("too_short", field.name, len(reader.body))
    if reader.left() // size > field.capacity:
        raise CodecError("too_long", field.name, reader.at)
    return reader.left() // size


def _size_of(type_: Type) -> int:
    size = type_.size if isinstance(type_, (Blob, Struct)) else scalar_of(type_).size
    assert size is not None, f"the size of {type_} varies"
    return size


def _read_value(type_: Type, reader: _Reader, name: str) -> Any:
    if isinstance(type_, Struct):
        if type_.size is not None:  # is there as a whole, or not at all
            reader = _Reader(reader.take(type_.size, name))
        return _read_fields(type_.fields, reader, {})
    if isinstance(type_, Blob):
        return _read_blob(type_, reader, name)
    scalar = scalar_of(type_)
    data = reader.take(scalar.size, name)
    if scalar.is_float:
        return float_from_bits(int.from_bytes(data, "little"))
    return int.from_bytes(data, "little", signed=scalar.name[0] == "i")


def _read_blob(type_: Blob, reader: _Reader, name: str) -> str:
    if type_.kind == "string":
        return text_from_bytes(reader.take(reader.take(1, name)[0], name))
    assert type_.size is not None, "bytes without a size are the rest of a body"
    data = reader.take(type_.size, name)
    return text_from_bytes(data.rstrip(b"\0")) if type_.kind == "text" else data.hex()


def _read_region(type_: Struct, reader: _Reader, around: Fields) -> Fields:
    """A region has its size whatever is in it; its conditions are about the fields around it."""
    assert type_.size is not None
    inner = _Reader(reader.take(type_.size, ""))
    values: Fields = {}
    for field in type_.fields:
        if field.when and not holds(field.when, around.get(field.when.source)):
            continue
        values[field.name] = _read_field(field, inner, values, {})
    return values


# Encoding


class _Writer:
    """A body in the making, of at most `limit` bytes, the first of which is byte `base`."""

    def __init__(self, limit: int, base: int = 0) -> None:
        self.data = bytearray()
        self.limit = limit
        self.base = base
        self.missing: list[tuple[int, int, str]] = []  # up to which byte, from where, what

    @property
    def at(self) -> int:
        return self.base + len(self.data)

    def put(self, data: bytes, field: str) -> None:
        if len(self.data) + len(data) > self.limit:
            raise CodecError("buffer_too_small", field, self.at)
        self.data += data


def encode(message: Message, fields: Fields, limit: int = 255) -> bytes:
    """The body that holds these fields, of at most `limit` bytes.

    Beyond what the C++ codec can report, values of the wrong kind or size are refused: there, the
    types of the members see to that.
    """
    writer = _Writer(limit)
    given = dict(fields)
    tail = str(given.pop("tail", "")) if message.keeps_tail else ""
    _write_fields(message.fields, given, writer, "")
    writer.put(_hex(tail, None, "tail", writer), "tail")
    # What follows a missing value must be too short to be taken for it.
    for end, at, name in sorted(writer.missing, key=lambda entry: entry[0])[:1]:
        if writer.at >= end:
            raise CodecError("presence_mismatch", name, at)
    return bytes(writer.data)


def _write_fields(
    fields: tuple[Field, ...], values: Fields, writer: _Writer, path: str, around: Any = None
) -> None:
    conditions = values if around is None else around
    unknown = values.keys() - {f.name for f in fields}
    if unknown:
        raise CodecError("presence_mismatch", path + min(unknown), writer.at)
    for field in fields:
        name = path + field.name
        present = field.name in values
        if field.is_counter:
            _write_counter(fields, field, values, writer, name)
        elif field.when:
            # A context is not at hand here, so what depends on one is written if it is there.
            if not field.when.from_context:
                wanted = holds(field.when, conditions.get(field.when.source))
                if present != wanted and (present or not field.when.may_be_missing):
                    raise CodecError("presence_mismatch", name, writer.at)
                if wanted and not present:
                    writer.missing.append((writer.at + (field.size or 0), writer.at, name))
            if present:
                _write_field(field, values[field.name], writer, name, values)
        elif present:
            _write_field(field, values[field.name], writer, name, values)
        elif not field.optional:
            raise CodecError("presence_mismatch", name, writer.at)


def _write_counter(
    fields: tuple[Field, ...], counter: Field, values: Fields, writer: _Writer, name: str
) -> None:
    counted = next(f for f in fields if f.counter == counter.name)
    if counted.name not in values:
        raise CodecError("presence_mismatch", counted.name, writer.at)
    value = values[counted.name]
    count = len(value) // 2 if isinstance(value, str) else len(value)
    if values.get(counter.name, count) != count:
        raise CodecError("count_mismatch", name, writer.at)
    _write_value(counter.type, count, writer, name)


def _write_field(field: Field, value: Any, writer: _Writer, name: str, around: Fields) -> None:
    if field.dim == "one":
        if isinstance(field.type, Struct) and field.type.is_region:
            _write_region(field.type, value, writer, name, around)
        else:
            _write_value(field.type, value, writer, name)
    elif field.dim not in LISTS:
        if list(value) != list(keys_of(field)):
            raise CodecError("presence_mismatch", name, writer.at)
        _write_all(field, list(value.values()), writer, name)
    elif isinstance(field.type, Announced):
        _check_count(field, len(value), name, writer)
        for number in value:
            for word, element in number.items():
                _write_value(SCALARS[word], element, writer, name)
    elif is_bytes(field):
        data = bytes.fromhex(value)
        _check_count(field, len(data), name, writer)
        writer.put(data, name)
    elif field.type == SCALARS["u8"]:  # bytes that are numbers; they fit all together or not at all
        _check_count(field, len(value), name, writer)
        writer.put(b"".join(_number(SCALARS["u8"], v, writer, name) for v in value), name)
    else:
        _check_count(field, len(value), name, writer)
        _write_all(field, value, writer, name)


def _write_all(field: Field, elements: list[Any], writer: _Writer, name: str) -> None:
    """Elements one by one; those of a member of fixed size fit all together or not at all."""
    inner = writer if field.size is None else _Writer(field.size, writer.at)
    for element in elements:
        _write_value(field.type, element, inner, name)
    if inner is not writer:
        writer.put(bytes(inner.data), name)


def _check_count(field: Field, count: int, name: str, writer: _Writer) -> None:
    fits = field.min_count <= count <= field.capacity
    if not fits if field.dim != "fixed" else count != field.count:
        raise CodecError("count_mismatch", name, writer.at)


def _hex(text: str, size: int | None, name: str, writer: _Writer) -> bytes:
    data = bytes.fromhex(text)
    if size is not None and len(data) != size:
        raise CodecError("count_mismatch", name, writer.at)
    return data


def _write_value(type_: Type, value: Any, writer: _Writer, name: str) -> None:
    if isinstance(type_, Struct):
        inner = _Writer(type_.size or writer.limit, writer.at) if type_.size else writer
        # The C++ codec names the whole of a struct of fixed size, a member of any other.
        _write_fields(type_.fields, value, inner, f"{name}." if type_.size else "")
        if inner is not writer:
            writer.put(bytes(inner.data), name)
    elif isinstance(type_, Blob):
        _write_blob(type_, value, writer, name)
    else:
        writer.put(_number(scalar_of(type_), value, writer, name), name)


def _number(scalar: Scalar, value: Any, writer: _Writer, name: str) -> bytes:
    try:
        if scalar.is_float:
            return float_to_bits(value).to_bytes(4, "little")
        return int(value).to_bytes(scalar.size, "little", signed=scalar.name[0] == "i")
    except (OverflowError, ValueError):
        raise CodecError("value_out_of_range", name, writer.at) from None


def _write_blob(type_: Blob, value: str, writer: _Writer, name: str) -> None:
    if type_.kind == "bytes":
        writer.put(_hex(value, type_.size, name, writer), name)
        return
    data = text_to_bytes(value)
    assert type_.size is not None
    if len(data) > type_.size:
        raise CodecError("text_too_long", name, writer.at)
    if type_.kind == "text":
        writer.put(data.ljust(type_.size, b"\0"), name)
        return
    for byte in (len(data), *data):
        writer.put(bytes((byte,)), name)


def _write_region(
    type_: Struct, values: Fields, writer: _Writer, name: str, around: Fields
) -> None:
    assert type_.size is not None
    inner = _Writer(type_.size, writer.at)
    _write_fields(type_.fields, values, inner, f"{name}.", around)
    writer.put(bytes(inner.data).ljust(type_.size, b"\0"), name)


# Messages and frames


def forms_of(layout: Layout) -> Forms:
    """The messages of each direction and id."""
    forms: Forms = {}
    for message in layout.messages:
        forms.setdefault((message.direction, message.id), []).append(message)
    return forms


def choose_message(forms: Forms, direction: str, id: int, size: int) -> Message:
    """The message that a body of `size` bytes is.

    A command with one form is always that; of several forms the one that allows the size.
    """
    candidates = forms.get((direction, id), [])
    if not candidates:
        raise CodecError("unknown_command")
    if len(candidates) == 1:
        return candidates[0]
    for message in candidates:
        if message.min_size <= size and (message.is_open or size <= message.max_size):
            return message
    raise CodecError("unknown_form")


def write_frame(framing: Framing, id: int, body: bytes) -> bytes:
    """A body in its frame."""
    if id == 0:
        raise CodecError("invalid_id")
    if len(body) > framing.max_body:
        raise CodecError("too_long", "", framing.max_body)
    header = bytes((framing.start, id, len(body), (id + len(body)) % 256))
    return header + body + bytes((sum(body) % 256,))


def read_frames(framing: Framing, stream: bytes) -> Iterator[tuple[int, int, bytes]]:
    """The frames in a stream: position, id and body of each, by the rule of the design."""
    at = 0
    while at < len(stream):
        frame = _frame_at(framing, stream[at:])
        if frame is None:
            at += 1
        else:
            yield at, frame[0], frame[1]
            at += framing.header_size + len(frame[1]) + framing.trailer_size


def _frame_at(framing: Framing, data: bytes) -> tuple[int, bytes] | None:
    if len(data) < framing.header_size or data[0] != framing.start or data[1] == 0:
        return None
    if (data[1] + data[2]) % 256 != data[3]:
        return None
    body = data[framing.header_size :][: data[2]]
    trailer = data[framing.header_size + data[2] :][: framing.trailer_size]
    if len(body) != data[2] or not trailer or trailer[0] != sum(body) % 256:
        return None
    return data[1], body
