"""The encoder of the second codec (see codec.py)."""

from __future__ import annotations

from typing import Any

from sbgcgen.model import SCALARS, Announced, Blob, Field, Message, Scalar, Struct, Type
from sbgcgen.oracle.codec import LISTS, CodecError, Fields, is_bytes, keys_of, scalar_of
from sbgcgen.oracle.json_values import float_to_bits, text_to_bytes
from sbgcgen.spec.resolve.sizes import size_of


class _Writer:
    """A buffer of at most `limit` bytes; `base` is the offset of its first byte in the body."""

    def __init__(self, limit: int, base: int = 0) -> None:
        self.data = bytearray()
        self.limit = limit
        self.base = base
        self.missing: list[tuple[int, int, str]] = []  # end, begin and name of missing fields

    @property
    def at(self) -> int:
        return self.base + len(self.data)

    def put(self, data: bytes, field: str) -> None:
        if len(self.data) + len(data) > self.limit:
            raise CodecError("buffer_too_small", field, self.at)
        self.data += data

    def end(self) -> None:
        """Check that nothing can be mistaken for a missing value.

        The following bytes must be too few to be decoded as that value; after an appended one, there
        must be none.
        """
        for end, at, name in sorted(self.missing, key=lambda entry: entry[0])[:1]:
            if self.at >= end:
                raise CodecError("presence_mismatch", name, at)

    def put_number(self, scalar: Scalar, value: Any, field: str) -> None:
        size = scalar.size
        try:
            number = float_to_bits(value, size) if scalar.is_float else int(value)
            data = number.to_bytes(size, "little", signed=scalar.is_signed)
        except (OverflowError, ValueError):
            raise CodecError("value_out_of_range", field, self.at) from None
        self.put(data, field)


def encode(message: Message, fields: Fields) -> bytes:
    """Encode fields to a body.

    Also rejects values of the wrong kind or size, which the types of members prevent in generated
    code.
    """
    writer = _Writer(message.room)
    given = dict(fields)
    may_have_tail = message.keeps_tail or message.takes_surplus
    tail = str(given.pop("tail", "")) if may_have_tail else ""
    _write_fields(message.body, given, writer, "")
    writer.put(_hex(tail, None, "tail", writer), "tail")
    writer.end()
    if tail and message.takes_surplus and writer.at <= message.max_size:
        raise CodecError("presence_mismatch", "tail", writer.at - len(tail) // 2)
    return bytes(writer.data)


def _write_fields(
    body: Struct, values: Fields, writer: _Writer, path: str, around: Any = None, word: str = ""
) -> None:
    around = {} if around is None else around
    unknown = values.keys() - body.names
    if unknown:
        raise CodecError("presence_mismatch", path + min(unknown), writer.at)
    for field in body.fields:
        _write_member(body, field, values, writer, path, around, word)


def _write_member(
    body: Struct,
    field: Field,
    values: Fields,
    writer: _Writer,
    path: str,
    around: Fields,
    word: str,
) -> None:
    name = path + field.name
    present = field.name in values
    if field.is_counter:
        _write_counter(body.fields, field, values, writer, name)
    elif field.when:
        # Encoding has no context, so fields that depend on one are written if present.
        if not field.when.from_context:
            seen = around if body.is_region else values
            wanted = field.when.of(word).holds_in(seen, None, around)
            if present != wanted and (present or not field.when.may_be_missing):
                raise CodecError("presence_mismatch", name, writer.at)
            if wanted and not present:
                writer.missing.append((writer.at + (field.size or 0), writer.at, name))
        if present:
            _write_field(field, values[field.name], writer, name, values)
    elif present:
        if field.fits_rest and not field.is_evident(text_to_bytes(values[field.name])):
            raise CodecError("presence_mismatch", name, writer.at)
        _write_field(field, values[field.name], writer, name, values)
        if field.fits_rest:  # nothing may follow
            writer.missing.append((writer.at + 1, writer.at, name))
    elif field.appended:
        writer.missing.append((writer.at + 1, writer.at, name))
    elif not field.optional and not field.fits:
        raise CodecError("presence_mismatch", name, writer.at)


def _write_counter(
    fields: tuple[Field, ...], counter: Field, values: Fields, writer: _Writer, name: str
) -> None:
    counted = next(f for f in fields if f.counter == counter.name and f.has_hidden_counter)
    if counted.name not in values:
        raise CodecError("presence_mismatch", counted.name, writer.at)
    value = values[counted.name]
    count = counter_of(counted, value)
    if count < 0 or values.get(counter.name, count) != count:
        raise CodecError("count_mismatch", name, writer.at)
    _write_value(counter.type, count, writer, name)


def counter_of(counted: Field, value: Any) -> int:
    """The value of the hidden counter of a list; -1 if there is none."""
    count = len(value) // 2 if isinstance(value, str) else len(value)
    if counted.counting == "bytes":
        return count * (1 if is_bytes(counted) else size_of(counted.type) or 1)
    return count - 1 if counted.counting == "minus_1" else count


def _write_field(field: Field, value: Any, writer: _Writer, name: str, around: Fields) -> None:
    value = bytes.fromhex(value) if is_bytes(field) else value
    if field.counter and not field.has_hidden_counter:
        if len(value) != field.counted(int(around[field.counter])):
            raise CodecError("count_mismatch", name, writer.at)
    if field.dim == "one":
        if isinstance(field.type, Struct) and field.type.is_region:
            _write_region(field.type, value, writer, name, around)
        elif isinstance(field.type, Struct) and field.type.looks_outside:
            _write_fields(field.type, value, writer, f"{name}.", around)
        else:
            _write_value(field.type, value, writer, name)
    elif isinstance(field.type, Struct) and field.type.looks_outside:
        keys = keys_of(field) if field.dim != "fixed" else range(field.count)
        if len(value) != len(keys):
            raise CodecError("presence_mismatch", name, writer.at)
        for key, (suffix, word) in zip(keys, field.elements):
            _write_fields(field.type, value[key], writer, f"{name}{suffix}.", around, word)
    elif field.dim not in LISTS:
        if list(value) != list(keys_of(field)):
            raise CodecError("presence_mismatch", name, writer.at)
        _write_all(field, list(value.values()), writer, name)
    else:
        _write_list(field, value, writer, name)


def _write_list(field: Field, value: Any, writer: _Writer, name: str) -> None:
    fits = field.min_count <= len(value) <= field.capacity
    if not fits if field.dim != "fixed" else len(value) != field.count:
        raise CodecError("count_mismatch", name, writer.at)
    if isinstance(field.type, Announced):
        for number in value:
            for word, element in number.items():
                _write_value(SCALARS[word], element, writer, name)
    elif is_bytes(field):
        writer.put(value, name)
    elif field.type == SCALARS["u8"]:  # written at once, so all of them fit or none
        try:
            writer.put(bytes(map(int, value)), name)
        except (OverflowError, ValueError):
            raise CodecError("value_out_of_range", name, writer.at) from None
    elif field.has_grown_elements:
        _write_grown(field, value, writer, name)
    else:
        _write_all(field, value, writer, name)


def _write_grown(field: Field, elements: list[Any], writer: _Writer, name: str) -> None:
    """Write elements that all have the size of the same firmware."""
    assert isinstance(field.type, Struct)
    size = None
    for element in elements:
        inner = _Writer(writer.limit - len(writer.data), writer.at)
        _write_fields(field.type, element, inner, "")
        inner.end()
        size = len(inner.data) if size is None else size
        if len(inner.data) != size or size not in field.type.element_sizes:
            raise CodecError("presence_mismatch", name, writer.at)
        writer.put(bytes(inner.data), name)


def _write_all(field: Field, elements: list[Any], writer: _Writer, name: str) -> None:
    """Write elements; for a member of fixed size, either all elements fit or none."""
    inner = writer if field.size is None else _Writer(field.size, writer.at)
    for element in elements:
        _write_value(field.type, element, inner, name)
    if inner is not writer:
        writer.put(bytes(inner.data), name)


def _hex(text: str, size: int | None, name: str, writer: _Writer) -> bytes:
    data = bytes.fromhex(text)
    if size is not None and len(data) != size:
        raise CodecError("count_mismatch", name, writer.at)
    return data


def _write_value(type_: Type, value: Any, writer: _Writer, name: str) -> None:
    if isinstance(type_, Struct):
        inner = _Writer(type_.size or writer.limit, writer.at) if type_.size else writer
        # In errors, the generated codec names a fixed-size struct, but the member of any other
        # struct.
        _write_fields(type_, value, inner, f"{name}." if type_.size else "")
        if inner is not writer:
            writer.put(bytes(inner.data), name)
    elif isinstance(type_, Blob):
        _write_blob(type_, value, writer, name)
    else:
        writer.put_number(scalar_of(type_), value, name)


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
    _write_fields(type_, values, inner, f"{name}.", around)
    writer.put(bytes(inner.data).ljust(type_.size, b"\0"), name)
