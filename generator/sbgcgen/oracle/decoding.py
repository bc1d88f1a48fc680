"""The decoder of the second codec (see codec.py)."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sbgcgen.model import SCALARS, Announced, Blob, Field, Message, Scalar, Struct, Type
from sbgcgen.oracle.codec import LISTS, CodecError, Fields, is_bytes, keys_of, scalar_of
from sbgcgen.oracle.json_values import float_from_bits, integer_of, text_from_bytes
from sbgcgen.spec.resolve.sizes import size_of


FITS = ""  # in the context: whether the field that may fit is there


class _Reader:
    """A position in a body; read operations name the field for errors."""

    def __init__(self, body: bytes, at: int = 0) -> None:
        self.body = body
        self.at = at

    def left(self) -> int:
        return len(self.body) - self.at

    def take(self, size: int, field: str) -> bytes:
        begin, end = self.at, self.at + size
        if end > len(self.body):
            raise CodecError("too_short", field, len(self.body))
        self.at = end
        return self.body[begin:end]


def decode(message: Message, body: bytes, context: Fields | None = None) -> Fields:
    """Decode a body.

    `context` has the facts from earlier messages: raw values, and lists of type names. The surplus of
    a request becomes its tail. If the body may repeat its context, the first of the two that fits the
    body exactly is used; otherwise the context that is required to be repeated.
    """
    tries, usual = _contexts_of(message, body, context or {})
    for known in tries:
        try:
            values = _decode(message, body, known)
        except CodecError:
            continue
        if "tail" not in values:
            return values
    return _decode(message, body, usual)


def _contexts_of(message: Message, body: bytes, context: Fields) -> tuple[list[Fields], Fields]:
    """The contexts to try, and the one that counts if none of them fits exactly."""
    if any(field.fits and not field.fits_rest for field in message.fields):
        return [{**context, FITS: fits} for fits in (False, True)], context
    repeats = next((f for f in message.fields if f.repeats_context), None)
    if repeats is None or repeats.when is None:
        return [], context
    when, at, size = repeats.when, message.body.fixed_size, repeats.size or 0
    given = int(context.get(when.source, 0))
    own = int.from_bytes(body[at : at + size], "little") if len(body) >= at + size else 0
    flags = [given & ~when.mask, *([own] if when.holds(own) else [])]
    if when.holds(given):
        flags.reverse()
    tries = [{**context, when.source: one} for one in flags]
    return tries, tries[0]


def _decode(message: Message, body: bytes, context: Fields) -> Fields:
    fixed = message.body.fixed_part
    size = message.body.fixed_size
    has_surplus = message.takes_surplus and len(body) > message.max_size
    has_tail = message.keeps_tail or has_surplus
    exact = len(fixed) == len(message.fields) and not has_tail
    if len(body) < size or (exact and len(body) != size):
        raise CodecError("too_short" if len(body) < size else "too_long", "", min(len(body), size))
    reader = _Reader(body)
    values = _read_fields(message.body, reader, context)
    if has_tail:
        if reader.left() > message.tail_capacity:
            everything = len(fixed) == len(message.fields)
            raise CodecError(
                "too_long", *(("", message.room) if everything else ("tail", reader.at))
            )
        if reader.left():
            values["tail"] = reader.take(reader.left(), "tail").hex()
    elif reader.left():
        raise CodecError("too_long", "", reader.at)
    return values


def _read_fields(body: Struct, reader: _Reader, context: Fields) -> Fields:
    values: Fields = {}
    for field in body.fields:
        if _is_present(field, reader, values, context):
            values[field.name] = _read_field(field, reader, values, context)
    return values


def _is_present(field: Field, reader: _Reader, values: Fields, context: Fields) -> bool:
    when = field.when
    if field.fits_rest:
        assert isinstance(field.type, Blob) and field.type.size is not None
        size, text = reader.left() - 1, reader.body[reader.at + 1 :]
        is_whole = 0 < size <= field.type.size and reader.body[reader.at] == size
        return is_whole and field.is_evident(text)
    if field.fits:
        return bool(context.get(FITS))
    if field.appended and not reader.left():
        return False
    if when is None:
        return True
    is_missing = when.may_be_missing and reader.left() < (field.size or 0)
    return when.holds_in(values, context) and not is_missing


def _read_announced(types: list[str], reader: _Reader, field: Field) -> list[Fields]:
    """Numbers of announced types, up to the end of the body."""
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
        return _read_one(field, reader, values, "", "")
    if isinstance(field.type, Struct) and field.type.looks_outside:
        elements = [_read_one(field, reader, values, *element) for element in field.elements]
        return elements if field.dim == "fixed" else dict(zip(keys_of(field), elements))
    if field.dim not in LISTS:
        keys = keys_of(field)
        return dict(zip(keys, _read_some(field, len(keys), reader)))
    if isinstance(field.type, Announced):
        return _read_announced(context.get(field.type.context, []), reader, field)
    count = _count(field, reader, values)
    if field.has_grown_elements:
        return _read_grown(field, count, reader)
    if is_bytes(field):
        return reader.take(count, field.name).hex()
    if count < 0:
        return _read_to_the_end(field, reader)
    return _read_some(field, count, reader)


def _read_one(field: Field, reader: _Reader, values: Fields, suffix: str, word: str) -> Any:
    """One element; the content of a group may depend on surrounding fields and on the element."""
    if not isinstance(field.type, Struct) or not field.type.looks_outside:
        return _read_value(field.type, reader, field.name)
    inner: Fields = {}
    for member in field.type.fields:
        named = replace(member, name=f"{field.name}{suffix}.{member.name}")
        when = member.when.of(word) if member.when else None
        is_short = bool(when and when.may_be_missing and reader.left() < (member.size or 0))
        if when is None or (when.holds_in(inner, None, values) and not is_short):
            inner[member.name] = _read_field(named, reader, inner, {})
    return inner


def _read_to_the_end(field: Field, reader: _Reader) -> list[Any]:
    elements: list[Any] = []
    while reader.left():
        if len(elements) == field.capacity:
            raise CodecError("too_long", field.name, reader.at)
        elements.append(_read_value(field.type, reader, field.name))
    if len(elements) < field.min_count:
        raise CodecError("too_short", field.name, reader.at)
    return elements


def _element_sizes(field: Field) -> tuple[int, ...]:
    return field.type.element_sizes if isinstance(field.type, Struct) else ()


def _read_grown(field: Field, count: int, reader: _Reader) -> list[Any]:
    """Elements that fill the rest of the body, and have the size of some firmware."""
    assert isinstance(field.type, Struct)
    size = reader.left() // count if count else 0
    if count and (size * count != reader.left() or size not in _element_sizes(field)):
        raise CodecError("count_mismatch", field.name, reader.at)
    elements = [_Reader(reader.take(size, field.name)) for _ in range(count)]
    return [_read_fields(field.type, element, {}) for element in elements]


def _count(field: Field, reader: _Reader, values: Fields) -> int:
    if field.dim == "fixed":
        return field.count
    if field.dim == "counted":
        count = _counted(field, int(values[field.counter]), reader)
        if count > field.capacity:  # no body has room for this many elements
            raise CodecError("too_short", field.name, reader.at)
        return count
    if field.has_grown_elements:
        fitting = [size for size in _element_sizes(field) if reader.left() % size == 0]
        size = fitting[0] if fitting else _element_sizes(field)[0]
    elif not is_bytes(field) and size_of(field.type) is None:
        return -1  # elements that end by themselves
    else:
        size = 1 if is_bytes(field) else _size_of(field.type)
    if reader.left() % size or reader.left() // size < field.min_count:
        raise CodecError("too_short", field.name, len(reader.body))
    if reader.left() // size > field.capacity:
        raise CodecError("too_long", field.name, reader.at)
    return reader.left() // size


def _counted(field: Field, counter: int, reader: _Reader) -> int:
    """The number of elements for the value of a counter."""
    if field.counting == "bytes":
        size = 1 if is_bytes(field) else _size_of(field.type)
        if counter % size:
            raise CodecError("count_mismatch", field.name, reader.at)
        return counter // size
    return field.counted(counter)


def _size_of(type_: Type) -> int:
    size = type_.size if isinstance(type_, (Blob, Struct)) else scalar_of(type_).size
    assert size is not None, f"the size of {type_} varies"
    return size


def _read_some(field: Field, count: int, reader: _Reader) -> list[Any]:
    if field.scalar is None:
        return [_read_value(field.type, reader, field.name) for _ in range(count)]
    scalar = field.scalar
    data = reader.take(count * scalar.size, field.name)
    starts = range(0, len(data), scalar.size)
    return [_number(scalar, data[at : at + scalar.size]) for at in starts]


def _read_value(type_: Type, reader: _Reader, name: str) -> Any:
    if isinstance(type_, Struct):
        if type_.size is not None:  # must be complete
            reader = _Reader(reader.take(type_.size, name))
        return _read_fields(type_, reader, {})
    if isinstance(type_, Blob):
        return _read_blob(type_, reader, name)
    scalar = scalar_of(type_)
    return _number(scalar, reader.take(scalar.size, name))


def _number(scalar: Scalar, data: bytes) -> Any:
    number = int.from_bytes(data, "little", signed=scalar.is_signed)
    if scalar.is_float:
        return float_from_bits(number, scalar.size)
    return integer_of(number, scalar.size) if scalar.size == 8 else number


def _read_blob(type_: Blob, reader: _Reader, name: str) -> str:
    if type_.kind == "string":
        text = reader.take(reader.take(1, name)[0], name)
        if len(text) > (type_.size or 0):
            raise CodecError("text_too_long", name, reader.at)
        return text_from_bytes(text)
    assert type_.size is not None, "bytes without a size are the rest of a body"
    data = reader.take(type_.size, name)
    return text_from_bytes(data.rstrip(b"\0")) if type_.kind == "text" else data.hex()


def _read_region(type_: Struct, reader: _Reader, around: Fields) -> Fields:
    """Read a tagged union: its size is fixed; its conditions refer to the fields `around` it."""
    assert type_.size is not None
    inner = _Reader(reader.take(type_.size, ""))
    values: Fields = {}
    for field in type_.fields:
        if field.when and not field.when.holds_in(around):
            continue
        values[field.name] = _read_field(field, inner, values, {})
    return values
