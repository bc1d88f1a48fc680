"""Random messages of a protocol, as lines of a vector file (see sbgcgen/oracle/vector_line.py), and random settings.

Some bodies are valid, some have bytes changed, removed or added, some are noise. Some fields are modified
as a program may set them.

A line of settings has the results expected of the generated code: the message that holds the settings
("settings"), the number of copies ("copies"), the messages that read and store them, the fields of two such
messages ("from", "to"), the copy number in the second ("copy", null if there is only one), and its fields and
body after the general settings of the first have been copied to it ("shared", "hex").
"""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Iterator
from typing import Any, Optional

from sbgcgen.model import Announced, Blob, Enum, Field, Layout, Message, Settings, Struct
from sbgcgen.model import copy_field
from sbgcgen.oracle.codec import LISTS, CodecError, Fields, is_bytes, scalar_of
from sbgcgen.oracle.compose import Choice, Places, compose, full_context, variable_parts
from sbgcgen.oracle.decoding import decode
from sbgcgen.oracle.encoding import encode
from sbgcgen.oracle.frames import choose_message
from sbgcgen.oracle.vector_line import line
from sbgcgen.oracle.json_values import integer_of, plain
from sbgcgen.oracle.vectors import Vector
from sbgcgen.oracle.room import has_room
from spec_parts import MAX_BODY


def lines_of(layout: Layout, seed: int, count: int) -> Iterator[str]:
    """Yields `count` lines for each message, and lines with bodies that are no message."""
    chosen = random.Random(seed)
    forms = layout.messages_by_id
    for message in layout.messages:
        maker = RandomMessages(message, chosen)
        for _ in range(count):
            if (vector := maker.vector()) is not None:
                yield line(vector, forms)
    for _ in range(count):
        direction, number = chosen.choice(("from_board", "to_board")), chosen.randrange(256)
        body = chosen.randbytes(chosen.randrange(MAX_BODY + 1))
        try:
            choose_message(forms, direction, number, len(body))
        except CodecError as error:
            refused = {"code": error.code, "field": error.field, "offset": error.offset}
            fields = {"id": number, "direction": direction, "hex": body.hex(), "error": refused}
            yield json.dumps({**fields, "why": "no message"}) + "\n"


class RandomMessages:
    """Makes random vectors of one message."""

    def __init__(self, message: Message, chosen: random.Random) -> None:
        self.message = message
        self.random = chosen
        self.places = Places()
        self.mutator = _Mutator(chosen, self.composed)

    def vector(self) -> Optional[Vector]:
        """Returns a body with its fields, or fields that cannot be encoded."""
        context = self.context()
        fields = self.composed(context)
        if self.random.random() < 0.4:
            for _ in range(self.random.randint(1, 3)):
                self.mutator.change(self.message.fields, fields)
            if self.message.keeps_tail and self.random.random() < 0.2:
                fields["tail"] = self.random.randbytes(self.random.randint(1, 9)).hex()
            try:
                body = encode(self.message, fields)
            except CodecError as error:
                if not has_room(self.message.fields, fields):
                    return None
                return Vector(self.message, "changed fields", None, fields, {}, error)
            return self.decoded(body, context, "changed fields")
        try:
            body = encode(self.message, fields)
        except CodecError:
            body = self.random.randbytes(self.message.min_size)
        body, why = self.mutated(body)
        return self.decoded(body, context, why)

    def decoded(self, body: bytes, context: Fields, why: str) -> Vector:
        """Returns the vector of a body with its fields or its error."""
        try:
            return Vector(self.message, why, body, decode(self.message, body, context), context)
        except CodecError as error:
            return Vector(self.message, why, body, None, context, error)

    def context(self) -> Fields:
        """Returns a context that earlier messages may have provided."""
        kind = self.random.random()
        if kind < 0.2:
            return {}
        if kind < 0.4:
            return full_context(self.message)
        context: Fields = {}
        for told in self.message.contexts:
            if told.announced:
                types = self.random.choices(told.announced.types, k=self.random.randrange(12))
                context[told.name] = types
            elif told.type is not None:
                named = [v.value for v in told.type.values]
                if told.type.kind == "enum":
                    context[told.name] = self.random.choice(named)
                    continue
                context[told.name] = 0
                for value in self.random.sample(named, self.random.randint(0, len(named))):
                    context[told.name] |= value
        return {name: value for name, value in context.items() if value}

    def composed(self, context: Fields) -> Fields:
        """Returns fields with values at their limits, and lists of all lengths."""
        lengths = {}
        for path, member, _ in variable_parts(self.message.fields):
            if self.random.random() < 0.5:
                most = member.capacity if member.dim in LISTS else 30
                lengths[path] = min(most, self.random.choice((0, 1, 2, 3, 4, 7, MAX_BODY)))
        choice = Choice(
            self.places,
            round=self.random.randrange(1000),
            context=context,
            lengths={path: length for path, length in lengths.items() if length <= MAX_BODY},
            short=self.random.random() < 0.3,
            leave_out=self.random.random() < 0.3,
            ends_before=self.end(),
        )
        # Many choices exceed the size of a body.
        fields = compose(self.message, choice)
        try:
            encode(self.message, fields)
        except CodecError:
            choice.short, choice.lengths = True, {}
            fields = compose(self.message, choice)
        return copy.deepcopy(fields)

    def end(self) -> str:
        """Returns a field before which the body, or elements, of some firmware end, or ""."""
        appended = [field.name for field in self.message.fields if field.appended]
        for field in self.message.fields:
            if isinstance(field.type, Struct) and field.has_grown_elements:
                appended += [f"{field.name}[].{f.name}" for f in field.type.fields if f.appended]
        return self.random.choice(appended) if appended and self.random.random() < 0.5 else ""

    def mutated(self, body: bytes) -> tuple[bytes, str]:
        """Returns a body with or without damage, and a description of it."""
        result = bytearray(body)
        kind = self.random.randrange(6)
        if kind == 0:
            return body, "as it should be"
        if kind == 1:
            return body[: self.random.randint(0, len(body))], "cut off"
        if kind == 2:
            more = self.random.randint(0, min(9, self.message.room - len(body)))
            return body + self.random.randbytes(more), "with more after it"
        if kind == 3:
            return self.random.randbytes(self.random.randint(0, self.message.room)), "noise"
        if kind == 4:
            size = self.random.randint(self.message.min_size, self.message.max_size)
            return bytes(self.random.randrange(4) for _ in range(size)), "small numbers"
        for _ in range(self.random.randint(1, 3)):
            if result:
                byte = self.random.choice((0, 1, 0x7F, 0x80, 0xFF, self.random.randrange(256)))
                result[self.random.randrange(len(result))] = byte
        return bytes(result), "with other bytes"


class _Mutator:
    """Modifies fields within the limits of a C++ message; the result may not be encodable."""

    def __init__(self, chosen: random.Random, composed: Any) -> None:
        self.random = chosen
        self.composed = composed

    def change(self, members: tuple[Field, ...], values: Fields) -> None:
        """Modifies, removes or adds one of the values."""
        members = tuple(m for m in members if not m.is_counter)
        if not members:
            return
        member = self.random.choice(members)
        if member.may_be_absent and member.name in values and self.random.random() < 0.5:
            del values[member.name]
            return
        if member.name not in values:
            if not member.may_be_absent or member.dim != "one":
                return
            if not isinstance(member.type, (Struct, Blob, Announced)):
                values[member.name] = self.number(member.type)
            return
        value = values[member.name]
        if isinstance(value, list) and isinstance(member.type, Announced):
            self.random.shuffle(value)
        elif is_bytes(member):
            if member.has_hidden_counter:
                values.pop(member.counter, None)
            size = self.random.randint(0, member.capacity)
            values[member.name] = self.random.randbytes(size).hex()
        elif member.dim in ("counted", "rest") and self.random.random() < 0.5:
            if member.has_hidden_counter:
                values.pop(member.counter, None)
            self.resize(value, member.capacity)
        elif isinstance(value, list):
            for place in range(len(value)):
                if self.random.random() < 0.5:
                    value[place] = self.changed(member, value[place])
        elif member.dim != "one":
            for key in value:
                value[key] = self.changed(member, value[key])
        else:
            values[member.name] = self.changed(member, value)

    def resize(self, value: list[Any], capacity: int) -> None:
        """Makes a list shorter, or longer by repetition."""
        size = self.random.choice((0, 1, capacity, self.random.randint(0, capacity)))
        if not value:
            return
        value[:] = [copy.deepcopy(value[i % len(value)]) for i in range(size)]

    def changed(self, member: Field, value: Any) -> Any:
        """Returns another value of the same type."""
        if isinstance(member.type, Struct):
            self.change(member.type.fields, value)
            return value
        if isinstance(member.type, Blob):
            if member.type.kind == "bytes":
                return self.random.randbytes(member.type.size or 0).hex()
            assert member.type.size is not None
            size = self.random.choice((0, 1, member.type.size, self.random.randint(0, 20)))
            size = min(size, member.type.size)
            return "".join(self.random.choice("aZ~\x01\x7f") for _ in range(size))
        return self.number(member.type)

    def number(self, type_: Any) -> Any:
        """Returns a number of a type, often one with a name."""
        scalar = scalar_of(type_)
        if scalar.minimum is None or scalar.maximum is None:
            nan = "nan:7fc00001" if scalar.size == 4 else "nan:7ff8000000000001"
            return self.random.choice((0.0, -0.0, 1.5, "inf", nan, 16777216.0))
        if isinstance(type_, Enum) and type_.values and self.random.random() < 0.7:
            return self.random.choice(type_.values).value
        low, high = scalar.minimum, scalar.maximum
        number = self.random.choice((0, 1, low, high, self.random.randint(low, high)))
        return integer_of(number, scalar.size)


def settings_lines_of(layout: Layout, seed: int, count: int) -> Iterator[str]:
    """Yields `count` lines for each kind of settings."""
    chosen = random.Random(seed)
    for settings in layout.settings:
        maker = RandomMessages(settings.message, chosen)
        for _ in range(count):
            made = _settings_line(settings, _valid_fields(maker), _valid_fields(maker))
            yield json.dumps(plain(made)) + "\n"


def _valid_fields(maker: RandomMessages) -> Fields:
    """Returns the fields of a random valid body."""
    while True:
        vector = maker.vector()
        if vector is not None and vector.body is not None and vector.fields is not None:
            return vector.fields


def _settings_line(settings: Settings, source: Fields, target: Fields) -> dict[str, Any]:
    message, number = settings.message, copy_field(settings.message)
    general = {f.name: source[f.name] for f in message.fields if f.role == "general"}
    shared = {**target, **general}
    return {
        "settings": message.name,
        "copies": settings.copies,
        "readers": [m.name for m in settings.readers],
        "writers": [m.name for m in settings.writers],
        "from": source,
        "to": target,
        "copy": target[number.name] if number else None,
        "shared": shared,
        "hex": encode(message, shared).hex(),
    }
